//! A plan, sent to a vehicle.

use mavlink_wire::Frame;

use super::access::{Access, Form};
use super::failure::{Awaited, Failure};
use super::item::MissionItem;
use crate::common::{MavMissionResult, MissionCount, MissionRequest, MissionRequestInt, MissionWritePartialList};
use crate::retry::Attempt;
use crate::{Instant, Outgoing, Output, Service, Update};

/// How often the first item may be asked for with the old message before it is sent in the old one, too: the answer may be lost.
const OLD_QUESTIONS: u8 = 2;

/// Sends a plan to a vehicle, which asks for one item after the other.
///
/// The items are yours: a slice, an array, a vector. A vehicle that asks for the first one a third time with `MISSION_REQUEST` does not
/// know `MISSION_ITEM_INT`, and gets floats from then on.
///
/// ```text
/// announce ──▶ waiting ── asks for the first item ──▶ sending ── says it has all ──▶ done
///    ▲            │                                   ▲  │ ▲ └── refuses ──▶ refused
///    └── timeout ─┴▶ often enough: timed out          │  │ └ asks for an item: sent
///                                                     └──┴ timeout: the last item once more, if it was sent;
///                                                          nothing new for long enough: timed out
/// ```
///
/// ```
/// use mavlink_services::common::{MavCmd, MissionCount};
/// use mavlink_services::mission::{Access, MissionItem, Upload};
/// use mavlink_services::{Address, Instant, Output, Service};
///
/// let items = [MissionItem::at(MavCmd::NAV_TAKEOFF, 47.4, 8.5, 10.0), MissionItem::at(MavCmd::NAV_LAND, 47.4, 8.5, 0.0)];
/// let access = Access::new(Address::new(255, 190), Address::new(1, 1));
/// let mut upload = Upload::new(access, items, Instant::ZERO);
/// let Some(Output::Send(count)) = upload.poll(Instant::ZERO) else { panic!() };
/// assert_eq!(count.decode::<MissionCount>().unwrap().count, 2);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Upload<S> {
    access: Access,
    items: S,
    /// Index of the first item; `None` replaces the whole plan.
    part: Option<u16>,
    attempt: Attempt,
    state: State,
    /// The item that is to be sent.
    wanted: Option<u16>,
    /// One more than the last item that was sent, counted from the first.
    sent: u16,
    told: u16,
    old_questions: u8,
}

#[derive(Clone, Copy, Debug)]
enum State {
    Announce,
    Waiting,
    Sending,
    Cancel,
    End(Result<Uploaded, Failure>),
    Over,
}

/// How far an upload is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sent {
    /// How many items were sent.
    pub sent: u16,
    /// How many there are.
    pub count: u16,
}

/// A plan is on the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Uploaded {
    /// How many items were sent.
    pub count: u16,
    /// What the vehicle calls its plan: it is the same until the plan changes (`MISSION_CURRENT`). 0 if it does not say.
    pub opaque_id: u32,
}

impl<S: AsRef<[MissionItem]>> Upload<S> {
    /// Replaces the plan by these items. None at all clears it.
    #[must_use]
    pub fn new(access: Access, items: S, now: Instant) -> Self {
        Self::begin(access, items, None, now)
    }

    /// Replaces a part of the plan by these items, the first of which has this index. ArduPilot knows how.
    #[must_use]
    pub fn part(access: Access, first: u16, items: S, now: Instant) -> Self {
        Self::begin(access, items, Some(first), now)
    }

    fn begin(access: Access, items: S, part: Option<u16>, now: Instant) -> Self {
        let count = u16::try_from(items.as_ref().len()).ok();
        // The messages for a part have 15 bits for an index.
        let fits = count
            .is_some_and(|count| part.is_none_or(|first| i16::try_from(u32::from(first) + u32::from(count)).is_ok()));
        let state = match count {
            _ if access.check().is_err() => State::End(Err(Failure::Version1)),
            Some(0) if part.is_some() => State::End(Err(Failure::NoSuchItem { count: 0 })),
            Some(_) if fits => State::Announce,
            count => State::End(Err(Failure::TooMany { count: count.unwrap_or(u16::MAX) })),
        };
        let attempt = Attempt::start(access.retry, now);
        Self { access, items, part, attempt, state, wanted: None, sent: 0, told: 0, old_questions: 0 }
    }

    /// Gives up, and tells the vehicle so, which keeps the plan that it has.
    pub fn cancel(&mut self) {
        if !matches!(self.state, State::End(_) | State::Over) {
            self.state = State::Cancel;
        }
    }

    fn count(&self) -> u16 {
        u16::try_from(self.items.as_ref().len()).unwrap_or(u16::MAX)
    }

