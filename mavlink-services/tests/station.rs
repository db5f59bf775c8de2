//! The station over a real link, and a vehicle at its other end.
#![cfg(feature = "std")]

mod flying;

use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;
use std::time::{self, Duration};

use flying::{link, pair};
use mavlink_services::common::{
    self, CommandAck, CommandLong, Heartbeat, MavAutopilot, MavCmd, MavMissionResult, MavMissionType, MavParamError,
    MavResult, MavType, MissionAck, MissionCount,
};
use mavlink_services::interval::Interval;
use mavlink_services::mission::{self, MissionItem};
use mavlink_services::param::{self, ParamValue};
use mavlink_services::{Address, Error, Patience, Retry, Station, command};
use mavlink_wire::link::LinkError;
use mavlink_wire::{Encode, MAX_FRAME, Message, Sender, Targeted};

const HASTY: Patience = Patience {
    connect: Duration::from_secs(5),
    command: command::Options {
        retry: Retry { timeout: Duration::from_millis(400), retries: 1 },
        ..command::Options::DEFAULT
    },
    retry: Retry { timeout: Duration::from_millis(400), retries: 1 },
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
    station.set_current(4).unwrap();
    let told = station.download().unwrap();
    assert_eq!(told.iter().position(|item| item.current), Some(4));
    let beyond = station.set_current(5).unwrap_err();
    let Error::Command { failure: command::Failure::Refused { result: MavResult::DENIED, .. }, .. } = beyond else {
        panic!("{beyond:?}")
    };
    let fence = [MissionItem::at(MavCmd::NAV_FENCE_CIRCLE_INCLUSION, 47.0, 8.0, 0.0)];
    let mut progress = Vec::new();
    station.upload_plan(MavMissionType::FENCE, &fence, |sent| progress.push((sent.sent, sent.count))).unwrap();
    assert_eq!(progress, [(1, 1)]);
    station.clear(MavMissionType::FENCE).unwrap();
    assert_eq!(station.download_plan(MavMissionType::FENCE, |_, _| {}).unwrap(), []);
    assert_eq!(station.download().unwrap().len(), 5);

    station.set_current(3).unwrap();

    let calibrate = CommandLong { command: MavCmd::PREFLIGHT_CALIBRATION, ..CommandLong::DEFAULT };
    let mut reports = 0;
    let stopped = station.command_while(&calibrate, |told| {
        reports += 1;
        assert_eq!(told.percent, Some(1));
        reports < 2
    });
    let Err(Error::Command { failure: command::Failure::Refused { result, .. }, .. }) = stopped else {
        panic!("{stopped:?}")
    };
    assert_eq!((result, reports), (MavResult::CANCELLED, 2));

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

/// Somebody else on the link, who answers everything at once and all the time: with other values, for others, and for this station.
fn babble(station: SocketAddr, stop: &AtomicBool) {
    let link = link(&format!("udpout:{station}"), 9);
    let accepted = CommandAck { command: MavCmd::COMPONENT_ARM_DISARM, ..CommandAck::DEFAULT };
    let param_id = param::Name::truncated("RATE_P");
    let param = common::ParamValue { param_id, param_value: 9.0, param_count: 9999, ..common::ParamValue::DEFAULT };
    let beat = Heartbeat { autopilot: MavAutopilot::PX4, ..Heartbeat::DEFAULT };
    while !stop.load(Ordering::Relaxed) {
        let messages: [&dyn Encode; 6] = [
            &accepted,
            &CommandAck { target_system: 255, target_component: 1, ..accepted },
            &param,
            &MissionCount { count: u16::MAX, ..MissionCount::DEFAULT }.to(255, 1),
            &MissionAck { r#type: MavMissionResult::ERROR, ..MissionAck::DEFAULT }.to(255, 1),
            &beat,
        ];
        for message in messages {
            let _ = link.send(message);
        }
        // A hundred thousand frames in a second, if the machine can: but the others have to come through the same socket.
        thread::sleep(Duration::from_micros(50));
    }
}

/// Ends the babble, also when the test fails.
struct End<'s>(&'s AtomicBool);

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

#[test]
fn who_else_is_on_the_link_disturbs_nothing() {
    let (link, _vehicle) = pair();
    let address = link.local_addr().unwrap();
    let mut station = Station::over(link, Patience::DEFAULT).unwrap();
    let stop = AtomicBool::new(false);
    thread::scope(|scope| {
        scope.spawn(|| babble(address, &stop));
        let _end = End(&stop);
        assert_eq!(station.params(|_, _| {}).unwrap().len(), 3);
        assert_eq!(station.set_param("RATE_P", 0.3).unwrap(), ParamValue::F32(0.3));
        let items = [MissionItem::at(MavCmd::NAV_WAYPOINT, 47.0, 8.0, 10.0); 8];
        assert_eq!(station.upload(&items).unwrap().count, 8);
        assert_eq!(station.download().unwrap().len(), 8);
        assert!(matches!(station.arm(), Err(Error::Command { failure: command::Failure::Refused { .. }, .. })));
        assert_eq!((station.vehicle(), station.heartbeat().autopilot), (Address::new(1, 1), MavAutopilot::AUTOQUAD));
    });
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

#[test]
fn a_vehicle_of_mavlink_1_has_no_fence_that_could_be_taken_for_its_mission() {
    let ours = link("udpin:127.0.0.1:0", 255);
    let to = ours.local_addr().unwrap();
    let silent = std::net::UdpSocket::bind("127.0.0.1:0").unwrap();
    let beat = Heartbeat { r#type: MavType::QUADROTOR, ..Heartbeat::DEFAULT };
    let mut buffer = [0; MAX_FRAME];
    silent.send_to(Sender::v1(1, 1).encode(&beat, &mut buffer).unwrap(), to).unwrap();
    let mut station = Station::over(ours, HASTY).unwrap();
    let fence = [MissionItem::at(MavCmd::NAV_FENCE_CIRCLE_INCLUSION, 47.0, 8.0, 0.0)];
    let refused = station.upload_plan(MavMissionType::FENCE, &fence, |_| {}).unwrap_err();
    assert!(matches!(refused, Error::Mission(mission::Failure::Version1)), "{refused:?}");
    let refused = station.clear(MavMissionType::FENCE).unwrap_err();
    assert!(matches!(refused, Error::Mission(mission::Failure::Version1)), "{refused:?}");
}
