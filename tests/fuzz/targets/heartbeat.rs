//! Anybody says anything to who watches heartbeats: nobody takes more than one place, and in silence all are lost, once.

#![no_main]

use std::collections::BTreeSet;

use libfuzzer_sys::fuzz_target;
use mavlink_fuzz::services::{Arrival, feed};
use mavlink_services::heartbeat::{Event, Monitor};
use mavlink_services::{Output, Service};

fuzz_target!(|arrivals: Vec<Arrival>| {
    let (mut monitor, mut there) = (Monitor::<2>::new(), BTreeSet::new());
    let mut tell = |event| match event {
        Event::Appeared(peer) => assert!(there.insert(peer.address), "it was there"),
        Event::Changed(peer) => assert!(there.contains(&peer.address), "it was not there"),
        Event::Lost(peer) => assert!(there.remove(&peer.address), "it was not there"),
        _ => {}
    };
    feed(&mut monitor, &arrivals, &mut tell);
    while let Some(deadline) = monitor.deadline() {
        while let Some(output) = monitor.poll(deadline) {
            match output {
                Output::Event(event) => tell(event),
                Output::Send(_) => panic!("a monitor says nothing"),
            }
        }
    }
    assert_eq!((monitor.peers().count(), there.len()), (0, 0));
});
