//! Plans, with stations and vehicles that know nothing but the old messages.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "a part of tests")]
#![expect(deprecated, reason = "old stations and vehicles know nothing newer")]

mod plans;
mod simulated;

use mavlink_services::common::{
    self, MavAutopilot, MavCmd, MavFrame, MavMissionResult, MavMissionType, MavProtocolCapability, MissionAck,
    MissionCount, MissionCurrent, MissionItemInt, MissionRequest, MissionRequestInt, MissionSetCurrent,
};
use mavlink_services::mission::{Access, Download, Failure, Form, Item, MissionItem, Plans, Upload};
use mavlink_services::{Instant, Service, Update};
use mavlink_wire::{Message, Targeted};
use plans::{access, vehicle};
use simulated::{COMPONENT, STATION, give, outputs};

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

#[test]
fn a_station_of_today_that_did_not_hear_is_asked_in_its_way_again() {
    let (mut vehicle, mut now) = (vehicle(20), Instant::ZERO);
    give(&mut vehicle, STATION, &MissionCount { count: 3, ..MissionCount::DEFAULT }.to(1, 1), now);
    for seq in 0..2 {
        assert!(outputs(&mut vehicle, now).0[0].decode::<MissionRequestInt>().is_some_and(|asked| asked.seq == seq));
        now = vehicle.deadline().unwrap();
        assert!(outputs(&mut vehicle, now).0[0].decode::<MissionRequest>().is_some_and(|asked| asked.seq == seq));
        // As the guide has it, it answers the old question with the new item.
        give(&mut vehicle, STATION, &MissionItemInt { seq, ..MissionItemInt::DEFAULT }.to(1, 1), now);
    }
    assert!(outputs(&mut vehicle, now).0[0].decode::<MissionRequestInt>().is_some());
}
