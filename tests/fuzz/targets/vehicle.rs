//! Stations say anything to a whole vehicle: it comes to rest after each frame, and sends no message more often than it may.

#![no_main]

use std::time::Duration;

use libfuzzer_sys::fuzz_target;
use mavlink_autoquad::wire::Message;
use mavlink_fuzz::services::{Arrival, component, step};
use mavlink_services::Instant;
use mavlink_services::common::{AutopilotVersion, Heartbeat, MavResult};
use mavlink_services::heartbeat::Beacon;
use mavlink_services::interval::Stream;
use mavlink_services::mission::{MissionItem, Plan, PlanStore};
use mavlink_services::param::{Encoding, Param};
use mavlink_services::vehicle::{Event, Vehicle};

fuzz_target!(|arrivals: Vec<Arrival>| {
    let plan = || Plan::new(vec![MissionItem::DEFAULT; 4], vec![MissionItem::DEFAULT; 4]);
    let plans = PlanStore { mission: plan(), fence: plan(), rally: plan() };
    let params = (Encoding::Bytewise, [Param::new("RATE_P", 0.2_f32), Param::new("MOTORS", 4_u8)]);
    let shortest = Duration::from_millis(100);
    let streams = [AutopilotVersion::ID, 33].map(|message_id| Stream { message_id, default: Some(shortest), shortest });
    let mut vehicle = Vehicle::new(component(), Beacon::from(Heartbeat::DEFAULT), streams, params, plans);
    let mut now = Instant::ZERO;
    for arrival in &arrivals {
        let (mut told, mut due) = (Vec::new(), 0);
        now = step(&mut vehicle, now, arrival, |event| match event {
            Event::Command(request) => told.push(request.ticket),
            Event::Due(_) => due += 1,
            _ => {}
        });
        // Each stream once by the clock and once by request.
        assert!(due <= 4, "{due} messages at once");
        for ticket in told {
            assert!(vehicle.commands.finish(ticket, MavResult::UNSUPPORTED, now));
        }
    }
});
