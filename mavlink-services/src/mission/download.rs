//! A plan, fetched from a vehicle.

use mavlink_wire::Frame;

use super::access::{Access, Form};
use super::failure::{Awaited, Failure};
use super::item::MissionItem;
use crate::common::{
    self, MavMissionResult, MissionCount, MissionItemInt, MissionRequest, MissionRequestInt, MissionRequestList,
};
use crate::retry::Attempt;
use crate::{Instant, Outgoing, Output, Service, Update};

/// How often the first item is asked for in one form alone. If there is no answer, both forms are tried in turn.
const ONE_FORM: u16 = 8;

/// Fetches the plan of a vehicle, one item after the other, in order. It tells them as they come and keeps none.
///
/// If the vehicle does not answer the question for the first item, it is asked with `MISSION_REQUEST_INT` and with the old
/// `MISSION_REQUEST` in turn; the others go by what it knew.
///
/// ```text
/// ask how many ──▶ waiting ── count ──▶ ask for an item ──▶ waiting ── the last one ──▶ acknowledge ──▶ done
///   ▲                 │                   ▲  ▲                │ │
///   └──── timeout ────┴▶ often enough:    │  └── the item ────┘ │
///                        timed out        └───── timeout ───────┴▶ often enough: timed out
///
/// waiting ── the vehicle refuses ──▶ refused
/// ```
///
/// ```
/// use mavlink_services::common::MissionRequestList;
/// use mavlink_services::mission::{Access, Download};
/// use mavlink_services::{Address, Instant, Output, Service};
///
/// let mut download = Download::new(Access::new(Address::new(255, 190), Address::new(1, 1)), Instant::ZERO);
/// let Some(Output::Send(question)) = download.poll(Instant::ZERO) else { panic!() };
/// assert!(question.decode::<MissionRequestList>().is_some());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Download {
    access: Access,
    limit: u16,
    /// Indices of the first and the last item, if not all are wanted.
    part: Option<(u16, u16)>,
    attempt: Attempt,
    state: State,
    next: u16,
    end: u16,
    opaque_id: u32,
    /// What came, until it is told. Nothing is taken before that: it counts as lost.
    news: Option<Item>,
}

#[derive(Clone, Copy, Debug)]
enum State {
    AskCount,
    AwaitCount,
    AskItem,
    AwaitItem,
    /// The vehicle is to be told how it ended.
    Acknowledge(MavMissionResult, Result<Downloaded, Failure>),
    End(Result<Downloaded, Failure>),
    Over,
}

/// An item of a plan that is fetched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Item {
    /// Its index in the plan.
    pub seq: u16,
    /// What it is.
    pub item: MissionItem,
    /// How many items have come.
    pub received: u16,
    /// How many will come.
    pub count: u16,
}

/// A plan was fetched.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Downloaded {
    /// How many items were told.
    pub count: u16,
    /// What the vehicle calls its plan: it is the same until the plan changes (`MISSION_CURRENT`). 0 if it does not say.
    pub opaque_id: u32,
}

impl Download {
    /// Fetches the whole plan.
    #[must_use]
    pub fn new(access: Access, now: Instant) -> Self {
        let attempt = Attempt::start(access.retry, now);
        let state = access.check().map_or_else(|failure| State::End(Err(failure)), |()| State::AskCount);
        Self { access, limit: u16::MAX, part: None, attempt, state, next: 0, end: 0, opaque_id: 0, news: None }
    }

    /// Fetches the items from the first to the last of these indices only. Any vehicle knows how.
    #[must_use]
    pub fn part(access: Access, first: u16, last: u16, now: Instant) -> Self {
        Self { part: Some((first, last)), ..Self::new(access, now) }
    }

    /// Takes no more items than this; a longer plan is an error.
    #[must_use]
    pub fn with_limit(self, limit: u16) -> Self {
        Self { limit, ..self }
    }

    /// Gives up, and tells the vehicle so.
    pub fn cancel(&mut self) {
        if !matches!(self.state, State::End(_) | State::Over) {
            self.state = State::Acknowledge(MavMissionResult::OPERATION_CANCELLED, Err(Failure::Cancelled));
        }
    }

    fn first(&self) -> u16 {
        self.part.map_or(0, |(first, _)| first)
    }

    /// How many items are wanted.
    fn count(&self) -> u16 {
        self.end.saturating_sub(self.first())
    }

    /// The vehicle has so many items.
    fn counted(&mut self, count: u16, opaque_id: u32, now: Instant) {
        if !matches!(self.state, State::AskCount | State::AwaitCount) {
            return;
        }
        let end = self.part.map_or(count, |(_, last)| last.saturating_add(1));
        (self.next, self.end, self.opaque_id) = (self.first(), end, opaque_id);
        if end > count || self.next >= end && self.part.is_some() {
            let failure = Failure::NoSuchItem { count };
            self.state = State::Acknowledge(MavMissionResult::OPERATION_CANCELLED, Err(failure));
        } else if self.count() > self.limit {
            self.state = State::Acknowledge(MavMissionResult::NO_SPACE, Err(Failure::TooMany { count }));
        } else {
            self.go_on(now);
        }
    }

