//! Stations say anything to a component with parameters: it answers, and each value has the type that it had.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavlink_fuzz::services::{Arrival, component, feed};
use mavlink_services::param::{Component, Encoding, Param};

fuzz_target!(|input: (bool, Vec<Arrival>)| {
    let (cast, arrivals) = input;
    let encoding = if cast { Encoding::Cast } else { Encoding::Bytewise };
    let table =
        vec![Param::new("", 5_u8), Param::new("A", -1_i32), Param::new("A", 0.5_f32), Param::new("B", i64::MIN)];
    let kinds: Vec<_> = table.iter().map(|param| param.value.kind()).collect();
    let mut vehicle = Component::new(component(), encoding, table);
    feed(&mut vehicle, &arrivals, |set| assert_eq!(set.param.value.kind(), set.before.kind()));
    assert!(vehicle.parameters().iter().zip(kinds).all(|(param, kind)| param.value.kind() == kind));
});
