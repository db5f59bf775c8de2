//! One parameter, read.

use mavlink_wire::Frame;

use super::failure::{Awaited, Failure};
use super::{Access, Name, Told, is_same};
use crate::common::{self, ParamRequestRead};
use crate::question::Question;
use crate::{Instant, Output, Service, Update};

/// Which parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The one with this name.
    Name(Name),
    /// The one at this place of the list, up to 32,767. A name is surer: places change where parameters come and go.
    Index(u16),
}

impl Which {
    /// Whether the message is about this one.
    fn is(&self, message: &common::ParamValue) -> bool {
        match self {
            Self::Name(name) => is_same(name, &message.param_id),
            Self::Index(index) => message.param_index == *index,
        }
    }

    /// Whether the error is about this one.
    fn is_refused(&self, error: &common::ParamError) -> bool {
        match self {
            Self::Name(name) => is_same(name, &error.param_id),
            Self::Index(index) => i16::try_from(*index).is_ok_and(|index| index == error.param_index),
        }
    }

    /// The question for it.
    pub(super) fn question(&self, access: &Access) -> ParamRequestRead {
        let (target_system, target_component) = access.peer.target();
        let (param_id, param_index) = match self {
            Self::Name(name) => (*name, -1),
            Self::Index(index) => (Name::default(), index.cast_signed()),
        };
        ParamRequestRead { target_system, target_component, param_id, param_index }
    }
}

/// Reads one parameter.
///
/// ```text
///            PARAM_VALUE of it ──▶ done
/// ask ──▶ waiting ── PARAM_ERROR ──▶ refused
///  ▲         │
///  └─────────┴ timeout ──▶ asked often enough: timed out
/// ```
///
/// ```
/// use mavlink_services::common::ParamRequestRead;
/// use mavlink_services::param::{Access, Encoding, Read, Which};
/// use mavlink_services::{Address, Instant, Output, Service};
///
/// let access = Access::new(Address::new(255, 190), Address::new(1, 1), Encoding::Cast);
/// let mut read = Read::new(access, Which::Name("RATE_P".try_into()?), Instant::ZERO);
/// let Some(Output::Send(question)) = read.poll(Instant::ZERO) else { panic!() };
/// assert_eq!(question.decode::<ParamRequestRead>().unwrap().param_id, "RATE_P");
/// # Ok::<(), mavlink_wire::TooLong>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Read {
    access: Access,
    which: Which,
    question: Question<Told, Failure>,
}

impl Read {
    /// Asks for this one.
    #[must_use]
    pub fn new(access: Access, which: Which, now: Instant) -> Self {
        let allowed = match which {
            // The message has 15 bits for it, and the highest one would ask for a name.
            Which::Index(index) if i16::try_from(index).is_err() => {
                Err(Failure::Refused(common::MavParamError::DOES_NOT_EXIST))
            }
            _ => Ok(()),
        };
        Self { access, which, question: Question::new(allowed, access.retry, now) }
    }
}

impl Service for Read {
    type Event = Update<core::convert::Infallible, Told, Failure>;

    fn handle(&mut self, frame: &Frame<'_>, _now: Instant) {
        if !self.question.is_open() {
            return;
        }
        if let Some(message) = self.access.value(frame).filter(|message| self.which.is(message)) {
            self.question.end(self.access.told(&message).map_err(Failure::Value));
        } else if let Some(error) = self.access.error(frame).filter(|error| self.which.is_refused(error)) {
            self.question.end(Err(Failure::Refused(error.error)));
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        let Self { access, which, question } = self;
        let ask = || which.question(access).into();
        question.poll(now, ask, |asked| Failure::Timeout { awaited: Awaited::Value, asked })
    }

    fn deadline(&self) -> Option<Instant> {
        self.question.deadline()
    }
}
