//! All parameters of a component.

use mavlink_wire::Frame;

use super::failure::{Awaited, Failure};
use super::{Access, Name, ParamValue, Which, index_of};
use crate::common::{self, ParamRequestList};
use crate::retry::Attempt;
use crate::{Instant, Output, Service, Update};

/// Parameters that may be asked for at once when gaps are filled.
const WINDOW: u8 = 8;

/// The longest list: `PARAM_REQUEST_READ` has 15 bits for an index.
const LONGEST: u16 = 1 << 15;

/// How often a list is begun anew because its length changed.
const RESTARTS: u8 = 3;

/// The name under which PX4 sends a hash of all its parameters before the list.
const HASH: &[u8] = b"_HASH_CHECK";

/// Lists all parameters of a component: asks for the list, then for each parameter of it that did not come.
///
/// Parameters are told as they come, in any order, perhaps more than once: the last of an index counts. All that is kept is a bit for
/// each, in storage of yours: `[u8; 128]` is for 1,024 parameters. Components that are listed have up to 32,768 of them, as more
/// cannot be asked for one by one.
///
/// ```text
/// ask ──▶ listing ── the last index, or silence ──▶ filling ── all are there ──▶ done
///  ▲         │                                      │  ▲ │
///  │ timeout ┴▶ asked often enough: timed out       │  └─┴ ask for some that are missing
///  └──────────── another length, up to 3 times ─────┘      asked in vain often enough: timed out
/// ```
///
/// ```
/// use mavlink_services::common::ParamRequestList;
/// use mavlink_services::param::{Access, Encoding, List};
/// use mavlink_services::{Address, Instant, Output, Service};
///
/// let access = Access::new(Address::new(255, 190), Address::new(1, 1), Encoding::Bytewise);
/// let mut list = List::new(access, [0; 128], Instant::ZERO);
/// let Some(Output::Send(question)) = list.poll(Instant::ZERO) else { panic!() };
/// assert!(question.decode::<ParamRequestList>().is_some());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct List<S> {
    access: Access,
    seen: S,
    count: u16,
    received: u16,
    restarts: u8,
    attempt: Attempt,
    state: State,
    /// What came, until it is told. A second one is not taken before that: it counts as lost.
    news: Option<ListProgress>,
}

#[derive(Clone, Copy, Debug)]
enum State {
    Ask,
    Listing,
    /// Gaps from `next` on are to be asked for; so many answers are awaited.
    Filling {
        next: u16,
        awaited: u8,
    },
    End(Result<u16, Failure>),
    Over,
}

/// What a [`List`] tells on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ListProgress {
    /// A parameter.
    Value(Listed),
    /// PX4's hash of all names and values: who kept the list of the last time with this hash can stop here.
    Hash(u32),
    /// The component has another number of parameters than it said before: what was told so far is void.
    Restarted,
}

/// A parameter of a list.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Listed {
    /// Its name, empty if the component refused to tell the parameter. Two indices may have the same one: the component has a
    /// fault then, and only the first can be set.
    pub name: Name,
    /// Its value, or why there is none. It counts as listed all the same.
    pub value: Result<ParamValue, Failure>,
    /// Its place; `None` if somebody set it just now, and the component does not say.
    pub index: Option<u16>,
    /// How many of the list have come.
    pub received: u16,
    /// How many the list has.
    pub count: u16,
}

impl<S: AsRef<[u8]> + AsMut<[u8]>> List<S> {
    /// Asks for the list, with storage of a bit for each parameter.
    #[must_use]
    pub fn new(access: Access, storage: S, now: Instant) -> Self {
        let attempt = Attempt::start(access.retry, now);
        let mut list =
            Self { access, seen: storage, count: 0, received: 0, restarts: 0, attempt, state: State::Ask, news: None };
        list.seen.as_mut().fill(0);
        list
    }

    fn capacity(&self) -> u16 {
        u16::try_from(self.seen.as_ref().len().saturating_mul(8)).unwrap_or(LONGEST).min(LONGEST)
    }

    fn is_seen(&self, index: u16) -> bool {
        self.seen.as_ref().get(usize::from(index / 8)).is_some_and(|byte| byte >> (index % 8) & 1 == 1)
    }

    /// Takes a parameter, or what is said of one.
    fn take(&mut self, message: &common::ParamValue, now: Instant) {
        let index = index_of(message);
        if index.is_some() && message.param_count != self.count && !self.resize(message.param_count, now) {
            return;
        }
        let value = self.access.encoding.decode(message.param_value, message.param_type);
        if index.is_none() && message.param_id.as_bytes() == HASH {
            self.news = Some(ListProgress::Hash(message.param_value.to_bits()));
            if message.param_count == 0 {
                self.state = State::End(Ok(0));
            }
            return;
        }
        self.count_in(index, now);
        self.tell(message.param_id, value.map_err(Failure::Value), index);
    }

