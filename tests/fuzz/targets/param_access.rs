//! A station reads and sets a parameter of a component that says anything: it ends, once.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavlink_fuzz::services::{Arrival, component, finish, station};
use mavlink_services::Instant;
use mavlink_services::common::MavParamType;
use mavlink_services::param::{Access, Encoding, Name, Read, Which, Write};

fuzz_target!(|input: (bool, u16, f64, u8, Vec<Arrival>)| {
    let (cast, index, number, kind, arrivals) = input;
    let encoding = if cast { Encoding::Cast } else { Encoding::Bytewise };
    let access = Access::new(station(), component(), encoding);
    // What a payload of zeros names.
    let name = Name::default();
    finish(&mut Read::new(access, Which::Name(name), Instant::ZERO), &arrivals);
    finish(&mut Read::new(access, Which::Index(index), Instant::ZERO), &arrivals);
    finish(&mut Write::new(access, name, number, Instant::ZERO), &arrivals);
    finish(&mut Write::of_kind(access, name, i64::from(index), MavParamType(kind), Instant::ZERO), &arrivals);
});
