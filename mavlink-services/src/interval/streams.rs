//! Who sends.

use core::time::Duration;

use mavlink_wire::{Frame, Message};

use super::Interval;
use crate::command::Command;
use crate::common::{MavCmd, MavResult, MessageInterval};
use crate::{Instant, Output, Service, earliest};

/// The messages that a component sends, and how often.
///
/// ```text
///          SET_MESSAGE_INTERVAL                  REQUEST_MESSAGE
///   Off ◀──────────────────────▶ Every(t)     ──────────────────▶ Event::Due once
///                                 │ ▲
///                                 └─┘ Event::Due every t
/// ```
///
/// It reads no frames: hand it the commands of a [`command::Component`](crate::command::Component), and answer with what
/// [`command`](Self::command) gives. It asks for a message that is due; the program makes it and sends it.
#[derive(Clone, Debug)]
pub struct Streams<const N: usize> {
    slots: [Slot; N],
    /// A `MESSAGE_INTERVAL` is to be sent for this one.
    told: Option<MessageInterval>,
}

/// A message that a component can send.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stream {
    /// Its id.
    pub message_id: u32,
    /// How often it is sent if nobody asks for anything else; `None` is never.
    pub default: Option<Duration>,
    /// The shortest interval. Whoever asks for less gets this; nothing goes below a millisecond.
    pub shortest: Duration,
}

/// What [`Streams`] tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Event {
    /// The message with this id is to be sent now.
    Due(u32),
}

#[derive(Clone, Copy, Debug)]
struct Slot {
    stream: Stream,
    every: Option<Duration>,
    next: Instant,
    /// Asked for once.
    wanted: bool,
}

impl Slot {
    fn set(&mut self, interval: Interval, now: Instant) {
        let shortest = self.stream.shortest.max(Duration::from_millis(1));
        self.every = match interval {
            Interval::Off => None,
            Interval::Default => self.stream.default,
            Interval::Every(time) => Some(time),
        };
        self.every = self.every.map(|time| time.max(shortest));
        self.next = self.every.map_or(Instant::MAX, |time| now + time);
    }

    fn told(&self) -> i32 {
        self.every.map_or(Interval::Off, Interval::Every).to_micros()
    }
}

impl<const N: usize> Streams<N> {
    /// Sends these by their defaults.
    #[must_use]
    pub fn new(streams: [Stream; N], now: Instant) -> Self {
        let slots = streams.map(|stream| {
            let mut slot = Slot { stream, every: None, next: now, wanted: false };
            slot.set(Interval::Default, now);
            slot
        });
        Self { slots, told: None }
    }

    /// Carries out `SET_MESSAGE_INTERVAL`, `REQUEST_MESSAGE` and `GET_MESSAGE_INTERVAL`, and gives the result to be acknowledged;
    /// `None` if it is another command, or asks for a message that is not among these.
    ///
    /// That one is then yours: a message that is only sent when asked for, or `MAV_RESULT_UNSUPPORTED`.
    pub fn command(&mut self, command: &Command, now: Instant) -> Option<MavResult> {
        let [id, argument, ..] = command.params();
        match command.command() {
            MavCmd::SET_MESSAGE_INTERVAL => {
                let micros = to_integer(argument, -1, i32::MAX);
                let slot = self.slot(to_id(id)?)?;
                let Some(micros) = micros else { return Some(MavResult::DENIED) };
                slot.set(Interval::from_micros(micros), now);
                Some(MavResult::ACCEPTED)
            }
            MavCmd::GET_MESSAGE_INTERVAL => Some(self.tell(id)),
            MavCmd::REQUEST_MESSAGE if to_id(id) == Some(MessageInterval::ID) => Some(self.tell(argument)),
            MavCmd::REQUEST_MESSAGE => {
                self.slot(to_id(id)?)?.wanted = true;
                Some(MavResult::ACCEPTED)
            }
            _ => None,
        }
    }

    /// How often a message is sent, `None` is never or not at all.
    #[must_use]
    pub fn every(&self, message_id: u32) -> Option<Duration> {
        self.slots.iter().find(|slot| slot.stream.message_id == message_id)?.every
    }

    fn slot(&mut self, message_id: u32) -> Option<&mut Slot> {
        self.slots.iter_mut().find(|slot| slot.stream.message_id == message_id)
    }

    fn tell(&mut self, id: f32) -> MavResult {
        let Some(id) = to_id(id) else { return MavResult::DENIED };
        let Ok(message_id) = u16::try_from(id) else { return MavResult::DENIED };
        // 0: that is not available.
        let interval_us = self.slot(id).map_or(0, |slot| slot.told());
        self.told = Some(MessageInterval { message_id, interval_us });
        MavResult::ACCEPTED
    }
}

/// The id that a float carries.
fn to_id(value: f32) -> Option<u32> {
    to_integer(value, 0, 0xff_ffff).and_then(|id| u32::try_from(id).ok())
}

/// The integer that a float is, if it is one within the bounds.
fn to_integer(value: f32, least: i32, most: i32) -> Option<i32> {
    let integer = value as i32;
    if integer as f32 == value && (least..=most).contains(&integer) { Some(integer) } else { None }
}

impl<const N: usize> Service for Streams<N> {
    type Event = Event;

    fn handle(&mut self, _: &Frame<'_>, _: Instant) {}

    fn poll(&mut self, now: Instant) -> Option<Output<Event>> {
        if let Some(told) = self.told.take() {
            return Some(Output::Send(told.into()));
        }
        let is_due = |slot: &&mut Slot| slot.wanted || (slot.every.is_some() && now >= slot.next);
        let slot = self.slots.iter_mut().find(is_due)?;
        if let Some(every) = slot.every.filter(|_| now >= slot.next) {
            // In step as long as it is polled in time; what was missed is not sent afterwards.
            let following = slot.next + every;
            slot.next = if following > now { following } else { now + every };
        }
        slot.wanted = false;
        Some(Output::Event(Event::Due(slot.stream.message_id)))
    }

    fn deadline(&self) -> Option<Instant> {
        let sent = self.slots.iter().filter(|slot| slot.every.is_some());
        sent.fold(None, |first, slot| earliest(first, Some(slot.next)))
    }
}
