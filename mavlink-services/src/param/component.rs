//! The side that has the parameters.

use core::time::Duration;

use mavlink_wire::{Frame, Version};

use super::{Encoding, Name, Param, ParamValue, Parameters, ValueError};
use crate::common::{self, MavParamError, MavParamType, ParamRequestList, ParamRequestRead, ParamSet};
use crate::{Address, Instant, Output, Service};

/// Answers that may be due at once. What is asked beyond that is not heard, and will be asked again.
const ANSWERS: usize = 8;

/// How far a list may fall behind its pace and catch up.
const BEHIND: u32 = 8;

/// Answers stations that list, read and set the parameters of a component.
///
/// ```text
///          PARAM_REQUEST_LIST ──▶ one PARAM_VALUE after the other, at the pace; asked again meanwhile: once more around
/// idle ──▶ PARAM_REQUEST_READ ──▶ PARAM_VALUE at once, or PARAM_ERROR
///          PARAM_SET ───────────▶ set or refused ──▶ PARAM_VALUE at once, and PARAM_ERROR if refused
/// ```
///
/// `PARAM_ERROR` goes to who asked in MAVLink 2 only: MAVLink 1 cannot carry it.
///
/// ```
/// use mavlink_services::param::{Component, Encoding, Param, Parameters};
/// use mavlink_services::Address;
///
/// let table = [Param::new("RATE_P", 0.2_f32), Param::new("MOTORS", 4_u8)];
/// let mut component = Component::new(Address::new(1, 1), Encoding::Bytewise, table);
/// component.parameters_mut().set(1, 6_u8.into()).unwrap();
/// component.announce(1);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Component<P> {
    own: Address,
    encoding: Encoding,
    options: ComponentOptions,
    parameters: P,
    list: Option<Cursor>,
    answers: [Option<Answer>; ANSWERS],
    set: Option<Set>,
}

/// How a component answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ComponentOptions {
    /// Time between two parameters of a list, so that nothing is lost where a link is slow: 10 ms unless told otherwise, which
    /// leaves a third of 57,600 baud to others.
    pub pace: Duration,
}

impl ComponentOptions {
    /// The usual pace.
    pub const DEFAULT: Self = Self { pace: Duration::from_millis(10) };
}

impl Default for ComponentOptions {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// A station has set a parameter. If it is not polled for, the last one is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Set {
    /// Its place.
    pub index: u16,
    /// Its name and the value that it has now.
    pub param: Param,
    /// The value that it had.
    pub before: ParamValue,
    /// Who did it.
    pub by: Address,
}

/// Where a list is.
#[derive(Clone, Copy, Debug)]
struct Cursor {
    next: u16,
    remaining: u16,
    due: Instant,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Answer {
    /// The value of this one; who can be told if it cannot be sent.
    Value(u16, Option<Address>),
    Error(common::ParamError),
}

impl<P: Parameters> Component<P> {
    /// The parameters of this component, whose values are sent in this encoding. `AUTOPILOT_VERSION` has to
    /// [say so](Encoding::capability).
    #[must_use]
    pub fn new(own: Address, encoding: Encoding, parameters: P) -> Self {
        let options = ComponentOptions::DEFAULT;
        Self { own, encoding, options, parameters, list: None, answers: [None; ANSWERS], set: None }
    }

    /// The same with other options.
    #[must_use]
    pub fn with_options(self, options: ComponentOptions) -> Self {
        Self { options, ..self }
    }

    /// The parameters.
    pub const fn parameters(&self) -> &P {
        &self.parameters
    }

    /// The parameters, to be changed; [`announce`](Self::announce) tells the stations.
    pub const fn parameters_mut(&mut self) -> &mut P {
        &mut self.parameters
    }

    /// Tells all stations the value of the parameter at this place, which has changed.
    pub fn announce(&mut self, index: u16) {
        self.answer(Answer::Value(index, None));
    }

    /// Something is to be answered, unless it already is or there is too much of it.
    fn answer(&mut self, answer: Answer) {
        if self.answers.contains(&Some(answer)) {
            return;
        }
        if let Some(free) = self.answers.iter_mut().find(|free| free.is_none()) {
            *free = Some(answer);
        }
    }

    /// Refuses a request, if who asked can be told.
    fn refuse(&mut self, to: Option<Address>, param_id: Name, param_index: i16, error: MavParamError) {
        if let Some(to) = to {
            self.answer(Answer::Error(refusal(to, param_id, param_index, error)));
        }
    }

    fn list(&mut self, now: Instant) {
        let remaining = self.parameters.count();
        let next = self.list.map_or(0, |cursor| cursor.next);
        let due = self.list.map_or(now, |cursor| cursor.due);
        self.list = (remaining > 0).then_some(Cursor { next, remaining, due });
    }

