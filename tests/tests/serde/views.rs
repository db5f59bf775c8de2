//! Messages with their views: what overlays see in a message stands behind its fields, and is read over.

use std::fmt::Debug;

use mavlink_autoquad::autoquad::{
    AqEscTelemetry, AqGps, AqTelemetryF, Autoquad, Esc, Esc32State, Esc32Status, Heartbeat, MavAutopilot, Statustext,
};
use mavlink_conformance::golden::{view_floats, view_slots, view_switch};
use mavlink_wire::Message;
use mavlink_wire::generated::serde::Deserialize;
use mavlink_wire::serde::{Envelope, HasViews, Header, WithViews};
use serde_json::{Value, json};

use super::others::decoded;
use super::{BEAT, messages, same};

/// Writes a message with its views, checks that it is read as the message, and gives the views.
fn views<M: HasViews + Debug + PartialEq + for<'de> Deserialize<'de>>(message: &M) -> Value {
    let text = serde_json::to_string(&WithViews(message)).unwrap();
    assert_eq!(&serde_json::from_str::<M>(&text).unwrap(), message, "{text}");
    let mut written: Value = serde_json::from_str(&text).unwrap();
    let views = written.as_object_mut().unwrap().shift_remove("views").unwrap();
    let plain: Value = serde_json::from_str(&serde_json::to_string(message).unwrap()).unwrap();
    assert_eq!(written, plain, "beside the views, the message as it is written by itself");
    views
}

/// Holds what serde writes of a view against what `mavgen decode` does, which leaves out the bits and what a layout lacks, and
/// does not round to `f32`.
fn assert_agree(ours: &Value, theirs: &Value) {
    match (ours, theirs) {
        (Value::Object(ours), Value::Object(theirs)) => {
            theirs.iter().for_each(|(key, value)| assert_agree(&ours[key], value));
            for (key, value) in ours.iter().filter(|(key, _)| !theirs.contains_key(*key)) {
                assert!(value.is_null() || ["bits", "data_version"].contains(&key.as_str()), "{key}: {value}");
            }
        }
        (Value::Array(ours), Value::Array(theirs)) => {
            assert_eq!(ours.len(), theirs.len());
            ours.iter().zip(theirs).for_each(|(ours, theirs)| assert_agree(ours, theirs));
        }
        (Value::Number(number), Value::Number(exact)) if exact.is_f64() => {
            let (number, exact) = (number.as_f64().unwrap(), exact.as_f64().unwrap());
            assert!((number - exact).abs() <= exact.abs() * 1e-6, "{number} {exact}");
        }
        _ => assert_eq!(ours, theirs),
    }
}

#[test]
fn json_with_views_has_those_of_mavgen_decode() {
    let (mut with_views, mut without) = (0, 0);
    for (sent, line) in decoded() {
        let mut theirs = line["views"].as_object().unwrap().clone();
        // A parameter's type is no matter of an overlay.
        theirs.shift_remove("parameter");
        // NaN is not equal to itself, so the message is compared in `messages_with_views_are_read`.
        let text = serde_json::to_string(&WithViews(&sent)).unwrap();
        let written: Value = serde_json::from_str(&text).unwrap();
        let ours = written["views"].as_object().unwrap();
        assert!(ours.keys().eq(theirs.keys()), "{text}");
        assert_agree(&written["views"], &Value::Object(theirs));
        *if ours.is_empty() { &mut without } else { &mut with_views } += 1;
    }
    assert!(with_views >= 2 && without >= 2, "{with_views} {without}");
}

#[test]
fn messages_with_views_are_read() {
    let mut buffers = [[0; 1024]; 2];
    for message in messages() {
        let text = serde_json::to_string(&WithViews(&message)).unwrap();
        same(&message, &serde_json::from_str(&text).unwrap(), &text);
        let [ours, plain] = &mut buffers;
        let plain = postcard::to_slice(&message, plain).unwrap();
        assert_eq!(postcard::to_slice(&WithViews(&message), ours).unwrap(), plain, "no views for programs");
    }
}

#[test]
fn a_message_has_its_views_behind_its_fields() {
    let status = Esc32Status::from_bits(0, 2).with_state(Esc32State::RUNNING).unwrap().with_rpm(6543).unwrap();
    let mut telemetry = AqEscTelemetry::DEFAULT;
    telemetry.push_esc(Esc { id: 3, age_ms: Some(20), status: Some(status) }).unwrap();
    telemetry.push_esc(Esc { id: 4, age_ms: None, status: None }).unwrap();
    let seen = views(&telemetry);
    assert!(seen.as_object().unwrap().keys().eq(["escs", "legacy_escs"]));
    let [first, second] = &seen["escs"].as_array().unwrap()[..] else { panic!("two are in use") };
    assert_eq!((&first["id"], &first["age_ms"], &first["status"]["rpm"]), (&json!(3), &json!(20), &json!(6543)));
    assert_eq!(first["status"]["state"], "ESC32_STATE_RUNNING");
    assert_eq!(second, &json!({ "id": 4, "age_ms": null, "status": null }));
    assert_eq!(seen, views(&Autoquad::from(telemetry)), "the enum has the same");

    assert_eq!(views(&Statustext::DEFAULT), json!({}));
    assert_eq!(views(&Autoquad::from(Statustext::DEFAULT)), json!({}));
}

#[test]
fn views_under_a_condition_are_left_out_where_it_does_not_hold() {
    let gps = views(&AqTelemetryF::DEFAULT.with_gps(AqGps { vel_d: -0.5, ..AqGps::default() }));
    assert!(gps.as_object().unwrap().keys().eq(["gps", "legacy_gps"]), "{gps}");
    assert_eq!((&gps["gps"]["vel_d"], &gps["gps"]["itow"]), (&json!(-0.5), &json!(0.0)));

    let named = views(&BEAT);
    assert!(named.as_object().unwrap().keys().eq(["nav_status"]) && named["nav_status"].is_string(), "{named}");
    assert_eq!(views(&Heartbeat { autopilot: MavAutopilot::PX4, ..BEAT }), json!({}));

    let report = view_switch::Report { layout: view_switch::Layout(77), word: 0xc807, other: 0xfffd };
    assert!(views(&report).as_object().unwrap().keys().eq(["details"]));
    let report = view_switch::Report { layout: view_switch::Layout::NEW, ..report };
    let seen = views(&report);
    assert!(seen.as_object().unwrap().keys().eq(["details", "other_details"]));
    assert_eq!((&seen["other_details"]["far"], &seen["other_details"]["near"]), (&json!(-1), &Value::Null));
}

#[test]
fn views_of_every_kind_are_written() {
    let seen = views(&view_floats::Gauges::DEFAULT);
    assert!(seen.as_object().unwrap().keys().eq(["joined", "gauges"]) && seen["gauges"].is_array(), "{seen}");
    let wheels = view_slots::Wheels { used: view_slots::Amount::BOTH, radius: 0.5, ..view_slots::Wheels::DEFAULT };
    assert_eq!(views(&wheels)["all"][1]["radius"], json!(0.5));
}

#[test]
fn a_message_carries_its_header_and_its_views() {
    let header: Header = serde_json::from_value(json!({ "system_id": 7, "component_id": 3, "sequence": 9 })).unwrap();
    let message = Autoquad::Heartbeat(BEAT);
    let text = serde_json::to_string(&Envelope::new(header, WithViews(&message))).unwrap();
    let read: Envelope<Autoquad> = serde_json::from_str(&text).unwrap();
    assert_eq!(read, Envelope::new(header, message));
    let written: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(written["message"]["views"], views(&message));
}
