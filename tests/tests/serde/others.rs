//! JSON that others write: rust-mavlink, mavlink2rest, `mavgen decode`.

use super::*;

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
pub(super) fn decoded() -> Vec<(Autoquad, Value)> {
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
