//! The trait that all machines implement.

use mavlink_wire::Frame;

use crate::{Instant, Outgoing};

/// One end of a protocol, without io and without a clock.
///
/// Run it in a loop: pass it each received frame, send the messages that it returns, wait for the next frame or the deadline.
///
/// ```
/// use mavlink_services::{Instant, Outgoing, Service};
/// use mavlink_wire::Frame;
///
/// /// Call this for each received frame, and when the deadline has passed.
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
/// Times may repeat and may be late; they must not go back. If you do not [`poll`](Self::poll), you lose events and nothing else:
/// a machine keeps only the last event of each kind.
pub trait Service {
    /// What the machine reports to the program.
    type Event;

    /// Takes a received frame. Pass all frames: the machine ignores those that are not for it.
    fn handle(&mut self, frame: &Frame<'_>, now: Instant);

    /// The next thing to do now. Call it until it returns `None`: after each [`handle`](Self::handle), after each call that starts
    /// or answers something, and at the [`deadline`](Self::deadline).
    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>>;

    /// When to poll again if no frame comes; `None` means never. Ask after [`poll`](Self::poll) returned `None`.
    fn deadline(&self) -> Option<Instant>;

    /// Polls until there is an event, and sends the messages before it. `None` means that all is done for now.
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

/// What the program has to do for a machine.
#[derive(Clone, Copy, Debug)]
pub enum Output<E> {
    /// Send this message to the other side.
    Send(Outgoing),
    /// Look at this event.
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
