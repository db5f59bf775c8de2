//! The side that has the plans.

mod answers;
mod transfer;

use core::time::Duration;

use mavlink_wire::{Frame, Message};

use super::access::ack;
use super::item::MissionItem;
use super::plans::{Plans, Replaced};
use super::receiving::Receiving;
use crate::command::Request;
use crate::common::{
    self, MavCmd, MavMissionResult, MavMissionType, MavResult, MissionAck, MissionClearAll, MissionCount,
    MissionCurrent, MissionItemInt, MissionItemReached, MissionSetCurrent, MissionState, MissionWritePartialList,
};
use crate::param::ParamValue;
use crate::{Address, Instant, Outgoing, Output, Retry, Service};

/// The largest `current` of an item that belongs to a plan: 2 and 3 are targets and heights for a vehicle that is guided.
const OF_PLAN: u8 = 1;

/// Keeps the plans of a vehicle, and moves them from and to stations; says which item of the mission it is at.
///
/// Items are given to whoever asks, at any time. A plan is received from one station at a time; others are refused with `DENIED`
/// meanwhile. What is received replaces the plan when all of it is there, and nothing before.
///
/// ```text
/// idle ── MISSION_COUNT, or MISSION_WRITE_PARTIAL_LIST ──▶ receiving ── the last item ──▶ in force: ACCEPTED ──▶ idle
///                                                          │  │  ▲
///   the station cancels, an item is refused, or silence ◀──┘  └──┴ ask for the next item; again after a timeout,
///   for long enough: the old plan stands ──▶ idle                  with MISSION_REQUEST_INT and MISSION_REQUEST in turn
///
/// in any state: MISSION_REQUEST_LIST ──▶ MISSION_COUNT      MISSION_REQUEST_INT ──▶ MISSION_ITEM_INT
///               MISSION_CLEAR_ALL ──▶ MISSION_ACK           MISSION_REQUEST ──▶ MISSION_ITEM
///               MISSION_SET_CURRENT ──▶ MISSION_CURRENT     MISSION_REQUEST_PARTIAL_LIST ──▶ these MISSION_ITEM_INT
/// ```
///
/// ```
/// use mavlink_services::Address;
/// use mavlink_services::mission::{Component, MissionItem, Plan, PlanStore};
///
/// let plan = || Plan::new([MissionItem::DEFAULT; 20], [MissionItem::DEFAULT; 20]);
/// let store = PlanStore { mission: plan(), fence: plan(), rally: plan() };
/// let mut component = Component::new(Address::new(1, 1), store);
/// component.reached(0);
/// component.set_current(1);
/// assert_eq!(component.current().seq, 1);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Component<P> {
    own: Address,
    plans: P,
    retry: Retry,
    receiving: Option<Receiving>,
    /// The last transfer that succeeded: the word of it may have been lost.
    received: Option<(Address, MavMissionType, u16)>,
    /// Items that were asked for at once, from the first to the last.
    part: Option<(Address, MavMissionType, u16, u16)>,
    answer: Option<Outgoing>,
    current: u16,
    state: MissionState,
    tell_current: bool,
    reached: Option<u16>,
    event: Option<ComponentEvent>,
}

/// What has happened to the plans of a vehicle. If it is not polled for, the last one is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ComponentEvent {
    /// A plan was replaced.
    Replaced {
        /// Which one; all of them if they were cleared together.
        plan: MavMissionType,
        /// How many items it has now: 0 if it was cleared.
        count: u16,
        /// Who did it.
        by: Address,
    },
    /// A plan was to be replaced and was not.
    Failed {
        /// Which one.
        plan: MavMissionType,
        /// Why; a station that fell silent is `OPERATION_CANCELLED`.
        why: MavMissionResult,
        /// Who wanted it.
        by: Address,
    },
    /// A station sends the vehicle to an item that the mission has.
    Current {
        /// Its index.
        seq: u16,
        /// Who did it.
        by: Address,
    },
}

impl<P: Plans> Component<P> {
    /// The plans of this component.
    #[must_use]
    pub fn new(own: Address, plans: P) -> Self {
        let retry = Retry { timeout: Duration::from_millis(250), retries: 20 };
        let (receiving, received, part, answer, event) = (None, None, None, None, None);
        let (current, state, tell_current, reached) = (0, MissionState::UNKNOWN, false, None);
        Self { own, plans, retry, receiving, received, part, answer, current, state, tell_current, reached, event }
    }

    /// The same, with another patience for items that a station sends: 250 ms and twenty more times, unless told otherwise.
    #[must_use]
    pub fn with_retry(self, retry: Retry) -> Self {
        Self { retry, ..self }
    }

    /// The plans.
    pub const fn plans(&self) -> &P {
        &self.plans
    }

    /// The plans, to be changed.
    pub const fn plans_mut(&mut self) -> &mut P {
        &mut self.plans
    }

    /// The vehicle is at this item now: all stations are told.
    pub fn set_current(&mut self, seq: u16) {
        (self.current, self.tell_current) = (seq, true);
    }

    /// The mission is in this state now: all stations are told. Until then, they are told that it is unknown.
    pub fn set_state(&mut self, state: MissionState) {
        (self.state, self.tell_current) = (state, true);
    }

