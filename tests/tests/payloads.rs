//! Any payload at all: every one decodes, and encodes again to what a sender of the same values would have sent.

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_conformance::autoquad::SUBJECTS;
use mavlink_conformance::payload::{Canonical, Fill};
use mavlink_conformance::random::Random;
use mavlink_conformance::subject::Subject;
use mavlink_wire::{Dialect, MAX_PAYLOAD};

fn check(subject: &Subject<Autoquad>, payload: &[u8]) {
    let (info, expected) = (subject.info, Canonical::of(payload, subject.info));
    let decoded = (subject.decode)(payload);
    assert_eq!(Canonical::sent(&*decoded.message), expected, "{} from {payload:02x?}", info.name);
    let in_dialect = Autoquad::decode(subject.id, payload).unwrap();
    assert_eq!(Canonical::sent(&in_dialect), expected, "{} from {payload:02x?}", info.name);
    let rebuilt = (subject.build)(&decoded.values);
    assert_eq!(Canonical::sent(&*rebuilt), expected, "{} from {payload:02x?}", info.name);
}

#[test]
fn every_payload_of_every_length_survives() {
    let (mut random, mut checked) = (Random::new(0x4D41_564C), 0);
    for subject in &SUBJECTS {
        for fill in Fill::ALL {
            for length in 0..=MAX_PAYLOAD {
                check(subject, &fill.payload(length, &mut random));
                checked += 1;
            }
        }
    }
    println!("{checked} payloads");
    assert!(checked >= 236 * 3 * 256, "{checked}");
}
