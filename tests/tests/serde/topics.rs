//! uORB messages: by names for people, as tuples else, every bit kept.

use mavlink_conformance::golden::definitions::TankStatus;
use mavlink_conformance::golden::topics::{Pump, PumpFaults, PumpStatus, PumpStatusMode, PumpStatusTrend, Topics};
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

#[test]
fn any_topic_of_a_package_has_its_name() {
    let pump = Topics::from(Pump { rpm: 7, ..Pump::UNKNOWN });
    let written = serde_json::to_string(&[pump, station().into()]).unwrap();
    assert!(written.starts_with(r#"[{"Pump":{"on":false,"timestamp":0,"rpm":7}},{"PumpStatus":{"#), "{written}");
    let [first, second]: [Topics; 2] = serde_json::from_str(&written).unwrap();
    assert_eq!(first, pump);
    assert_eq!(bytes(&second.try_into().unwrap()), bytes(&station()));
}

/// So that what was written is still read when a package has more topics.
#[test]
fn the_name_of_a_topic_is_in_postcard() {
    let (pump, mut buffer) = (Topics::from(Pump { rpm: 7, ..Pump::UNKNOWN }), [0; 512]);
    let written = postcard::to_slice(&pump, &mut buffer).unwrap();
    assert!(written.starts_with(b"\x04Pump"), "{written:?}");
    assert_eq!(postcard::from_bytes(written), Ok(pump));
    assert!(postcard::from_bytes::<Topics>(b"\x04Tank\0\0\0").is_err());
    assert!(postcard::from_bytes::<Topics>(b"\x04Pump").is_err());
}

#[test]
fn another_topic_is_refused_with_those_that_there_are() {
    let refused = |text| serde_json::from_str::<Topics>(text).unwrap_err().to_string();
    assert!(refused(r#"{"Tank": {}}"#).starts_with("unknown variant `Tank`, expected `Pump` or `PumpStatus`"));
    assert!(refused(r#"{"Pump": {"on": true, "rpm": 1}}"#).starts_with("missing field `timestamp`"));
}
