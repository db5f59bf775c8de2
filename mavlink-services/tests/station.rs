//! The station over a real link, and a vehicle at its other end.
#![cfg(feature = "std")]
#![allow(clippy::expect_used, clippy::panic, reason = "a part of tests")]

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{self, Duration};

use mavlink_services::common::{
    AutopilotVersion, Common, Heartbeat, MavAutopilot, MavCmd, MavMissionResult, MavMissionType, MavParamError,
    MavProtocolCapability, MavResult, MavSeverity, MavType, Statustext,
};
use mavlink_services::heartbeat::Beacon;
use mavlink_services::interval::{Interval, Stream};
use mavlink_services::mission::{self, MissionItem, Plan, PlanStore};
use mavlink_services::param::{self, Encoding, Param, ParamValue};
use mavlink_services::vehicle::{Event, Vehicle};
use mavlink_services::{Address, Error, Instant, Patience, Retry, Service, Station, command};
use mavlink_wire::link::{Link, LinkError, Options};
use mavlink_wire::{Chars, Dialect, Message, Sender};

/// A vehicle in a thread, until it is dropped.
struct Running(Arc<AtomicBool>, Option<JoinHandle<()>>);

impl Drop for Running {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
        let _ = self.1.take().map(JoinHandle::join);
    }
}

fn link(address: &str, system_id: u8) -> Link {
    Link::connect(address, Options::new(Common::TABLE, Sender::v2(system_id, 1))).expect("a loopback link")
}

/// A station's link on a free port, and a vehicle that sends there.
fn pair() -> (Link, Running) {
    let station = link("udpin:127.0.0.1:0", 255);
    let to = format!("udpout:{}", station.local_addr().expect("a port"));
    let stop = Arc::new(AtomicBool::new(false));
    let stopped = Arc::clone(&stop);
    let vehicle = thread::spawn(move || fly(link(&to, 1), &stopped));
    (station, Running(stop, Some(vehicle)))
}

