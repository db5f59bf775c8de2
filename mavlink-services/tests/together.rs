//! Several operations at once, of one station with one vehicle that answers all of it, over a bad link: none is an answer to another.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a part of tests")]

mod plans;
mod simulated;

use std::ops::ControlFlow;
use std::time::Duration;

use mavlink_services::common::{Heartbeat, MavCmd, MavMissionType};
use mavlink_services::heartbeat::Beacon;
use mavlink_services::mission::{self, Download, MissionItem, Plan, PlanStore, Plans, Replaced, Upload};
use mavlink_services::param::{self, Encoding, List, Name, Param, ParamValue, Write};
use mavlink_services::vehicle::{Event, Vehicle};
use mavlink_services::{Instant, Operation, Output, Retry, Service, Update, earliest};
use mavlink_wire::{Frame, Message};
use plans::{access, items};
use simulated::{Simulation, Weather, component, station};

type Plane = Vehicle<Vec<Param>, PlanStore<Vec<MissionItem>>, 0>;

/// What a station does at once.
struct Together {
    list: List<[u8; 16]>,
    write: Write,
    fence: Upload<Vec<MissionItem>>,
    mission: Download,
    /// Items of the mission that have come, and operations that have ended well.
    fetched: Vec<MissionItem>,
    done: u8,
}

impl Service for Together {
    type Event = ();

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        self.list.handle(frame, now);
        self.write.handle(frame, now);
        self.fence.handle(frame, now);
        self.mission.handle(frame, now);
    }

    fn poll(&mut self, now: Instant) -> Option<Output<()>> {
        let Self { list, write, fence, mission, fetched, done } = self;
        step(list, now, done, |_| {})
            .or_else(|| step(write, now, done, |_| {}))
            .or_else(|| step(fence, now, done, |_| {}))
            .or_else(|| step(mission, now, done, |told| fetched.push(told.item)))
    }

    fn deadline(&self) -> Option<Instant> {
        let params = earliest(self.list.deadline(), self.write.deadline());
        earliest(params, earliest(self.fence.deadline(), self.mission.deadline()))
    }
}

/// What one of them wants to be sent.
fn step<O: Operation>(
    operation: &mut O,
    now: Instant,
    done: &mut u8,
    mut told: impl FnMut(O::Progress),
) -> Option<Output<()>>
where
    O::Failure: std::fmt::Debug,
{
    while let Some(output) = operation.poll(now) {
        match output {
            Output::Send(message) => return Some(Output::Send(message)),
            Output::Event(Update::Progress(progress)) => told(progress),
            Output::Event(Update::Done(end)) => {
                assert!(end.is_ok(), "{:?}", end.err());
                *done += 1;
                // Somebody looks whether all have ended.
                return Some(Output::Event(()));
            }
        }
    }
    None
}

fn plane(mission: &[MissionItem]) -> Plane {
    let table: Vec<_> = (0..100_u16).map(|number| Param::new(&format!("P{number}"), number)).collect();
    let plan = || Plan::new(vec![MissionItem::DEFAULT; 50], vec![MissionItem::DEFAULT; 50]);
    let mut store = PlanStore { mission: plan(), fence: plan(), rally: plan() };
    let count = u16::try_from(mission.len()).unwrap();
    store.begin(MavMissionType::MISSION, Replaced::All { count }).unwrap();
    for (seq, item) in (0..).zip(mission) {
        store.put(MavMissionType::MISSION, seq, *item).unwrap();
    }
    store.commit(MavMissionType::MISSION).unwrap();
    let beacon = Beacon::new(&Heartbeat::DEFAULT).unwrap();
    Vehicle::new(component(), beacon, [], (Encoding::Bytewise, table), store)
}

#[test]
fn operations_at_once_do_not_disturb_each_other() {
    for seed in 0..20 {
        let mission = items(30, 7);
        let mut vehicle = plane(&mission);
        let mut simulation = Simulation::new(seed, Weather::BAD);
        let params = param::Access::new(station(), component(), Encoding::Bytewise);
        let fence = vec![MissionItem::at(MavCmd::NAV_FENCE_CIRCLE_INCLUSION, 47.0, 8.0, 0.0); 20];
        // Six questions are all lost once in 450 times: that is not what is tested.
        let patient =
            |access: mission::Access| mission::Access { retry: Retry { retries: 20, ..access.retry }, ..access };
        let params = param::Access { retry: Retry { retries: 20, ..params.retry }, ..params };
        let mut all = Together {
            list: List::new(params, [0; 16], simulation.now),
            write: Write::new(params, Name::truncated("P7"), 4711, simulation.now),
            fence: Upload::new(patient(access(MavMissionType::FENCE)), fence.clone(), simulation.now),
            mission: Download::new(patient(access(MavMissionType::MISSION)), simulation.now),
            fetched: vec![],
            done: 0,
        };
        let mut set = 0;
        let ended = simulation.run(
            (&mut all, &mut |all, (), _| {
                if all.done == 4 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            }),
            (&mut vehicle, &mut |_, event, _| set += usize::from(matches!(event, Event::Param(_)))),
            Duration::from_secs(600),
        );
        assert_eq!((ended, all.done), (ControlFlow::Break(()), 4), "seed {seed}");
        assert!(set > 0 && vehicle.params.parameters().iter().any(|param| param.value == ParamValue::U16(4711)));
        let fetched: Vec<_> = all.fetched.iter().map(|item| MissionItem { current: false, ..*item }).collect();
        assert_eq!(fetched, mission, "seed {seed}");
        assert_eq!(vehicle.plans.plans().fence.items(), fence, "seed {seed}");
        assert_eq!(vehicle.plans.plans().mission.items(), mission, "seed {seed}");
    }
}
