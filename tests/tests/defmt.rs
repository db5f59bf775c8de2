//! Messages in the log of a small device: what is sent over the wire contains what the message says.

use mavlink_autoquad::autoquad::{
    AqEscTelemetry, Autoquad, Esc, Esc32State, Esc32Status, GpsRawInt, Heartbeat, MavAutopilot, MavModeFlag, MavState,
    MavType, SetupSigning, Statustext,
};
use mavlink_autoquad::esc::{DisarmReason, Update};
use mavlink_conformance::golden::topics::{Pump, PumpStatus, PumpStatusMode, Topics};
use mavlink_conformance::payload::Fill;
use mavlink_conformance::random::Random;
use mavlink_wire::reflect::Reflected;
use mavlink_wire::signing::{Key, Setup, Verifier};
use mavlink_wire::{
    Chars, Dialect, EncodeError, Frame, FrameBuf, Losses, MAX_FRAME, MAX_PAYLOAD, Message, Parser, Sender, Timestamp,
};

/// What is sent for a value: indices of strings that stay in the program, and the rest.
fn log(value: &impl defmt::Format) -> Vec<u8> {
    defmt::export::fmt(value);
    defmt::export::fetch_bytes()
}

/// Text is sent with its length before it.
fn sent(text: &str) -> Vec<u8> {
    [&(text.len() as u32).to_le_bytes(), text.as_bytes()].concat()
}

/// Whether the log has these parts, in this order.
fn has(log: &[u8], parts: &[&[u8]]) -> bool {
    let mut rest = log;
    parts.iter().all(|part| match rest.windows(part.len()).position(|window| window == *part) {
        Some(at) => {
            rest = &rest[at + part.len()..];
            true
        }
        None => false,
    })
}

