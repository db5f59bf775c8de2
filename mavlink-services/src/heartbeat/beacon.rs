//! Who is there.

use core::convert::Infallible;
use core::error::Error;
use core::fmt;
use core::time::Duration;

use mavlink_wire::{Encode, Frame};

use crate::common::Heartbeat;
use crate::{Instant, Output, Service, convert};

/// Sends a heartbeat every second.
///
/// ```text
///   new             every second
///  ─────▶ Beating ──────────────▶ HEARTBEAT
///           ▲ │ set: the next one says something else
///           └─┘
/// ```
///
/// Poll it from the loop that does the work, not from a thread of its own, so that a program that hangs sends no heartbeats.
#[derive(Clone, Debug)]
pub struct Beacon {
    heartbeat: Heartbeat,
    interval: Duration,
    next: Instant,
}

impl Beacon {
    /// Sends this `HEARTBEAT` of any dialect every second, the first one at once.
    ///
    /// # Errors
    ///
    /// It is another message.
    pub fn new(heartbeat: &(impl Encode + ?Sized)) -> Result<Self, NoHeartbeat> {
        Self::with_interval(heartbeat, Duration::from_secs(1))
    }

    /// The same with another interval, for a link on which a second is too often; at least a millisecond.
    ///
    /// # Errors
    ///
    /// It is another message.
    pub fn with_interval(heartbeat: &(impl Encode + ?Sized), interval: Duration) -> Result<Self, NoHeartbeat> {
        let heartbeat = convert(heartbeat).ok_or(NoHeartbeat { message_id: heartbeat.info().id })?;
        Ok(Self { heartbeat, interval: interval.max(Duration::from_millis(1)), next: Instant::ZERO })
    }

    /// Says this from the next time on.
    ///
    /// # Errors
    ///
    /// It is another message.
    pub fn set(&mut self, heartbeat: &(impl Encode + ?Sized)) -> Result<(), NoHeartbeat> {
        self.heartbeat = convert(heartbeat).ok_or(NoHeartbeat { message_id: heartbeat.info().id })?;
        Ok(())
    }

    /// What is said.
    #[must_use]
    pub fn heartbeat(&self) -> &Heartbeat {
        &self.heartbeat
    }
}

/// Every second, the first one at once.
impl From<Heartbeat> for Beacon {
    fn from(heartbeat: Heartbeat) -> Self {
        Self { heartbeat, interval: Duration::from_secs(1), next: Instant::ZERO }
    }
}

impl Service for Beacon {
    type Event = Infallible;

    fn handle(&mut self, _: &Frame<'_>, _: Instant) {}

    fn poll(&mut self, now: Instant) -> Option<Output<Infallible>> {
        if now < self.next {
            return None;
        }
        // In step as long as it is polled in time; what was missed is not sent afterwards.
        let following = self.next + self.interval;
        self.next = if following > now { following } else { now + self.interval };
        Some(Output::Send(self.heartbeat.into()))
    }

    fn deadline(&self) -> Option<Instant> {
        Some(self.next)
    }
}

/// A message is no `HEARTBEAT` as `common` defines it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoHeartbeat {
    /// The id of the message.
    pub message_id: u32,
}

impl fmt::Display for NoHeartbeat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "message {} is no HEARTBEAT as common.xml defines it", self.message_id)
    }
}

impl Error for NoHeartbeat {}
