//! Frames that are sent on: as they came, with another number, without their signature.

use crate::small::{Heartbeat, Small};
use crate::streams::pieces::encoded;
use mavlink_wire::{Dialect, EncodeError, Frame, FrameBuf, MAX_FRAME, Message, Parser, Sender, Table, crc};

const SIGNED: [u8; 34] = [
    0xfd, 9, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0xed, 0x78, 3, 0xe8, 3, 0, 0, 0, 0, 0x44, 0x3d, 0xf4,
    0x50, 0xd5, 0x92,
];
const UNSIGNED: [u8; 21] = [0xfd, 9, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x0a, 0x80];
const MAVLINK_1: [u8; 17] = [0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];

fn kept(bytes: &[u8], table: &Table<'_>) -> FrameBuf {
    Frame::parse(bytes, table).unwrap().into()
}

/// Header and payload, completed to a frame.
fn with_checksum(bytes: &[u8], crc_extra: u8) -> Vec<u8> {
    let checksum = crc::step(crc::checksum(&bytes[1..]), crc_extra);
    [bytes, &checksum.to_le_bytes()].concat()
}

#[test]
fn a_kept_frame_is_sent_as_it_came() {
    for bytes in [&SIGNED[..], &UNSIGNED, &MAVLINK_1] {
        assert_eq!(kept(bytes, Small::TABLE).bytes(), bytes);
    }
}

#[test]
fn without_its_signature_a_frame_is_that_of_a_sender_that_does_not_sign() {
    for table in [Small::TABLE, &Table::of(&[])] {
        for (bytes, stripped) in [(&SIGNED[..], &UNSIGNED[..]), (&UNSIGNED, &UNSIGNED), (&MAVLINK_1, &MAVLINK_1)] {
            let mut frame = kept(bytes, table);
            frame.strip_signature();
            assert_eq!(frame.bytes(), stripped);
            assert_eq!(frame, kept(stripped, table));
        }
    }
}

#[test]
fn another_number_is_that_of_the_senders_own_frame() {
    let heartbeat = Frame::parse(&UNSIGNED, Small::TABLE).unwrap().decode::<Heartbeat>().unwrap();
    for (bytes, mut sender) in
        [(&SIGNED[..], Sender::v2(1, 1)), (&UNSIGNED, Sender::v2(1, 1)), (&MAVLINK_1, Sender::v1(1, 1))]
    {
        let (mut frame, mut buffer) = (kept(bytes, Small::TABLE), [0; MAX_FRAME]);
        sender.set_sequence(200);
        frame.set_sequence(200);
        assert_eq!(sender.encode(&heartbeat, &mut buffer), Ok(frame.bytes()));
    }
}

#[test]
fn forwarded_frames_are_counted_with_the_senders_own() {
    let (mut sender, mut buffer) = (Sender::v2(1, 1), [0; MAX_FRAME]);
    sender.set_sequence(254);
    let frame = kept(&SIGNED, Small::TABLE);
    let first = sender.renumber(&frame.as_frame()).unwrap();
    let own = sender.encode(&Heartbeat::DEFAULT, &mut buffer).unwrap()[4];
    let third = sender.renumber(&frame.as_frame()).unwrap();
    assert_eq!((first.as_frame().sequence(), own, third.as_frame().sequence()), (254, 255, 0));
    assert_eq!(Frame::parse(third.bytes(), Small::TABLE).as_ref(), Ok(&third.as_frame()));
}

#[test]
fn system_component_and_flags_of_a_forwarded_frame_stay() {
    let foreign = with_checksum(&[0xfd, 2, 0, 0x5a, 9, 77, 88, 0x44, 0x33, 0x22, 1, 2], 99);
    let frame = kept(&foreign, Small::TABLE);
    assert!(!frame.as_frame().is_verified());
    let sent = Sender::v2(1, 1).renumber(&frame.as_frame()).unwrap();
    assert_eq!(sent.bytes(), with_checksum(&[0xfd, 2, 0, 0x5a, 0, 77, 88, 0x44, 0x33, 0x22, 1, 2], 99));
    assert_eq!(Frame::parse(sent.bytes(), Small::TABLE), Ok(sent.as_frame()));
}

#[test]
fn a_key_is_neither_forwarded_nor_shown() {
    let mut setup = vec![0xfd, 42, 0, 0, 0, 255, 190, 0, 1, 0];
    setup.extend([0; 10]);
    setup.extend([0xA7; 32]);
    let setup = with_checksum(&setup, 71);
    let frame = Frame::parse(&setup, Small::TABLE).unwrap();
    let mut sender = Sender::v2(1, 1);
    assert!(frame.carries_key());
    assert_eq!(sender.renumber(&frame), Err(EncodeError::CarriesKey));
    assert_eq!(sender.sequence(), 0);
    let mut parser = Parser::new(Small::TABLE);
    assert_eq!(parser.next(&mut &setup[..40]), None);
    let shown = format!("{frame:?} {:?} {parser:?}", FrameBuf::from(frame));
    assert!(!shown.contains("167") && shown.contains("secret"), "{shown}");
    assert!(!kept(&SIGNED, Small::TABLE).as_frame().carries_key());
}

#[test]
#[cfg(not(feature = "signing"))]
fn a_sender_that_cannot_sign_is_four_bytes() {
    assert_eq!(size_of::<Sender>(), 4);
}

#[test]
fn frames_are_bytes_and_keys_of_maps() {
    let bytes = encoded(Sender::v2(1, 1), 3, &Heartbeat::DEFAULT.into());
    let frame = Frame::parse(&bytes, Small::TABLE).unwrap();
    let kept = FrameBuf::from(frame);
    assert_eq!((frame.as_ref(), kept.as_ref()), (&bytes[..], &bytes[..]));
    assert!(std::collections::HashSet::from([frame]).contains(&kept.as_frame()));
    assert!(std::collections::HashSet::from([kept]).contains(&FrameBuf::from(frame)));
}
