//! Who asks.

use mavlink_wire::{Frame, Message};

use super::Interval;
use crate::command::{Command, Failure, Fetch, Options, Send};
use crate::common::{CommandLong, MavCmd, MessageInterval};
use crate::{Address, Instant, Output, Retry, Service, Update};

/// Asks the peer to send the message with this id so often, by `MAV_CMD_SET_MESSAGE_INTERVAL`: a [`Send`], with its states.
///
/// A float carries all ids, and times to seven digits; what is over 35 minutes is sent as that.
#[must_use]
pub fn set(
    own: Address,
    peer: Address,
    options: Options,
    (message_id, interval): (u32, Interval),
    now: Instant,
) -> Send {
    let (param1, param2) = (message_id as f32, interval.to_micros() as f32);
    let command = CommandLong { command: MavCmd::SET_MESSAGE_INTERVAL, param1, param2, ..CommandLong::DEFAULT };
    Send::of(own, peer, options, (Command::Long(command), now))
}

/// Asks the peer how often it sends a message: a [`Fetch`] of `MESSAGE_INTERVAL`, with its states.
#[derive(Clone, Debug)]
pub struct Get {
    message_id: u16,
    fetch: Fetch<MessageInterval>,
}

impl Get {
    /// Asks for the message with this id; the answer has no room for ids over 65,535.
    #[must_use]
    pub fn new(own: Address, peer: Address, retry: Retry, message_id: u16, now: Instant) -> Self {
        Self { message_id, fetch: Fetch::new(own, peer, retry, f32::from(message_id), now) }
    }
}

impl Service for Get {
    type Event = Update<(), Interval, Failure>;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        // The peer may just have told somebody of another one.
        if frame.decode::<MessageInterval>().is_none_or(|answer| answer.message_id == self.message_id) {
            self.fetch.handle(frame, now);
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        Some(match self.fetch.poll(now)? {
            Output::Send(message) => Output::Send(message),
            Output::Event(Update::Progress(())) => Output::Event(Update::Progress(())),
            Output::Event(Update::Done(end)) => {
                Output::Event(Update::Done(end.map(|answer| Interval::from_micros(answer.interval_us))))
            }
        })
    }

    fn deadline(&self) -> Option<Instant> {
        self.fetch.deadline()
    }
}
