//! Message intervals: asked for over a bad link, and by those who ask for nonsense.

mod simulated;

use std::ops::ControlFlow;
use std::time::Duration;

use mavlink_services::command::{self, Command, Component, Options};
use mavlink_services::common::{CommandLong, MavCmd, MavResult, MessageInterval};
use mavlink_services::interval::{Event, Get, Interval, Stream, Streams, set};
use mavlink_services::{Instant, Output, Retry, Service, earliest};
use mavlink_wire::{Frame, Message};
use simulated::{COMPONENT, Simulation, Weather, component, give, outputs, station};

const ATTITUDE: u32 = 30;

const fn streams() -> [Stream; 2] {
    [
        Stream { message_id: ATTITUDE, default: None, shortest: Duration::from_millis(20) },
        Stream { message_id: 33, default: Some(Duration::from_secs(1)), shortest: Duration::ZERO },
    ]
}

/// A component that answers commands by its streams.
struct Vehicle {
    commands: Component,
    streams: Streams<2>,
}

impl Vehicle {
    fn new() -> Self {
        Self { commands: Component::new(component()), streams: Streams::new(streams(), Instant::ZERO) }
    }
}

impl Service for Vehicle {
    type Event = u32;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        self.commands.handle(frame, now);
    }

    fn poll(&mut self, now: Instant) -> Option<Output<u32>> {
        while let Some(output) = self.commands.poll(now) {
            match output {
                Output::Send(message) => return Some(Output::Send(message)),
                Output::Event(command::Event::Request(request)) => {
                    let result = self.streams.command(&request.command, now).unwrap_or(MavResult::UNSUPPORTED);
                    self.commands.finish(request.ticket, result, now);
                }
                Output::Event(_) => {}
            }
        }
        Some(match self.streams.poll(now)? {
            Output::Send(message) => Output::Send(message),
            Output::Event(Event::Due(message_id)) => Output::Event(message_id),
            Output::Event(_) => return None,
        })
    }

    fn deadline(&self) -> Option<Instant> {
        earliest(self.commands.deadline(), self.streams.deadline())
    }
}

#[test]
fn an_interval_is_set_and_read_over_a_bad_link() {
    for seed in 0..50 {
        let (mut simulation, mut vehicle) = (Simulation::new(seed, Weather::BAD), Vehicle::new());
        let every = Interval::Every(Duration::from_millis(250));
        let mut setting = set(station(), component(), Options::DEFAULT, (ATTITUDE, every), Instant::ZERO);
        let mut end = None;
        let _ = simulation.run(
            (&mut setting, &mut |_, event, _| {
                end = event.done();
                if end.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            }),
            (&mut vehicle, &mut |_, _, _| {}),
            Duration::from_secs(20),
        );
        if end.is_some_and(|end| end.is_err()) {
            continue;
        }
        let mut getting = Get::new(station(), component(), Retry::DEFAULT, ATTITUDE as u16, simulation.now);
        let (mut told, mut due) = (None, 0);
        let _ = simulation.run(
            (&mut getting, &mut |_, event, _| {
                told = event.done();
                ControlFlow::Continue(())
            }),
            (&mut vehicle, &mut |_, message_id, _| due += u32::from(message_id == ATTITUDE)),
            Duration::from_secs(20),
        );
        assert!(matches!(told, Some(Ok(interval)) if interval == every) || matches!(told, Some(Err(_))), "{told:?}");
        assert!((79..=81).contains(&due), "seed {seed}: {due} in 20 s");
    }
}

#[test]
fn nonsense_is_denied_and_haste_is_slowed() {
    let mut streams = Streams::new(streams(), Instant::ZERO);
    let mut say = |command, param1, param2| {
        let long = CommandLong { command, param1, param2, ..CommandLong::DEFAULT };
        let result = streams.command(&Command::Long(long), Instant::ZERO);
        (result, streams.every(ATTITUDE), streams.every(33))
    };
    let (accepted, denied, second) = (Some(MavResult::ACCEPTED), Some(MavResult::DENIED), Some(Duration::from_secs(1)));
    assert_eq!(say(MavCmd::SET_MESSAGE_INTERVAL, 30.0, 1.0), (accepted, Some(Duration::from_millis(20)), second));
    assert_eq!(say(MavCmd::SET_MESSAGE_INTERVAL, 30.0, f32::NAN).0, denied);
    assert_eq!(say(MavCmd::SET_MESSAGE_INTERVAL, 30.0, -2.0).0, denied);
    assert_eq!(say(MavCmd::SET_MESSAGE_INTERVAL, 30.0, 0.5).0, denied);
    assert_eq!(say(MavCmd::SET_MESSAGE_INTERVAL, 31.0, 1e6).0, None);
    assert_eq!(say(MavCmd::SET_MESSAGE_INTERVAL, f32::NAN, 1e6).0, None);
    assert_eq!(say(MavCmd::SET_MESSAGE_INTERVAL, 30.0, 0.0), (accepted, None, second));
    assert_eq!(say(MavCmd::SET_MESSAGE_INTERVAL, 33.0, -1.0), (accepted, None, None));
    assert_eq!(say(MavCmd::SET_MESSAGE_INTERVAL, 33.0, 1.0).2, Some(Duration::from_millis(1)));
    assert_eq!(say(MavCmd::GET_MESSAGE_INTERVAL, 1e9, 0.0).0, denied);
    assert_eq!(say(MavCmd::NAV_LAND, 0.0, 0.0).0, None);
    assert_eq!(say(MavCmd::REQUEST_MESSAGE, 30.0, 0.0).0, accepted);
    assert_eq!(say(MavCmd::REQUEST_MESSAGE, 244.0, 30.0).0, accepted);
    let (sent, events) = outputs(&mut streams, Instant::ZERO);
    assert_eq!(events, [Event::Due(ATTITUDE)]);
    let told = MessageInterval { message_id: 30, interval_us: -1 };
    assert_eq!(sent[0].decode::<MessageInterval>(), Some(told));
}

#[test]
fn what_was_missed_is_not_made_good() {
    let mut streams = Streams::new(streams(), Instant::ZERO);
    assert_eq!(streams.deadline(), Some(Instant::from_millis(1000)));
    assert_eq!(outputs(&mut streams, Instant::from_millis(60_000)).1, [Event::Due(33)]);
    assert_eq!(streams.deadline(), Some(Instant::from_millis(61_000)));
}

#[test]
fn the_interval_of_another_message_is_no_answer() {
    let mut getting = Get::new(station(), component(), Retry::DEFAULT, 30, Instant::ZERO);
    outputs(&mut getting, Instant::ZERO);
    give(&mut getting, COMPONENT, &MessageInterval { message_id: 31, interval_us: 7 }, Instant::ZERO);
    assert!(outputs(&mut getting, Instant::ZERO).1.is_empty());
    give(&mut getting, COMPONENT, &MessageInterval { message_id: 30, interval_us: -5 }, Instant::ZERO);
    assert_eq!(outputs(&mut getting, Instant::ZERO).1.pop().and_then(|event| event.done()), Some(Ok(Interval::Off)));
}
