//! The shape of a machine.

use mavlink_wire::Frame;

use crate::{Instant, Outgoing};

/// One end of a protocol, without io and without a clock.
///
/// The whole of it is a loop: hand over what comes, send what it says, wait for the next of both.
///
/// ```
/// use mavlink_services::{Instant, Outgoing, Service};
/// use mavlink_wire::Frame;
///
/// /// What a loop does each time that a frame came, or the deadline passed.
/// fn step<S: Service>(
///     service: &mut S,
///     frame: Option<&Frame<'_>>,
///     now: Instant,
///     mut send: impl FnMut(&Outgoing),
///     mut tell: impl FnMut(S::Event),
/// ) -> Option<Instant> {
///     if let Some(frame) = frame {
///         service.handle(frame, now);
///     }
///     while let Some(event) = service.next_event(now, &mut send) {
///         tell(event);
///     }
///     service.deadline()
/// }
/// ```
///
/// Times may repeat and may be late; they must not go back. Who does not [`poll`](Self::poll) loses events, and nothing else
/// goes wrong: a machine keeps the last of a kind.
pub trait Service {
    /// What is to be told to the program.
    type Event;

    /// Takes a frame. Any frame will do: what is not this machine's is left alone.
    fn handle(&mut self, frame: &Frame<'_>, now: Instant);

    /// What is to be done now: call it until it gives `None`, after each [`handle`](Self::handle), after each call that starts
    /// or answers something, and at the [`deadline`](Self::deadline).
    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>>;

    /// When there will be something to do although no frame comes; `None` is never. Ask after [`poll`](Self::poll) gave `None`.
    fn deadline(&self) -> Option<Instant>;

    /// Polls until there is an event, and sends what is to be sent before it. `None`: all is done for now.
    fn next_event(&mut self, now: Instant, mut send: impl FnMut(&Outgoing)) -> Option<Self::Event>
    where
        Self: Sized,
    {
        loop {
            match self.poll(now)? {
                Output::Send(message) => send(&message),
                Output::Event(event) => return Some(event),
            }
        }
    }
}

/// What a machine wants.
#[derive(Clone, Copy, Debug)]
pub enum Output<E> {
    /// This is to be sent to the other side.
    Send(Outgoing),
    /// This is to be told to the program.
    Event(E),
}

/// The first of two deadlines, to wait for several machines.
#[must_use]
pub fn earliest(one: Option<Instant>, other: Option<Instant>) -> Option<Instant> {
    match (one, other) {
        (Some(one), Some(other)) => Some(one.min(other)),
        (one, other) => one.or(other),
    }
}
