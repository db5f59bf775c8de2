//! A station lists the parameters of a component that says anything: the list ends, once, and no index is told that it does not have.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavlink_fuzz::services::{Arrival, component, finish, station};
use mavlink_services::Instant;
use mavlink_services::param::{Access, Encoding, List};

fuzz_target!(|input: (bool, u8, Vec<Arrival>)| {
    let (cast, storage, arrivals) = input;
    let encoding = if cast { Encoding::Cast } else { Encoding::Bytewise };
    let access = Access::new(station(), component(), encoding);
    finish(&mut List::new(access, vec![0; usize::from(storage % 9)], Instant::ZERO), &arrivals);
});
