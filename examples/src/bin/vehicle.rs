//! A simulated AutoQuad that answers ground stations: heartbeat, commands, message intervals, parameters, plans, time.
//!
//! `vehicle [ADDRESS]` sends to `udpout:127.0.0.1:14550` unless told otherwise, until it is stopped.

use std::error::Error;
use std::process::ExitCode;
use std::time::{self, Duration};

use mavlink_autoquad::autoquad::{self as aq, MavProtocolCapability as Capability};
use mavlink_autoquad::wire::link::{Link, Options};
use mavlink_autoquad::wire::{Dialect, Encode, Message, Sender};
use mavlink_services::common::{MavCmd, MavResult};
use mavlink_services::heartbeat::Beacon;
use mavlink_services::interval::Stream;
use mavlink_services::mission::{MissionItem, Plan, PlanStore};
use mavlink_services::param::{Encoding, Param};
use mavlink_services::vehicle::{Event, Vehicle};
use mavlink_services::{Address, Instant, Service, command};

const DISARMED: aq::Heartbeat = aq::Heartbeat {
    r#type: aq::MavType::QUADROTOR,
    autopilot: aq::MavAutopilot::AUTOQUAD,
    system_status: aq::MavState::STANDBY,
    ..aq::Heartbeat::DEFAULT
};
const ARMED: aq::Heartbeat =
    aq::Heartbeat { system_status: aq::MavState::ACTIVE, base_mode: aq::MavModeFlag::SAFETY_ARMED, ..DISARMED };
/// What is sent, and how often in a second; 0 is when asked for.
const SENT: [(u32, u32); 3] =
    [(aq::GlobalPositionInt::ID, 5), (aq::ExtendedSysState::ID, 2), (aq::AutopilotVersion::ID, 0)];
/// Metres per second.
const CLIMB: f32 = 5.0;

/// The protocols, and what flies.
struct AutoQuad {
    services: Vehicle<Vec<Param>, PlanStore<Vec<MissionItem>>, 3>,
    /// Metres above home, as it is and as it should be.
    height: f32,
    target: f32,
    takeoff: Option<command::Ticket>,
    moved: Instant,
}

impl AutoQuad {
    fn new() -> Result<Self, Box<dyn Error>> {
        let streams = SENT.map(|(message_id, rate)| {
            let default = Duration::from_secs(1).checked_div(rate);
            Stream { message_id, default, shortest: Duration::from_millis(20) }
        });
        let mut params =
            vec![Param::new("RATE_P", 0.15_f32), Param::new("RATE_D", 0.003_f32), Param::new("MOTORS", 4_u8)];
        params.extend([Param::new("TRIM", -3_i8), Param::new("PWM_MAX", 1950_u16), Param::new("LEVEL", -250_i16)]);
        params.extend([Param::new("BAUD", 115_200_u32), Param::new("OFFSET", -70_000_i32)]);
        let plan = || Plan::new(vec![MissionItem::DEFAULT; 512], vec![MissionItem::DEFAULT; 512]);
        let plans = PlanStore { mission: plan(), fence: plan(), rally: plan() };
        let (own, params) = (Address::new(1, 1), (Encoding::Bytewise, params));
        let services = Vehicle::new(own, Beacon::new(&DISARMED)?, streams, params, plans);
        Ok(Self { services, height: 0.0, target: 0.0, takeoff: None, moved: Instant::ZERO })
    }

    /// Carries out a command, or begins to.
    fn obey(&mut self, request: &command::Request, now: Instant) -> Option<MavResult> {
        let [first, ..] = request.command.params();
        match request.command.command() {
            MavCmd::COMPONENT_ARM_DISARM if self.height > 0.0 => return Some(MavResult::DENIED),
            MavCmd::COMPONENT_ARM_DISARM => {
                self.services.beacon.set(if first == 1.0 { &ARMED } else { &DISARMED }).ok()?;
            }
            MavCmd::NAV_TAKEOFF if self.services.beacon.heartbeat().base_mode.is_empty() => {
                return Some(MavResult::TEMPORARILY_REJECTED);
            }
            MavCmd::NAV_TAKEOFF => {
                (self.target, self.takeoff) = (10.0, Some(request.ticket));
                self.services.commands.progress(request.ticket, Some(0), now);
                return None;
            }
            MavCmd::NAV_LAND | MavCmd::NAV_RETURN_TO_LAUNCH => self.target = 0.0,
            MavCmd::MISSION_START => self.services.plans.set_current(0),
            _ => return Some(MavResult::UNSUPPORTED),
        }
        Some(MavResult::ACCEPTED)
    }

