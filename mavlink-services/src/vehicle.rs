//! One machine that answers all protocols of a vehicle.

use mavlink_wire::Frame;

use crate::heartbeat::Beacon;
use crate::interval::{Stream, Streams};
use crate::mission::{self, Plans};
use crate::param::{self, Encoding, Parameters};
use crate::{Address, Instant, Output, Service, command, earliest, interval, timesync};

/// The component sides of all protocols in one machine.
///
/// The parts are public: answer commands with [`commands`](Self::commands), change the heartbeat with [`beacon`](Self::beacon). The
/// vehicle itself answers commands about message intervals and the current item. To leave out a protocol, compose the other machines
/// yourself, as this type does.
#[derive(Clone, Debug)]
pub struct Vehicle<P, M, const STREAMS: usize> {
    /// Its heartbeat.
    pub beacon: Beacon,
    /// The commands that it was given.
    pub commands: command::Component,
    /// The messages that it sends.
    pub streams: Streams<STREAMS>,
    /// Its parameters.
    pub params: param::Component<P>,
    /// Its mission, fence and rally points.
    pub plans: mission::Component<M>,
    clock: timesync::Responder,
}

/// What a [`Vehicle`] reports.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// Carry this out, and [finish](command::Component::finish) it.
    Command(command::Request),
    /// The sender would like this command stopped.
    Cancel(command::Ticket),
    /// A parameter has another value.
    Param(param::Set),
    /// Something happened to the plans.
    Plans(mission::ComponentEvent),
    /// The message with this id is to be sent now.
    Due(u32),
}

impl<P: Parameters, M: Plans, const STREAMS: usize> Vehicle<P, M, STREAMS> {
    /// A vehicle with this address and heartbeat, which sends these messages.
    #[must_use]
    pub fn new(
        own: Address,
        beacon: Beacon,
        streams: [Stream; STREAMS],
        (encoding, params): (Encoding, P),
        plans: M,
    ) -> Self {
        Self {
            beacon,
            commands: command::Component::new(own),
            streams: Streams::new(streams, Instant::ZERO),
            params: param::Component::new(own, encoding, params),
            plans: mission::Component::new(own, plans),
            clock: timesync::Responder::new(own),
        }
    }

    /// What of a command event is not done here.
    fn command(&mut self, event: command::Event, now: Instant) -> Option<Event> {
        match event {
            command::Event::Request(request) => {
                match self.streams.command(&request.command, now).or_else(|| self.plans.command(&request)) {
                    Some(result) => {
                        self.commands.finish(request.ticket, result, now);
                        None
                    }
                    None => Some(Event::Command(request)),
                }
            }
            command::Event::Cancel(ticket) => Some(Event::Cancel(ticket)),
        }
    }
}

/// The same output, with another event or none.
fn map<A, B>(output: Output<A>, event: impl FnOnce(A) -> B) -> Output<B> {
    match output {
        Output::Send(message) => Output::Send(message),
        Output::Event(told) => Output::Event(event(told)),
    }
}

impl<P: Parameters, M: Plans, const STREAMS: usize> Service for Vehicle<P, M, STREAMS> {
    type Event = Event;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        self.clock.handle(frame, now);
        self.commands.handle(frame, now);
        self.params.handle(frame, now);
        self.plans.handle(frame, now);
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Event>> {
        if let Some(output) = self.clock.poll(now) {
            return Some(map(output, |never| match never {}));
        }
        while let Some(output) = self.commands.poll(now) {
            match output {
                Output::Send(message) => return Some(Output::Send(message)),
                Output::Event(event) => {
                    if let Some(event) = self.command(event, now) {
                        return Some(Output::Event(event));
                    }
                }
            }
        }
        if let Some(output) = self.params.poll(now) {
            return Some(map(output, Event::Param));
        }
        if let Some(output) = self.plans.poll(now) {
            return Some(map(output, Event::Plans));
        }
        if let Some(output) = self.beacon.poll(now) {
            return Some(map(output, |never| match never {}));
        }
        let output = self.streams.poll(now)?;
        Some(map(output, |interval::Event::Due(message_id)| Event::Due(message_id)))
    }

    fn deadline(&self) -> Option<Instant> {
        let parts = [self.commands.deadline(), self.params.deadline(), self.plans.deadline(), self.streams.deadline()];
        parts.into_iter().fold(self.beacon.deadline(), earliest)
    }
}
