//! The item that a vehicle is at, set.

use mavlink_wire::Frame;

use super::access::Access;
use super::failure::{Awaited, Failure};
use crate::common::{MissionCurrent, MissionSetCurrent};
use crate::question::Question;
use crate::{Instant, Output, Service, Update};

/// Sends a vehicle to an item of its mission, with `MISSION_SET_CURRENT`, and waits until it says that it is at it.
///
/// Newer vehicles have a command for it, `MAV_CMD_DO_SET_MISSION_CURRENT`, which they acknowledge. This message they refuse, if at
/// all, in a `STATUSTEXT`: then it ends with a timeout.
///
/// ```text
///   ask ──▶ waiting ── MISSION_CURRENT with this item ──▶ done
///    ▲         │
///    └ timeout ┴▶ asked often enough: timed out
/// ```
///
/// ```
/// use mavlink_services::common::MissionSetCurrent;
/// use mavlink_services::mission::{Access, SetCurrent};
/// use mavlink_services::{Address, Instant, Output, Service};
///
/// let access = Access::new(Address::new(255, 190), Address::new(1, 1));
/// let mut set = SetCurrent::new(access, 3, Instant::ZERO);
/// let Some(Output::Send(question)) = set.poll(Instant::ZERO) else { panic!() };
/// assert_eq!(question.decode::<MissionSetCurrent>().unwrap().seq, 3);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SetCurrent {
    access: Access,
    seq: u16,
    question: Question<(), Failure>,
}

impl SetCurrent {
    /// Sends the vehicle to the item with this index.
    #[must_use]
    pub fn new(access: Access, seq: u16, now: Instant) -> Self {
        Self { access, seq, question: Question::new(Ok(()), access.retry, now) }
    }
}

impl Service for SetCurrent {
    type Event = Update<core::convert::Infallible, (), Failure>;

    fn handle(&mut self, frame: &Frame<'_>, _now: Instant) {
        let waiting = self.question.is_waiting() && self.access.is_peer(frame);
        if waiting && frame.decode::<MissionCurrent>().is_some_and(|current| current.seq == self.seq) {
            self.question.end(Ok(()));
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        let Self { access, seq, question } = self;
        let ask = || {
            let (target_system, target_component) = access.peer.target();
            MissionSetCurrent { target_system, target_component, seq: *seq }.into()
        };
        question.poll(now, ask, |asked| Failure::Timeout { awaited: Awaited::Current(*seq), asked })
    }

    fn deadline(&self) -> Option<Instant> {
        self.question.deadline()
    }
}