    fn tell(&mut self, name: Name, value: Result<ParamValue, Failure>, index: Option<u16>) {
        let (received, count) = (self.received, self.count);
        self.news = Some(ListProgress::Value(Listed { name, value, index, received, count }));
    }

    /// The list has this length; `false` if it cannot be taken, or is to be begun anew.
    fn resize(&mut self, count: u16, now: Instant) -> bool {
        let capacity = self.capacity();
        let first = self.count == 0;
        if count > capacity {
            self.state = State::End(Err(Failure::TooMany { count, capacity }));
        } else if first {
            self.count = count;
        } else if self.restarts == RESTARTS {
            self.state = State::End(Err(Failure::Unsteady));
        } else {
            self.restarts += 1;
            (self.count, self.received) = (0, 0);
            self.seen.as_mut().fill(0);
            (self.state, self.attempt) = (State::Ask, Attempt::start(self.access.retry, now));
            self.news = Some(ListProgress::Restarted);
        }
        first && count <= capacity
    }

    /// The one at this place has come, if it was not here before.
    fn count_in(&mut self, index: Option<u16>, now: Instant) {
        let Some(index) = index.filter(|index| !self.is_seen(*index)) else { return };
        let Some(byte) = self.seen.as_mut().get_mut(usize::from(index / 8)) else { return };
        *byte |= 1 << (index % 8);
        self.received = self.received.saturating_add(1);
        self.attempt = Attempt::start(self.access.retry, now);
        match &mut self.state {
            _ if self.received == self.count => self.state = State::End(Ok(self.count)),
            State::Ask | State::Listing if index == self.count - 1 => {
                self.state = State::Filling { next: 0, awaited: 0 }
            }
            State::Filling { awaited, .. } => *awaited = awaited.saturating_sub(1),
            _ => {}
        }
    }

    /// Nothing new has come for as long as an answer may take.
    fn overdue(&mut self, now: Instant) {
        let awaited = match self.count.saturating_sub(self.received) {
            0 => Awaited::List,
            missing => Awaited::Rest { missing },
        };
        let timeout = Failure::Timeout { awaited, asked: self.attempt.asked() };
        self.state = match self.attempt.again(now) {
            false => State::End(Err(timeout)),
            true if self.received == 0 => State::Ask,
            true => State::Filling { next: 0, awaited: 0 },
        };
    }

    /// Asks for the next one that is missing, if not enough have been asked for.
    fn fill(&mut self) -> Option<Output<<Self as Service>::Event>> {
        let State::Filling { next, awaited } = self.state else { return None };
        if awaited >= WINDOW {
            return None;
        }
        let index = (next..self.count).find(|index| !self.is_seen(*index));
        let next = index.map_or(self.count, |index| index.saturating_add(1));
        self.state = State::Filling { next, awaited: awaited.saturating_add(u8::from(index.is_some())) };
        let question = Which::Index(index?).question(&self.access);
        Some(Output::Send(question.into()))
    }
}

impl<S: AsRef<[u8]> + AsMut<[u8]>> Service for List<S> {
    type Event = Update<ListProgress, u16, Failure>;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        if matches!(self.state, State::End(_) | State::Over) || self.news.is_some() {
            return;
        }
        if let Some(message) = self.access.value(frame) {
            self.take(&message, now);
        } else if let Some(error) = self.access.error(frame)
            && let Some(index) = u16::try_from(error.param_index).ok().filter(|index| *index < self.count)
            && !self.is_seen(index)
        {
            // The component has it and cannot tell it: the list is whole without it.
            self.count_in(Some(index), now);
            self.tell(error.param_id, Err(Failure::Refused(error.error)), Some(index));
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        if let Some(news) = self.news.take() {
            return Some(Output::Event(Update::Progress(news)));
        }
        if matches!(self.state, State::Listing | State::Filling { .. }) && !self.attempt.is_waiting(now) {
            self.overdue(now);
        }
        match self.state {
            State::Ask => {
                self.state = State::Listing;
                let (target_system, target_component) = self.access.peer.target();
                Some(Output::Send(ParamRequestList { target_system, target_component }.into()))
            }
            State::Filling { .. } => self.fill(),
            State::End(result) => {
                self.state = State::Over;
                Some(Output::Event(Update::Done(result)))
            }
            State::Listing | State::Over => None,
        }
    }

    fn deadline(&self) -> Option<Instant> {
        matches!(self.state, State::Listing | State::Filling { .. }).then(|| self.attempt.deadline())
    }
}