    /// The vehicle asks for this item.
    fn request(&mut self, seq: u16, now: Instant) {
        let Some(place) = seq.checked_sub(self.part.unwrap_or(0)).filter(|place| *place < self.count()) else { return };
        match self.state {
            // Any other one is asked for by a transfer that is over.
            State::Announce | State::Waiting if place == 0 => self.state = State::Sending,
            State::Sending => {}
            _ => return,
        }
        // An item that was sent is sent again, which is no reason to wait longer.
        if place >= self.sent {
            self.sent = place.saturating_add(1);
            self.attempt = Attempt::start(self.access.retry, now);
        }
        self.wanted = Some(place);
    }

    /// The vehicle asks for this item with the old message.
    fn request_old(&mut self, seq: u16, now: Instant) {
        self.request(seq, now);
        if self.sent == 1 && self.wanted == Some(0) {
            self.old_questions = self.old_questions.saturating_add(1);
        }
        if self.old_questions > OLD_QUESTIONS {
            self.access.form = Form::Float;
        }
    }

    fn acknowledged(&mut self, result: MavMissionResult, opaque_id: u32) {
        let count = self.count();
        self.state = match (result, self.state) {
            // Before all was sent, it is about another transfer.
            (MavMissionResult::ACCEPTED, _) if self.sent < count => return,
            (MavMissionResult::ACCEPTED, State::Waiting | State::Sending) => {
                State::End(Ok(Uploaded { count, opaque_id }))
            }
            // It will ask for the right one.
            (MavMissionResult::ACCEPTED, _) | (MavMissionResult::INVALID_SEQUENCE, State::Sending) => return,
            (result, State::Announce | State::Waiting | State::Sending) => State::End(Err(Failure::Refused(result))),
            _ => return,
        };
    }

    fn overdue(&mut self, now: Instant) {
        let all = self.sent == self.count();
        let awaited = match self.state {
            State::Waiting if !all => Awaited::Begin,
            _ if all => Awaited::Ack,
            _ => Awaited::Request(self.part.unwrap_or(0).saturating_add(self.sent)),
        };
        let timeout = Failure::Timeout { awaited, asked: self.attempt.asked() };
        if !self.attempt.again(now) {
            self.state = State::End(Err(timeout));
        } else if matches!(self.state, State::Waiting) {
            self.state = State::Announce;
        } else if all {
            // The word that all are there was lost, or the last item was.
            self.wanted = self.sent.checked_sub(1);
        }
    }

    fn announcement(&self) -> Outgoing {
        let (target_system, target_component) = self.access.peer.target();
        let (count, mission_type) = (self.count(), self.access.plan);
        match self.part {
            None => MissionCount { target_system, target_component, count, mission_type, opaque_id: 0 }.into(),
            Some(first) => {
                let (start_index, last) = (first.cast_signed(), first.saturating_add(count).saturating_sub(1));
                let end_index = last.cast_signed();
                MissionWritePartialList { target_system, target_component, start_index, end_index, mission_type }.into()
            }
        }
    }

    fn item(&mut self) -> Option<Outgoing> {
        let place = self.wanted.take()?;
        let item = self.items.as_ref().get(usize::from(place))?;
        let seq = self.part.unwrap_or(0).saturating_add(place);
        Some(item.message(seq, self.access.peer, self.access.plan, self.access.form))
    }
}

impl<S: AsRef<[MissionItem]>> Service for Upload<S> {
    type Event = Update<Sent, Uploaded, Failure>;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        let access = self.access;
        if !access.is_peer(frame) {
            return;
        }
        if let Some(request) = frame.decode::<MissionRequestInt>() {
            if access.concerns((request.target_system, request.target_component), request.mission_type) {
                self.request(request.seq, now);
            }
        } else if let Some(request) = frame.decode::<MissionRequest>() {
            if access.concerns((request.target_system, request.target_component), request.mission_type) {
                self.request_old(request.seq, now);
            }
        } else if let Some(ack) = access.acked(frame) {
            self.acknowledged(ack.r#type, ack.opaque_id);
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        if matches!(self.state, State::Waiting | State::Sending) && !self.attempt.is_waiting(now) {
            self.overdue(now);
        }
        match self.state {
            State::Announce => {
                self.state = State::Waiting;
                Some(Output::Send(self.announcement()))
            }
            State::Sending => {
                if let Some(item) = self.item() {
                    return Some(Output::Send(item));
                }
                let (sent, count) = (self.sent, self.count());
                (core::mem::replace(&mut self.told, sent) != sent)
                    .then_some(Output::Event(Update::Progress(Sent { sent, count })))
            }
            State::Cancel => {
                self.state = State::End(Err(Failure::Cancelled));
                Some(Output::Send(self.access.ack(MavMissionResult::OPERATION_CANCELLED)))
            }
            State::End(result) => {
                self.state = State::Over;
                Some(Output::Event(Update::Done(result)))
            }
            State::Waiting | State::Over => None,
        }
    }

    fn deadline(&self) -> Option<Instant> {
        matches!(self.state, State::Waiting | State::Sending).then(|| self.attempt.deadline())
    }
}
