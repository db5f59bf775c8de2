//! Every machine of the services, run through all that it can do: this program is not run, it links or it does not.

#![no_std]
#![no_main]

mod panic;
mod uart;

use core::hint::black_box;

use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{self, EXIT_SUCCESS};
use embedded_io::Read;
use mavlink_autoquad::wire::{Dialect, Frame, Message, Parser};
use mavlink_services::common::{AutopilotVersion, CommandLong, Common, Heartbeat, MavMissionType, MavResult};
use mavlink_services::heartbeat::{Beacon, Monitor};
use mavlink_services::interval::{self, Interval, Stream};
use mavlink_services::mission::{self, MissionItem, Plan, PlanStore};
use mavlink_services::param::{self, Encoding, Name, Param};
use mavlink_services::vehicle::{Event, Vehicle};
use mavlink_services::{Address, Instant, Retry, Service, command, timesync};

use uart::Uart;

const STATION: Address = Address::EVERYBODY;

#[entry]
fn main() -> ! {
    let mut parser = Parser::new(Common::TABLE);
    let mut bytes = [0; 64];
    let read = Uart::new().read(&mut bytes).unwrap_or(0);
    let mut chunk = bytes.get(..read).unwrap_or_default();
    while let Some(frame) = parser.next(&mut chunk) {
        let now = Instant::from_nanos(black_box(7));
        fly(&frame, now);
        ask(&frame, now);
        move_plans(&frame, now);
    }
    debug::exit(EXIT_SUCCESS);
    loop {
        core::hint::spin_loop();
    }
}

/// What a loop does with a machine.
fn step<S: Service>(mut service: S, frame: &Frame<'_>, now: Instant) {
    service.handle(frame, now);
    while let Some(event) = service.next_event(now, |message| {
        black_box(message);
    }) {
        black_box(&event);
    }
    black_box(service.deadline());
}

fn fly(frame: &Frame<'_>, now: Instant) {
    let plan = || Plan::new([MissionItem::DEFAULT; 4], [MissionItem::DEFAULT; 4]);
    let plans = PlanStore { mission: plan(), fence: plan(), rally: plan() };
    let streams = [Stream { message_id: Heartbeat::ID, default: None, shortest: black_box(now) - Instant::ZERO }];
    let params = (Encoding::Bytewise, [Param::new("RATE_P", 0.2_f32)]);
    let mut vehicle = Vehicle::new(black_box(STATION), Beacon::from(Heartbeat::DEFAULT), streams, params, plans);
    vehicle.handle(frame, now);
    while let Some(event) = vehicle.next_event(now, |message| {
        black_box(message);
    }) {
        if let Event::Command(request) = event {
            vehicle.commands.progress(request.ticket, black_box(Some(3)), now);
            vehicle.commands.finish(request.ticket, black_box(MavResult::ACCEPTED), now);
        }
    }
    vehicle.plans.reached(black_box(1));
    vehicle.plans.set_current(black_box(1));
    vehicle.params.announce(black_box(1));
    black_box(vehicle.deadline());
    step(Monitor::<4>::new(), frame, now);
}

fn ask(frame: &Frame<'_>, now: Instant) {
    let (own, peer) = (black_box(STATION), black_box(STATION));
    if let Ok(mut send) = command::Send::new(own, peer, command::Options::DEFAULT, &CommandLong::DEFAULT, now) {
        send.cancel(black_box(now));
        step(send, frame, now);
    }
    step(command::Fetch::<AutopilotVersion>::new(own, peer, Retry::DEFAULT, 0.0, now), frame, now);
    let every = Interval::Every(now - Instant::ZERO);
    step(interval::set(own, peer, command::Options::DEFAULT, (black_box(33), every), now), frame, now);
    step(interval::Get::new(own, peer, Retry::DEFAULT, black_box(33), now), frame, now);
    let offset = timesync::Offset { nanos: black_box(-7), round_trip: now - Instant::ZERO };
    black_box((offset.peer_nanos(now), offset.to_own(black_box(7))));
    step(timesync::Measure::new(own, peer, black_box(timesync::Options::DEFAULT), now), frame, now);
    for encoding in [Encoding::Bytewise, Encoding::Cast] {
        let access = param::Access::new(own, peer, encoding);
        let name: Name = black_box(Name::default());
        step(param::List::new(access, [0; 128], now), frame, now);
        step(param::Read::new(access, param::Which::Name(name), now), frame, now);
        step(param::Write::new(access, name, black_box(0.2), now), frame, now);
    }
}

fn move_plans(frame: &Frame<'_>, now: Instant) {
    let access = mission::Access::new(black_box(STATION), black_box(STATION)).plan(black_box(MavMissionType::FENCE));
    let items = [MissionItem::at(black_box(MissionItem::DEFAULT).command, black_box(47.0), black_box(8.0), 10.0); 3];
    step(mission::Upload::new(access, items, now), frame, now);
    step(mission::Upload::part(access, black_box(3), items, now), frame, now);
    step(mission::Download::new(access, now), frame, now);
    step(mission::Clear::new(access, now), frame, now);
}
