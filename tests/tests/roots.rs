//! Two dialects in one crate: what is the same in them is one type, what differs is two, and neither disturbs the other.

#![allow(deprecated, reason = "what is deprecated is tested like the rest")]

use std::any::TypeId;

use mavlink_conformance::dialects::roots::{enums, heron, messages, osprey};
use mavlink_wire::{Dialect, Encode, Enum, Frame, MAX_FRAME, Message, Parser, Sender, Targeted, UnknownName};

/// Code over what both dialects have: it sends a message of either, and reads a `TANK` from either.
fn level<D: Dialect + From<messages::Tank>>() -> Option<u16>
where
    messages::Tank: TryFrom<D>,
{
    let tank = messages::Tank { level: 7, state: enums::SprayState::ON, ..messages::Tank::DEFAULT };
    let (mut sender, mut buffer) = (Sender::v2(1, 1), [0; MAX_FRAME]);
    let mut sent = sender.encode(&D::from(tank.to(3, 4)), &mut buffer).unwrap();
    let mut parser = Parser::new(D::TABLE);
    let tank = messages::Tank::try_from(parser.next(&mut sent)?.message::<D>()?).ok()?;
    assert_eq!((tank.target_system, tank.target_component), (3, 4));
    Some(tank.level)
}

#[test]
fn code_over_what_is_shared_works_for_both() {
    assert_eq!((level::<heron::Heron>(), level::<osprey::Osprey>()), (Some(7), Some(7)));
    assert_eq!(TypeId::of::<heron::Tank>(), TypeId::of::<osprey::Tank>());
    assert_eq!(TypeId::of::<heron::messages::OldTank>(), TypeId::of::<osprey::OldTank>());
}

#[test]
fn two_messages_with_one_id_do_not_disturb_each_other() {
    let mut buffer = [0; MAX_FRAME];
    let nest = heron::Heron::from(heron::Nest { sticks: 0x0a0b_0c0d });
    let sent = Sender::v2(1, 1).encode(&nest, &mut buffer).unwrap();
    assert_eq!(Frame::parse(sent, heron::Heron::TABLE).unwrap().message(), Some(nest));
    // The checksum is seeded by the definition: to the other dialect this is a damaged frame.
    assert!(Frame::parse(sent, osprey::Osprey::TABLE).is_err());
    assert_eq!(osprey::Catch { fish: 1 }.info().id, nest.info().id);
    assert_ne!(osprey::Catch::INFO.crc_extra, heron::Nest::INFO.crc_extra);
}

#[test]
fn each_dialect_has_exactly_its_messages() {
    let names = |table: &mavlink_wire::Table<'_>| -> Vec<&str> { table.iter().map(|info| info.name).collect() };
    assert_eq!(
        names(heron::Heron::TABLE),
        ["TANK", "ORDER", "OLD_TANK", "NEST", "GAUGE", "DEPTH", "PERCH", "SHIP", "WEATHER"]
    );
    assert_eq!(
        names(osprey::Osprey::TABLE),
        ["TANK", "ORDER", "OLD_TANK", "CATCH", "GAUGE", "DEPTH", "PERCH", "SHIP", "WEATHER"]
    );
    let ids = |table: &mavlink_wire::Table<'_>| -> Vec<u32> { table.iter().map(|info| info.id).collect() };
    assert_eq!(ids(osprey::Osprey::TABLE), [1, 2, 3, 150, 160, 161, 163, 170, 171]);
}

#[test]
fn an_enum_has_the_constants_of_all() {
    use enums::SprayState;
    assert_eq!([SprayState::OFF, SprayState::MIST, SprayState::JET].map(|state| state.0), [0, 2, 3]);
    assert_eq!("SPRAY_STATE_JET".parse::<heron::SprayState>(), Ok(SprayState::JET));
}