    /// Asks for the next item, if there is one.
    fn go_on(&mut self, now: Instant) {
        self.attempt = Attempt::start(self.access.item_retry, now);
        self.state = if self.next < self.end {
            State::AskItem
        } else {
            let done = Downloaded { count: self.count(), opaque_id: self.opaque_id };
            State::Acknowledge(MavMissionResult::ACCEPTED, Ok(done))
        };
    }

    /// An item has come; `None` if it cannot be understood.
    fn take(&mut self, (seq, form): (u16, Form), item: Option<MissionItem>, now: Instant) {
        if seq != self.next || !matches!(self.state, State::AskItem | State::AwaitItem) {
            return;
        }
        let Some(item) = item else {
            self.state = State::Acknowledge(MavMissionResult::INVALID_PARAM5_X, Err(Failure::Position { seq }));
            return;
        };
        if seq == self.first() {
            self.access.form = form;
        }
        self.next = self.next.saturating_add(1);
        let received = self.next.saturating_sub(self.first());
        self.news = Some(Item { seq, item, received, count: self.count() });
        self.go_on(now);
    }

    fn refused(&mut self, result: MavMissionResult) {
        let waiting = matches!(self.state, State::AskCount | State::AwaitCount | State::AskItem | State::AwaitItem);
        if waiting && result != MavMissionResult::ACCEPTED {
            self.state = State::End(Err(Failure::Refused(result)));
        }
    }

    fn overdue(&mut self, now: Instant) {
        let (awaited, question) = match self.state {
            State::AwaitItem => (Awaited::Item(self.next), State::AskItem),
            _ => (Awaited::Count, State::AskCount),
        };
        let timeout = Failure::Timeout { awaited, asked: self.attempt.asked() };
        self.state = if self.attempt.again(now) { question } else { State::End(Err(timeout)) };
    }

    fn ask_count(&self) -> Outgoing {
        let (target_system, target_component) = self.access.peer.target();
        MissionRequestList { target_system, target_component, mission_type: self.access.plan }.into()
    }

    fn ask_item(&self) -> Outgoing {
        let asked = self.attempt.asked();
        let other = self.next == self.first() && asked > ONE_FORM && asked.is_multiple_of(2);
        let form = if other { self.access.form.other() } else { self.access.form };
        request(self.access.peer, self.access.plan, self.next, form)
    }
}

/// The question for an item.
pub(super) fn request(to: crate::Address, mission_type: common::MavMissionType, seq: u16, form: Form) -> Outgoing {
    let (target_system, target_component) = to.target();
    match form {
        Form::Int => MissionRequestInt { target_system, target_component, seq, mission_type }.into(),
        Form::Float => MissionRequest { target_system, target_component, seq, mission_type }.into(),
    }
}

impl Service for Download {
    type Event = Update<Item, Downloaded, Failure>;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        let access = self.access;
        if !access.is_peer(frame) || self.news.is_some() {
            return;
        }
        if let Some(item) = frame.decode::<MissionItemInt>() {
            if access.concerns((item.target_system, item.target_component), item.mission_type) {
                self.take((item.seq, Form::Int), Some(item.into()), now);
            }
        } else if let Some(item) = frame.decode::<common::MissionItem>() {
            if access.concerns((item.target_system, item.target_component), item.mission_type) {
                self.take((item.seq, Form::Float), MissionItem::of_float(&item), now);
            }
        } else if let Some(count) = frame.decode::<MissionCount>() {
            if access.concerns((count.target_system, count.target_component), count.mission_type) {
                self.counted(count.count, count.opaque_id, now);
            }
        } else if let Some(ack) = access.acked(frame) {
            self.refused(ack.r#type);
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        if let Some(item) = self.news.take() {
            return Some(Output::Event(Update::Progress(item)));
        }
        if matches!(self.state, State::AwaitCount | State::AwaitItem) && !self.attempt.is_waiting(now) {
            self.overdue(now);
        }
        match self.state {
            State::AskCount => {
                self.state = State::AwaitCount;
                Some(Output::Send(self.ask_count()))
            }
            State::AskItem => {
                self.state = State::AwaitItem;
                Some(Output::Send(self.ask_item()))
            }
            State::Acknowledge(result, end) => {
                self.state = State::End(end);
                Some(Output::Send(self.access.ack(result)))
            }
            State::End(result) => {
                self.state = State::Over;
                Some(Output::Event(Update::Done(result)))
            }
            State::AwaitCount | State::AwaitItem | State::Over => None,
        }
    }

    fn deadline(&self) -> Option<Instant> {
        matches!(self.state, State::AwaitCount | State::AwaitItem).then(|| self.attempt.deadline())
    }
}
