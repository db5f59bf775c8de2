//! A component says anything to a station that commands, asks for messages and measures time: each operation ends once, in bounded
//! time, cancelled or not.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavlink_autoquad::wire::Message;
use mavlink_fuzz::services::{Arrival, component, finish, station};
use mavlink_services::command::{Fetch, Options, Send};
use mavlink_services::common::{AutopilotVersion, CommandInt, CommandLong, MavCmd};
use mavlink_services::interval::{Get, Interval, set};
use mavlink_services::timesync::{self, Measure};
use mavlink_services::{Instant, Retry};

fuzz_target!(|input: (u8, u16, Vec<Arrival>)| {
    let (pick, number, arrivals) = input;
    let (own, peer, now) = (station(), component(), Instant::ZERO);
    let long = CommandLong { command: MavCmd(number), ..CommandLong::DEFAULT };
    match pick % 6 {
        0 | 1 => {
            let int = CommandInt { command: MavCmd(number), ..CommandInt::DEFAULT };
            let command: &dyn mavlink_autoquad::wire::Encode = if pick & 8 == 0 { &long } else { &int };
            let mut send = Send::new(own, peer, Options::DEFAULT, command, now).expect("a command");
            if pick % 6 == 1 {
                send.cancel(now);
            }
            finish(&mut send, &arrivals);
        }
        2 => finish(&mut Fetch::<AutopilotVersion>::new(own, peer, Retry::DEFAULT, 0.0, now), &arrivals),
        3 => finish(&mut Get::new(own, peer, Retry::DEFAULT, number, now), &arrivals),
        4 => finish(&mut set(own, peer, Options::DEFAULT, (number.into(), Interval::Default), now), &arrivals),
        _ => finish(&mut Measure::new(own, peer, timesync::Options::DEFAULT, now), &arrivals),
    }
});