    /// Carries out `MAV_CMD_DO_SET_MISSION_CURRENT`, and gives the result to be acknowledged; `None` if it is another command.
    ///
    /// Whether the mission is to begin anew is the second parameter; that is yours to do, as flying to the item is.
    pub fn command(&mut self, request: &Request) -> Option<MavResult> {
        let [number, ..] = request.command.params();
        if request.command.command() != MavCmd::DO_SET_MISSION_CURRENT {
            return None;
        }
        let seq = if number == -1.0 { Ok(self.current) } else { u16::try_from(ParamValue::F32(number)) };
        let done = seq.is_ok_and(|seq| self.set_current_by(request.from, seq));
        Some(if done { MavResult::ACCEPTED } else { MavResult::DENIED })
    }

    /// The vehicle has reached this item: all stations are told.
    pub fn reached(&mut self, seq: u16) {
        self.reached = Some(seq);
    }

    /// Where the vehicle is in its mission, to be sent from time to time.
    pub fn current(&self) -> MissionCurrent {
        let total = match self.plans.count(MavMissionType::MISSION) {
            Ok(0) | Err(_) => u16::MAX,
            Ok(count) => count,
        };
        MissionCurrent {
            seq: self.current,
            total,
            mission_state: self.state,
            mission_mode: 0,
            mission_id: self.plans.id(MavMissionType::MISSION),
            fence_id: self.plans.id(MavMissionType::FENCE),
            rally_points_id: self.plans.id(MavMissionType::RALLY),
        }
    }

    fn acknowledge(&mut self, to: Address, plan: MavMissionType, result: MavMissionResult) {
        let id = if result == MavMissionResult::ACCEPTED { self.plans.id(plan) } else { 0 };
        self.answer = Some(ack(to, plan, result, id));
    }

    /// Clears a plan, or all that there are.
    fn clear(&mut self, by: Address, plan: MavMissionType) {
        const ALL: [MavMissionType; 3] = [MavMissionType::MISSION, MavMissionType::FENCE, MavMissionType::RALLY];
        if self.receiving.is_some_and(|receiving| receiving.from != by) {
            return self.acknowledge(by, plan, MavMissionResult::DENIED);
        }
        self.abort();
        self.received = None;
        let (some, only) = (ALL, [plan]);
        let plans: &[MavMissionType] = if plan == MavMissionType::ALL { &some } else { &only };
        for each in plans {
            if plan == MavMissionType::ALL && self.plans.count(*each).is_err() {
                continue;
            }
            let cleared = self.plans.begin(*each, Replaced::All { count: 0 });
            if let Err(why) = cleared.and_then(|()| self.plans.commit(*each)) {
                return self.fail(by, plan, why);
            }
        }
        self.event = Some(ComponentEvent::Replaced { plan, count: 0, by });
        self.acknowledge(by, plan, MavMissionResult::ACCEPTED);
    }

    /// A station sends the vehicle to an item; whether the mission has it.
    fn set_current_by(&mut self, by: Address, seq: u16) -> bool {
        let exists = self.plans.count(MavMissionType::MISSION).is_ok_and(|count| seq < count);
        if exists {
            self.current = seq;
            self.event = Some(ComponentEvent::Current { seq, by });
        }
        self.tell_current = true;
        exists
    }

    /// Where the vehicle is, if that is to be told.
    fn next_of_state(&mut self) -> Option<Outgoing> {
        if let Some(seq) = self.reached.take() {
            return Some(MissionItemReached { seq }.into());
        }
        core::mem::take(&mut self.tell_current).then(|| self.current().into())
    }
}

impl<P: Plans> Service for Component<P> {
    type Event = ComponentEvent;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        let from = Address::of(frame);
        match frame.message_id() {
            MissionCount::ID | MissionWritePartialList::ID => self.announced(frame, now),
            MissionItemInt::ID => {
                if let Some(item) = self.own.addressed::<MissionItemInt>(frame).filter(|item| item.current <= OF_PLAN) {
                    self.put(frame, (item.mission_type, item.seq), Some(item.into()), now);
                }
            }
            common::MissionItem::ID => {
                if let Some(item) =
                    self.own.addressed::<common::MissionItem>(frame).filter(|item| item.current <= OF_PLAN)
                {
                    self.put(frame, (item.mission_type, item.seq), MissionItem::of_float(&item), now);
                }
            }
            MissionAck::ID => self.acknowledged(frame),
            MissionClearAll::ID => {
                if let Some(clear) = self.own.addressed::<MissionClearAll>(frame) {
                    self.clear(from, clear.mission_type);
                }
            }
            MissionSetCurrent::ID => {
                if let Some(set) = self.own.addressed::<MissionSetCurrent>(frame) {
                    self.set_current_by(from, set.seq);
                }
            }
            _ => self.asked(frame),
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<ComponentEvent>> {
        if let Some(event) = self.event.take() {
            return Some(Output::Event(event));
        }
        if let Some(receiving) = &mut self.receiving
            && !receiving.is_alive(now)
        {
            let Receiving { from, plan, .. } = *receiving;
            self.fail(from, plan, MavMissionResult::OPERATION_CANCELLED);
            return self.event.take().map(Output::Event);
        }
        let answer = self.answer.take();
        let message = answer.or_else(|| self.receiving.as_mut()?.question()).or_else(|| self.next_of_part());
        message.or_else(|| self.next_of_state()).map(Output::Send)
    }

    fn deadline(&self) -> Option<Instant> {
        self.receiving.map(|receiving| receiving.deadline())
    }
}