#[test]
fn a_message_names_its_fields_and_their_values() {
    let beat = Heartbeat {
        r#type: MavType::QUADROTOR,
        autopilot: MavAutopilot(77),
        base_mode: MavModeFlag::from_bits_retain(0x81),
        custom_mode: 0x1234_5678,
        system_status: MavState::ACTIVE,
        mavlink_version: 3,
    };
    let [name, r#type, quadrotor] = [sent("HEARTBEAT"), sent("type"), sent("MAV_TYPE_QUADROTOR")];
    let [autopilot, flag, other] =
        [sent("autopilot"), sent("MAV_MODE_FLAG_CUSTOM_MODE_ENABLED"), sent("MAV_MODE_FLAG_SAFETY_ARMED")];
    let (custom_mode, active) = (sent("custom_mode"), sent("MAV_STATE_ACTIVE"));
    let number = 0x1234_5678_u64.to_le_bytes();
    let parts: [&[u8]; 10] =
        [&name, &r#type, &quadrotor, &autopilot, &77_u64.to_le_bytes(), &flag, &other, &custom_mode, &number, &active];
    assert!(has(&log(&beat), &parts), "{:?}", log(&beat));
    assert!(has(&log(&Autoquad::Heartbeat(beat)), &parts));
    assert!(!has(&log(&Heartbeat::DEFAULT), &parts));
}

#[test]
fn a_key_is_not_logged() {
    let setup = SetupSigning { secret_key: [0xa7; 32], ..SetupSigning::DEFAULT };
    for log in [log(&setup), log(&Autoquad::from(setup))] {
        assert!(has(&log, &[&sent("secret_key"), &sent("initial_timestamp")]));
        assert!(!log.contains(&0xa7), "{log:?}");
    }
}

#[test]
fn values_have_units_or_are_unknown() {
    let known = log(&GpsRawInt { eph: 121, ..GpsRawInt::DEFAULT });
    assert!(has(&known, &[&sent("eph"), &121_u64.to_le_bytes()]));
    assert!(has(&known, &[&sent("alt"), &sent("mm")]));
    let unknown = log(&GpsRawInt { eph: u16::MAX, ..GpsRawInt::DEFAULT });
    assert!(!has(&unknown, &[&sent("eph"), &u64::from(u16::MAX).to_le_bytes()]));
}

#[test]
fn text_is_text() {
    let text: Chars<50> = "ready".try_into().unwrap();
    assert!(has(&log(&Statustext { text, ..Statustext::DEFAULT }), &[&sent("text"), &sent("ready")]));
    assert!(has(&log(&text), &[&sent("ready")]));
    assert!(has(&log(&Chars([0xff, 0xfe])), &[&[2, 0, 0, 0, 0xff, 0xfe]]));
}

#[test]
fn every_message_is_logged_whole() {
    let mut random = Random::new(3);
    for info in Autoquad::TABLE.iter() {
        for fill in Fill::ALL {
            let payload = fill.payload(MAX_PAYLOAD, &mut random);
            let message = Autoquad::decode(info.id, &payload).unwrap();
            let names: Vec<_> = Autoquad::fields(info.id).unwrap().iter().map(|field| sent(field.name)).collect();
            let names: Vec<&[u8]> = names.iter().map(|name| &name[..]).collect();
            assert!(has(&log(&message), &names), "{}", info.name);
            let reflected = Reflected::new(info, Autoquad::fields(info.id).unwrap(), &payload);
            assert!(has(&log(&reflected), &names), "{}", info.name);
        }
    }
}

#[test]
fn frames_and_errors_are_logged() {
    let (mut sender, mut buffer) = (Sender::v2(7, 8), [0; MAX_FRAME]);
    let bytes = sender.encode(&AqEscTelemetry { seq: 9, ..AqEscTelemetry::DEFAULT }, &mut buffer).unwrap();
    let frame = Frame::parse(bytes, Autoquad::TABLE).unwrap();
    let expected = [&[7][..], &[8], &152_u32.to_le_bytes(), frame.payload()];
    assert!(has(&log(&frame), &expected), "{:?}", log(&frame));
    assert!(has(&log(&FrameBuf::from(frame)), &expected));
    assert!(has(&log(&EncodeError::IdTooLarge { message_id: 300 }), &[&300_u32.to_le_bytes()]));
}

#[test]
fn a_key_is_logged_by_no_frame() {
    let setup = Setup::new(1, 1, Key::new([0xA7; 32]), Timestamp::ZERO).unwrap();
    let (mut sender, mut buffer) = (Sender::v2(255, 190), [0; MAX_FRAME]);
    let frame = Frame::parse(sender.encode(&setup, &mut buffer).unwrap(), Autoquad::TABLE).unwrap();
    for logged in [log(&frame), log(&FrameBuf::from(frame))] {
        assert!(has(&logged, &[&[255], &[190], &256_u32.to_le_bytes()]));
        assert!(!has(&logged, &[&[0xA7; 2]]), "{logged:?}");
    }
}

#[test]
fn what_a_link_tells_of_itself_is_logged() {
    let (mut sender, mut buffer) = (Sender::v2(7, 8), [0; MAX_FRAME]);
    let bytes = sender.encode(&Heartbeat::DEFAULT, &mut buffer).unwrap();
    let (mut parser, mut losses) = (Parser::new(Autoquad::TABLE), Losses::<2>::new());
    let frame = parser.next(&mut &bytes[..]).unwrap();
    log(&losses.count(&frame));
    assert!(has(&log(&losses.total()), &[&1_u64.to_le_bytes()]));
    let refused = Verifier::new(Some(Key::new([1; 32]))).check_with(&frame, Timestamp::new(77), |_| false);
    assert!(has(&log(&refused), &[&[0; 4]]));
    assert!(has(&log(&Timestamp::new(77)), &[&77_u64.to_le_bytes()]));
    assert!(has(&log(&parser.statistics()), &[&1_u64.to_le_bytes()]));
}

#[test]
fn views_slots_and_reasons_say_what_they_hold() {
    let status = Esc32Status::from_bits(0, 3).with_state(Esc32State::RUNNING).unwrap().with_rpm(6543).unwrap();
    let parts =
        [sent("Esc32Status"), sent("state"), sent("ESC32_STATE_RUNNING"), sent("rpm"), 6543_u16.to_le_bytes().to_vec()];
    let parts: Vec<&[u8]> = parts.iter().map(Vec::as_slice).collect();
    assert!(has(&log(&status), &parts), "{:?}", log(&status));
    let (esc, age) = (sent("Esc"), sent("age_ms"));
    let all: Vec<&[u8]> = [esc.as_slice(), &age].into_iter().chain(parts).collect();
    assert!(has(&log(&Esc { id: 1, age_ms: Some(5), status: Some(status) }), &all));
    assert!(has(&log(&DisarmReason::Undefined(9)), &[&sent("Undefined"), &[9]]));
    assert!(has(&log(&Update::Restarted), &[&sent("Restarted")]));
}

#[test]
fn a_topic_names_its_fields_and_their_values() {
    let mut status = PumpStatus { mode: PumpStatusMode::FILL, pressure: 0x1234, ..PumpStatus::UNKNOWN };
    status.pumps[1] = Pump { rpm: 0x5678, ..Pump::UNKNOWN };
    let [name, mode, fill, pressure] = [sent("PumpStatus"), sent("mode"), sent("MODE_FILL"), sent("pressure")];
    let [pumps, nested] = [sent("pumps"), sent("Pump")];
    for log in [log(&status), log(&Topics::from(status))] {
        assert!(has(&log, &[&name, &mode, &fill, &pressure, &[0x34, 0x12], &pumps, &nested, &[0x78, 0x56]]));
    }
}
