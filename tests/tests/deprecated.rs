//! A deprecated message warns where its name is used, and not again at each of its fields.

#![deny(deprecated)]

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::prelude::*;

#[expect(deprecated, reason = "it is what is tested")]
fn asked() -> mavlink_autoquad::autoquad::MissionRequest {
    mavlink_autoquad::autoquad::MissionRequest::DEFAULT
}

#[test]
fn fields_of_a_deprecated_message_do_not_warn() {
    let mut message = asked();
    message.target_system = 1;
    message.seq += 2;
    assert_eq!((message.target_system, message.seq, message.info().name), (1, 2, "MISSION_REQUEST"));
    assert!(format!("{message:?}").starts_with("MissionRequest { target_system: 1,"));
    let Autoquad::MissionRequest(inside) = Autoquad::from(message) else { panic!("another message") };
    assert_eq!(inside.seq, 2);
}
