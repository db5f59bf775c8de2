//! Two machines and a bad link between them, in simulated time: the same seed gives the same run.
#![allow(dead_code, reason = "each test uses a part of it")]
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a part of tests")]

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::time::Duration;

use mavlink_services::{Address, Instant, Operation, Outgoing, Output, Service, Update};
use mavlink_wire::{Dialect, Encode, Frame, MAX_FRAME, Sender};

/// What a link does to frames.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weather {
    /// Frames of a hundred that are lost.
    pub(crate) loss: u64,
    /// Frames of a hundred that arrive twice.
    pub(crate) duplicates: u64,
    /// How long a frame takes at least, and by how much more at most: what takes longer is overtaken.
    pub(crate) delay: (Duration, Duration),
}

impl Weather {
    /// Nothing happens.
    pub(crate) const FINE: Self = Self { loss: 0, duplicates: 0, delay: (Duration::from_millis(5), Duration::ZERO) };

    /// Everything happens: 20 % loss, 10 % duplicates, delays of 5 to 255 ms, so that the order is lost as well.
    pub(crate) const BAD: Self =
        Self { loss: 20, duplicates: 10, delay: (Duration::from_millis(5), Duration::from_millis(250)) };
}

/// A sequence of numbers that a seed decides (SplitMix64).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn below(&mut self, end: u64) -> u64 {
        self.next() % end
    }
}

/// Which end of the link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum End {
    Station,
    Component,
}

/// What is done with the events of the one end, until it breaks.
pub(crate) type Watched<'w, M> = &'w mut dyn FnMut(&mut M, <M as Service>::Event, Instant) -> ControlFlow<()>;

/// What is done with the events of the other end.
pub(crate) type Told<'t, M> = &'t mut dyn FnMut(&mut M, <M as Service>::Event, Instant);

/// The link, and what went over it.
pub(crate) struct Simulation {
    pub(crate) now: Instant,
    weather: Weather,
    random: Random,
    /// By when they arrive, and by a number that tells those of one time apart.
    flying: BTreeMap<(Instant, u64), (End, Vec<u8>)>,
    sent: u64,
    senders: [Sender; 2],
    /// What was sent: when, by whom, and which message. Lost ones, too.
    pub(crate) trace: Vec<(Instant, End, Vec<u8>)>,
}

pub(crate) const STATION: (u8, u8) = (255, 190);
pub(crate) const COMPONENT: (u8, u8) = (1, 1);

pub(crate) fn station() -> Address {
    Address::new(STATION.0, STATION.1)
}

pub(crate) fn component() -> Address {
    Address::new(COMPONENT.0, COMPONENT.1)
}

impl Simulation {
    pub(crate) fn new(seed: u64, weather: Weather) -> Self {
        let senders = [Sender::v2(STATION.0, STATION.1), Sender::v2(COMPONENT.0, COMPONENT.1)];
        let (flying, trace) = (BTreeMap::new(), Vec::new());
        Self { now: Instant::ZERO, weather, random: Random::new(seed), flying, sent: 0, senders, trace }
    }

    /// The same, with both ends speaking MAVLink 1.
    pub(crate) fn v1(mut self) -> Self {
        self.senders = [Sender::v1(STATION.0, STATION.1), Sender::v1(COMPONENT.0, COMPONENT.1)];
        self
    }

    /// Puts a message on the link, as if that end had sent it.
    pub(crate) fn send(&mut self, from: End, message: &dyn Encode) {
        let sender = &mut self.senders[from as usize];
        let bytes = sender.encode(message, &mut [0; MAX_FRAME]).unwrap().to_vec();
        self.trace.push((self.now, from, bytes.clone()));
        self.put(from, bytes);
    }

    /// Puts the bytes of a frame on the link.
    pub(crate) fn put(&mut self, from: End, bytes: Vec<u8>) {
        let Weather { loss, duplicates, delay } = self.weather;
        let to = if from == End::Station { End::Component } else { End::Station };
        let copies = if self.random.below(100) < duplicates { 2 } else { 1 };
        for _ in 0..copies {
            if self.random.below(100) < loss {
                continue;
            }
            let more = delay.1.as_nanos() as u64;
            let arrives = self.now + delay.0 + Duration::from_nanos(self.random.below(more + 1));
            self.sent += 1;
            self.flying.insert((arrives, self.sent), (to, bytes.clone()));
        }
    }

