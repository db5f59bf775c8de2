//! Messages through JSON and through postcard: every payload comes back as it was, and what was written reads well.

mod errors;
mod others;
mod topics;
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
