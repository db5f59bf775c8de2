//! Frames that pymavlink made: the bytes that everybody else on the link sends and expects.

use crate::small::{AqEscTelemetry, Heartbeat, MavState, Small, Statustext};
use mavlink_wire::{
    Chars, Encode, EncodeError, Frame, FrameBuf, FrameError, MAX_FRAME, Message, MessageInfo, Parser, Sender, Table,
    Version, crc,
};

static AQ_TELEMETRY_F: MessageInfo = MessageInfo::new(150, "AQ_TELEMETRY_F", 241, 82);
static TABLE: Table<'static> = Table::of(&[Heartbeat::INFO, &AQ_TELEMETRY_F, AqEscTelemetry::INFO]);

const HEARTBEAT: Heartbeat =
    Heartbeat { r#type: 6, autopilot: 8, system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT };
const ESC: AqEscTelemetry = AqEscTelemetry {
    time_boot_ms: 0x0102_0304,
    seq: 1,
    num_motors: 4,
    num_in_seq: 4,
    escid: [0, 1, 2, 3],
    status_age: [10, 20, 30, 65535],
    data_version: [3; 4],
    data0: [0x1111_1111, 0x2222_2222, 0x3333_3333, 0x4444_4444],
    data1: [1, 2, 3, 0],
};

const HEARTBEAT_V1: &str = "fe0900010100000000000608000403 9043";
const HEARTBEAT_V2: &str = "fd0900000001010000000000000006080004030a80";
const ZERO_V2: &str = "fd010000000101000000 00 d52c";
const HEARTBEAT_SIGNED: &str = "fd0901000001010000000000000006080004 03 ed78 03 e80300000000 443df450d592";
const ESC_PAYLOAD: &str = "0403020111111111222222223333333344444444010000000200000003000000000000000a0014001e00ffff\
    0104040001020303030303";

fn bytes(hex: &str) -> Vec<u8> {
    let digits: Vec<u8> = hex.bytes().filter_map(|c| (c as char).to_digit(16)).map(|digit| digit as u8).collect();
    digits.chunks(2).map(|pair| pair[0] << 4 | pair[1]).collect()
}

#[track_caller]
fn sends(mut sender: Sender, sequence: u8, message: &dyn Encode, hex: &str) {
    sender.set_sequence(sequence);
    let mut buffer = [0xAA; MAX_FRAME];
    assert_eq!(sender.encode(message, &mut buffer), Ok(&bytes(hex)[..]));
    assert_eq!(sender.sequence(), sequence.wrapping_add(1));
}

#[test]
fn heartbeat_is_sent_as_pymavlink_sends_it() {
    sends(Sender::v1(1, 1), 0, &HEARTBEAT, HEARTBEAT_V1);
    sends(Sender::v2(1, 1), 0, &HEARTBEAT, HEARTBEAT_V2);
    sends(Sender::v2(1, 1), 0, &Small::from(HEARTBEAT), HEARTBEAT_V2);
}

#[test]
fn one_zero_byte_remains_of_a_zero_payload() {
    sends(Sender::v2(1, 1), 0, &Heartbeat { mavlink_version: 0, ..Heartbeat::DEFAULT }, ZERO_V2);
}

#[test]
fn arrays_are_sent_in_wire_order() {
    sends(Sender::v2(1, 1), 7, &ESC, &format!("fd370000070101980000 {ESC_PAYLOAD} f443"));
    sends(Sender::v1(1, 1), 7, &ESC, &format!("fe3707010198 {ESC_PAYLOAD} 2037"));
}

#[test]
fn heartbeat_is_read() {
    for (hex, version) in [(HEARTBEAT_V1, Version::V1), (HEARTBEAT_V2, Version::V2), (HEARTBEAT_SIGNED, Version::V2)] {
        let bytes = bytes(hex);
        let frame = Frame::parse(&bytes, &TABLE).unwrap();
        assert_eq!(
            (frame.version(), frame.message_id(), frame.crc_extra(), frame.is_verified()),
            (version, 0, 50, true)
        );
        assert_eq!((frame.sequence(), frame.compat_flags()), (0, 0));
        assert!(frame.system_id() == 1 && frame.component_id() == 1);
        assert_eq!(frame.bytes(), bytes);
        assert_eq!(frame.decode(), Some(HEARTBEAT));
        assert_eq!(frame.message(), Some(Small::Heartbeat(HEARTBEAT)));
        assert_eq!(frame.decode::<AqEscTelemetry>(), None);
        assert_eq!(FrameBuf::from(frame).as_frame(), frame);
    }
}

#[test]
fn the_signature_is_handed_over() {
    let bytes = bytes(HEARTBEAT_SIGNED);
    let frame = Frame::parse(&bytes, &TABLE).unwrap();
    let signature = frame.signature().unwrap();
    assert_eq!((frame.incompat_flags(), signature.link_id(), signature.timestamp().units()), (1, 3, 1000));
    assert_eq!(signature.bytes()[7..], [0x44, 0x3d, 0xf4, 0x50, 0xd5, 0x92]);
    let unsigned = self::bytes(HEARTBEAT_V2);
    assert_eq!(Frame::parse(&unsigned, &TABLE).unwrap().signature(), None);
}

#[test]
fn telemetry_frames_are_read() {
    let zeros = "00".repeat(78);
    let v1 = format!("fe52070101960000803f {zeros} 3f93");
    let v2 = "fd0400000701019600000000803fbb36";
    let signed = "fd0401000701019600000000803f1633 03 e80300000000 f235ec089e75";
    for (hex, length) in [(&*v1, 82), (v2, 4), (signed, 4)] {
        let bytes = bytes(hex);
        let frame = Frame::parse(&bytes, &TABLE).unwrap();
        assert_eq!((frame.message_id(), frame.sequence(), frame.payload().len()), (150, 7, length));
        assert_eq!(frame.payload()[..4], 1.0_f32.to_le_bytes());
        assert!(frame.is_verified());
    }
    let esc = bytes(&format!("fe3707010198 {ESC_PAYLOAD} 2037"));
    assert_eq!(Frame::parse(&esc, &TABLE).unwrap().decode(), Some(ESC));
}

#[test]
fn short_and_empty_payloads_are_zero_extended() {
    assert_eq!(Heartbeat::decode(&[]), Heartbeat { mavlink_version: 0, ..Heartbeat::DEFAULT });
    assert_eq!(Heartbeat::decode(&[1, 2]).custom_mode, 0x0201);
    let zero = bytes(ZERO_V2);
    assert_eq!(Frame::parse(&zero, &TABLE).unwrap().decode::<Heartbeat>().map(|m| m.mavlink_version), Some(0));
    for header in [&[0xfe, 0, 0, 1, 1, 0][..], &[0xfd, 0, 0, 0xff, 0, 1, 1, 0, 0, 0]] {
        let empty = with_checksum(header, 50);
        assert_eq!(Frame::parse(&empty, &TABLE).unwrap().decode(), Some(Heartbeat::decode(&[])));
    }
}

#[test]
fn longer_payloads_are_cut() {
    let mut longer = vec![0xfd, 11, 0, 0, 0, 1, 1, 0, 0, 0];
    longer.extend([0, 0, 0, 0, 6, 8, 0, 4, 3, 77, 78]);
    let longer = with_checksum(&longer, 50);
    let frame = Frame::parse(&longer, &TABLE).unwrap();
    assert_eq!((frame.payload().len(), frame.decode()), (11, Some(HEARTBEAT)));
}

#[test]
fn extensions_stay_out_of_mavlink_1_and_are_read_from_it() {
    let text = Statustext { text: Chars::truncated("hello"), id: 7, chunk_seq: 9, ..Statustext::DEFAULT };
    let mut buffer = [0; MAX_FRAME];
    assert_eq!(Sender::v1(1, 1).encode(&text, &mut buffer).unwrap().len(), 6 + 51 + 2);
    let mut payload = [0; 255];
    let mut extended = vec![0xfe, 54, 0, 1, 1, 253];
    assert_eq!(text.payload(Version::V1, &mut payload).len(), 51);
    extended.extend(text.payload(Version::V2, &mut payload));
    let extended = with_checksum(&extended, 83);
    assert_eq!(Frame::parse(&extended, &Table::of(&[Statustext::INFO])).unwrap().decode(), Some(text));
}

#[test]
fn what_is_no_frame_says_why() {
    let good = bytes(HEARTBEAT_V2);
    assert_eq!(Frame::parse(&[0x55], &TABLE), Err(FrameError::NotStx { found: 0x55 }));
    assert_eq!(Frame::parse(&good[..2], &TABLE), Err(FrameError::Incomplete { needed: 3 }));
    assert_eq!(Frame::parse(&good[..20], &TABLE), Err(FrameError::Incomplete { needed: 21 }));
    let mut flags = good.clone();
    flags[2] = 2;
    assert_eq!(Frame::parse(&flags, &TABLE), Err(FrameError::IncompatFlags { flags: 2 }));
    let mut damaged = good;
    damaged[12] ^= 1;
    assert_eq!(Frame::parse(&damaged, &TABLE), Err(FrameError::Checksum { message_id: 0 }));
}

#[test]
fn an_unknown_id_is_handed_over_unverified() {
    let bytes = bytes(HEARTBEAT_V2);
    let nothing = Table::of(&[]);
    let frame = Frame::parse(&bytes, &nothing).unwrap();
    assert_eq!((frame.is_verified(), frame.crc_extra()), (false, 50));
    assert_eq!(frame.decode(), Some(HEARTBEAT));
}

#[test]
fn a_message_of_another_definition_is_not_decoded() {
    let memory_info = with_checksum(&[0xfe, 4, 0, 1, 1, 152, 1, 2, 3, 4], 208);
    assert_eq!(Frame::parse(&memory_info, &TABLE), Err(FrameError::Checksum { message_id: 152 }));
    let nothing = Table::of(&[]);
    let frame = Frame::parse(&memory_info, &nothing).unwrap();
    assert_eq!((frame.decode::<AqEscTelemetry>(), frame.message::<Small>()), (None, None));
}

#[test]
fn mavlink_1_refuses_large_ids() {
    static LARGE: MessageInfo = MessageInfo::new(256, "LARGE", 241, 82);
    struct Large;
    impl Encode for Large {
        fn info(&self) -> &'static MessageInfo {
            &LARGE
        }
        fn write(&self, payload: &mut [u8; 255]) {
            payload[..82].fill(1);
        }
    }
    let (mut sender, mut buffer) = (Sender::v1(1, 1), [0; MAX_FRAME]);
    assert_eq!(sender.encode(&Large, &mut buffer), Err(EncodeError::IdTooLarge { message_id: 256 }));
    assert_eq!(sender.sequence(), 0);
    assert_eq!(Sender::v2(1, 1).encode(&Large, &mut buffer).map(|frame| frame[7..10].to_vec()), Ok(vec![0, 1, 0]));
}