    fn read(&mut self, request: &ParamRequestRead, by: Option<Address>) {
        let index = match request.param_index {
            -1 => self.parameters.find(&request.param_id),
            index => u16::try_from(index).ok().filter(|index| *index < self.parameters.count()),
        };
        match index {
            Some(index) => self.answer(Answer::Value(index, by)),
            None => self.refuse(by, request.param_id, request.param_index, MavParamError::DOES_NOT_EXIST),
        }
    }

    fn write(&mut self, request: &ParamSet, by: Address, answerable: Option<Address>) {
        let found = self.parameters.find(&request.param_id);
        let Some((index, before)) = found.and_then(|index| Some((index, self.parameters.get(index)?))) else {
            return self.refuse(answerable, request.param_id, -1, MavParamError::DOES_NOT_EXIST);
        };
        let value = self.value_of(request, before.value.kind());
        match value.and_then(|value| self.parameters.set(index, value).map(|()| value)) {
            Ok(value) => {
                let param = self.parameters.get(index).unwrap_or(Param { value, ..before });
                self.set = Some(Set { index, param, before: before.value, by });
            }
            Err(error) => self.refuse(answerable, request.param_id, -1, error),
        }
        self.answer(Answer::Value(index, answerable));
    }

    /// The value in a request for a parameter of this type. Bytes have to be of that type; a number is converted, as stations that
    /// send numbers do not care for types.
    fn value_of(&self, request: &ParamSet, kind: MavParamType) -> Result<ParamValue, MavParamError> {
        if self.encoding == Encoding::Bytewise && request.param_type != kind {
            return Err(MavParamError::TYPE_MISMATCH);
        }
        self.encoding.decode(request.param_value, kind).map_err(|error| match error {
            ValueError::OutOfRange | ValueError::NotAnInteger | ValueError::Inexact => {
                MavParamError::VALUE_OUT_OF_RANGE
            }
            ValueError::TooWide | ValueError::UnknownType(_) => MavParamError::TYPE_UNSUPPORTED,
        })
    }

    /// The message that tells the parameter at this place.
    fn message(&self, param_index: u16) -> Result<common::ParamValue, MavParamError> {
        let Param { name, value } = self.parameters.get(param_index).ok_or(MavParamError::READ_FAIL)?;
        let param_value = self.encoding.encode(value).map_err(|_| MavParamError::TYPE_UNSUPPORTED)?;
        let param_count = self.parameters.count();
        Ok(common::ParamValue { param_id: name, param_value, param_type: value.kind(), param_count, param_index })
    }

    /// The next answer that is due.
    fn next_answer(&mut self) -> Option<crate::Outgoing> {
        while let Some(answer) = self.answers.first().copied().flatten() {
            self.answers.rotate_left(1);
            if let Some(taken) = self.answers.last_mut() {
                *taken = None;
            }
            match answer {
                Answer::Error(error) => return Some(error.into()),
                Answer::Value(index, to) => match (self.message(index), to) {
                    (Ok(message), _) => return Some(message.into()),
                    (Err(error), Some(to)) => {
                        let name = self.parameters.get(index).map(|param| param.name).unwrap_or_default();
                        return Some(refusal(to, name, index.cast_signed(), error).into());
                    }
                    (Err(_), None) => {}
                },
            }
        }
        None
    }

    /// The next parameter of the list, if it is time for it. One that cannot be sent is left out: who asks for it is told why.
    fn next_of_list(&mut self, now: Instant) -> Option<crate::Outgoing> {
        let mut cursor = self.list.filter(|cursor| cursor.due <= now)?;
        let mut message = None;
        while message.is_none() && cursor.remaining > 0 {
            if cursor.next >= self.parameters.count() {
                cursor.next = 0;
            }
            message = self.message(cursor.next).ok();
            (cursor.next, cursor.remaining) = (cursor.next.saturating_add(1), cursor.remaining - 1);
        }
        // In additions: a product of durations can panic.
        let tolerated = (0..BEHIND).fold(cursor.due, |due, _| due + self.options.pace);
        cursor.due += now - tolerated;
        cursor.due += self.options.pace;
        self.list = (cursor.remaining > 0).then_some(cursor);
        Some(message?.into())
    }
}

fn refusal(to: Address, param_id: Name, param_index: i16, error: MavParamError) -> common::ParamError {
    let (target_system, target_component) = to.target();
    common::ParamError { target_system, target_component, param_id, param_index, error }
}

impl<P: Parameters> Service for Component<P> {
    type Event = Set;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        let by = Address::of(frame);
        let answerable = (frame.version() == Version::V2).then_some(by);
        if self.own.addressed::<ParamRequestList>(frame).is_some() {
            self.list(now);
        } else if let Some(request) = self.own.addressed(frame) {
            self.read(&request, answerable);
        } else if let Some(request) = self.own.addressed(frame) {
            self.write(&request, by, answerable);
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Set>> {
        if let Some(set) = self.set.take() {
            return Some(Output::Event(set));
        }
        self.next_answer().or_else(|| self.next_of_list(now)).map(Output::Send)
    }

    fn deadline(&self) -> Option<Instant> {
        self.list.map(|cursor| cursor.due)
    }
}
