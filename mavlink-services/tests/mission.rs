//! Plans: both ends, over links that are fine and bad.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "a part of tests")]
#![expect(deprecated, reason = "old stations and vehicles know nothing newer")]

mod plans;
mod simulated;

use mavlink_services::common::{
    CommandLong, MavCmd, MavMissionResult, MavMissionType, MavResult, MissionAck, MissionCount, MissionCurrent,
    MissionItemInt, MissionRequest, MissionRequestInt, MissionRequestPartialList,
};
use mavlink_services::mission::{
    Access, Awaited, Clear, ComponentEvent, Download, Failure, Plans, Sent, SetCurrent, Upload, Uploaded,
};
use mavlink_services::{Instant, Operation, Service, command};
use mavlink_wire::{Encode, Message, Targeted, Version};
use plans::{PLANS, access, fetched, items, stored, vehicle};
use simulated::{COMPONENT, STATION, Simulation, Weather, component, finish, give, outputs, station};

#[test]
fn three_plans_go_there_and_back_over_a_fine_link() {
    let (mut simulation, mut vehicle) = (Simulation::new(1, Weather::FINE), vehicle(300));
    for (plan, count) in PLANS.into_iter().zip([300, 7, 0]) {
        let mut upload = Upload::new(access(plan), items(count, 0), simulation.now);
        let (end, told, events) = finish(&mut simulation, &mut upload, &mut vehicle);
        let opaque_id = vehicle.plans().id(plan);
        assert_eq!(end, Ok(Uploaded { count, opaque_id }));
        assert_eq!(told.last(), (count > 0).then_some(&Sent { sent: count, count }));
        assert_eq!(events, [ComponentEvent::Replaced { plan, count, by: station() }]);
        assert_eq!(opaque_id == 0, count == 0);
    }
    let asked = simulation.sent::<MissionRequestInt>().len();
    assert_eq!((asked, simulation.sent::<MissionRequest>().len()), (307, 0), "each item is asked for once");
    for (plan, count) in PLANS.into_iter().zip([300, 7, 0]) {
        let mut download = Download::new(access(plan), simulation.now);
        let (end, told, events) = finish(&mut simulation, &mut download, &mut vehicle);
        assert_eq!(end.map(|end| (end.count, end.opaque_id)), Ok((count, vehicle.plans().id(plan))));
        assert_eq!((fetched(&told), events), (items(count, 0), vec![]));
        assert!(told.iter().enumerate().all(|(seq, item)| usize::from(item.seq) == seq && item.count == count));
    }
    assert_eq!(simulation.sent::<MissionAck>().len(), 6);
    let mut clear = Clear::new(access(MavMissionType::FENCE), simulation.now);
    let (end, _, events) = finish(&mut simulation, &mut clear, &mut vehicle);
    assert_eq!((end, events.len(), vehicle.plans().fence.items().len()), (Ok(()), 1, 0));
    assert_eq!(vehicle.plans().mission.items().len(), 300, "the others stay");
    let mut clear = Clear::new(access(MavMissionType::ALL), simulation.now);
    assert_eq!(finish(&mut simulation, &mut clear, &mut vehicle).0, Ok(()));
    assert!(PLANS.iter().all(|plan| vehicle.plans().count(*plan) == Ok(0)));
}

#[test]
fn over_a_bad_link_a_plan_arrives_whole_or_not_at_all_and_a_seed_decides() {
    let mut failures = 0;
    for seed in 0..50_u16 {
        let mut run = || {
            let (mut simulation, mut vehicle) = (Simulation::new(seed.into(), Weather::BAD), vehicle(100));
            for (turn, plan) in PLANS.into_iter().cycle().take(4).enumerate() {
                let (new, old) = (items(20 + seed, turn as i32), stored(&vehicle, plan));
                let mut upload = Upload::new(access(plan), &new, simulation.now);
                let uploaded = finish(&mut simulation, &mut upload, &mut vehicle).0;
                let now_there = stored(&vehicle, plan);
                match uploaded {
                    Ok(_) => assert_eq!(now_there, new, "seed {seed}"),
                    Err(failure) => assert!(matches!(failure, Failure::Timeout { .. }), "seed {seed}: {failure}"),
                }
                assert!(now_there == new || now_there == old, "seed {seed}: a mixture");
                let mut download = Download::new(access(plan), simulation.now);
                let (end, told, _) = finish(&mut simulation, &mut download, &mut vehicle);
                match end {
                    Ok(_) => assert_eq!(fetched(&told), stored(&vehicle, plan), "seed {seed}"),
                    Err(failure) => assert!(matches!(failure, Failure::Timeout { .. }), "seed {seed}: {failure}"),
                }
                failures += usize::from(uploaded.is_err()) + usize::from(end.is_err());
            }
            simulation.trace
        };
        assert_eq!(run(), run(), "seed {seed}");
    }
    assert!(failures < 40, "{failures} of 800 transfers fail");
}

