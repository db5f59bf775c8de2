//! Stations say anything to a component that carries commands out, or does not: what it hands out has one end, and it never hands out
//! more than it has places for.

#![no_main]

use std::collections::BTreeSet;

use libfuzzer_sys::fuzz_target;
use mavlink_fuzz::services::{Arrival, component, step};
use mavlink_services::Instant;
use mavlink_services::command::{Component, Event};
use mavlink_services::common::MavResult;

fuzz_target!(|input: (Vec<u8>, Vec<Arrival>)| {
    let (habits, arrivals) = input;
    let mut machine = Component::<3>::new(component());
    let (mut now, mut open, mut asked) = (Instant::ZERO, Vec::new(), BTreeSet::new());
    for (turn, arrival) in arrivals.iter().enumerate() {
        let mut told = Vec::new();
        now = step(&mut machine, now, arrival, |event| told.push(event));
        for event in told {
            match event {
                Event::Request(request) => {
                    assert!(asked.insert(format!("{:?}", request.ticket)), "a ticket was given twice");
                    open.push(request.ticket);
                }
                Event::Cancel(ticket) => assert!(open.contains(&ticket), "what was cancelled had ended"),
                _ => {}
            }
        }
        assert!(open.len() <= 3);
        let habit = habits.get(turn).copied().unwrap_or_default();
        match (open.first().copied(), habit % 4) {
            (Some(ticket), 1) => {
                assert!(machine.finish(ticket, MavResult(habit / 4 % 5), now));
                open.remove(0);
            }
            (Some(ticket), 2) => assert!(machine.progress(ticket, Some(habit), now)),
            _ => {}
        }
    }
});
