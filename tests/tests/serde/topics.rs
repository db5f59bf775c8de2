//! uORB messages: by names for people, as tuples else, every bit kept.

use mavlink_conformance::golden::definitions::TankStatus;
use mavlink_conformance::golden::topics::{PumpFaults, PumpStatus, PumpStatusMode, PumpStatusTrend};
use mavlink_wire::Chars;
use mavlink_wire::uorb::Topic;
use serde_json::json;

fn station() -> PumpStatus {
    let mut station = PumpStatus {
        timestamp: u64::MAX,
        mode: PumpStatusMode::FILL,
        trend: PumpStatusTrend::FALLING,
        faults: PumpFaults::HOT | PumpFaults::from_bits_retain(64),
        level: f32::from_bits(0x7fc0_0001),
        latitude: f64::NEG_INFINITY,
        name: Chars::truncated("north"),
        open: true,
        ..PumpStatus::UNKNOWN
    };
    station.pumps[2].rpm = 7;
    station
}

/// NaN is not itself: the bytes are compared.
fn bytes(station: &PumpStatus) -> Vec<u8> {
    station.to_cdr(&PumpStatus::MAIN, &mut [0; 256]).unwrap().to_vec()
}

#[test]
fn a_topic_in_json() {
    let written = serde_json::to_value(station()).unwrap();
    let pump = |rpm: u16| json!({"on": false, "timestamp": 0, "rpm": rpm});
    let expected = json!({
        "timestamp": u64::MAX, "mode": "MODE_FILL", "trend": "TREND_FALLING", "faults": "FAULT_HOT | 0x40",
        "level": "NaN(0x7fc00001)", "flow": [-1.0, -1.0], "latitude": "-Infinity", "pressure": 65535, "open": true,
        "running": [false, false, false], "name": "north", "type": 0,
        "modes": ["MODE_OFF", "MODE_OFF", "MODE_OFF", "MODE_OFF"],
        "pumps": [pump(0), pump(0), pump(7)], "spare": pump(0),
    });
    assert_eq!(written, expected);
    let read: PumpStatus = serde_json::from_str(&written.to_string()).unwrap();
    assert_eq!(bytes(&read), bytes(&station()));
    let mut short = written;
    short["pumps"] = json!([pump(0)]);
    assert!(serde_json::from_value::<PumpStatus>(short).is_err());
}

#[test]
fn a_topic_in_postcard() {
    let mut buffer = [0; 512];
    let written = postcard::to_slice(&station(), &mut buffer).unwrap();
    let read: PumpStatus = postcard::from_bytes(written).unwrap();
    assert_eq!(bytes(&read), bytes(&station()));
}

#[test]
fn arrays_of_any_length() {
    let mut tank = TankStatus { temperature: 20.0, ..TankStatus::UNKNOWN };
    tank.sensors.iter_mut().for_each(|sensor| sensor.value = 0.5);
    tank.history[39] = 1.25;
    let read: TankStatus = serde_json::from_str(&serde_json::to_string(&tank).unwrap()).unwrap();
    assert_eq!(read, tank);
    let mut buffer = [0; 512];
    assert_eq!(postcard::from_bytes::<TankStatus>(postcard::to_slice(&tank, &mut buffer).unwrap()), Ok(tank));
}
