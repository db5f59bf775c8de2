//! A question and its answer: what the simple operations are made of.

use core::convert::Infallible;

use crate::retry::Attempt;
use crate::{Instant, Outgoing, Output, Retry, Update};

/// A question that is asked again until it is answered, or was asked often enough.
///
/// ```text
///   ask ──▶ waiting ── end ──▶ told ──▶ over
///    ▲         │                ▲
///    └ timeout ┴────────────────┘ asked often enough
/// ```
#[derive(Clone, Copy, Debug)]
pub(crate) struct Question<T, F> {
    attempt: Attempt,
    state: State<T, F>,
}

#[derive(Clone, Copy, Debug)]
enum State<T, F> {
    Ask,
    Waiting,
    End(Result<T, F>),
    Over,
}

impl<T: Copy, F: Copy> Question<T, F> {
    /// To be asked now, unless something is to be said against it.
    pub(crate) fn new(allowed: Result<(), F>, retry: Retry, now: Instant) -> Self {
        let state = allowed.map_or_else(|failure| State::End(Err(failure)), |()| State::Ask);
        Self { attempt: Attempt::start(retry, now), state }
    }

    /// Whether it has not been answered.
    pub(crate) fn is_open(&self) -> bool {
        matches!(self.state, State::Ask | State::Waiting)
    }

    /// Whether it has been asked, and the answer is still to come.
    pub(crate) fn is_waiting(&self) -> bool {
        matches!(self.state, State::Waiting)
    }

    /// This is the answer.
    pub(crate) fn end(&mut self, answer: Result<T, F>) {
        self.state = State::End(answer);
    }

    /// The next thing to do. `timeout` is the failure after so many questions.
    pub(crate) fn poll(
        &mut self,
        now: Instant,
        ask: impl FnOnce() -> Outgoing,
        timeout: impl FnOnce(u16) -> F,
    ) -> Option<Output<Update<Infallible, T, F>>> {
        if self.is_waiting() && !self.attempt.is_waiting(now) {
            let asked = self.attempt.asked();
            self.state = if self.attempt.again(now) { State::Ask } else { State::End(Err(timeout(asked))) };
        }
        match self.state {
            State::Ask => {
                self.state = State::Waiting;
                Some(Output::Send(ask()))
            }
            State::End(result) => {
                self.state = State::Over;
                Some(Output::Event(Update::Done(result)))
            }
            State::Waiting | State::Over => None,
        }
    }

    pub(crate) fn deadline(&self) -> Option<Instant> {
        self.is_waiting().then(|| self.attempt.deadline())
    }
}
