//! The message that carries a key.

use super::*;
use mavlink_wire::signing::{ReceivedSetup, Setup};
use mavlink_wire::{EncodeError, MAX_PAYLOAD, Table, Version};

fn decode(bytes: &[u8]) -> Option<ReceivedSetup> {
    Setup::decode(&Frame::parse(bytes, &Table::of(&[])).unwrap())
}

#[test]
fn a_setup_is_laid_out_as_the_dialect_says() {
    let setup = Setup::new(2, 3, key(), at(0x0102_0304_0506)).unwrap();
    let expected = [&[6, 5, 4, 3, 2, 1, 0, 0, 2, 3][..], key().as_bytes()].concat();
    assert_eq!(setup.payload(Version::V2, &mut [0xA5; MAX_PAYLOAD]), expected);
    let frame = made(&mut Sender::v2(255, 190), &setup);
    let received = decode(&frame).unwrap();
    assert!(received.target_system() == 2 && received.target_component() == 3);
    assert_eq!(received.key(), Some((&key(), at(0x0102_0304_0506))));
}

#[test]
fn switching_off_is_a_short_payload() {
    let off = Setup::off(2, 3).unwrap();
    assert_eq!(off.payload(Version::V2, &mut [0xA5; MAX_PAYLOAD]), [0, 0, 0, 0, 0, 0, 0, 0, 2, 3]);
    let received = decode(&made(&mut Sender::v2(255, 190), &off)).unwrap();
    assert!(received.key().is_none() && received.target_system() == 2);
}

#[test]
fn a_key_goes_to_one_component() {
    for (system, component) in [(0, 1), (1, 0), (0, 0)] {
        let refusal = SigningError::Broadcast { system_id: system.into(), component_id: component.into() };
        assert_eq!(Setup::new(system, component, key(), at(1)), Err(refusal));
        assert_eq!(Setup::off(system, component), Err(refusal));
    }
}

#[test]
fn mavlink_1_has_no_setup() {
    let setup = Setup::new(1, 1, key(), at(1)).unwrap();
    let refusal = EncodeError::IdTooLarge { message_id: 256 };
    assert_eq!(Sender::v1(1, 1).encode(&setup, &mut [0; MAX_FRAME]), Err(refusal));
}

#[test]
fn only_a_setup_is_read_as_one() {
    assert_eq!(decode(&frame_at(1)), None);
    let mut other = made(&mut Sender::v2(255, 190), &Setup::off(2, 3).unwrap());
    let end = other.len() - 2;
    let checksum = mavlink_wire::crc::step(mavlink_wire::crc::checksum(&other[1..end]), 72);
    other[end..].copy_from_slice(&checksum.to_le_bytes());
    assert_eq!(decode(&other), None);
}

#[test]
fn a_given_key_makes_both_sides_agree() {
    let sent = Setup::new(1, 1, key(), at(1000)).unwrap();
    let setup = decode(&made(&mut Sender::v2(255, 190), &sent)).unwrap();
    let (key, timestamp) = setup.key().unwrap();
    let mut vehicle = Sender::v2(1, 1).signed(Signer::new(key.clone(), 0, timestamp));
    let mut station = Verifier::new(Some(super::key()));
    station.advance_time(at(1000));
    assert_eq!(checked(&mut station, &made(&mut vehicle, &HEARTBEAT)), Ok(Trust::Signed));
}
