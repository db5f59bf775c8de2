//! Signed frames: the unsigned frame with a flag, a checksum of its own and a signature (MAVLink guide, "Message signing").

use mavlink_wire::signing::{Key, Signer, SigningError, Trust, Verifier};
use mavlink_wire::{Dialect, Frame, MAX_FRAME, Sender, Timestamp};
use sha2::{Digest, Sha256};

use crate::fault::{Check, Findings};
use crate::subject::Subject;
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

/// The runtime makes the signed frame of a case, and believes it, once.
pub fn check_runtime<D: Dialect>(subject: &Subject<D>, case: &Case, place: &str, findings: &mut Findings) {
    let (bytes, timestamp) = (case.signed.bytes(), Timestamp::new(case.timestamp));
    let signer = Signer::new(Key::new(key()), case.link, timestamp);
    let mut sender = Sender::v2(case.system, case.component).signed(signer);
    sender.set_sequence(case.sequence);
    let made = sender.encode(&*(subject.build)(&case.values), &mut [0xA5; MAX_FRAME]).map(<[u8]>::to_vec);
    findings.equal(Check::Sign, place, made.as_ref(), Ok(&bytes));
    let mut verifier = Verifier::new(Some(Key::new(key())));
    let mut verify = || Frame::parse(&bytes, D::TABLE).ok().map(|frame| verifier.check(&frame, Timestamp::ZERO));
    findings.equal(Check::Verify, place, verify(), Some(Ok(Trust::Signed)));
    let replayed = SigningError::Replayed { timestamp, last: timestamp };
    let allowed = if subject.id == 109 { Ok(Trust::Allowed) } else { Err(replayed) };
    findings.equal(Check::Verify, place, verify(), Some(allowed));
}

/// The first 48 bits of SHA-256 over key, frame, link and timestamp.
fn sign(frame: &GoldenFrame, stamp: &[u8]) -> [u8; 6] {
    let parts = [&key()[..], &frame.header, &frame.payload, &frame.checksum, stamp];
    let hash = parts.into_iter().fold(Sha256::new(), Sha256::chain_update).finalize();
    std::array::from_fn(|at| hash[at])
}