#[test]
fn a_part_of_a_plan_goes_there_and_back() {
    let (mut simulation, mut vehicle) = (Simulation::new(1, Weather::FINE), vehicle(20));
    let mission = access(MavMissionType::MISSION);
    let mut upload = Upload::new(mission, items(20, 0), simulation.now);
    finish(&mut simulation, &mut upload, &mut vehicle).0.unwrap();
    let mut part = Upload::part(mission, 5, items(3, 1000), simulation.now);
    let (end, told, _) = finish(&mut simulation, &mut part, &mut vehicle);
    assert_eq!((end.map(|end| end.count), told.last().map(|sent| sent.count)), (Ok(3), Some(3)));
    let mut expected = items(20, 0);
    expected[5..8].copy_from_slice(&items(3, 1000));
    assert_eq!(stored(&vehicle, MavMissionType::MISSION), expected);
    let mut part = Download::part(mission, 4, 8, simulation.now);
    let (end, told, _) = finish(&mut simulation, &mut part, &mut vehicle);
    assert_eq!((end.map(|end| end.count), fetched(&told)), (Ok(5), expected[4..=8].to_vec()));
    // What the plan does not have.
    let mut part = Download::part(mission, 18, 20, simulation.now);
    assert_eq!(finish(&mut simulation, &mut part, &mut vehicle).0, Err(Failure::NoSuchItem { count: 20 }));
    let mut part = Upload::part(mission, 18, items(3, 0), simulation.now);
    let refused = Failure::Refused(MavMissionResult::INVALID_SEQUENCE);
    assert_eq!(finish(&mut simulation, &mut part, &mut vehicle).0, Err(refused));
    for (first, count) in [(32_760, 8), (0, 40_000)] {
        let mut part = Upload::part(mission, first, items(count, 0), simulation.now);
        assert_eq!(finish(&mut simulation, &mut part, &mut vehicle).0, Err(Failure::TooMany { count }));
    }
    assert_eq!(stored(&vehicle, MavMissionType::MISSION), expected);
    // Some stations ask for a part in one message.
    let ask =
        MissionRequestPartialList { start_index: 17, end_index: -1, ..MissionRequestPartialList::DEFAULT }.to(1, 1);
    give(&mut vehicle, STATION, &ask, simulation.now);
    let sent = outputs(&mut vehicle, simulation.now).0;
    let seqs: Vec<u16> = sent.iter().map(|sent| sent.decode::<MissionItemInt>().unwrap().seq).collect();
    assert_eq!(seqs, [17, 18, 19]);
}

#[test]
fn mavlink_1_has_missions() {
    let (mut simulation, mut vehicle) = (Simulation::new(1, Weather::FINE).v1(), vehicle(20));
    let mut upload = Upload::new(access(MavMissionType::MISSION), items(20, 0), simulation.now);
    assert!(finish(&mut simulation, &mut upload, &mut vehicle).0.is_ok());
    assert_eq!(stored(&vehicle, MavMissionType::MISSION), items(20, 0));
    // A message would not say that it is about the fence, and the vehicle would take it for the mission.
    for plan in [MavMissionType::FENCE, MavMissionType::RALLY, MavMissionType::ALL] {
        let v1 = Access { version: Version::V1, ..access(plan) };
        let mut upload = Upload::new(v1, items(20, 0), simulation.now);
        assert_eq!(finish(&mut simulation, &mut upload, &mut vehicle).0, Err(Failure::Version1));
        let mut download = Download::new(v1, simulation.now);
        assert_eq!(finish(&mut simulation, &mut download, &mut vehicle).0, Err(Failure::Version1));
        let mut clear = Clear::new(v1, simulation.now);
        assert_eq!(finish(&mut simulation, &mut clear, &mut vehicle).0, Err(Failure::Version1));
    }
    assert_eq!(stored(&vehicle, MavMissionType::MISSION), items(20, 0));
}

#[test]
fn a_command_sets_the_current_item() {
    let (mut simulation, mut vehicle) = (Simulation::new(1, Weather::FINE), vehicle(20));
    let mut upload = Upload::new(access(MavMissionType::MISSION), items(20, 0), simulation.now);
    finish(&mut simulation, &mut upload, &mut vehicle).0.unwrap();
    let mut commands = command::Component::<1>::new(component());
    let cases = [
        (19.0, MavResult::ACCEPTED, 19),
        (-1.0, MavResult::ACCEPTED, 19),
        (20.0, MavResult::DENIED, 19),
        (0.5, MavResult::DENIED, 19),
        (f32::NAN, MavResult::DENIED, 19),
        (0.0, MavResult::ACCEPTED, 0),
    ];
    for ((param1, result, current), second) in cases.into_iter().zip(10..) {
        let now = Instant::from_millis(second * 10_000);
        let set = CommandLong { command: MavCmd::DO_SET_MISSION_CURRENT, param1, ..CommandLong::DEFAULT };
        give(&mut commands, STATION, &set.to(1, 1), now);
        let Some(command::Event::Request(request)) = outputs(&mut commands, now).1.pop() else { panic!("no request") };
        assert_eq!(vehicle.command(&request), Some(result), "{param1}");
        commands.finish(request.ticket, result, now);
        let (sent, events) = outputs(&mut vehicle, now);
        let told = sent.first().map(|sent| sent.decode::<MissionCurrent>().unwrap().seq);
        assert_eq!((vehicle.current().seq, told), (current, (param1.fract() == 0.0).then_some(current)), "{param1}");
        assert_eq!(events.len(), usize::from(result == MavResult::ACCEPTED), "{param1}");
    }
    let now = Instant::from_millis(1_000_000);
    give(&mut commands, STATION, &CommandLong { command: MavCmd::MISSION_START, ..CommandLong::DEFAULT }.to(1, 1), now);
    let Some(command::Event::Request(request)) = outputs(&mut commands, now).1.pop() else { panic!("no request") };
    assert_eq!(vehicle.command(&request), None);
}