    /// Runs both ends until the station's closure breaks, nothing happens any more, or the limit has passed.
    ///
    /// The closures get the events. A machine that wants to be polled without an end fails the test.
    pub(crate) fn run<S: Service, C: Service>(
        &mut self,
        station: (&mut S, Watched<'_, S>),
        component: (&mut C, Told<'_, C>),
        limit: Duration,
    ) -> ControlFlow<()> {
        let end = self.now + limit;
        let (station, on_station) = station;
        let (component, on_component) = component;
        loop {
            self.drain(station, End::Station, &mut |machine, event, now| on_station(machine, event, now))?;
            self.drain(component, End::Component, &mut |machine, event, now| {
                on_component(machine, event, now);
                ControlFlow::Continue(())
            })?;
            let next = mavlink_services::earliest(station.deadline(), component.deadline());
            let arrival = self.flying.first_key_value().map(|(key, _)| key.0);
            let Some(next) = mavlink_services::earliest(next, arrival).filter(|next| *next <= end) else {
                self.now = self.now.max(end);
                return ControlFlow::Continue(());
            };
            self.now = self.now.max(next);
            if arrival.is_some_and(|arrival| arrival <= self.now) {
                let (_, (to, bytes)) = self.flying.pop_first().unwrap();
                let frame = Frame::parse(&bytes, mavlink_services::common::Common::TABLE).unwrap();
                match to {
                    End::Station => station.handle(&frame, self.now),
                    End::Component => component.handle(&frame, self.now),
                }
            }
        }
    }

    fn drain<M: Service>(&mut self, machine: &mut M, end: End, on_event: Watched<'_, M>) -> ControlFlow<()> {
        for _ in 0..1000 {
            match machine.poll(self.now) {
                None => {
                    assert!(machine.deadline().is_none_or(|next| next > self.now), "a deadline that has passed");
                    return ControlFlow::Continue(());
                }
                Some(Output::Send(message)) => self.send(end, &message),
                Some(Output::Event(event)) => on_event(machine, event, self.now)?,
            }
        }
        panic!("the {end:?} does not come to rest at {:?}", self.now);
    }

    /// The messages of this kind that were sent, lost ones as well.
    pub(crate) fn sent<M: mavlink_wire::Message>(&self) -> Vec<(Instant, End, M)> {
        let table = mavlink_services::common::Common::TABLE;
        let decoded =
            self.trace.iter().map(|(at, end, bytes)| (*at, *end, Frame::parse(bytes, table).unwrap().decode()));
        decoded.filter_map(|(at, end, message)| Some((at, end, message?))).collect()
    }
}

/// All that a machine wants now: for tests that need no link.
pub(crate) fn outputs<S: Service>(machine: &mut S, now: Instant) -> (Vec<Outgoing>, Vec<S::Event>) {
    let (mut sent, mut events) = (Vec::new(), Vec::new());
    for _ in 0..1000 {
        match machine.poll(now) {
            None => return (sent, events),
            Some(Output::Send(message)) => sent.push(message),
            Some(Output::Event(event)) => events.push(event),
        }
    }
    panic!("it does not come to rest");
}

/// Hands a message over, as if it came from there.
pub(crate) fn give<S: Service>(machine: &mut S, from: (u8, u8), message: &dyn Encode, now: Instant) {
    let mut sender = Sender::v2(from.0, from.1);
    let mut buffer = [0; MAX_FRAME];
    let bytes = sender.encode(message, &mut buffer).unwrap();
    machine.handle(&Frame::parse(bytes, mavlink_services::common::Common::TABLE).unwrap(), now);
}

/// How an operation ended.
pub(crate) type Ended<O> = Result<<O as Operation>::Outcome, <O as Operation>::Failure>;

/// Runs an operation to its end, and gives that, what it told before, and what the component told.
pub(crate) fn finish<O: Operation, C: Service>(
    simulation: &mut Simulation,
    operation: &mut O,
    component: &mut C,
) -> (Ended<O>, Vec<O::Progress>, Vec<C::Event>) {
    let (mut end, mut told, mut events) = (None, vec![], vec![]);
    let _ = simulation.run(
        (operation, &mut |_, event, _| match event {
            Update::Progress(progress) => {
                told.push(progress);
                ControlFlow::Continue(())
            }
            Update::Done(result) => {
                end = Some(result);
                ControlFlow::Break(())
            }
        }),
        (component, &mut |_, event, _| events.push(event)),
        Duration::from_secs(3600),
    );
    (end.unwrap_or_else(|| panic!("an operation ends in an hour")), told, events)
}