/// The dialect that was named first gives a value its name, and a command its parameters.
#[test]
fn a_value_with_two_names_has_the_first_and_knows_both() {
    assert_eq!(enums::MavCmd::HERON, enums::MavCmd::OSPREY);
    assert_eq!(enums::MavCmd::OSPREY.to_string(), "MAV_CMD_HERON");
    for name in ["MAV_CMD_HERON", "MAV_CMD_OSPREY"] {
        assert_eq!(name.parse::<enums::MavCmd>(), Ok::<_, UnknownName>(enums::MavCmd(500)));
    }
    let labels: Vec<_> = enums::MavCmd(500).params().iter().map(|param| param.label).collect();
    assert_eq!(labels, [Some("Heron")]);
    assert_eq!(enums::MavCmd::SPRAY.params().len(), 1);
}

/// Dialects of different age: an entry that was renamed and kept its value is one constant, with the name that it had first.
#[test]
fn an_entry_that_was_renamed_is_one_constant() {
    let ship = messages::Ship { state: enums::ShipState::MOORED };
    assert_eq!(TypeId::of::<heron::Ship>(), TypeId::of::<osprey::Ship>());
    assert_eq!((ship.state.to_string().as_str(), osprey::ShipState::ADRIFT.0), ("MOORED", 3));
    for name in ["SAILING", "SHIP_STATE_SAILING"] {
        assert_eq!(name.parse::<enums::ShipState>(), Ok(enums::ShipState::SAILING));
    }
}

/// And an enum in which an entry has another value is another type, and so are the messages with a field of it.
#[test]
fn an_entry_with_two_values_makes_two_enums() {
    assert_eq!((heron::Wind::STORM.0, osprey::Wind::STORM.0, osprey::Wind::BREEZE.0), (1, 2, 1));
    assert_eq!(osprey::Wind(1).to_string(), "WIND_BREEZE");
    assert_ne!(TypeId::of::<heron::Weather>(), TypeId::of::<osprey::Weather>());
    let weather = heron::Heron::from(heron::Weather { wind: heron::Wind::STORM });
    let mut buffer = [0; MAX_FRAME];
    let sent = Sender::v2(1, 1).encode(&weather, &mut buffer).unwrap();
    // On the wire they are one message, in which the number means something else.
    let read = Frame::parse(sent, osprey::Osprey::TABLE).unwrap().message::<osprey::Osprey>();
    assert_eq!(read, Some(osprey::Weather { wind: osprey::Wind::BREEZE }.into()));
}

#[test]
fn what_differs_is_a_type_in_each() {
    let heron = heron::Gauge { kind: heron::GaugeKind::FLOAT };
    let osprey = osprey::messages::Gauge { kind: osprey::enums::GaugeKind::LASER };
    assert_eq!((heron.kind.0, osprey.kind.0), (1_u8, 300_u16));
    assert_eq!((heron.info().len_v2, osprey.info().len_v2), (1, 2));
    assert_eq!((heron::GaugeKind::INFO.entries.len(), osprey::GaugeKind::INFO.entries.len()), (1, 2));
    // The bytes of these are alike, what they mean is not; and of these not even the id.
    assert_ne!(TypeId::of::<heron::Depth>(), TypeId::of::<osprey::Depth>());
    assert_eq!((heron::Depth::FIELDS[0].units, osprey::Depth::FIELDS[0].units), (Some("cm"), Some("m")));
    assert_eq!((heron::Perch::ID, osprey::Perch::ID), (162, 163));
}

#[test]
fn a_shared_message_has_what_the_overlays_of_all_say() {
    let mut tank = messages::Tank::DEFAULT;
    tank.set_kind(heron::GaugeKind::FLOAT);
    assert_eq!((tank.mode, tank.kind()), (1, heron::GaugeKind(1)));
    let mut gauge: osprey::TankLevel = tank.gauge();
    gauge.set_height(99).unwrap();
    tank.set_gauge(gauge);
    assert_eq!(tank.level, 99);
}

#[test]
fn views_of_one_name_are_apart() {
    assert_eq!(heron::Nest { sticks: 0x0002_0001 }.contents().short(), 2);
    assert_eq!(osprey::Catch { fish: 5 }.contents().trout(), 5);
    assert_ne!(TypeId::of::<heron::views::Contents>(), TypeId::of::<osprey::Contents>());
}
