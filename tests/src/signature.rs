//! Signed frames: the unsigned frame with a flag, a checksum of its own and a signature (MAVLink guide, "Message signing").

use sha2::{Digest, Sha256};

use crate::fault::{Check, Findings};
use crate::vectors::{Case, GoldenFrame, key};

/// Where the incompatibility flags are.
const FLAGS: usize = 2;
/// The flag that says that a signature follows.
const SIGNED: u8 = 1;

/// The signed frame of a case, held against its unsigned one and against the key.
pub fn check(case: &Case, place: &str, findings: &mut Findings) {
    let GoldenFrame { header, payload, signature, .. } = &case.signed;
    let mut unsigned = case.v2.header.clone();
    unsigned[FLAGS] |= SIGNED;
    findings.equal(Check::Signed, place, header, &unsigned);
    findings.equal(Check::Signed, place, payload, &case.v2.payload);
    let (stamp, hash) = signature.split_at(signature.len().min(7));
    let mut expected = vec![case.link];
    expected.extend(&case.timestamp.to_le_bytes()[..6]);
    findings.equal(Check::Signature, place, stamp, &expected);
    findings.equal(Check::Signature, place, hash, &sign(&case.signed, stamp));
}

/// The first 48 bits of SHA-256 over key, frame, link and timestamp.
fn sign(frame: &GoldenFrame, stamp: &[u8]) -> [u8; 6] {
    let parts = [&key()[..], &frame.header, &frame.payload, &frame.checksum, stamp];
    let hash = parts.into_iter().fold(Sha256::new(), Sha256::chain_update).finalize();
    std::array::from_fn(|at| hash[at])
}