#[test]
fn the_sequence_wraps() {
    let (mut sender, mut buffer) = (Sender::v1(1, 1), [0; MAX_FRAME]);
    let sequences: Vec<u8> = (0..258).map(|_| sender.encode(&HEARTBEAT, &mut buffer).unwrap()[2]).collect();
    assert_eq!(sequences[254..], [254, 255, 0, 1]);
}

#[test]
fn a_stream_is_decoded_into_one_place() {
    let stream = bytes(&[HEARTBEAT_V1, HEARTBEAT_SIGNED, ZERO_V2].concat());
    let (mut parser, mut input, mut seen) = (Parser::new(&TABLE), &stream[..], vec![]);
    let mut message = Small::Statustext(Statustext::DEFAULT);
    while let Some(frame) = parser.next(&mut input) {
        assert!(frame.decode_into(&mut message));
        seen.push(message);
    }
    let zero = Heartbeat { mavlink_version: 0, ..Heartbeat::DEFAULT };
    assert_eq!(seen, [HEARTBEAT.into(), HEARTBEAT.into(), zero.into()]);
    assert_eq!(Heartbeat::try_from(message), Ok(zero));
    assert_eq!(Statustext::try_from(message), Err(message));
}

/// Header and payload, completed to a frame.
fn with_checksum(bytes: &[u8], crc_extra: u8) -> Vec<u8> {
    let checksum = crc::step(crc::checksum(&bytes[1..]), crc_extra);
    [bytes, &checksum.to_le_bytes()].concat()
}
