//! A vehicle with plans, and items that differ in everything.
#![allow(dead_code, reason = "each test uses a part of it")]
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a part of tests")]

use crate::simulated::{component, station};
use mavlink_services::common::{MavCmd, MavFrame, MavMissionType};
use mavlink_services::mission::{Access, Component, Item, MissionItem, Plan, PlanStore, Plans};

pub(crate) const PLANS: [MavMissionType; 3] = [MavMissionType::MISSION, MavMissionType::FENCE, MavMissionType::RALLY];

pub(crate) type Vehicle = Component<PlanStore<Vec<MissionItem>>>;

pub(crate) fn vehicle(capacity: usize) -> Vehicle {
    let plan = || Plan::new(vec![MissionItem::DEFAULT; capacity], vec![MissionItem::DEFAULT; capacity]);
    Component::new(component(), PlanStore { mission: plan(), fence: plan(), rally: plan() })
}

pub(crate) fn access(plan: MavMissionType) -> Access {
    Access::new(station(), component()).plan(plan)
}

/// Items that differ in everything.
pub(crate) fn items(count: u16, seed: i32) -> Vec<MissionItem> {
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

pub(crate) fn fetched(told: &[Item]) -> Vec<MissionItem> {
    told.iter().map(|item| MissionItem { current: false, ..item.item }).collect()
}

pub(crate) fn stored(vehicle: &Vehicle, plan: MavMissionType) -> Vec<MissionItem> {
    (0..vehicle.plans().count(plan).unwrap()).map(|seq| vehicle.plans().item(plan, seq).unwrap()).collect()
}
