//! A station sends, fetches and clears a plan, and sets the current item, of a vehicle that says anything: each ends, once.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavlink_fuzz::services::{Arrival, component, finish, station};
use mavlink_services::Instant;
use mavlink_services::common::MavMissionType;
use mavlink_services::mission::{Access, Clear, Download, Form, MissionItem, SetCurrent, Upload};

fuzz_target!(|input: (bool, u8, u8, u16, Vec<Arrival>)| {
    let (float, plan, count, first, arrivals) = input;
    let form = if float { Form::Float } else { Form::Int };
    let access = Access { form, ..Access::new(station(), component()).plan(MavMissionType(plan % 3)) };
    let items = vec![MissionItem::DEFAULT; usize::from(count % 64)];
    finish(&mut Upload::new(access, &items, Instant::ZERO), &arrivals);
    finish(&mut Upload::part(access, first, &items, Instant::ZERO), &arrivals);
    finish(&mut Download::new(access, Instant::ZERO).with_limit(100), &arrivals);
    finish(&mut Download::part(access, first, u16::from(count), Instant::ZERO), &arrivals);
    finish(&mut Clear::new(access, Instant::ZERO), &arrivals);
    finish(&mut SetCurrent::new(access, first, Instant::ZERO), &arrivals);
});
