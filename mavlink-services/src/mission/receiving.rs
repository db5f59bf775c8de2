//! A plan on its way to the vehicle.

use mavlink_wire::Frame;

use super::access::Form;
use super::download::request;
use crate::common::MavMissionType;
use crate::retry::Attempt;
use crate::{Address, Instant, Outgoing, Retry};

/// The transfer that is under way: the vehicle asks for one item after the other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Receiving {
    pub(super) from: Address,
    pub(super) plan: MavMissionType,
    pub(super) next: u16,
    pub(super) end: u16,
    /// How items are asked for: a station may be too old for `MISSION_REQUEST_INT`, so both are tried until one is answered.
    form: Form,
    retry: Retry,
    attempt: Attempt,
    ask: bool,
}

impl Receiving {
    pub(super) fn new(
        from: Address,
        plan: MavMissionType,
        (next, end): (u16, u16),
        retry: Retry,
        now: Instant,
    ) -> Self {
        let attempt = Attempt::start(retry, now);
        Self { from, plan, next, end, form: Form::Int, retry, attempt, ask: true }
    }

    /// Whether what a frame says of a plan is about this transfer.
    pub(super) fn is_with(&self, frame: &Frame<'_>, plan: MavMissionType) -> bool {
        self.from == Address::of(frame) && self.plan == plan
    }

    /// The next item has come, in this form; gives whether it was the last one.
    pub(super) fn advance(&mut self, form: Form, now: Instant) -> bool {
        if form == Form::Int {
            self.form = Form::Int;
        }
        self.next = self.next.saturating_add(1);
        self.attempt = Attempt::start(self.retry, now);
        self.ask = self.next < self.end;
        !self.ask
    }

    /// The question for the next item, if it is to be asked now.
    pub(super) fn question(&mut self) -> Option<Outgoing> {
        core::mem::take(&mut self.ask).then(|| request(self.from, self.plan, self.next, self.form))
    }

    /// Asks again if the answer is overdue; `false` says that the station is gone.
    pub(super) fn is_alive(&mut self, now: Instant) -> bool {
        if self.ask || self.attempt.is_waiting(now) {
            return true;
        }
        self.form = self.form.other();
        self.ask = self.attempt.again(now);
        self.ask
    }

    pub(super) fn deadline(&self) -> Instant {
        self.attempt.deadline()
    }
}
