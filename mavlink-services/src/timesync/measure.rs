//! Who wants to know the other's clock.

use core::error::Error;
use core::fmt;
use core::time::Duration;

use mavlink_wire::Frame;

use crate::common::Timesync;
use crate::{Address, Instant, Output, Service, Update};

/// Measures how far the peer's clock is ahead.
///
/// ```text
///   new             its answer, or silence: the next one
///  ─────▶ Asking ─────────────────────────────────────┐
///           │  ▲                                      │
///           │  └──────────────────────────────────────┘
///           ▼ all asked
///         Done: the quickest answer, or none at all
/// ```
///
/// The way there and the way back are taken to be equally long. What they differ by is an error, of at most half the round trip:
/// that is why the quickest of several answers is taken. Clocks drift; measure again from time to time.
#[derive(Clone, Debug)]
pub struct Measure {
    own: Address,
    peer: Address,
    options: Options,
    /// Questions that are left, with the one under way.
    left: u8,
    /// When the question under way was sent, if it was.
    asked: Option<Instant>,
    next: Instant,
    best: Option<Offset>,
    told: Option<Offset>,
    finished: bool,
}

/// How thoroughly a [`Measure`] measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// How often it asks; at least once.
    pub samples: u8,
    /// How long one answer may take.
    pub timeout: Duration,
}

impl Options {
    /// Eight times, each up to half a second.
    pub const DEFAULT: Self = Self { samples: 8, timeout: Duration::from_millis(500) };
}

impl Default for Options {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// What an exchange, or the best of several, found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Offset {
    /// What the peer's clock is ahead, in nanoseconds; less than zero if it is behind.
    pub nanos: i64,
    /// How long question and answer took; half of it is the largest possible error.
    pub round_trip: Duration,
}

impl Offset {
    /// What the peer's clock shows at this time, in nanoseconds.
    #[must_use]
    pub fn peer_nanos(self, now: Instant) -> i64 {
        clock(now).saturating_add(self.nanos)
    }

    /// When the peer's clock showed this; `None` is before one's own was started.
    #[must_use]
    pub fn to_own(self, peer_nanos: i64) -> Option<Instant> {
        u64::try_from(peer_nanos.saturating_sub(self.nanos)).ok().map(Instant::from_nanos)
    }
}

/// A clock as the wire has it; 292 years are enough.
pub(super) fn clock(now: Instant) -> i64 {
    i64::try_from(now.to_nanos()).unwrap_or(i64::MAX)
}

/// The clock is unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Failure {
    /// The peer answered none of so many questions.
    Timeout {
        /// How often it was asked.
        asked: u8,
    },
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self::Timeout { asked } = self;
        write!(f, "TIMESYNC was sent {asked} times, and the answer never came")
    }
}

impl Error for Failure {}

impl Measure {
    /// Asks this peer.
    #[must_use]
    pub fn new(own: Address, peer: Address, options: Options, now: Instant) -> Self {
        let (left, asked, next) = (options.samples.max(1), None, now);
        Self { own, peer, options, left, asked, next, best: None, told: None, finished: false }
    }

    fn end(&self) -> Result<Offset, Failure> {
        self.best.ok_or(Failure::Timeout { asked: self.options.samples.max(1) })
    }
}

impl Service for Measure {
    type Event = Update<Offset, Offset, Failure>;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        let (Some(answer), Some(asked)) = (frame.decode::<Timesync>(), self.asked) else { return };
        let for_us = self.own.is_target(answer.target_system, answer.target_component);
        if answer.tc1 == 0 || answer.ts1 != clock(asked) || !for_us || !self.peer.includes(Address::of(frame)) {
            return;
        }
        let round_trip = now - asked;
        let middle = asked + round_trip / 2;
        let offset = Offset { nanos: answer.tc1.saturating_sub(clock(middle)), round_trip };
        if self.best.is_none_or(|best| round_trip < best.round_trip) {
            self.best = Some(offset);
        }
        (self.told, self.asked, self.next) = (Some(offset), None, now);
        self.left = self.left.saturating_sub(1);
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        if self.asked.is_some() && now >= self.next {
            self.asked = None;
            self.left = self.left.saturating_sub(1);
        }
        if let Some(offset) = self.told.take() {
            return Some(Output::Event(Update::Progress(offset)));
        }
        if self.finished || self.asked.is_some() {
            return None;
        }
        if self.left == 0 {
            self.finished = true;
            return Some(Output::Event(Update::Done(self.end())));
        }
        let (target_system, target_component) = self.peer.target();
        (self.asked, self.next) = (Some(now), now + self.options.timeout);
        Some(Output::Send(Timesync { tc1: 0, ts1: clock(now), target_system, target_component }.into()))
    }

    fn deadline(&self) -> Option<Instant> {
        if self.finished { None } else { Some(self.next) }
    }
}
