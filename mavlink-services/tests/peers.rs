//! Stations of ours and vehicles that nobody here wrote: MAVSDK and pymavlink. Ignored unless asked for, since they are not at hand
//! everywhere: `tests/services/check.sh` in the repository runs them.
#![cfg(feature = "std")]
#![allow(clippy::expect_used, clippy::unwrap_used, clippy::panic, reason = "a part of tests")]

use std::env;
use std::process::{Child, Command, Stdio};
use std::time::{self, Duration};

use mavlink_services::common::{
    CommandLong, Common, MavAutopilot, MavCmd, MavMissionResult, MavMissionType, MavModeFlag, MavParamType,
    MavProtocolCapability, MavResult,
};
use mavlink_services::interval::Interval;
use mavlink_services::mission::{self, MissionItem};
use mavlink_services::param::{Listed, ParamValue};
use mavlink_services::{Error, Patience, Retry, Station, command, param};
use mavlink_wire::link::{Link, Options};
use mavlink_wire::{Dialect, Frame, Message, Sender};

/// A vehicle as a program.
struct Peer(Child);

impl Drop for Peer {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Starts a vehicle, and a station that has heard it.
fn meet(program: &str) -> (Station, Peer) {
    let options = Options::new(Common::TABLE, Sender::v2(255, 190));
    let link = Link::connect("udpin:127.0.0.1:0", options).unwrap();
    let port = link.local_addr().expect("a port").port();
    let script = format!("{}/../tests/services/{program}.py", env!("CARGO_MANIFEST_DIR"));
    let python = env::var("PEERS_PYTHON").expect("PEERS_PYTHON is a Python with mavsdk and pymavlink");
    let peer = Command::new(python)
        .arg(script)
        .arg(port.to_string())
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let peer = Peer(peer);
    let station = Station::over(link, Patience { connect: Duration::from_secs(30), ..Patience::DEFAULT }).unwrap();
    (station, peer)
}

/// `GLOBAL_POSITION_INT`.
const POSITION: u32 = 33;

/// Waits for a frame after which it is so.
fn until(station: &mut Station, what: &str, condition: impl Fn(&Station, &Frame<'_>) -> bool) {
    let end = time::Instant::now() + Duration::from_secs(10);
    while let Some(frame) = station.receive_until(end).unwrap() {
        if condition(station, &frame.as_frame()) {
            return;
        }
    }
    panic!("{what}: not within 10 s");
}

fn value(params: &[Listed], name: &str) -> ParamValue {
    params.iter().find(|param| param.name == name).unwrap_or_else(|| panic!("{name} is missing")).value.unwrap()
}

fn waypoints(count: u16) -> Vec<MissionItem> {
    let item = |seq: u16| {
        let at = MissionItem::at(MavCmd::NAV_WAYPOINT, 47.0 + f64::from(seq) / 1e4, 8.5, f32::from(seq));
        MissionItem { current: seq == 0, params: [f32::from(seq % 7), 1.0, 0.0, 0.0], ..at }
    };
    (0..count).map(item).collect()
}

/// Uploads, reads back, clears.
fn move_plan(station: &mut Station, plan: MavMissionType, items: &[MissionItem]) {
    assert_eq!(usize::from(station.upload_plan(plan, items, |_| {}).unwrap().count), items.len());
    let told = station.download_plan(plan, |_, _| {}).unwrap();
    // Which item is the current one is the vehicle's to say.
    let told: Vec<_> =
        told.iter().zip(items).map(|(told, sent)| MissionItem { current: sent.current, ..*told }).collect();
    assert_eq!(told, items, "{plan}");
}

#[test]
#[ignore = "needs MAVSDK"]
fn mavsdk_is_the_vehicle() {
    let (mut station, _peer) = meet("mavsdk_vehicle");
    let version = station.version().unwrap();
    assert!(version.capabilities.contains(MavProtocolCapability::MISSION_INT), "{version:?}");

    let params = station.params(|_, _| {}).unwrap();
    for index in 0..50_u8 {
        assert_eq!(value(&params, &format!("INT_{index}")), ParamValue::I32(i32::from(index) * 1_000_003 - 25));
        assert_eq!(value(&params, &format!("FLOAT_{index}")), ParamValue::F32(f32::from(index) / 8.0));
    }
    for set in [i32::MIN, -1_234_567, 16_777_217, i32::MAX] {
        assert_eq!(station.set_param("INT_7", set).unwrap(), ParamValue::I32(set));
        assert_eq!(station.param("INT_7").unwrap(), ParamValue::I32(set));
    }
    assert_eq!(station.set_param("FLOAT_3", 0.1).unwrap(), ParamValue::F32(0.1));
    assert!(matches!(station.param("NO_SUCH"), Err(Error::Param(_))));

    move_plan(&mut station, MavMissionType::MISSION, &waypoints(300));
    station.clear(MavMissionType::MISSION).unwrap();

    assert!(!station.heartbeat().base_mode.contains(MavModeFlag::SAFETY_ARMED));
    station.arm().unwrap();
    let takeoff = CommandLong { command: MavCmd::NAV_TAKEOFF, param7: 10.0, ..CommandLong::DEFAULT };
    station.command(&takeoff).unwrap();
    until(&mut station, "it is armed", |station, _| station.heartbeat().base_mode.contains(MavModeFlag::SAFETY_ARMED));
    station.set_interval(POSITION, Interval::Every(Duration::from_millis(100))).unwrap();
    until(&mut station, "it tells its position", |_, frame| frame.message_id() == POSITION);
    // MAVSDK does not answer what it does not know.
    station.patience().command.retry = Retry { timeout: Duration::from_millis(100), retries: 1 };
    let unknown = CommandLong { command: MavCmd(60_000), ..CommandLong::DEFAULT };
    let silent = station.command(&unknown).unwrap_err();
    assert!(matches!(silent, Error::Command { failure: command::Failure::Timeout { sent: 2, .. }, .. }), "{silent:?}");
}

/// An old vehicle: parameters cast to floats, `MISSION_REQUEST` and `MISSION_ITEM`, `AUTOPILOT_VERSION` by the old command.
#[test]
#[ignore = "needs pymavlink"]
fn pymavlink_is_the_vehicle() {
    let (mut station, _peer) = meet("pymavlink_vehicle");
    assert_eq!(station.heartbeat().autopilot, MavAutopilot::ARDUPILOTMEGA);
    assert_eq!(station.version().unwrap().uid, 7);

    let params = station.params(|_, _| {}).unwrap();
    assert_eq!(params.len(), 60);
    let expected = [
        ("FLOAT", ParamValue::F32(0.15)),
        ("UINT8", ParamValue::U8(200)),
        ("INT8", ParamValue::I8(-100)),
        ("UINT16", ParamValue::U16(60_000)),
        ("INT16", ParamValue::I16(-30_000)),
        ("UINT32", ParamValue::U32(16_777_216)),
        ("INT32", ParamValue::I32(-16_777_216)),
    ];
    for (name, is) in expected {
        assert_eq!(value(&params, name), is, "{name}");
    }
    assert_eq!(station.set_param("INT16", -12).unwrap(), ParamValue::I16(-12));
    assert_eq!(station.set_param("FLOAT", 0.25).unwrap(), ParamValue::F32(0.25));
    let inexact = station.set_param("INT32", 16_777_217).unwrap_err();
    assert!(matches!(inexact, Error::Param(param::Failure::Value(_))), "{inexact:?}");

    let items = waypoints(300);
    assert_eq!(station.upload(&items).unwrap().count, 300);
    let told = station.download().unwrap();
    assert_eq!(told.len(), 300);
    for (sent, told) in items.iter().zip(&told) {
        // A float keeps a position to about a metre.
        assert!(
            (sent.x - told.x).abs() < 100 && (sent.y - told.y).abs() < 100 && sent.z == told.z,
            "{sent:?} {told:?}"
        );
    }
    // By message: it refuses the command as one that it does not know.
    station.set_current(7).unwrap();
    station.clear(MavMissionType::MISSION).unwrap();
    assert_eq!(station.download().unwrap(), []);

    station.arm().unwrap();
    let mut heard = Vec::new();
    let calibrate = CommandLong { command: MavCmd::PREFLIGHT_CALIBRATION, param1: 1.0, ..CommandLong::DEFAULT };
    station.command_with(&calibrate, |told| heard.push(told.percent)).unwrap();
    assert_eq!(heard, [Some(0), Some(50)]);
    let refused = station.disarm().unwrap_err();
    let Error::Command { failure: command::Failure::Refused { result, .. }, text } = refused else {
        panic!("{refused:?}")
    };
    assert_eq!((result, text.as_deref()), (MavResult::DENIED, Some("in flight")));
    assert!(station.measure_time().unwrap().round_trip < Duration::from_secs(1));
}

/// PX4's habits: values bytewise, a hash before the list, `MISSION_REQUEST_INT`; and it does not tell its capabilities.
#[test]
#[ignore = "needs pymavlink"]
fn pymavlink_is_a_px4() {
    let (mut station, _peer) = meet("pymavlink_px4");
    let params = station.params(|_, _| {}).unwrap();
    assert_eq!(params.len(), 40);
    for (number, kind) in (0..40).zip([1, 2, 3, 4, 5, 6, 9].into_iter().cycle()) {
        let expected = ParamValue::from(number).to_kind(MavParamType(kind)).unwrap();
        assert_eq!(value(&params, &format!("P{number}")), expected);
    }
    for (name, set) in [("P0", 200.0), ("P1", -100.0), ("P5", -123_456_789.0), ("P6", 0.2)] {
        let expected = ParamValue::from(set).to_kind(value(&params, name).kind()).unwrap();
        assert_eq!(station.set_param(name, set).unwrap(), expected);
        assert_eq!(station.param(name).unwrap(), expected);
    }
    let too_large = station.set_param("P0", 256).unwrap_err();
    assert!(matches!(too_large, Error::Param(param::Failure::Value(param::ValueError::OutOfRange))), "{too_large:?}");
    for (plan, count) in [(MavMissionType::MISSION, 60), (MavMissionType::FENCE, 5), (MavMissionType::RALLY, 1)] {
        move_plan(&mut station, plan, &waypoints(count));
    }
    station.clear(MavMissionType::MISSION).unwrap();
    assert_eq!(station.download().unwrap(), []);
    let refused = station.clear(MavMissionType::RALLY).unwrap_err();
    assert!(matches!(refused, Error::Mission(mission::Failure::Refused(MavMissionResult::DENIED))), "{refused:?}");
}
