//! A plan, cleared.

use mavlink_wire::Frame;

use super::access::Access;
use super::failure::{Awaited, Failure};
use crate::common::{MavMissionResult, MissionClearAll};
use crate::question::Question;
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
    question: Question<(), Failure>,
}

impl Clear {
    /// Clears the plan that the access is for.
    #[must_use]
    pub fn new(access: Access, now: Instant) -> Self {
        Self { access, question: Question::new(access.check(), access.retry, now) }
    }
}

impl Service for Clear {
    type Event = Update<core::convert::Infallible, (), Failure>;

    fn handle(&mut self, frame: &Frame<'_>, _now: Instant) {
        if !self.question.is_waiting() || !self.access.is_peer(frame) {
            return;
        }
        match self.access.acked(frame).map(|ack| ack.r#type) {
            Some(MavMissionResult::ACCEPTED) => self.question.end(Ok(())),
            Some(result) => self.question.end(Err(Failure::Refused(result))),
            None => {}
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        let Self { access, question } = self;
        let ask = || {
            let (target_system, target_component) = access.peer.target();
            MissionClearAll { target_system, target_component, mission_type: access.plan }.into()
        };
        question.poll(now, ask, |asked| Failure::Timeout { awaited: Awaited::Ack, asked })
    }

    fn deadline(&self) -> Option<Instant> {
        self.question.deadline()
    }
}
