//! One parameter, set.

use mavlink_wire::Frame;

use super::failure::{Awaited, Failure};
use super::{Access, Name, ParamValue, Read, Told, Which, is_same};
use crate::common::{self, MavParamType, ParamSet};
use crate::retry::Attempt;
use crate::{Instant, Output, Service, Update};

/// How often another value may come back before it is taken for the answer: the first one may have been under way already.
const REFUSALS: u8 = 2;

/// Sets one parameter, and waits until the component says that it has the new value.
///
/// First it asks what type the parameter has, so that any number that the type can hold will do: `5` for an integer of 8 bits as
/// well as for a float. Who knows the type saves the question: [`of_kind`](Self::of_kind).
///
/// ```text
/// learn the type (as Read does) ─▶ set ──▶ waiting ── PARAM_VALUE, the new value ──▶ done
///    │ does not fit: failed         ▲         │ ├──── PARAM_ERROR ──▶ refused
///    ▼                              └ timeout ┘ └──── timeout after an old value, twice ──▶ kept
///                                                     timeout, asked often enough ──▶ timed out
/// ```
///
/// ```
/// use mavlink_services::common::{MavParamType, ParamSet};
/// use mavlink_services::param::{Access, Encoding, Write};
/// use mavlink_services::{Address, Instant, Output, Service};
///
/// let access = Access::new(Address::new(255, 190), Address::new(1, 1), Encoding::Bytewise);
/// let mut write = Write::of_kind(access, "SYS_AUTOSTART".try_into()?, 4001, MavParamType::INT32, Instant::ZERO);
/// let Some(Output::Send(set)) = write.poll(Instant::ZERO) else { panic!() };
/// assert_eq!(set.decode::<ParamSet>().unwrap().param_value.to_bits(), 4001);
/// # Ok::<(), mavlink_wire::TooLong>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Write {
    access: Access,
    name: Name,
    value: ParamValue,
    /// The field that carries the value, once its type is known.
    field: f32,
    attempt: Attempt,
    state: State,
    /// Another value that came after the last question, and how often that was so.
    kept: Option<ParamValue>,
    refusals: u8,
}

#[derive(Clone, Copy, Debug)]
enum State {
    Learn(Read),
    Set,
    Wait,
    End(Result<Told, Failure>),
    Over,
}

impl Write {
    /// Sets this parameter to this number.
    #[must_use]
    pub fn new(access: Access, name: Name, value: impl Into<ParamValue>, now: Instant) -> Self {
        let learn = State::Learn(Read::new(access, Which::Name(name), now));
        let attempt = Attempt::start(access.retry, now);
        Self { access, name, value: value.into(), field: 0.0, attempt, state: learn, kept: None, refusals: 0 }
    }

    /// Sets this parameter, which has this type, to this number.
    #[must_use]
    pub fn of_kind(access: Access, name: Name, value: impl Into<ParamValue>, kind: MavParamType, now: Instant) -> Self {
        let mut write = Self::new(access, name, value, now);
        write.set(kind, now);
        write
    }

    /// Goes on to the question itself, if the type can hold the number.
    fn set(&mut self, kind: MavParamType, now: Instant) {
        let fitting = self.value.to_kind(kind);
        self.state = match fitting.and_then(|value| Ok((value, self.access.encoding.encode(value)?))) {
            Ok((value, field)) => {
                (self.value, self.field) = (value, field);
                self.attempt = Attempt::start(self.access.retry, now);
                State::Set
            }
            Err(error) => State::End(Err(error.into())),
        };
    }

    /// Takes what is said of the parameter while a confirmation is awaited.
    fn answer(&mut self, message: &common::ParamValue) {
        match self.access.told(message) {
            Ok(told) if self.is_taken(told.value) => self.state = State::End(Ok(told)),
            Ok(told) => self.kept = Some(told.value),
            // In the other encoding, or of another type: no confirmation, and no refusal.
            Err(_) => {}
        }
    }

    /// Whether this is the number that was set, as far as a message can carry it.
    fn is_taken(&self, value: ParamValue) -> bool {
        let field = value.to_kind(self.value.kind()).and_then(|value| self.access.encoding.encode(value));
        field.is_ok_and(|field| field == self.field || field.to_bits() == self.field.to_bits())
    }

    /// The answer is overdue.
    fn overdue(&mut self, now: Instant) {
        self.refusals = self.refusals.saturating_add(u8::from(self.kept.is_some()));
        let timeout = Failure::Timeout { awaited: Awaited::Confirmation, asked: self.attempt.asked() };
        self.state = match self.kept.take() {
            Some(value) if self.refusals >= REFUSALS => State::End(Err(Failure::Kept(value))),
            _ if self.attempt.again(now) => State::Set,
            Some(value) => State::End(Err(Failure::Kept(value))),
            None => State::End(Err(timeout)),
        };
    }

    fn message(&self) -> ParamSet {
        let (target_system, target_component) = self.access.peer.target();
        let (param_id, param_value, param_type) = (self.name, self.field, self.value.kind());
        ParamSet { target_system, target_component, param_id, param_value, param_type }
    }
}

impl Service for Write {
    type Event = Update<core::convert::Infallible, Told, Failure>;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        match &mut self.state {
            State::Learn(read) => read.handle(frame, now),
            State::Set | State::Wait => {
                if let Some(message) = self.access.value(frame).filter(|message| is_same(&self.name, &message.param_id))
                {
                    self.answer(&message);
                } else if let Some(error) =
                    self.access.error(frame).filter(|error| is_same(&self.name, &error.param_id))
                {
                    self.state = State::End(Err(Failure::Refused(error.error)));
                }
            }
            State::End(_) | State::Over => {}
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        if let State::Learn(read) = &mut self.state {
            match read.poll(now)? {
                Output::Event(Update::Done(Ok(told))) => self.set(told.value.kind(), now),
                Output::Event(Update::Done(Err(failure))) => self.state = State::End(Err(failure)),
                question => return Some(question),
            }
        }
        if matches!(self.state, State::Wait) && !self.attempt.is_waiting(now) {
            self.overdue(now);
        }
        match self.state {
            State::Set => {
                self.state = State::Wait;
                Some(Output::Send(self.message().into()))
            }
            State::End(result) => {
                self.state = State::Over;
                Some(Output::Event(Update::Done(result)))
            }
            State::Learn(_) | State::Wait | State::Over => None,
        }
    }

    fn deadline(&self) -> Option<Instant> {
        match &self.state {
            State::Learn(read) => read.deadline(),
            State::Wait => Some(self.attempt.deadline()),
            State::Set | State::End(_) | State::Over => None,
        }
    }
}
