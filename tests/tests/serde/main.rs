//! Messages through JSON and through postcard: every payload comes back as it was, and what was written reads well.

mod views;

use std::fmt::Debug;

use mavlink_autoquad::autoquad::{
    AqEscTelemetry, Attitude, Autoquad, BatteryStatus, CommandAck, Esc, Esc32State, Esc32Status, GpsRawInt, GpsStatus,
    Heartbeat, MavAutopilot, MavModeFlag, MavState, MavType, NamedValueFloat, ParamSet, Statustext,
};
use mavlink_autoquad::esc::{DisarmReason, EscTable};
use mavlink_conformance::payload::{Canonical, Fill};
use mavlink_conformance::random::Random;
use mavlink_wire::generated::serde::{Deserialize, Serialize};
use mavlink_wire::{Chars, Dialect, Encode, Frame, MAX_PAYLOAD, Message};
use proptest::prelude::*;
use serde_json::{Value, json};

/// Messages of every type, over payloads of all kinds.
fn messages() -> Vec<Autoquad> {
    let mut random = Random::new(0x5E2D_E000);
    let mut messages = Vec::new();
    for info in Autoquad::TABLE.iter() {
        for fill in Fill::ALL {
            for _ in 0..8 {
                messages.extend(Autoquad::decode(info.id, &fill.payload(MAX_PAYLOAD, &mut random)));
            }
        }
        messages.extend(Autoquad::decode(info.id, &[]));
        messages.extend(Autoquad::decode(info.id, &[0xff; MAX_PAYLOAD]));
    }
    assert!(messages.len() >= 236 * 25, "{}", messages.len());
    messages
}

fn same(message: &Autoquad, back: &Autoquad, written: &dyn Debug) {
    assert_eq!(Canonical::sent(message), Canonical::sent(back), "{} by {written:?}", back.info().name);
}

#[test]
fn every_message_survives_json() {
    for message in messages() {
        let text = serde_json::to_string(&message).unwrap();
        same(&message, &serde_json::from_str(&text).unwrap(), &text);
        let value = serde_json::to_value(message).unwrap();
        same(&message, &serde_json::from_value(value.clone()).unwrap(), &value);
    }
}

#[test]
fn every_message_survives_json_whose_type_comes_last() {
    for message in messages() {
        let Value::Object(fields) = serde_json::to_value(message).unwrap() else { panic!("an object") };
        let turned = Value::Object(fields.into_iter().rev().collect());
        same(&message, &serde_json::from_value(turned.clone()).unwrap(), &turned);
    }
}

#[test]
fn every_message_survives_postcard() {
    let mut buffer = [0; 1024];
    for message in messages() {
        let bytes = postcard::to_slice(&message, &mut buffer).unwrap();
        same(&message, &postcard::from_bytes(bytes).unwrap(), &bytes);
    }
}

#[test]
fn a_message_by_itself_survives() {
    let mut random = Random::new(7);
    for fill in Fill::ALL {
        for _ in 0..100 {
            let message = ParamSet::decode(&fill.payload(MAX_PAYLOAD, &mut random));
            let back: ParamSet = serde_json::from_str(&serde_json::to_string(&message).unwrap()).unwrap();
            same(&message.into(), &back.into(), &message);
            let mut buffer = [0; 64];
            let back = postcard::from_bytes(postcard::to_slice(&message, &mut buffer).unwrap()).unwrap();
            same(&message.into(), &Autoquad::ParamSet(back), &message);
        }
    }
}

proptest! {
    #[test]
    fn every_float_survives_json(bits: u32) {
        let message = Attitude { roll: f32::from_bits(bits), ..Attitude::DEFAULT };
        let back: Attitude = serde_json::from_str(&serde_json::to_string(&message).unwrap()).unwrap();
        prop_assert_eq!(back.roll.to_bits(), bits);
    }

    #[test]
    fn any_json_is_read_or_refused(text in r#"\{("type":"HEARTBEAT",|"mavtype":[0-9]{1,3},|"x":[\[\{]{0,20}|"[a-z]{1,9}":("[^"]*"|-?[0-9.e]{1,9}|null),){0,5}\}"#) {
        let _ = serde_json::from_str::<Autoquad>(&text);
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let _ = postcard::from_bytes::<Autoquad>(&bytes);
    }
}

