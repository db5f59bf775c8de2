//! Signed frames: the unsigned frame with a flag, a checksum of its own and a signature (MAVLink guide, "Message signing").

use mavlink_wire::signing::{Key, Signer, SigningError, Trust, Verifier};
use mavlink_wire::{Dialect, EncodeError, Frame, FrameBuf, MAX_FRAME, Sender, Table, Timestamp};
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

/// A router that does not know the message makes the signed frame of a case from the unsigned one, and the other way round;
/// but it signs no key.
pub fn check_router(case: &Case, id: u32, place: &str, findings: &mut Findings) {
    let (plain, signed) = (case.v2.bytes(), case.signed.bytes());
    let kept = |bytes| Frame::parse(bytes, &Table::of(&[])).ok().map(FrameBuf::from);
    let mut stripped = kept(&signed);
    stripped.iter_mut().for_each(FrameBuf::strip_signature);
    findings.equal(Check::Strip, place, stripped.as_ref().map(FrameBuf::bytes), Some(&plain));
    let mut signer = Signer::new(Key::new(key()), case.link, Timestamp::new(case.timestamp));
    let mut resigned = kept(&plain);
    let result = resigned.as_mut().map(|frame| frame.sign(&mut signer));
    let (refusal, expected) = if id == 256 { (Err(EncodeError::CarriesKey), plain) } else { (Ok(()), signed) };
    findings.equal(Check::Sign, place, result, Some(refusal));
    findings.equal(Check::Sign, place, resigned.as_ref().map(FrameBuf::bytes), Some(&expected));
}

/// The first 48 bits of SHA-256 over key, frame, link and timestamp.
fn sign(frame: &GoldenFrame, stamp: &[u8]) -> [u8; 6] {
    let parts = [&key()[..], &frame.header, &frame.payload, &frame.checksum, stamp];
    let hash = parts.into_iter().fold(Sha256::new(), Sha256::chain_update).finalize();
    std::array::from_fn(|at| hash[at])
}
