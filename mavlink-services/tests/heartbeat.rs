//! Heartbeats: sent in step, and watched.

mod simulated;

use std::ops::ControlFlow;
use std::time::Duration;

use mavlink_services::common::{CommandAck, Heartbeat, MavState};
use mavlink_services::heartbeat::{Beacon, Event, Monitor, NoHeartbeat};
use mavlink_services::{Address, Instant, Service};
use mavlink_wire::Message;
use simulated::{COMPONENT, Simulation, Weather, component, give, outputs};

#[test]
fn a_beacon_keeps_step_and_makes_nothing_good() {
    let mut beacon = Beacon::new(&Heartbeat { custom_mode: 7, ..Heartbeat::DEFAULT }).unwrap();
    let mut sent = |millis| outputs(&mut beacon, Instant::from_millis(millis)).0.len();
    assert_eq!([0, 999, 1010, 1999, 2000, 9500, 9999, 10_499, 10_500].map(&mut sent), [1, 0, 1, 0, 1, 1, 0, 0, 1]);
    beacon.set(&Heartbeat { custom_mode: 8, ..Heartbeat::DEFAULT }).unwrap();
    let (sent, _) = outputs(&mut beacon, Instant::from_millis(20_000));
    assert_eq!(sent[0].decode::<Heartbeat>().unwrap().custom_mode, 8);
    assert_eq!(beacon.set(&CommandAck::DEFAULT), Err(NoHeartbeat { message_id: 77 }));
}

#[test]
fn a_monitor_tells_who_comes_changes_and_goes() {
    let mut monitor = Monitor::<2>::new();
    let says = |system_status| Heartbeat { system_status, ..Heartbeat::DEFAULT };
    give(&mut monitor, COMPONENT, &says(MavState::STANDBY), Instant::ZERO);
    give(&mut monitor, COMPONENT, &says(MavState::ACTIVE), Instant::ZERO);
    let (_, events) = outputs(&mut monitor, Instant::ZERO);
    assert!(
        matches!(events[..], [Event::Appeared(peer)] if peer.heartbeat.system_status == MavState::ACTIVE),
        "{events:?}"
    );
    give(&mut monitor, COMPONENT, &says(MavState::ACTIVE), Instant::from_millis(1000));
    assert!(outputs(&mut monitor, Instant::from_millis(1000)).1.is_empty());
    give(&mut monitor, COMPONENT, &says(MavState::EMERGENCY), Instant::from_millis(2000));
    assert!(matches!(outputs(&mut monitor, Instant::from_millis(2000)).1[..], [Event::Changed(_)]));

    assert_eq!(monitor.deadline(), Some(Instant::from_millis(7000)));
    assert!(monitor.peer(component()).is_some());
    let (_, events) = outputs(&mut monitor, Instant::from_millis(7000));
    assert!(matches!(events[..], [Event::Lost(peer)] if peer.heard == Instant::from_millis(2000)), "{events:?}");
    assert!(monitor.peer(component()).is_none());
    give(&mut monitor, COMPONENT, &says(MavState::ACTIVE), Instant::from_millis(8000));
    assert!(matches!(outputs(&mut monitor, Instant::from_millis(8000)).1[..], [Event::Appeared(_)]));
}

#[test]
fn heartbeats_of_everybody_take_no_more_than_their_places() {
    let mut monitor = Monitor::<4>::new();
    let mut known = Monitor::<4>::of(component(), Duration::from_secs(5));
    for system in 1..=255 {
        for component in 1..=255 {
            give(&mut monitor, (system, component), &Heartbeat::DEFAULT, Instant::ZERO);
            give(&mut known, (system, component), &Heartbeat::DEFAULT, Instant::ZERO);
        }
    }
    assert_eq!((monitor.peers().count(), outputs(&mut monitor, Instant::ZERO).1.len()), (4, 4));
    assert_eq!(known.peers().map(|peer| peer.address).collect::<Vec<_>>(), [component()]);
    assert_eq!(outputs(&mut monitor, Instant::from_millis(5000)).1.len(), 4);
    assert_eq!((monitor.peers().count(), monitor.deadline()), (0, None));
}

#[test]
fn loss_of_a_fifth_is_no_loss_of_the_peer() {
    let mut lost = 0;
    for seed in 0..50 {
        let mut simulation = Simulation::new(seed, Weather::BAD);
        let (mut monitor, mut beacon) = (Monitor::<1>::new(), Beacon::new(&Heartbeat::DEFAULT).unwrap());
        let mut appeared = 0;
        let end = simulation.run(
            (&mut monitor, &mut |_, event, _| {
                match event {
                    Event::Appeared(peer) => {
                        assert_eq!(peer.address, Address::new(1, 1));
                        appeared += 1;
                    }
                    Event::Lost(_) => lost += 1,
                    _ => {}
                }
                ControlFlow::Continue(())
            }),
            (&mut beacon, &mut |_, event, _| match event {}),
            Duration::from_secs(60),
        );
        assert!(end.is_continue() && appeared >= 1);
    }
    assert!(lost < 10, "{lost} in 50 minutes");
}
