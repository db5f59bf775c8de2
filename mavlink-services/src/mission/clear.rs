//! A plan, cleared.

use mavlink_wire::Frame;

use super::access::Access;
use super::failure::{Awaited, Failure};
use crate::common::{MavMissionResult, MissionClearAll};
use crate::retry::Attempt;
use crate::{Instant, Output, Service, Update};

/// Clears a plan of a vehicle; all of them with `MavMissionType::ALL`.
///
/// ```text
///   ask ──▶ waiting ── the vehicle has done it ──▶ done
///    ▲         │ └──── it refuses ──▶ refused
///    └ timeout ┴▶ asked often enough: timed out
/// ```
///
/// ```
/// use mavlink_services::common::{MavMissionType, MissionClearAll};
/// use mavlink_services::mission::{Access, Clear};
/// use mavlink_services::{Address, Instant, Output, Service};
///
/// let access = Access::new(Address::new(255, 190), Address::new(1, 1)).plan(MavMissionType::FENCE);
/// let mut clear = Clear::new(access, Instant::ZERO);
/// let Some(Output::Send(question)) = clear.poll(Instant::ZERO) else { panic!() };
/// assert_eq!(question.decode::<MissionClearAll>().unwrap().mission_type, MavMissionType::FENCE);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Clear {
    access: Access,
    attempt: Attempt,
    state: State,
}

#[derive(Clone, Copy, Debug)]
enum State {
    Ask,
    Waiting,
    End(Result<(), Failure>),
    Over,
}

impl Clear {
    /// Clears the plan that the access is for.
    #[must_use]
    pub fn new(access: Access, now: Instant) -> Self {
        let state = access.check().map_or_else(|failure| State::End(Err(failure)), |()| State::Ask);
        Self { access, attempt: Attempt::start(access.retry, now), state }
    }
}

impl Service for Clear {
    type Event = Update<core::convert::Infallible, (), Failure>;

    fn handle(&mut self, frame: &Frame<'_>, _now: Instant) {
        if !matches!(self.state, State::Waiting) || !self.access.is_peer(frame) {
            return;
        }
        match self.access.acked(frame).map(|ack| ack.r#type) {
            Some(MavMissionResult::ACCEPTED) => self.state = State::End(Ok(())),
            Some(result) => self.state = State::End(Err(Failure::Refused(result))),
            None => {}
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        if matches!(self.state, State::Waiting) && !self.attempt.is_waiting(now) {
            let timeout = Failure::Timeout { awaited: Awaited::Ack, asked: self.attempt.asked() };
            self.state = if self.attempt.again(now) { State::Ask } else { State::End(Err(timeout)) };
        }
        match self.state {
            State::Ask => {
                self.state = State::Waiting;
                let (target_system, target_component) = self.access.peer.target();
                let mission_type = self.access.plan;
                Some(Output::Send(MissionClearAll { target_system, target_component, mission_type }.into()))
            }
            State::End(result) => {
                self.state = State::Over;
                Some(Output::Event(Update::Done(result)))
            }
            State::Waiting | State::Over => None,
        }
    }

    fn deadline(&self) -> Option<Instant> {
        matches!(self.state, State::Waiting).then(|| self.attempt.deadline())
    }
}
