//! Plans: both ends over links that are fine and bad, and each before peers that do not play by the rules.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "a part of tests")]
#![expect(deprecated, reason = "old stations and vehicles know nothing newer")]

mod simulated;

use std::ops::ControlFlow;
use std::time::Duration;

use mavlink_services::command;
use mavlink_services::common::{
    self, CommandLong, MavAutopilot, MavCmd, MavFrame, MavMissionResult, MavMissionType, MavProtocolCapability,
    MavResult, MissionAck, MissionClearAll, MissionCount, MissionCurrent, MissionItemInt, MissionRequest,
    MissionRequestInt, MissionRequestList, MissionRequestPartialList, MissionSetCurrent, MissionWritePartialList,
};
use mavlink_services::mission::{
    Access, Awaited, Clear, Component, ComponentEvent, Download, Failure, Form, Item, MissionItem, Plan, PlanStore,
    Plans, Replaced, Sent, SetCurrent, Upload, Uploaded,
};
use mavlink_services::{Instant, Operation, Service, Update};
use mavlink_wire::{Encode, Message, Targeted, Version};
use simulated::{COMPONENT, STATION, Simulation, Weather, component, give, outputs, station};

const LONG: Duration = Duration::from_secs(3600);
const PLANS: [MavMissionType; 3] = [MavMissionType::MISSION, MavMissionType::FENCE, MavMissionType::RALLY];

type Vehicle = Component<PlanStore<Vec<MissionItem>>>;

fn vehicle(capacity: usize) -> Vehicle {
    let plan = || Plan::new(vec![MissionItem::DEFAULT; capacity], vec![MissionItem::DEFAULT; capacity]);
    Component::new(component(), PlanStore { mission: plan(), fence: plan(), rally: plan() })
}

fn access(plan: MavMissionType) -> Access {
    Access::new(station(), component()).plan(plan)
}

/// Items that differ in everything.
fn items(count: u16, seed: i32) -> Vec<MissionItem> {
    let frames = [MavFrame::GLOBAL_INT, MavFrame::GLOBAL_RELATIVE_ALT_INT, MavFrame::LOCAL_NED, MavFrame::MISSION];
    let commands = [MavCmd::NAV_WAYPOINT, MavCmd::DO_CHANGE_SPEED, MavCmd::NAV_RALLY_POINT, MavCmd(31_000)];
    let item = |seq: u16| MissionItem {
        command: commands[usize::from(seq % 4)],
        frame: frames[usize::from(seq / 4 % 4)],
        current: false,
        autocontinue: !seq.is_multiple_of(3),
        params: [f32::from(seq), -1.5, 0.0, 1e-3],
        x: 473_977_421 + i32::from(seq) + seed,
        y: -85_455_947 - i32::from(seq),
        z: f32::from(seq) + 0.25,
    };
    (0..count).map(item).collect()
}

type End<O> = Result<<O as Operation>::Outcome, <O as Operation>::Failure>;

/// Runs an operation to its end, and gives that, what it told before, and what the vehicle told.
fn finish<O: Operation, P: Plans>(
    simulation: &mut Simulation,
    operation: &mut O,
    component: &mut Component<P>,
) -> (End<O>, Vec<O::Progress>, Vec<ComponentEvent>) {
    let (mut end, mut told, mut events) = (None, vec![], vec![]);
    let _ = simulation.run(
        (operation, &mut |_, event, _| match event {
            Update::Progress(progress) => {
                told.push(progress);
                ControlFlow::Continue(())
            }
            Update::Done(result) => {
                end = Some(result);
                ControlFlow::Break(())
            }
        }),
        (component, &mut |_, event, _| events.push(event)),
        LONG,
    );
    (end.expect("an operation ends in an hour"), told, events)
}

fn fetched(told: &[Item]) -> Vec<MissionItem> {
    told.iter().map(|item| MissionItem { current: false, ..item.item }).collect()
}

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

