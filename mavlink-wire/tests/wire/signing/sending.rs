//! A sender signs as pymavlink does, and its timestamps only go up.

use super::*;
use mavlink_wire::EncodeError;

#[test]
fn heartbeat_is_signed_as_pymavlink_signs_it() {
    let golden = [
        0xfd, 9, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0xed, 0x78, 3, 0xe8, 3, 0, 0, 0, 0, 0x44, 0x3d,
        0xf4, 0x50, 0xd5, 0x92,
    ];
    assert_eq!(frame_at(1000), golden);
}

#[test]
fn every_frame_has_a_later_timestamp_whatever_the_clock_says() {
    let mut sender = Sender::v2(1, 1).signed(Signer::new(key(), 3, at(1000)));
    let mut stamps = vec![];
    for now in [0, 500, 1001, 5000, 4000, 5001, 5003, u64::MAX, 0] {
        sender.advance_time(at(now));
        let frame = made(&mut sender, &HEARTBEAT);
        stamps.push(Frame::parse(&frame, Small::TABLE).unwrap().signature().unwrap().timestamp().units());
    }
    assert_eq!(stamps, [1000, 1001, 1002, 5000, 5001, 5002, 5003, (1 << 48) - 1, (1 << 48) - 1]);
}

#[test]
fn a_restart_goes_on_from_the_saved_timestamp() {
    let mut verifier = Verifier::new(Some(key()));
    let mut sender = Sender::v2(1, 1).signed(Signer::new(key(), 3, at(1000)));
    assert_eq!(checked(&mut verifier, &made(&mut sender, &HEARTBEAT)), Ok(Trust::Signed));
    let saved = sender.signer().unwrap().timestamp();
    let mut sender = Sender::v2(1, 1).signed(Signer::new(key(), 3, saved));
    assert_eq!(checked(&mut verifier, &made(&mut sender, &HEARTBEAT)), Ok(Trust::Signed));
}

#[test]
fn mavlink_1_is_never_signed() {
    let mut sender = Sender::v1(1, 1).signed(Signer::new(key(), 3, at(1000)));
    assert_eq!(sender.encode(&HEARTBEAT, &mut [0; MAX_FRAME]), Err(EncodeError::SignatureInV1 { message_id: 0 }));
    assert_eq!((sender.sequence(), sender.signer().map(Signer::timestamp)), (0, Some(at(1000))));
    sender.set_signer(None);
    assert_eq!(made(&mut sender, &HEARTBEAT), made(&mut Sender::v1(1, 1), &HEARTBEAT));
}

#[test]
fn the_longest_frame_has_room_for_its_signature() {
    struct Longest;
    static INFO: mavlink_wire::MessageInfo = mavlink_wire::MessageInfo::new(70_000, "LONGEST", 1, 255);
    impl Encode for Longest {
        fn info(&self) -> &'static mavlink_wire::MessageInfo {
            &INFO
        }
        fn write(&self, payload: &mut [u8; 255]) {
            payload.fill(7);
        }
    }
    let frame = made(&mut Sender::v2(1, 1).signed(Signer::new(key(), 0, at(1))), &Longest);
    assert_eq!(frame.len(), MAX_FRAME);
    assert_eq!(checked(&mut Verifier::new(Some(key())), &frame), Ok(Trust::Signed));
}
