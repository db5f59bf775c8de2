//! What is refused, and in what words.

use super::*;

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