fn stored(vehicle: &Vehicle, plan: MavMissionType) -> Vec<MissionItem> {
    (0..vehicle.plans().count(plan).unwrap()).map(|seq| vehicle.plans().item(plan, seq).unwrap()).collect()
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
fn an_old_station_is_asked_in_the_old_way_and_its_floats_are_scaled() {
    let (mut vehicle, mut now) = (vehicle(20), Instant::ZERO);
    give(&mut vehicle, STATION, &MissionCount { count: 4, ..MissionCount::DEFAULT }.to(1, 1), now);
    let cases = [
        (MavFrame::GLOBAL_RELATIVE_ALT, MavCmd::NAV_WAYPOINT, (47.5, -8.25), (475_000_000, -82_500_000)),
        (MavFrame::LOCAL_NED, MavCmd::NAV_WAYPOINT, (2.5, -0.00006), (25_000, -1)),
        (MavFrame::GLOBAL_RELATIVE_ALT, MavCmd::DO_SET_SERVO, (3.0, -2.0), (3, -2)),
        (MavFrame::MISSION, MavCmd::NAV_WAYPOINT, (f32::NAN, 7.4), (i32::MAX, 7)),
    ];
    for (seq, (frame, command, (x, y), _)) in (0..).zip(cases) {
        // It knows nothing of MISSION_REQUEST_INT, so it hears the second question for the first item, and the first for the others.
        let asked_new = outputs(&mut vehicle, now).0.iter().any(|sent| sent.decode::<MissionRequestInt>().is_some());
        assert_eq!(asked_new, seq == 0);
        if asked_new {
            now = vehicle.deadline().unwrap();
            assert!(outputs(&mut vehicle, now).0[0].decode::<MissionRequest>().is_some());
        }
        let item = common::MissionItem { seq, frame, command, x, y, ..common::MissionItem::DEFAULT };
        give(&mut vehicle, STATION, &item.to(1, 1), now);
    }
    let (sent, events) = outputs(&mut vehicle, now);
    assert_eq!(sent[0].decode::<MissionAck>().unwrap().r#type, MavMissionResult::ACCEPTED);
    assert_eq!(events.len(), 1);
    for (seq, (frame, command, (x, y), expected)) in (0..).zip(cases) {
        let item = vehicle.plans().item(MavMissionType::MISSION, seq).unwrap();
        assert_eq!(
            (item.frame, item.command, (item.x, item.y)),
            (frame, command, expected),
            "{frame} {command} {x} {y}"
        );
        // It fetches them as floats as well.
        give(&mut vehicle, STATION, &MissionRequest { seq, ..MissionRequest::DEFAULT }.to(1, 1), now);
        let back = outputs(&mut vehicle, now).0[0].decode::<common::MissionItem>().unwrap();
        assert!(back.x == x || x.is_nan() && back.x.is_nan(), "{} is not {x}", back.x);
    }
}

#[test]
fn an_old_vehicle_gets_and_gives_floats() {
    let now = Instant::ZERO;
    let old = Access { form: Form::Float, ..access(MavMissionType::MISSION) };
    let item = MissionItem::at(MavCmd::NAV_WAYPOINT, 47.5, -8.25, 30.0);
    let mut upload = Upload::new(old, [item], now);
    outputs(&mut upload, now);
    give(&mut upload, COMPONENT, &MissionRequest::DEFAULT.to(STATION.0, STATION.1), now);
    let sent = outputs(&mut upload, now).0[0].decode::<common::MissionItem>().unwrap();
    assert_eq!((sent.x, sent.y, sent.z, sent.frame), (47.5, -8.25, 30.0, MavFrame::GLOBAL_RELATIVE_ALT_INT));
    assert_eq!(MissionItem::of(&sent), Some(item));
    let mut download = Download::new(old, now);
    outputs(&mut download, now);
    give(&mut download, COMPONENT, &MissionCount { count: 2, ..MissionCount::DEFAULT }.to(STATION.0, STATION.1), now);
    assert!(outputs(&mut download, now).0[0].decode::<MissionRequest>().is_some());
    give(&mut download, COMPONENT, &sent.to(STATION.0, STATION.1), now);
    let (_, events) = outputs(&mut download, now);
    assert!(matches!(events[..], [Update::Progress(told)] if told.item == item));
    // No position at all.
    let wrong = common::MissionItem { seq: 1, x: 1e6, ..sent }.to(STATION.0, STATION.1);
    give(&mut download, COMPONENT, &wrong, now);
    let (sent, events) = outputs(&mut download, now);
    assert_eq!(sent[0].decode::<MissionAck>().unwrap().r#type, MavMissionResult::INVALID_PARAM5_X);
    assert_eq!(events, [Update::Done(Err(Failure::Position { seq: 1 }))]);
}

/// The answers to a question of a station, as frames from the vehicle.
fn to_station<M: Targeted>(message: M) -> M {
    message.to(STATION.0, STATION.1)
}

#[test]
fn who_turns_out_to_be_old_gets_and_gives_floats() {
    let now = Instant::ZERO;
    let place = [MissionItem::at(MavCmd::NAV_WAYPOINT, 47.5, -8.25, 30.0); 2];
    let mut upload = Upload::new(access(MavMissionType::MISSION), place, now);
    outputs(&mut upload, now);
    let ask = |seq| to_station(MissionRequest { seq, ..MissionRequest::DEFAULT });
    for (seq, int) in [(0, true), (0, true), (0, false), (1, false), (0, false)] {
        give(&mut upload, COMPONENT, &ask(seq), now);
        let sent = outputs(&mut upload, now).0[0];
        assert_eq!(sent.decode::<MissionItemInt>().is_some(), int, "item {seq}");
        assert_eq!(sent.decode::<common::MissionItem>().is_some(), !int, "item {seq}");
    }
    // One that knows both and asks in the old way keeps integers, whatever is lost later.
    let mut upload = Upload::new(access(MavMissionType::MISSION), place, now);
    outputs(&mut upload, now);
    for seq in [0, 0, 1, 1, 1, 1, 0, 0, 0] {
        give(&mut upload, COMPONENT, &ask(seq), now);
        assert!(outputs(&mut upload, now).0[0].decode::<MissionItemInt>().is_some(), "item {seq}");
    }

    let mut download = Download::new(access(MavMissionType::MISSION), now);
    outputs(&mut download, now);
    give(&mut download, COMPONENT, &to_station(MissionCount { count: 2, ..MissionCount::DEFAULT }), now);
    let (mut now, mut old) = (now, vec![]);
    while !old.contains(&true) {
        let sent = outputs(&mut download, now).0;
        old.extend(sent.iter().map(|sent| sent.decode::<MissionRequest>().is_some()));
        now = download.deadline().unwrap();
    }
    assert_eq!(old.len(), 10, "nine times in one form: {old:?}");
    let item = to_station(common::MissionItem { x: 1.0, command: MavCmd::NAV_LAND, ..common::MissionItem::DEFAULT });
    give(&mut download, COMPONENT, &item, now);
    let (sent, told) = outputs(&mut download, now);
    assert!(sent[0].decode::<MissionRequest>().is_some_and(|request| request.seq == 1));
    assert!(matches!(told[..], [Update::Progress(Item { item: MissionItem { x: 10_000_000, .. }, .. })]));
}

#[test]
fn the_form_is_what_the_capabilities_say_or_else_the_autopilot() {
    const INT: MavProtocolCapability = MavProtocolCapability::MISSION_INT;
    const FLOAT: MavProtocolCapability = MavProtocolCapability::MISSION_FLOAT;
    for (capabilities, autopilot, expected) in [
        (Some(INT | FLOAT), MavAutopilot::AUTOQUAD, Form::Int),
        (Some(FLOAT), MavAutopilot::PX4, Form::Float),
        (Some(MavProtocolCapability::FTP), MavAutopilot::PX4, Form::Int),
        (Some(MavProtocolCapability::FTP), MavAutopilot::AUTOQUAD, Form::Float),
        (None, MavAutopilot::AUTOQUAD, Form::Float),
        (None, MavAutopilot::ARDUPILOTMEGA, Form::Int),
    ] {
        assert_eq!(Form::of(capabilities, autopilot), expected, "{capabilities:?} {autopilot}");
    }
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
    assert!(matches!(outputs(&mut download, now).1[..], [Update::Progress(Item { received: 1, count: 2, .. })]));
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

#[test]
fn messages_of_any_dialect_are_items() {
    assert_eq!(
        MissionItem::of(&MissionItemInt { x: 5, current: 1, ..MissionItemInt::DEFAULT })
            .map(|item| (item.x, item.current)),
        Some((5, true))
    );
    assert_eq!(MissionItem::of(&MissionCurrent::DEFAULT), None);
    assert_eq!(MissionItem::of(&MissionSetCurrent::DEFAULT), None);
    let far = MissionItem::at(MavCmd::NAV_WAYPOINT, f64::NAN, 1e6, 0.0);
    assert_eq!((far.x, far.y), (i32::MAX, i32::MAX));
}

#[test]
fn the_commands_with_a_position_are_those_of_the_definition() {
    let xml = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../xml/common.xml")).unwrap();
    let attribute = |line: &str, name: &str| {
        let (_, rest) = line.split_once(&format!(" {name}=\""))?;
        rest.split_once('"').map(|(value, _)| value.to_string())
    };
    let mut commands = 0;
    for line in xml.lines().filter(|line| line.contains("name=\"MAV_CMD_")) {
        let Some(value) = attribute(line, "value") else { continue };
        let expected = if attribute(line, "hasLocation").as_deref() == Some("true") { 10_000_000 } else { 1 };
        let (command, frame) = (MavCmd(value.parse().unwrap()), MavFrame::GLOBAL);
        let float = common::MissionItem { command, frame, x: 1.0, ..common::MissionItem::DEFAULT };
        assert_eq!(MissionItem::of(&float).unwrap().x, expected, "{command}");
        commands += 1;
    }
    assert!(commands > 150, "{commands} commands");
}
