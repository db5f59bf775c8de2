//! Only a holder of the key is believed, and only what is believed leaves a trace.

use super::*;
use mavlink_wire::{Table, crc};
use proptest::prelude::*;

/// The frame with a checksum that is right again.
fn resealed(mut frame: Vec<u8>) -> Vec<u8> {
    let end = frame.len() - 15;
    let checksum = crc::step(crc::checksum(&frame[1..end]), Heartbeat::INFO.crc_extra);
    frame[end..end + 2].copy_from_slice(&checksum.to_le_bytes());
    frame
}

#[test]
fn no_bit_of_a_signed_frame_can_be_changed() {
    let genuine = frame_at(1000);
    let refusal = |frame: &Frame<'_>| SigningError::WrongHash {
        link_id: frame.signature().unwrap().link_id(),
        system_id: frame.system_id(),
        component_id: frame.component_id(),
    };
    for bit in 0..8 * genuine.len() {
        // The start, the length, the flag and the id make it another frame or none.
        if matches!(bit / 8, 0..=2 | 7..=9 | 19..=20) {
            continue;
        }
        let mut forged = genuine.clone();
        forged[bit / 8] ^= 1 << (bit % 8);
        let forged = resealed(forged);
        let frame = Frame::parse(&forged, Small::TABLE).unwrap();
        let mut verifier = Verifier::new(Some(key()));
        assert_eq!(verifier.check(&frame, at(0)), Err(refusal(&frame)), "bit {bit}");
        assert_eq!((verifier.streams(), verifier.timestamp()), (&[][..], at(0)), "bit {bit}");
    }
    assert_eq!(checked(&mut Verifier::new(Some(key())), &genuine), Ok(Trust::Signed));
}

#[test]
fn every_byte_of_the_key_counts() {
    let genuine = frame_at(1000);
    for byte in 0..32 {
        let mut other = *key().as_bytes();
        other[byte] ^= 0x80;
        let refusal = SigningError::WrongHash { link_id: 3, system_id: 1.into(), component_id: 1.into() };
        assert_eq!(checked(&mut Verifier::new(Some(Key::new(other))), &genuine), Err(refusal), "byte {byte}");
    }
}

/// pymavlink 2.4.50 stores the time of a frame before it looks at the hash: there, one forged frame with a late time
/// shuts the genuine sender out. The C library does it in the right order.
#[test]
fn a_forged_late_timestamp_does_not_shut_the_sender_out() {
    let mut verifier = Verifier::new(Some(key()));
    assert_eq!(checked(&mut verifier, &frame_at(1000)), Ok(Trust::Signed));
    let mut forged = frame_at(9000);
    *forged.last_mut().unwrap() ^= 1;
    let refusal = SigningError::WrongHash { link_id: 3, system_id: 1.into(), component_id: 1.into() };
    assert_eq!(checked(&mut verifier, &forged), Err(refusal));
    assert_eq!(checked(&mut verifier, &frame_at(1001)), Ok(Trust::Signed));
    assert_eq!((verifier.streams(), verifier.timestamp()), (&[stream(3, 1, 1, 1001)][..], at(1001)));
}

#[test]
fn a_frame_of_an_unknown_message_is_verified_by_its_signature() {
    let bytes = frame_at(1000);
    let frame = Frame::parse(&bytes, &Table::of(&[])).map(|frame| (frame.is_verified(), frame)).unwrap();
    assert!(!frame.0);
    assert_eq!(Verifier::new(Some(key())).check(&frame.1, at(0)), Ok(Trust::Signed));
}

proptest! {
    /// Any payload, any header, any signature: judged, never more than refused.
    #[test]
    fn any_frame_is_survived(
        signed: bool,
        head in any::<[u8; 6]>(),
        id in prop_oneof![6 => 0..0x0100_0000_u32, 1 => Just(109), 1 => Just(256)],
        payload in proptest::collection::vec(any::<u8>(), 0..=255),
        signature in any::<[u8; 13]>(),
        now: u64,
    ) {
        let [compat, sequence, system, component, crc_extra, _] = head;
        let [a, b, c, _] = id.to_le_bytes();
        let header = [0xFD, payload.len() as u8, u8::from(signed), compat, sequence, system, component, a, b, c];
        let mut bytes = [&header[..], &payload].concat();
        let checksum = crc::step(crc::checksum(&bytes[1..]), crc_extra);
        bytes.extend(checksum.to_le_bytes());
        if signed {
            bytes.extend(signature);
        }
        let frame = Frame::parse(&bytes, &Table::of(&[])).unwrap();
        let mut verifier = Verifier::<2>::with_streams(Some(key()));
        let expected = match (signed, id) {
            (_, 109) => Ok(Trust::Allowed),
            (false, _) => Err(SigningError::Unsigned { message_id: id }),
            (true, _) => Err(SigningError::WrongHash { link_id: signature[0], system_id: system.into(), component_id: component.into() }),
        };
        prop_assert_eq!(verifier.check(&frame, at(now)), expected);
        prop_assert_eq!((verifier.streams(), verifier.timestamp()), (&[][..], at(now)));
        let mut kept = mavlink_wire::FrameBuf::from(frame);
        kept.strip_signature();
        prop_assert_eq!(kept.bytes().len(), bytes.len() - if signed { 13 } else { 0 });
        if id != 256 {
            prop_assert_eq!(kept.sign(&mut Signer::new(key(), 9, at(77))), Ok(()));
            prop_assert_eq!(Verifier::new(Some(key())).check(&kept.as_frame(), at(0)), Ok(Trust::Signed));
            let reparsed = Frame::parse(kept.bytes(), &Table::of(&[])).unwrap();
            prop_assert_eq!(reparsed, kept.as_frame());
        }
    }
}
