//! Messages out of arbitrary bytes, for fuzzing.

use std::collections::BTreeSet;

use arbitrary::{Arbitrary, Unstructured};
use mavlink_autoquad::autoquad::{Attitude, Autoquad, AutoquadNavStatus, MavState, Statustext};
use mavlink_conformance::golden::topics::{PumpStatus, Topics};
use mavlink_conformance::payload::{Canonical, Fill};
use mavlink_conformance::random::Random;
use mavlink_wire::uorb::Topics as _;
use mavlink_wire::{Chars, Dialect, Encode, Message};

fn bytes(random: &mut Random) -> Vec<u8> {
    Fill::Random.payload(300, random)
}

#[test]
fn a_message_is_what_its_bytes_decode_to() {
    let mut random = Random::new(1);
    for _ in 0..100 {
        let bytes = bytes(&mut random);
        let mut rest = Unstructured::new(&bytes);
        let message = Attitude::arbitrary(&mut rest).unwrap();
        assert_eq!(Canonical::sent(&message), Canonical::sent(&Attitude::decode(&bytes[..28])));
        assert_eq!(rest.len(), 300 - 28);
        assert_eq!(Attitude::size_hint(0), (28, Some(28)));
        let extended = Statustext::arbitrary(&mut Unstructured::new(&bytes)).unwrap();
        assert_eq!(Canonical::sent(&extended), Canonical::sent(&Statustext::decode(&bytes)));
        assert_eq!(Statustext::size_hint(0), (54, Some(54)), "with extensions");
    }
}

#[test]
fn every_message_of_a_dialect_comes_up() {
    let (mut random, mut seen) = (Random::new(2), BTreeSet::new());
    for _ in 0..20_000 {
        let bytes = bytes(&mut random);
        let message = Autoquad::arbitrary(&mut Unstructured::new(&bytes)).unwrap();
        seen.insert(message.info().id);
    }
    assert_eq!(seen.len(), Autoquad::TABLE.len());
    assert_eq!(Autoquad::size_hint(0), (0, Some(size_of::<usize>() + 255)), "the choice and its payload");
}

#[test]
fn few_bytes_make_a_message_too() {
    for length in 0..10 {
        let bytes = vec![0xff; length];
        Autoquad::arbitrary(&mut Unstructured::new(&bytes)).unwrap();
        Autoquad::arbitrary_take_rest(Unstructured::new(&bytes)).unwrap();
    }
}

#[test]
fn values_that_nothing_names_come_up() {
    let bytes = [200, 0xff, 0xfe, 0xfd, 0xfc, b'a', 0, b'b'];
    let mut rest = Unstructured::new(&bytes);
    assert_eq!(MavState::arbitrary(&mut rest).unwrap(), MavState(200));
    assert_eq!(AutoquadNavStatus::arbitrary(&mut rest).unwrap().bits(), 0xfcfd_feff);
    assert_eq!(Chars::<3>::arbitrary(&mut rest).unwrap(), Chars([b'a', 0, b'b']));
    let hints = (MavState::size_hint(0), AutoquadNavStatus::size_hint(0), Chars::<3>::size_hint(0));
    assert_eq!(hints, ((1, Some(1)), (4, Some(4)), (3, Some(3))));
}

/// Field by field, in their order; what bytes do not say is zero.
#[test]
fn a_topic_comes_of_its_bytes() {
    let status = PumpStatus::arbitrary(&mut Unstructured::new(&[1, 0, 0, 0, 0, 0, 0, 0, 2, 255, 8])).unwrap();
    assert_eq!((status.timestamp, status.mode.0, status.trend.0, status.faults.bits()), (1, 2, -1, 8));
    assert_eq!((status.level, status.pumps[2].rpm), (0.0, 0));
}

#[test]
fn every_topic_of_a_package_comes_up() {
    let (mut random, mut seen) = (Random::new(3), BTreeSet::new());
    for _ in 0..100 {
        let bytes = bytes(&mut random);
        seen.insert(Topics::arbitrary(&mut Unstructured::new(&bytes)).unwrap().name());
    }
    assert_eq!(seen, BTreeSet::from(["Pump", "PumpStatus"]));
}
