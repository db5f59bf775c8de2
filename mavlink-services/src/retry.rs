//! Waiting for an answer, and asking again.

use core::time::Duration;

use crate::Instant;

/// How long a station waits for an answer, and how often it asks.
///
/// The MAVLink guide leaves the numbers to implementations; these are what stations commonly use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Retry {
    /// How long one answer may take.
    pub timeout: Duration,
    /// How often it is asked again after the first time.
    pub retries: u8,
}

impl Retry {
    /// A second, and five more tries. At 20 % loss each way, 1 of 450 exchanges fails; over a good link, none.
    pub const DEFAULT: Self = Self { timeout: Duration::from_millis(1000), retries: 5 };
}

impl Default for Retry {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// A question that is being asked.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Attempt {
    timeout: Duration,
    until: Instant,
    left: u8,
    asked: u16,
}

impl Attempt {
    /// Asked for the first time now.
    pub(crate) fn start(retry: Retry, now: Instant) -> Self {
        Self { timeout: retry.timeout, until: now + retry.timeout, left: retry.retries, asked: 1 }
    }

    /// How often it has been asked, from 1 to 256.
    pub(crate) fn asked(&self) -> u16 {
        self.asked
    }

    /// When the answer is overdue.
    pub(crate) fn deadline(&self) -> Instant {
        self.until
    }

    /// Whether there is still time for the answer.
    pub(crate) fn is_waiting(&self, now: Instant) -> bool {
        now < self.until
    }

    /// Waits this much from now on, without having asked again.
    pub(crate) fn extend(&mut self, now: Instant, wait: Duration) {
        self.until = now + wait;
    }

    /// Asks again, if it may; `false` says that it was asked often enough.
    pub(crate) fn again(&mut self, now: Instant) -> bool {
        let Some(left) = self.left.checked_sub(1) else { return false };
        *self = Self { left, asked: self.asked.saturating_add(1), until: now + self.timeout, ..*self };
        true
    }
}
