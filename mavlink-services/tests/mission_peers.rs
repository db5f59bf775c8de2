//! Plans: each end before peers that refuse, and peers that do not play by the rules.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "a part of tests")]
#![expect(deprecated, reason = "old stations and vehicles know nothing newer")]

mod plans;
mod simulated;

use mavlink_services::common::{
    self, MavCmd, MavFrame, MavMissionResult, MavMissionType, MissionAck, MissionClearAll, MissionCount,
    MissionItemInt, MissionRequest, MissionRequestInt, MissionRequestList, MissionRequestPartialList,
    MissionWritePartialList,
};
use mavlink_services::mission::{
    Awaited, Component, ComponentEvent, Download, Failure, Item, MissionItem, PlanStore, Plans, Replaced, Sent, Upload,
};
use mavlink_services::{Instant, Service, Update};
use mavlink_wire::{Encode, Message, Targeted};
use plans::{Vehicle, access, items, vehicle};
use simulated::{COMPONENT, STATION, Simulation, Weather, component, finish, give, outputs, station};
use std::ops::ControlFlow;
use std::time::Duration;

/// What a vehicle answers to one message of somebody: its first acknowledgement.
fn answer(vehicle: &mut Vehicle, from: (u8, u8), message: &dyn Encode, now: Instant) -> Option<MavMissionResult> {
    give(vehicle, from, message, now);
    outputs(vehicle, now).0.iter().find_map(|sent| Some(sent.decode::<MissionAck>()?.r#type))
}

fn item(seq: u16) -> MissionItemInt {
    MissionItemInt { seq, command: MavCmd::NAV_WAYPOINT, ..MissionItemInt::DEFAULT }.to(1, 1)
}

#[test]
fn a_vehicle_refuses_with_a_reason_and_keeps_the_plan_that_it_has() {
    let (mut vehicle, now) = (vehicle(20), Instant::ZERO);
    let count = |count| MissionCount { count, ..MissionCount::DEFAULT }.to(1, 1);
    assert_eq!(answer(&mut vehicle, STATION, &count(2), now), None);
    answer(&mut vehicle, STATION, &item(0), now);
    // Another station has to wait, and may read.
    assert_eq!(answer(&mut vehicle, (7, 7), &count(1), now), Some(MavMissionResult::DENIED));
    assert_eq!(answer(&mut vehicle, (7, 7), &MissionClearAll::DEFAULT.to(1, 1), now), Some(MavMissionResult::DENIED));
    assert_eq!(answer(&mut vehicle, (7, 7), &item(1), now), None);
    give(&mut vehicle, (7, 7), &MissionRequestList::DEFAULT.to(1, 1), now);
    assert!(outputs(&mut vehicle, now).0[0].decode::<MissionCount>().is_some_and(|count| count.target_system == 7));
    assert_eq!(answer(&mut vehicle, STATION, &item(1), now), Some(MavMissionResult::ACCEPTED));
    assert_eq!(answer(&mut vehicle, STATION, &item(1), now), Some(MavMissionResult::ACCEPTED), "the word may be lost");
    assert_eq!(answer(&mut vehicle, (7, 7), &item(1), now), None);

    let part = MissionWritePartialList { start_index: 1, end_index: 2, ..MissionWritePartialList::DEFAULT }.to(1, 1);
    let other = MavMissionType(77);
    let cases: [(&dyn Encode, MavMissionResult); 7] = [
        (&count(21), MavMissionResult::NO_SPACE),
        (&count(u16::MAX), MavMissionResult::NO_SPACE),
        (&MissionCount { mission_type: other, ..count(1) }, MavMissionResult::UNSUPPORTED),
        (&MissionClearAll { mission_type: other, ..MissionClearAll::DEFAULT.to(1, 1) }, MavMissionResult::UNSUPPORTED),
        (
            &MissionRequestList { mission_type: other, ..MissionRequestList::DEFAULT.to(1, 1) },
            MavMissionResult::UNSUPPORTED,
        ),
        (&MissionRequestInt { seq: 2, ..MissionRequestInt::DEFAULT.to(1, 1) }, MavMissionResult::INVALID_SEQUENCE),
        (&part, MavMissionResult::INVALID_SEQUENCE),
    ];
    for (message, expected) in cases {
        assert_eq!(answer(&mut vehicle, STATION, message, now), Some(expected), "{}", message.info().name);
        assert_eq!(vehicle.plans().count(MavMissionType::MISSION), Ok(2));
    }
    // A target for a vehicle that is guided is no item.
    answer(&mut vehicle, STATION, &count(1), now);
    assert_eq!(answer(&mut vehicle, STATION, &MissionItemInt { current: 2, ..item(0) }, now), None);
    assert_eq!(vehicle.plans().count(MavMissionType::MISSION), Ok(2));
    // An item that is none, and a station that gives up.
    answer(&mut vehicle, STATION, &count(1), now);
    let nowhere = common::MissionItem {
        x: 1e9,
        frame: MavFrame::GLOBAL,
        command: MavCmd::NAV_LAND,
        ..common::MissionItem::DEFAULT
    };
    assert_eq!(answer(&mut vehicle, STATION, &nowhere.to(1, 1), now), Some(MavMissionResult::INVALID_PARAM5_X));
    answer(&mut vehicle, STATION, &count(1), now);
    let cancel = MissionAck { r#type: MavMissionResult::OPERATION_CANCELLED, ..MissionAck::DEFAULT }.to(1, 1);
    give(&mut vehicle, STATION, &cancel, now);
    let (sent, events) = outputs(&mut vehicle, now);
    let why = MavMissionResult::OPERATION_CANCELLED;
    let failed = ComponentEvent::Failed { plan: MavMissionType::MISSION, why, by: station() };
    assert_eq!((sent.len(), events, vehicle.deadline()), (0, vec![failed], None));
    assert_eq!(vehicle.plans().count(MavMissionType::MISSION), Ok(2));
}

/// Plans that refuse one kind of item.
struct Picky(PlanStore<Vec<MissionItem>>);

impl Plans for Picky {
    fn count(&self, plan: MavMissionType) -> Result<u16, MavMissionResult> {
        self.0.count(plan)
    }

    fn item(&self, plan: MavMissionType, seq: u16) -> Option<MissionItem> {
        self.0.item(plan, seq)
    }

    fn begin(&mut self, plan: MavMissionType, replaced: Replaced) -> Result<(), MavMissionResult> {
        self.0.begin(plan, replaced)
    }

    fn put(&mut self, plan: MavMissionType, seq: u16, item: MissionItem) -> Result<(), MavMissionResult> {
        if item.command == MavCmd::DO_CHANGE_SPEED {
            Err(MavMissionResult::UNSUPPORTED)
        } else {
            self.0.put(plan, seq, item)
        }
    }

    fn commit(&mut self, plan: MavMissionType) -> Result<(), MavMissionResult> {
        self.0.commit(plan)
    }

    fn abort(&mut self, plan: MavMissionType) {
        self.0.abort(plan);
    }
}

#[test]
fn a_refused_upload_and_a_cancelled_one_tell_why() {
    let mut simulation = Simulation::new(1, Weather::FINE);
    let mut picky = Component::new(component(), Picky(vehicle(20).plans().clone()));
    let mission = access(MavMissionType::MISSION);
    let mut upload = Upload::new(mission, items(5, 0), simulation.now);
    let (end, _, events) = finish(&mut simulation, &mut upload, &mut picky);
    let why = MavMissionResult::UNSUPPORTED;
    assert_eq!(end, Err(Failure::Refused(why)));
    assert_eq!(events, [ComponentEvent::Failed { plan: MavMissionType::MISSION, why, by: station() }]);

    let mut vehicle = vehicle(20);
    let mut upload = Upload::new(mission, items(20, 0), simulation.now);
    let mut end = None;
    let _ = simulation.run(
        (&mut upload, &mut |upload, event, _| match event {
            Update::Progress(Sent { sent, .. }) => {
                if sent == 5 {
                    upload.cancel();
                }
                ControlFlow::Continue(())
            }
            Update::Done(result) => {
                end = Some(result);
                ControlFlow::Continue(())
            }
        }),
        (&mut vehicle, &mut |_, _, _| {}),
        Duration::from_secs(1),
    );
    assert_eq!((end, vehicle.deadline()), (Some(Err(Failure::Cancelled)), None));
    assert_eq!(vehicle.plans().count(MavMissionType::MISSION), Ok(0));
    let mut download = Download::new(mission, simulation.now);
    download.cancel();
    assert_eq!(finish(&mut simulation, &mut download, &mut vehicle).0, Err(Failure::Cancelled));
}

#[test]
fn hostile_peers_get_neither_memory_nor_time() {
    let now = Instant::ZERO;
    let mission = access(MavMissionType::MISSION);
    // 65,535 items, where the program takes a thousand.
    let mut download = Download::new(mission, now).with_limit(1000);
    outputs(&mut download, now);
    give(
        &mut download,
        COMPONENT,
        &MissionCount { count: u16::MAX, ..MissionCount::DEFAULT }.to(STATION.0, STATION.1),
        now,
    );
    let (sent, events) = outputs(&mut download, now);
    assert_eq!(sent[0].decode::<MissionAck>().unwrap().r#type, MavMissionResult::NO_SPACE);
    assert_eq!(events, [Update::Done(Err(Failure::TooMany { count: u16::MAX }))]);
    // The first item again and again, an item that there is not, and success before it.
    let mut upload = Upload::new(mission, items(3, 0), now);
    outputs(&mut upload, now);
    let (mut now, mut end) = (now, None);
    while end.is_none() {
        for seq in [0, 3, u16::MAX] {
            give(
                &mut upload,
                COMPONENT,
                &MissionRequestInt { seq, ..MissionRequestInt::DEFAULT }.to(STATION.0, STATION.1),
                now,
            );
        }
        give(&mut upload, COMPONENT, &MissionAck::DEFAULT.to(STATION.0, STATION.1), now);
        end = outputs(&mut upload, now).1.into_iter().find_map(Update::done);
        now += Duration::from_millis(100);
    }
    assert_eq!(end, Some(Err(Failure::Timeout { awaited: Awaited::Request(1), asked: 6 })));
    assert!(now < Instant::from_millis(9200));
    // Another number of items in the midst of it, and items of another plan, index or system.
    let now = Instant::ZERO;
    let mut download = Download::new(mission, now);
    outputs(&mut download, now);
    let to_station = |count| MissionCount { count, ..MissionCount::DEFAULT }.to(STATION.0, STATION.1);
    give(&mut download, COMPONENT, &to_station(2), now);
    give(&mut download, COMPONENT, &to_station(9), now);
    outputs(&mut download, now);
    let item = MissionItemInt::DEFAULT.to(STATION.0, STATION.1);
    for (from, item) in [
        (COMPONENT, MissionItemInt { seq: 1, ..item }),
        (COMPONENT, MissionItemInt { mission_type: MavMissionType::FENCE, ..item }),
        (COMPONENT, item.to(9, 9)),
        ((1, 2), item),
        ((2, 1), item),
    ] {
        give(&mut download, from, &item, now);
        assert!(outputs(&mut download, now).1.is_empty());
    }
    give(&mut download, COMPONENT, &item, now);
    // It was not told yet: the next one counts as lost.
    give(&mut download, COMPONENT, &MissionItemInt { seq: 1, ..item }, now);
    let (sent, told) = outputs(&mut download, now);
    assert!(matches!(told[..], [Update::Progress(Item { received: 1, count: 2, .. })]));
    assert!(sent[0].decode::<MissionRequestInt>().is_some_and(|request| request.seq == 1));
}

#[test]
fn any_traffic_ends_in_bounded_time() {
    for seed in 0..300 {
        let mut random = simulated::Random::new(seed);
        let mut vehicle = vehicle(5);
        let mission = access(MavMissionType(random.below(2) as u8));
        let mut upload = Upload::new(mission, items(random.below(6) as u16, 0), Instant::ZERO);
        let mut download = Download::new(mission, Instant::ZERO);
        let (mut now, mut ended) = (Instant::ZERO, 0);
        while ended < 2 {
            let message = noise(&mut random);
            give(&mut upload, COMPONENT, &*message, now);
            give(&mut download, COMPONENT, &*message, now);
            give(&mut vehicle, STATION, &*message, now);
            ended += outputs(&mut upload, now).1.into_iter().filter_map(Update::done).count();
            ended += outputs(&mut download, now).1.into_iter().filter_map(Update::done).count();
            assert!(outputs(&mut vehicle, now).0.len() < 10);
            now += Duration::from_millis(random.below(100));
            assert!(now < Instant::from_millis(1_000_000), "seed {seed}");
        }
    }
}

/// Some message of the protocol, to anybody.
fn noise(random: &mut simulated::Random) -> Box<dyn Encode> {
    let (system, part) = ([1, 255, 0, 9][random.below(4) as usize], [1, 190, 0][random.below(3) as usize]);
    let mission_type = MavMissionType([0, 0, 1, 255][random.below(4) as usize]);
    let (seq, count) = (random.below(6) as u16, random.below(7) as u16);
    let r#type = MavMissionResult([0, 0, 13, 13, 13][random.below(5) as usize]);
    match random.below(9) {
        0 => Box::new(MissionCount { count, mission_type, ..MissionCount::DEFAULT }.to(system, part)),
        1 => Box::new(MissionRequestInt { seq, mission_type, ..MissionRequestInt::DEFAULT }.to(system, part)),
        2 => Box::new(MissionRequest { seq, mission_type, ..MissionRequest::DEFAULT }.to(system, part)),
        3 => Box::new(MissionItemInt { seq, mission_type, ..MissionItemInt::DEFAULT }.to(system, part)),
        4 => Box::new(
            common::MissionItem { seq, mission_type, x: f32::NAN, ..common::MissionItem::DEFAULT }.to(system, part),
        ),
        5 => Box::new(MissionAck { r#type, mission_type, ..MissionAck::DEFAULT }.to(system, part)),
        6 => Box::new(MissionClearAll { mission_type, ..MissionClearAll::DEFAULT }.to(system, part)),
        7 => Box::new(
            MissionRequestPartialList {
                start_index: seq as i16 - 1,
                end_index: count as i16 - 2,
                mission_type,
                ..MissionRequestPartialList::DEFAULT
            }
            .to(system, part),
        ),
        _ => Box::new(
            MissionWritePartialList {
                start_index: seq as i16 - 1,
                end_index: count as i16 - 2,
                mission_type,
                ..MissionWritePartialList::DEFAULT
            }
            .to(system, part),
        ),
    }
}
