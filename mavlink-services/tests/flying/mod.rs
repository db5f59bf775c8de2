//! A vehicle in a thread, at the other end of a real link.
#![allow(dead_code, reason = "each test uses a part of it")]
#![allow(clippy::expect_used, clippy::panic, reason = "a part of tests")]

use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{self, Duration};

use mavlink_services::common::{
    AutopilotVersion, Common, Heartbeat, MavAutopilot, MavCmd, MavProtocolCapability, MavResult, MavSeverity, MavType,
    Statustext,
};
use mavlink_services::heartbeat::Beacon;
use mavlink_services::interval::Stream;
use mavlink_services::mission::{MissionItem, Plan, PlanStore};
use mavlink_services::param::{Encoding, Param};
use mavlink_services::vehicle::{Event, Vehicle};
use mavlink_services::{Address, Instant, Service};
use mavlink_wire::link::{Link, LinkError, Options};
use mavlink_wire::{Chars, Dialect, Message, Sender};

/// A vehicle in a thread, until it is dropped.
pub(crate) struct Running(Arc<AtomicBool>, Option<JoinHandle<()>>);

impl Drop for Running {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
        let _ = self.1.take().map(JoinHandle::join);
    }
}

pub(crate) fn link(address: &str, system_id: u8) -> Link {
    Link::connect(address, Options::new(Common::TABLE, Sender::v2(system_id, 1))).expect("a loopback link")
}

/// A station's link on a free port, and a vehicle that sends there.
pub(crate) fn pair() -> (Link, Running) {
    let station = link("udpin:127.0.0.1:0", 255);
    let vehicle = vehicle(station.local_addr().expect("a port"), Duration::ZERO);
    (station, vehicle)
}

/// A vehicle that sends there, and thinks so long about each frame.
pub(crate) fn vehicle(station: SocketAddr, thinks: Duration) -> Running {
    let to = format!("udpout:{station}");
    let stop = Arc::new(AtomicBool::new(false));
    let stopped = Arc::clone(&stop);
    let vehicle = thread::spawn(move || fly(link(&to, 1), &stopped, thinks));
    Running(stop, Some(vehicle))
}

/// Answers until it is told to stop; refuses to arm, with a reason.
fn fly(mut link: Link, stop: &AtomicBool, thinks: Duration) {
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
                Event::Command(request) if request.command.command() == MavCmd::PREFLIGHT_CALIBRATION => {
                    vehicle.commands.progress(request.ticket, Some(1), now);
                }
                Event::Cancel(ticket) => drop(vehicle.commands.finish(ticket, MavResult::CANCELLED, now)),
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
            Ok(Some(frame)) => {
                thread::sleep(thinks);
                vehicle.handle(&frame, Instant::ZERO + started.elapsed());
            }
            Ok(None) => {}
            Err(LinkError::Closed) => return,
            Err(error) => panic!("{error}"),
        }
    }
}