/// Read as a `double`, its shortest decimal is the middle between it and the next.
#[test]
fn the_one_float_that_rounds_wrong_survives_json() {
    for bits in [0x15ae_43fd, 0x95ae_43fd] {
        let message = Attitude { roll: f32::from_bits(bits), ..Attitude::DEFAULT };
        let text = serde_json::to_string(&message).unwrap();
        let back: Attitude = serde_json::from_str(&text).unwrap();
        assert_eq!(back.roll.to_bits(), bits, "{text}");
    }
}

const BEAT: Heartbeat = Heartbeat {
    r#type: MavType::QUADROTOR,
    autopilot: MavAutopilot::AUTOQUAD,
    base_mode: MavModeFlag::SAFETY_ARMED.union(MavModeFlag::HIL_ENABLED),
    custom_mode: 4,
    system_status: MavState(200),
    mavlink_version: 3,
};

fn beat() -> Value {
    json!({
        "type": "HEARTBEAT",
        "mavtype": "MAV_TYPE_QUADROTOR",
        "autopilot": "MAV_AUTOPILOT_AUTOQUAD",
        "base_mode": "MAV_MODE_FLAG_HIL_ENABLED | MAV_MODE_FLAG_SAFETY_ARMED",
        "custom_mode": 4,
        "system_status": 200,
        "mavlink_version": 3,
    })
}

#[test]
fn json_has_the_names_of_the_xml() {
    assert_eq!(serde_json::to_value(Autoquad::Heartbeat(BEAT)).unwrap(), beat());
    let mut untagged = beat();
    untagged.as_object_mut().unwrap().shift_remove("type");
    assert_eq!(serde_json::to_value(BEAT).unwrap(), untagged);
}