/// Answers until it is told to stop; refuses to arm, with a reason.
fn fly(mut link: Link, stop: &AtomicBool) {
    let beat = Heartbeat { r#type: MavType::QUADROTOR, autopilot: MavAutopilot::AUTOQUAD, ..Heartbeat::DEFAULT };
    let streams = [148, 0].map(|message_id| Stream { message_id, default: None, shortest: Duration::ZERO });
    let params = [Param::new("RATE_P", 0.15_f32), Param::new("MOTORS", 4_u8), Param::new("OFFSET", -70_000_i32)];
    let plan = || Plan::new([MissionItem::DEFAULT; 8], [MissionItem::DEFAULT; 8]);
    let plans = PlanStore { mission: plan(), fence: plan(), rally: plan() };
    let mut vehicle =
        Vehicle::new(Address::new(1, 1), Beacon::from(beat), streams, (Encoding::Bytewise, params), plans);
    let started = time::Instant::now();
    while !stop.load(Ordering::Relaxed) {
        let now = Instant::ZERO + started.elapsed();
        while let Some(event) = vehicle.next_event(now, |message| drop(link.send(message))) {
            match event {
                Event::Command(request) if request.command.command() == MavCmd::COMPONENT_ARM_DISARM => {
                    let text = Chars::truncated("the gyro is warm");
                    let _ = link.send(&Statustext { severity: MavSeverity::ERROR, text, ..Statustext::DEFAULT });
                    vehicle.commands.finish_with(request.ticket, MavResult::FAILED, 7, now);
                }
                Event::Command(request) => drop(vehicle.commands.finish(request.ticket, MavResult::UNSUPPORTED, now)),
                Event::Due(148) => {
                    let capabilities =
                        MavProtocolCapability::PARAM_ENCODE_BYTEWISE | MavProtocolCapability::MISSION_INT;
                    let _ = link.send(&AutopilotVersion { capabilities, uid: 7, ..AutopilotVersion::DEFAULT });
                }
                _ => {}
            }
        }
        let until = time::Instant::now() + Duration::from_millis(5);
        match link.receive_until(until) {
            Ok(Some(frame)) => vehicle.handle(&frame, Instant::ZERO + started.elapsed()),
            Ok(None) => {}
            Err(LinkError::Closed) => return,
            Err(error) => panic!("{error}"),
        }
    }
}

const HASTY: Patience = Patience {
    connect: Duration::from_secs(5),
    command: command::Options {
        retry: Retry { timeout: Duration::from_millis(50), retries: 1 },
        ..command::Options::DEFAULT
    },
    retry: Retry { timeout: Duration::from_millis(50), retries: 1 },
    ..Patience::DEFAULT
};

#[test]
fn a_station_does_all_of_it() {
    let (link, _vehicle) = pair();
    let mut station = Station::over(link, Patience::DEFAULT).unwrap();
    let frames = Arc::new(AtomicUsize::new(0));
    let counted = Arc::clone(&frames);
    station.listen(move |_| {
        counted.fetch_add(1, Ordering::Relaxed);
    });
    assert_eq!((station.vehicle(), station.heartbeat().r#type), (Address::new(1, 1), MavType::QUADROTOR));
    assert!(station.is_alive());
    assert_eq!(station.version().unwrap().uid, 7);

    let mut heard = Vec::new();
    let params = station.params(|received, count| heard.push((received, count))).unwrap();
    let values: Vec<_> = params.iter().map(|param| (param.name.to_str().unwrap(), param.value.unwrap())).collect();
    let expected =
        [("RATE_P", ParamValue::F32(0.15)), ("MOTORS", ParamValue::U8(4)), ("OFFSET", ParamValue::I32(-70_000))];
    assert_eq!(values, expected);
    assert_eq!(heard.last(), Some(&(3, 3)));
    assert_eq!(station.set_param("RATE_P", 0.2).unwrap(), ParamValue::F32(0.2));
    assert_eq!(station.param("RATE_P").unwrap(), ParamValue::F32(0.2));

    let items: Vec<_> = (0..5).map(|at| MissionItem::at(MavCmd::NAV_WAYPOINT, 47.0, f64::from(at), 10.0)).collect();
    assert_eq!(station.upload(&items).unwrap().count, 5);
    // The vehicle is at the first one.
    let told = [&[MissionItem { current: true, ..items[0] }], &items[1..]].concat();
    assert_eq!(station.download().unwrap(), told);
    let fence = [MissionItem::at(MavCmd::NAV_FENCE_CIRCLE_INCLUSION, 47.0, 8.0, 0.0)];
    let mut progress = Vec::new();
    station.upload_plan(MavMissionType::FENCE, &fence, |sent| progress.push((sent.sent, sent.count))).unwrap();
    assert_eq!(progress, [(1, 1)]);
    station.clear(MavMissionType::FENCE).unwrap();
    assert_eq!(station.download_plan(MavMissionType::FENCE, |_, _| {}).unwrap(), []);
    assert_eq!(station.download().unwrap().len(), 5);

    let every = Interval::Every(Duration::from_millis(20));
    station.set_interval(Heartbeat::ID, every).unwrap();
    assert_eq!(station.interval(0).unwrap(), every);
    let offset = station.measure_time().unwrap();
    assert!(offset.round_trip < Duration::from_secs(1));
    assert!(frames.load(Ordering::Relaxed) > 20);
}

#[test]
fn what_does_not_happen_has_its_reason() {
    let (link, vehicle) = pair();
    let mut station = Station::over(link, HASTY).unwrap();
    let Err(Error::Command { failure, text }) = station.arm() else { panic!("it was armed") };
    let (command, result) = (MavCmd::COMPONENT_ARM_DISARM, MavResult::FAILED);
    assert_eq!(failure, command::Failure::Refused { command, result, reason: 7, progress: None });
    assert_eq!(text.as_deref(), Some("the gyro is warm"));

    let said = |error: Error| error.to_string();
    assert_eq!(
        station.arm().map_err(said).unwrap_err(),
        "MAV_CMD_COMPONENT_ARM_DISARM was refused: MAV_RESULT_FAILED, reason 7; the vehicle says: the gyro is warm"
    );
    let missing = station.param("NO_SUCH").unwrap_err();
    assert!(matches!(missing, Error::Param(param::Failure::Refused(MavParamError::DOES_NOT_EXIST))), "{missing:?}");
    let inexact = station.set_param("MOTORS", 300).unwrap_err();
    assert!(matches!(inexact, Error::Param(param::Failure::Value(_))), "{inexact:?}");
    assert!(matches!(station.param("A_NAME_THAT_IS_TOO_LONG"), Err(Error::Name(_))));
    let items = [MissionItem::at(MavCmd::NAV_WAYPOINT, 47.0, 8.0, 10.0); 9];
    let full = station.upload(&items).unwrap_err();
    assert!(matches!(full, Error::Mission(mission::Failure::Refused(MavMissionResult::NO_SPACE))), "{full:?}");
    assert!(matches!(station.command(&Heartbeat::DEFAULT), Err(Error::NoCommand(_))));
    assert!(matches!(station.set_vehicle(Address::new(1, 0)), Err(Error::Nobody(_))));

    drop(vehicle);
    let silent = station.disarm().unwrap_err();
    assert!(matches!(silent, Error::Command { failure: command::Failure::Timeout { sent: 2, .. }, .. }), "{silent:?}");
    station.receive_until(time::Instant::now() + Duration::from_millis(20)).unwrap();
}

#[test]
fn without_a_vehicle_it_says_so() {
    let patience = Patience { connect: Duration::from_millis(50), ..Patience::DEFAULT };
    let Err(error) = Station::over(link("udpin:127.0.0.1:0", 255), patience) else { panic!("nobody is there") };
    assert!(matches!(error, Error::NoVehicle { .. }));
    assert!(error.to_string().starts_with("no vehicle has sent a heartbeat in 50ms"), "{error}");
    let Err(error) = Station::connect("udpinn:0.0.0.0:14550") else { panic!("that is no address") };
    assert!(matches!(error, Error::Link(LinkError::Address(_))), "{error:?}");
}