    /// Climbs and sinks, and reports how far the takeoff is.
    fn fly(&mut self, now: Instant) {
        let step = CLIMB * (now - self.moved).as_secs_f32();
        (self.height, self.moved) = (self.height + (self.target - self.height).clamp(-step, step), now);
        let percent = (self.height / self.target * 100.0) as u8;
        match self.takeoff {
            Some(ticket) if percent >= 100 => {
                self.services.commands.finish(ticket, MavResult::ACCEPTED, now);
                self.takeoff = None;
            }
            Some(ticket) => drop(self.services.commands.progress(ticket, Some(percent), now)),
            None => {}
        }
    }

    fn message(&self, message_id: u32) -> Box<dyn Encode> {
        let relative_alt = (self.height * 1000.0) as i32;
        match message_id {
            aq::GlobalPositionInt::ID => Box::new(aq::GlobalPositionInt {
                lat: 473_977_420,
                lon: 85_455_940,
                alt: 408_000 + relative_alt,
                relative_alt,
                ..aq::GlobalPositionInt::DEFAULT
            }),
            aq::ExtendedSysState::ID => {
                let landed = relative_alt == 0;
                let landed_state = if landed { aq::MavLandedState::ON_GROUND } else { aq::MavLandedState::IN_AIR };
                Box::new(aq::ExtendedSysState { landed_state, ..aq::ExtendedSysState::DEFAULT })
            }
            _ => {
                let plans = Capability::MISSION_INT | Capability::MISSION_FENCE | Capability::MISSION_RALLY;
                let capabilities = plans | Capability::PARAM_ENCODE_BYTEWISE | Capability::MAVLINK2;
                let flight_sw_version = 0x0102_0300;
                Box::new(aq::AutopilotVersion { capabilities, flight_sw_version, ..aq::AutopilotVersion::DEFAULT })
            }
        }
    }
}

fn main() -> ExitCode {
    let Err(error) = run() else { return ExitCode::SUCCESS };
    eprintln!("vehicle: {error}");
    ExitCode::FAILURE
}

fn run() -> Result<(), Box<dyn Error>> {
    let address = std::env::args().nth(1).unwrap_or_else(|| "udpout:127.0.0.1:14550".into());
    let mut link =
        Link::connect(&address, Options::new(aq::Autoquad::TABLE, Sender::v2(1, aq::MavComponent::AUTOPILOT1)))?;
    let (mut vehicle, started) = (AutoQuad::new()?, time::Instant::now());
    loop {
        let now = Instant::ZERO + started.elapsed();
        while let Some(event) = vehicle.services.next_event(now, |message| drop(link.queue(message))) {
            match event {
                Event::Command(request) => {
                    if let Some(result) = vehicle.obey(&request, now) {
                        vehicle.services.commands.finish(request.ticket, result, now);
                    }
                }
                Event::Cancel(ticket) => drop(vehicle.services.commands.finish(ticket, MavResult::CANCELLED, now)),
                Event::Due(message_id) => drop(link.queue(&*vehicle.message(message_id))),
                other => println!("{other:?}"),
            }
        }
        // What was queued goes out at once.
        drop(link.flush());
        vehicle.fly(now);
        let next = vehicle.services.deadline().unwrap_or(now).min(now + Duration::from_millis(100));
        if let Some(frame) = link.receive_until(started + (next - Instant::ZERO))? {
            vehicle.services.handle(&frame, Instant::ZERO + started.elapsed());
        }
    }
}