#[test]
fn json_keeps_the_order_of_the_xml() {
    let text = serde_json::to_string(&Autoquad::Heartbeat(BEAT)).unwrap();
    assert!(text.starts_with(r#"{"type":"HEARTBEAT","mavtype":"MAV_TYPE_QUADROTOR","autopilot":"#), "{text}");
}

/// What rust-mavlink 0.21 writes of a HEARTBEAT.
#[test]
fn json_of_rust_mavlink_is_read() {
    let theirs = json!({
        "type": "HEARTBEAT",
        "custom_mode": 4,
        "mavtype": { "type": "MAV_TYPE_QUADROTOR" },
        "autopilot": { "type": "MAV_AUTOPILOT_AUTOQUAD" },
        "base_mode": "MAV_MODE_FLAG_HIL_ENABLED | MAV_MODE_FLAG_SAFETY_ARMED",
        "system_status": { "type": "MAV_STATE_ACTIVE" },
        "mavlink_version": 3,
    });
    let expected = Heartbeat { system_status: MavState::ACTIVE, ..BEAT };
    assert_eq!(serde_json::from_value::<Autoquad>(theirs).unwrap(), Autoquad::Heartbeat(expected));
}

/// What rust-mavlink up to 0.14 and mavlink2rest write of flags and of `char` arrays.
#[test]
fn json_of_older_rust_mavlink_is_read() {
    for early in [false, true] {
        let read = |mut message: Value, name: &str| {
            if !early {
                let Value::Object(fields) = message else { panic!("an object") };
                message = Value::Object([("type".to_owned(), json!(name))].into_iter().chain(fields).collect());
            } else {
                message["type"] = json!(name);
            }
            serde_json::from_str::<Autoquad>(&message.to_string()).map_err(|error| error.to_string())
        };
        let mut theirs = beat();
        theirs.as_object_mut().unwrap().shift_remove("type");
        theirs["base_mode"] = json!({ "bits": 160 });
        theirs["mavtype"] = json!({ "type": "MAV_TYPE_QUADROTOR" });
        let base_mode = MavModeFlag::from_bits_retain(160);
        assert_eq!(read(theirs, "HEARTBEAT"), Ok(Autoquad::Heartbeat(Heartbeat { base_mode, ..BEAT })));

        let named = |name: Value| read(json!({ "time_boot_ms": 9, "value": 2.5, "name": name }), "NAMED_VALUE_FLOAT");
        let nuls = ["\0"; 6];
        let tank = NamedValueFloat { time_boot_ms: 9, value: 2.5, name: "tank".try_into().unwrap() };
        let characters = [&["t", "a", "n", "k"][..], &nuls].concat();
        assert_eq!(named(json!(characters)), Ok(tank.into()));
        assert_eq!(named(json!(["t", "a", "n", "k"])), Ok(tank.into()), "the rest are NULs, as in a text");
        assert_eq!(named(json!(["t", 97, "n", "k", 0, 0, 0, "\0", 0, 0])), Ok(tank.into()));
        let latin = Chars([b't', 0xe4, 0, b'x', 0, 0, 0, 0, 0, 0xff]);
        let characters = latin.0.map(|byte| char::from(byte).to_string());
        assert_eq!(named(json!(characters)), Ok(NamedValueFloat { name: latin, ..tank }.into()));
        for (wrong, said) in [
            (json!(["t", "an"]), "invalid value: string \"an\", expected a character of one byte, or its number"),
            (json!(["€"]), "invalid value: string \"€\", expected a character of one byte, or its number"),
            (json!([116, 256]), "invalid value: integer `256`, expected a character of one byte, or its number"),
            (json!([]), "invalid length 0, expected text of at most 10 bytes, or 10 numbers or characters"),
            (json!([116]), "invalid length 1, expected text of at most 10 bytes, or 10 numbers or characters"),
            (json!(vec!["t"; 12]), "invalid length 12, expected text of at most 10 bytes, or 10 numbers or characters"),
            (
                json!(true),
                "invalid type: boolean `true`, expected text of at most 10 bytes, or 10 numbers or characters",
            ),
        ] {
            let error = named(wrong).unwrap_err();
            assert!(error.starts_with(said), "{error}");
        }
    }
}

/// A value in which every NaN is the usual one.
fn with_one_nan(value: Value) -> Value {
    match value {
        Value::String(text) if text.starts_with("NaN(") => json!("NaN"),
        Value::Array(values) => values.into_iter().map(with_one_nan).collect(),
        Value::Object(fields) => fields.into_iter().map(|(key, value)| (key, with_one_nan(value))).collect(),
        other => other,
    }
}

/// What was sent in the frames that mavgen-cli holds, and the lines that `mavgen decode` writes of them.
fn decoded() -> Vec<(Autoquad, Value)> {
    let frames: Vec<&str> = include_str!("../../../mavgen/cli/tests/decode/frames.hex").lines().collect();
    let lines: Vec<&str> = include_str!("../../../mavgen/cli/tests/decode/decoded.jsonl").lines().collect();
    assert_eq!(frames.len(), lines.len());
    let both = frames.into_iter().zip(lines).map(|(frame, line)| {
        let digits = (0..frame.len()).step_by(2);
        let bytes: Vec<u8> = digits.map(|at| u8::from_str_radix(&frame[at..at + 2], 16).unwrap()).collect();
        let sent: Autoquad = Frame::parse(&bytes, Autoquad::TABLE).unwrap().message().unwrap();
        (sent, serde_json::from_str(line).unwrap())
    });
    both.collect()
}

#[test]
fn what_mavgen_decode_writes_is_read() {
    let mut with_null = 0;
    for (sent, line) in decoded() {
        let read: Autoquad = serde_json::from_value(line["message"].clone()).unwrap();
        // By text, in which a float has its shortest digits.
        let written = |message| serde_json::from_str(&serde_json::to_string(&message).unwrap()).unwrap();
        let [sent, read] = [sent, read].map(|message: Autoquad| with_one_nan(written(message)));
        assert_eq!(read, sent);
        // Written by both in the same way, but for what is not known.
        for (key, value) in line["message"].as_object().unwrap() {
            if value.to_string().contains("null") {
                with_null += 1;
            } else if !value.to_string().contains("\"NaN") {
                assert_eq!(*value, sent[key], "{key} of {}", sent["type"]);
            }
        }
    }
    assert!(with_null >= 8, "{with_null}");
}

/// `mavgen decode` writes null for what the sender does not know.
#[test]
fn null_is_what_is_not_known() {
    let known = GpsRawInt { eph: 7, ..GpsRawInt::DEFAULT };
    let mut value = serde_json::to_value(known).unwrap();
    for key in ["eph", "vel"] {
        value[key] = Value::Null;
    }
    let read: GpsRawInt = serde_json::from_str(&value.to_string()).unwrap();
    assert_eq!((read.eph, read.vel, read.eph()), (u16::MAX, u16::MAX, None));
    assert_eq!(serde_json::from_value::<GpsRawInt>(value.clone()).unwrap(), read);
    value["lat"] = Value::Null;
    let error = serde_json::from_value::<GpsRawInt>(value).unwrap_err().to_string();
    assert!(error.starts_with("invalid type: null, expected"), "{error}");

    let mut value = serde_json::to_value(BatteryStatus::DEFAULT).unwrap();
    value["voltages"][3] = Value::Null;
    value["temperature"] = Value::Null;
    let read: BatteryStatus = serde_json::from_value(value).unwrap();
    assert_eq!((read.voltages[3], read.temperature), (u16::MAX, i16::MAX));
}

#[test]
fn what_is_no_number_is_text_in_json() {
    let floats = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -0.0, 0.1, f32::from_bits(0xffc0_0001)];
    let [roll, pitch, yaw, rollspeed, pitchspeed, yawspeed] = floats;
    let message = Attitude { time_boot_ms: 1, roll, pitch, yaw, rollspeed, pitchspeed, yawspeed };
    let text = serde_json::to_string(&message).unwrap();
    let expected = concat!(
        r#"{"time_boot_ms":1,"roll":"NaN","pitch":"Infinity","yaw":"-Infinity","#,
        r#""rollspeed":-0.0,"pitchspeed":0.1,"yawspeed":"NaN(0xffc00001)"}"#
    );
    assert_eq!(text, expected);
    let null: Attitude = serde_json::from_str(&text.replace(r#""NaN""#, "null")).unwrap();
    assert_eq!(null.roll.to_bits(), f32::NAN.to_bits());
}

#[test]
fn char_arrays_are_text_unless_that_would_lose_bytes() {
    let json =
        |text: Chars<50>| serde_json::to_value(Statustext { text, ..Statustext::DEFAULT }).unwrap()["text"].clone();
    assert_eq!(json("Grüße".try_into().unwrap()), json!("Grüße"));
    assert_eq!(json(Chars([b'x'; 50])), json!("x".repeat(50)));
    let mut behind_nul = [0; 50];
    behind_nul[49] = b'x';
    assert_eq!(json(Chars(behind_nul)), json!(behind_nul.to_vec()));
    assert_eq!(json(Chars([0xff; 50])), json!(vec![0xff; 50]));
}

/// The text of the error that reading this as a message gives.
fn error(value: Value) -> String {
    serde_json::from_value::<Autoquad>(value).unwrap_err().to_string()
}

fn with(key: &str, value: Value) -> Value {
    let mut beat = beat();
    beat[key] = value;
    beat
}

#[test]
fn errors_say_what_is_wrong() {
    let mut lacking = beat();
    lacking.as_object_mut().unwrap().shift_remove("autopilot");
    assert_eq!(error(lacking), "missing field `autopilot`");
    assert_eq!(error(json!({ "custom_mode": 1 })), "missing field `type`");
    let expected = "invalid value: string \"HEARTBEET\", expected the name of a message of Autoquad";
    assert_eq!(error(with("type", json!("HEARTBEET"))), expected);
    let expected = "invalid value: integer `-1`, expected a number of type uint32_t";
    assert_eq!(error(with("custom_mode", json!(-1))), expected);
    let expected = "invalid value: integer `256`, expected an entry of MAV_STATE, or a number of type uint8_t";
    assert_eq!(error(with("system_status", json!(256))), expected);
    let expected = "invalid value: string \"A | 4\", expected flags of MAV_MODE_FLAG, or a number of type uint8_t";
    assert_eq!(error(with("base_mode", json!("A | 4"))), expected);
    let flags = "expected flags of MAV_MODE_FLAG, or a number of type uint8_t";
    for (value, said) in [
        (json!({ "bits": 256 }), "invalid value: integer `256`, "),
        (json!({ "bits": "A" }), "invalid value: string \"A\", "),
        (json!({ "bits": { "bits": 1 } }), "invalid type: map, "),
        (json!({ "bit": 5 }), "invalid type: a map without the value, "),
        (json!({}), "invalid type: a map without the value, "),
        (json!([5]), "invalid type: sequence, "),
        (json!(5.5), "invalid type: floating point `5.5`, "),
        (json!(null), "invalid type: null, "),
    ] {
        assert_eq!(error(with("base_mode", value)), format!("{said}{flags}"));
    }
    let entry = "expected an entry of MAV_STATE, or a number of type uint8_t";
    assert_eq!(
        error(with("system_status", json!({ "bits": 3 }))),
        format!("invalid type: a map without the value, {entry}")
    );
    let text = json!({ "type": "STATUSTEXT", "severity": 0, "text": "x".repeat(51) });
    assert!(error(text).starts_with("51 bytes do not fit a field of 50: "));
}

#[test]
fn a_field_may_come_once() {
    for text in [
        r#"{"type":"HEARTBEAT","custom_mode":1,"custom_mode":1}"#,
        r#"{"custom_mode":1,"type":"HEARTBEAT","custom_mode":1}"#,
        r#"{"custom_mode":1,"custom_mode":1,"type":"HEARTBEAT"}"#,
    ] {
        let error = serde_json::from_str::<Autoquad>(text).unwrap_err().to_string();
        assert!(error.starts_with("duplicate field `custom_mode`"), "{error}");
    }
    let error = serde_json::from_str::<Autoquad>(r#"{"type":"HEARTBEAT","type":"HEARTBEAT"}"#).unwrap_err().to_string();
    assert!(error.starts_with("duplicate field `type`"), "{error}");
}

#[test]
fn a_sequence_may_end_before_the_extensions() {
    let acknowledged = |fields: Value| serde_json::from_value::<CommandAck>(fields);
    assert_eq!(acknowledged(json!([400, 4, 0, 0, 0, 0])).unwrap().result.0, 4);
    assert_eq!(acknowledged(json!([400, 4])).unwrap(), acknowledged(json!([400, 4, 0, 0, 0, 0])).unwrap());
    assert!(acknowledged(json!([400])).unwrap_err().to_string().contains("invalid length 1"));
}

#[test]
fn fields_that_the_message_does_not_have_are_ignored() {
    for key in ["altitude", "a"] {
        let read = serde_json::from_value::<Autoquad>(with(key, json!([{ "deep": [1] }, true, null]))).unwrap();
        assert_eq!(read, Autoquad::Heartbeat(BEAT));
    }
    let text = r#"{"a":[{"deep":[1.5,true]},null],"custom_mode":0,"type":"HEARTBEAT","mavtype":0,"autopilot":0,
        "base_mode":"","system_status":"0x3","mavlink_version":3}"#;
    let expected = Heartbeat { system_status: MavState::STANDBY, ..Heartbeat::DEFAULT };
    assert_eq!(serde_json::from_str::<Autoquad>(text).unwrap(), Autoquad::Heartbeat(expected));
}

#[test]
fn extension_fields_may_be_missing() {
    let text = r#"{"severity":"MAV_SEVERITY_INFO","text":"hello"}"#;
    let read: Statustext = serde_json::from_str(text).unwrap();
    assert_eq!((read.id, read.chunk_seq, read.text), (0, 0, "hello".try_into().unwrap()));
}

#[test]
fn arrays_have_exactly_their_length() {
    let status = serde_json::to_value(Autoquad::GpsStatus(GpsStatus::DEFAULT)).unwrap();
    for length in [0, 19, 20, 21] {
        let mut changed = status.clone();
        changed["satellite_prn"] = json!(vec![0; length]);
        let Value::Object(fields) = changed.clone() else { panic!("an object") };
        let turned = Value::Object(fields.into_iter().rev().collect());
        for value in [changed, turned] {
            assert_eq!(serde_json::from_value::<Autoquad>(value).is_ok(), length == 20, "{length}");
        }
    }
}

#[test]
fn too_much_before_the_type_is_an_error() {
    let text = format!(r#"{{"a":"{}","type":"HEARTBEAT"}}"#, "x".repeat(9000));
    let error = serde_json::from_str::<Autoquad>(&text).unwrap_err().to_string();
    assert!(error.starts_with("too much comes before `type`: put it first"), "{error}");
    let text = format!(r#"{{"a":{}{},"type":"HEARTBEAT"}}"#, "[".repeat(100), "]".repeat(100));
    assert!(serde_json::from_str::<Autoquad>(&text).is_err());
}

#[test]
fn postcard_has_the_message_id_and_the_fields() {
    let mut buffer = [0; 64];
    let bytes = postcard::to_slice(&Autoquad::Heartbeat(BEAT), &mut buffer).unwrap();
    assert_eq!(bytes, [0, 2, 14, 0xa0, 4, 200, 3]);
    let status = Autoquad::Statustext(Statustext::DEFAULT);
    let bytes = postcard::to_slice(&status, &mut buffer).unwrap();
    assert_eq!(bytes[..2], [0xfd, 0x01], "the id 253 as a varint");
}

#[test]
fn enums_and_flags_survive_alone() {
    for state in [MavState::ACTIVE, MavState(200)] {
        let text = serde_json::to_string(&state).unwrap();
        assert_eq!(serde_json::from_str::<MavState>(&text).unwrap(), state);
        let mut buffer = [0; 4];
        assert_eq!(postcard::to_slice(&state, &mut buffer).unwrap(), [state.0]);
        assert_eq!(postcard::from_bytes::<MavState>(&[state.0]).unwrap(), state);
    }
    for bits in 0..=255 {
        let flags = MavModeFlag::from_bits_retain(bits);
        let text = serde_json::to_string(&flags).unwrap();
        assert_eq!(serde_json::from_str::<MavModeFlag>(&text).unwrap(), flags);
    }
    assert_eq!(serde_json::to_string(&MavModeFlag::empty()).unwrap(), r#""""#);
    assert_eq!(serde_json::from_str::<MavModeFlag>("0").unwrap(), MavModeFlag::empty());
    assert_eq!(serde_json::to_string(&MavState(200)).unwrap(), "200");
}

/// Writes a value for people and for programs, and reads it again.
fn survives<T: Debug + PartialEq + Serialize + for<'de> Deserialize<'de>>(value: &T) -> Value {
    let text = serde_json::to_string(value).unwrap();
    assert_eq!(&serde_json::from_str::<T>(&text).unwrap(), value, "{text}");
    let mut buffer = [0; 64];
    let bytes = postcard::to_slice(value, &mut buffer).unwrap();
    assert_eq!(&postcard::from_bytes::<T>(bytes).unwrap(), value, "{bytes:?}");
    serde_json::from_str(&text).unwrap()
}

#[test]
fn views_slots_and_rows_survive() {
    let status = Esc32Status::from_bits(0, 2).with_state(Esc32State::RUNNING).unwrap().with_rpm(6543).unwrap();
    let seen = survives(&status);
    assert_eq!((&seen["bits"], &seen["data_version"]), (&json!(status.bits()), &json!(2)));
    assert_eq!((&seen["state"], &seen["rpm"]), (&json!("ESC32_STATE_RUNNING"), &json!(6543)));
    assert_eq!((&seen["errors"], &seen["temperature"]), (&json!(0), &Value::Null));
    let seen = survives(&Esc { id: 3, age_ms: None, status: Some(status) });
    assert_eq!((&seen["id"], &seen["age_ms"], &seen["status"]["voltage"]), (&json!(3), &Value::Null, &json!(0.0)));
    survives(&Esc::default());

    let mut table = EscTable::new();
    let telemetry = AqEscTelemetry { seq: 1, num_motors: 1, num_in_seq: 1, escid: [1; 4], ..AqEscTelemetry::DEFAULT };
    assert_eq!(survives(&table.update(&telemetry)), json!("Complete"));
    assert_eq!(survives(table.get(1).unwrap())["silent"], json!(true));
    assert_eq!(survives(&table.counts())["cycles"], json!(1));
    assert_eq!(survives(&DisarmReason::CrossingTimeout), json!("CrossingTimeout"));
    assert_eq!(survives(&DisarmReason::Undefined(9)), json!({ "Undefined": 9 }));
}

#[test]
fn what_is_no_view_or_reason_is_an_error() {
    for wrong in
        ["{}", r#"{"bits":1}"#, r#"{"bits":1,"bits":1,"data_version":3}"#, r#"{"bits":-1,"data_version":3}"#, "3"]
    {
        assert!(serde_json::from_str::<Esc32Status>(wrong).is_err(), "{wrong}");
    }
    let told = r#"{"data_version":3,"rpm":1,"bits":7}"#;
    assert_eq!(serde_json::from_str::<Esc32Status>(told).unwrap(), Esc32Status::from_bits(7, 3), "the bits decide");
    for wrong in [r#""Ready""#, r#"{"Startup":1}"#, r#""Undefined""#, r#"{"Undefined":256}"#] {
        assert!(serde_json::from_str::<DisarmReason>(wrong).is_err(), "{wrong}");
    }
}
