//! Stations say anything to a vehicle with plans: it answers, keeps a plan or replaces the whole of it, and is free again when
//! nobody speaks any more.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavlink_fuzz::services::{Arrival, component, feed};
use mavlink_services::Service;
use mavlink_services::common::MavMissionType;
use mavlink_services::mission::{Component, ComponentEvent, MissionItem, Plan, PlanStore, Plans};

fuzz_target!(|arrivals: Vec<Arrival>| {
    let plan = || Plan::new(vec![MissionItem::DEFAULT; 16], vec![MissionItem::DEFAULT; 16]);
    let mut vehicle = Component::new(component(), PlanStore { mission: plan(), fence: plan(), rally: plan() });
    feed(&mut vehicle, &arrivals, |event| {
        if let ComponentEvent::Replaced { count, .. } = event {
            assert!(count <= 16);
        }
    });
    let counts = [0, 1, 2].map(|plan| vehicle.plans().count(MavMissionType(plan)));
    for _ in 0..100 {
        let Some(deadline) = vehicle.deadline() else { break };
        while vehicle.poll(deadline).is_some() {}
    }
    assert_eq!(vehicle.deadline(), None, "it waits for ever");
    assert_eq!(counts, [0, 1, 2].map(|plan| vehicle.plans().count(MavMissionType(plan))), "silence changed a plan");
});
