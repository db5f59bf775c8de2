//! Time synchronisation: clocks that differ, over links that delay, and answers that are none.

mod simulated;

use std::ops::ControlFlow;
use std::time::Duration;

use mavlink_services::common::Timesync;
use mavlink_services::timesync::{Failure, Measure, Options, Responder};
use mavlink_services::{Instant, Output, Service, Update};
use mavlink_wire::{Frame, Message};
use simulated::{COMPONENT, STATION, Simulation, Weather, component, give, outputs, station};

/// A responder whose clock is ahead of everybody's by 90 s.
struct Ahead(Responder);

const AHEAD: Duration = Duration::from_secs(90);

impl Service for Ahead {
    type Event = core::convert::Infallible;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        self.0.handle(frame, now + AHEAD);
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        self.0.poll(now + AHEAD)
    }

    fn deadline(&self) -> Option<Instant> {
        None
    }
}

#[test]
fn the_offset_is_right_within_half_the_round_trip() {
    for seed in 0..100 {
        let (mut simulation, mut responder) = (Simulation::new(seed, Weather::BAD), Ahead(Responder::new(component())));
        let mut measure = Measure::new(station(), component(), Options::DEFAULT, Instant::ZERO);
        let (mut end, mut samples) = (None, 0);
        let _ = simulation.run(
            (&mut measure, &mut |_, event, _| {
                match event {
                    Update::Progress(_) => samples += 1,
                    Update::Done(result) => end = Some(result),
                }
                ControlFlow::Continue(())
            }),
            (&mut responder, &mut |_, event, _| match event {}),
            Duration::from_secs(10),
        );
        let offset = end.unwrap().unwrap();
        let error = Duration::from_nanos((offset.nanos - AHEAD.as_nanos() as i64).unsigned_abs());
        assert!(error <= offset.round_trip / 2, "seed {seed}: {error:?} of {offset:?}");
        assert!((1..=8).contains(&samples));
        let then = Instant::from_millis(1234);
        assert_eq!(offset.to_own(offset.peer_nanos(then)), Some(then));
        assert_eq!(offset.to_own(0), None);
    }
}

#[test]
fn answers_to_others_count_for_nothing() {
    let mut measure =
        Measure::new(station(), component(), Options { samples: 2, ..Options::DEFAULT }, Instant::from_millis(5));
    let (sent, _) = outputs(&mut measure, Instant::from_millis(5));
    let asked = sent[0].decode::<Timesync>().unwrap();
    assert_eq!((asked.tc1, asked.ts1, asked.target_system), (0, 5_000_000, 1));
    let answer = Timesync { tc1: 9, target_system: STATION.0, target_component: STATION.1, ..asked };
    let now = Instant::from_millis(6);
    give(&mut measure, (1, 9), &answer, now);
    give(&mut measure, COMPONENT, &Timesync { ts1: 4_000_000, ..answer }, now);
    give(&mut measure, COMPONENT, &Timesync { tc1: 0, ..answer }, now);
    give(&mut measure, COMPONENT, &Timesync { target_system: 7, ..answer }, now);
    assert!(outputs(&mut measure, now).1.is_empty());
    let (sent, events) = outputs(&mut measure, Instant::from_millis(505));
    assert_eq!((sent.len(), events.len()), (1, 0));
    // The answer to the first question is late; the second is never answered.
    give(&mut measure, COMPONENT, &answer, Instant::from_millis(506));
    let (sent, events) = outputs(&mut measure, Instant::from_millis(1005));
    assert_eq!((sent.len(), events), (0, vec![Update::Done(Err(Failure::Timeout { asked: 2 }))]));
    assert_eq!(measure.deadline(), None);
}

#[test]
fn clocks_at_the_ends_of_time_do_not_overflow() {
    let late = Instant::from_nanos(u64::MAX - 1_000_000_000);
    for tc1 in [i64::MIN, i64::MAX] {
        let mut measure = Measure::new(station(), component(), Options { samples: 1, ..Options::DEFAULT }, late);
        let (sent, _) = outputs(&mut measure, late);
        let ts1 = sent[0].decode::<Timesync>().unwrap().ts1;
        let answer = Timesync { tc1, ts1, ..Timesync::DEFAULT };
        give(&mut measure, COMPONENT, &answer, Instant::MAX);
        let (_, events) = outputs(&mut measure, Instant::MAX);
        assert!(matches!(events[..], [Update::Progress(_), Update::Done(Ok(_))]), "{events:?}");
    }
}

#[test]
fn a_responder_answers_whom_it_concerns() {
    let mut responder = Responder::new(component());
    for (target_system, answers) in [(0, 1), (1, 1), (2, 0)] {
        give(&mut responder, STATION, &Timesync { ts1: 7, target_system, ..Timesync::DEFAULT }, Instant::ZERO);
        let (sent, _) = outputs(&mut responder, Instant::ZERO);
        assert_eq!(sent.len(), answers);
        if let Some(sent) = sent.first() {
            let answer = Timesync { tc1: 1, ts1: 7, target_system: STATION.0, target_component: STATION.1 };
            assert_eq!(sent.decode(), Some(answer));
        }
    }
    give(&mut responder, STATION, &Timesync { tc1: 3, ..Timesync::DEFAULT }, Instant::ZERO);
    assert!(outputs(&mut responder, Instant::ZERO).0.is_empty(), "an answer is no question");
}