#[test]
fn the_vehicle_goes_to_an_item_and_says_where_it_is() {
    let (mut simulation, mut vehicle) = (Simulation::new(3, Weather::BAD), vehicle(20));
    let mission = access(MavMissionType::MISSION);
    let mut upload = Upload::new(mission, items(20, 0), simulation.now);
    finish(&mut simulation, &mut upload, &mut vehicle).0.unwrap();
    let mut set = SetCurrent::new(mission, 7, simulation.now);
    let (end, _, events) = finish(&mut simulation, &mut set, &mut vehicle);
    assert_eq!((end, vehicle.current().seq, vehicle.current().total), (Ok(()), 7, 20));
    assert!(events.contains(&ComponentEvent::Current { seq: 7, by: station() }));
    let mut set = SetCurrent::new(mission, 20, simulation.now);
    let (end, _, events) = finish(&mut simulation, &mut set, &mut vehicle);
    assert_eq!(end, Err(Failure::Timeout { awaited: Awaited::Current(20), asked: 6 }));
    assert!(!events.iter().any(|event| matches!(event, ComponentEvent::Current { seq: 20, .. })));
    give(&mut vehicle, STATION, &MissionRequestInt { seq: 7, ..MissionRequestInt::DEFAULT }.to(1, 1), simulation.now);
    let sent = outputs(&mut vehicle, simulation.now).0;
    assert_eq!(sent.iter().find_map(|sent| sent.decode::<MissionItemInt>()).unwrap().current, 1);
    vehicle.reached(7);
    vehicle.set_current(8);
    let names: Vec<_> = outputs(&mut vehicle, simulation.now).0.iter().map(|sent| sent.info().name).collect();
    assert_eq!(names, ["MISSION_ITEM_REACHED", "MISSION_CURRENT"]);
}

#[test]
fn nobody_and_silence_end_with_what_was_waited_for() {
    let (mut simulation, mut vehicle) = (Simulation::new(1, Weather { loss: 100, ..Weather::FINE }), vehicle(20));
    let mission = access(MavMissionType::MISSION);
    let timeout = |awaited, asked| Failure::Timeout { awaited, asked };
    let mut upload = Upload::new(mission, items(3, 0), simulation.now);
    assert_eq!(finish(&mut simulation, &mut upload, &mut vehicle).0, Err(timeout(Awaited::Begin, 6)));
    let mut download = Download::new(mission, simulation.now);
    assert_eq!(finish(&mut simulation, &mut download, &mut vehicle).0, Err(timeout(Awaited::Count, 6)));
    let mut clear = Clear::new(mission, simulation.now);
    assert_eq!(finish(&mut simulation, &mut clear, &mut vehicle).0, Err(timeout(Awaited::Ack, 6)));
    assert_eq!(simulation.now, Instant::from_millis(27_000));
    // In the midst of it: each waits on the other's side.
    let mut upload = Upload::new(mission, items(3, 0), Instant::ZERO);
    outputs(&mut upload, Instant::ZERO);
    give(&mut upload, COMPONENT, &MissionRequestInt::DEFAULT.to(STATION.0, STATION.1), Instant::ZERO);
    assert_eq!(run_down(&mut upload), (timeout(Awaited::Request(1), 6), Instant::from_millis(9000)));
    let mut download = Download::new(mission, Instant::ZERO);
    outputs(&mut download, Instant::ZERO);
    give(
        &mut download,
        COMPONENT,
        &MissionCount { count: 3, ..MissionCount::DEFAULT }.to(STATION.0, STATION.1),
        Instant::ZERO,
    );
    assert_eq!(run_down(&mut download), (timeout(Awaited::Item(0), 21), Instant::from_millis(5250)));
    // The vehicle waits for items, and then is free again.
    give(&mut vehicle, STATION, &MissionCount { count: 3, ..MissionCount::DEFAULT }.to(1, 1), Instant::ZERO);
    let mut now = Instant::ZERO;
    while let Some(next) = {
        outputs(&mut vehicle, now);
        vehicle.deadline()
    } {
        now = next;
    }
    assert_eq!(now, Instant::from_millis(5250));
}

/// Lets time pass until an operation has failed.
fn run_down<O: Operation<Failure = Failure>>(operation: &mut O) -> (Failure, Instant) {
    let mut now = Instant::ZERO;
    loop {
        for event in outputs(operation, now).1 {
            if let Some(Err(failure)) = event.done() {
                return (failure, now);
            }
        }
        now = operation.deadline().expect("it waits for something");
    }
}
