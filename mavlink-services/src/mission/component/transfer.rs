//! A plan is received.

use mavlink_wire::{Frame, Message};

use super::{Component, ComponentEvent};
use crate::common::{
    MavMissionResult, MavMissionType, MissionAck, MissionCount, MissionItemInt, MissionWritePartialList,
};
use crate::mission::access::Form;
use crate::mission::receiving::Receiving;
use crate::mission::{MissionItem, Plans, Replaced};
use crate::{Address, Instant};

impl<P: Plans> Component<P> {
    /// A station says how many items it has.
    pub(super) fn announced(&mut self, frame: &Frame<'_>, now: Instant) {
        let from = Address::of(frame);
        if let Some(all) = self.own.addressed::<MissionCount>(frame) {
            self.begin(from, all.mission_type, Replaced::All { count: all.count }, now);
        } else if let Some(part) = self.own.addressed::<MissionWritePartialList>(frame) {
            match self.range(part.mission_type, part.start_index, part.end_index) {
                Ok((first, last)) => self.begin(from, part.mission_type, Replaced::Part { first, last }, now),
                Err(why) => self.acknowledge(from, part.mission_type, why),
            }
        }
    }

    /// A transfer begins, if it may. The one before it is void.
    pub(super) fn begin(&mut self, from: Address, plan: MavMissionType, replaced: Replaced, now: Instant) {
        if self.receiving.is_some_and(|receiving| receiving.from != from) {
            return self.acknowledge(from, plan, MavMissionResult::DENIED);
        }
        self.abort();
        self.received = None;
        let (next, end) = match replaced {
            Replaced::All { count } => (0, count),
            Replaced::Part { first, last } => (first, last.saturating_add(1)),
        };
        if let Err(why) = self.plans.begin(plan, replaced) {
            return self.fail(from, plan, why);
        }
        if next == end {
            return self.commit(from, plan);
        }
        self.receiving = Some(Receiving::new(from, plan, (next, end), self.retry, now));
    }

    pub(super) fn abort(&mut self) {
        if let Some(receiving) = self.receiving.take() {
            self.plans.abort(receiving.plan);
        }
    }

    pub(super) fn fail(&mut self, by: Address, plan: MavMissionType, why: MavMissionResult) {
        self.abort();
        self.event = Some(ComponentEvent::Failed { plan, why, by });
        self.acknowledge(by, plan, why);
    }

    /// All items are there.
    fn commit(&mut self, by: Address, plan: MavMissionType) {
        let last = self.receiving.map(|receiving| receiving.next.saturating_sub(1));
        if let Err(why) = self.plans.commit(plan) {
            return self.fail(by, plan, why);
        }
        self.receiving = None;
        self.received = last.map(|last| (by, plan, last));
        let count = self.plans.count(plan).unwrap_or_default();
        self.event = Some(ComponentEvent::Replaced { plan, count, by });
        self.acknowledge(by, plan, MavMissionResult::ACCEPTED);
    }

    /// An item comes, in one of two forms; `None` if its position is none.
    pub(super) fn put(
        &mut self,
        frame: &Frame<'_>,
        (plan, seq): (MavMissionType, u16),
        item: Option<MissionItem>,
        now: Instant,
    ) {
        let from = Address::of(frame);
        let Some(mut receiving) = self.receiving.filter(|receiving| receiving.is_with(frame, plan)) else {
            // The word that all are there was lost.
            if self.received == Some((from, plan, seq)) {
                self.acknowledge(from, plan, MavMissionResult::ACCEPTED);
            }
            return;
        };
        if seq != receiving.next {
            return;
        }
        let put = item.ok_or(MavMissionResult::INVALID_PARAM5_X).and_then(|item| self.plans.put(plan, seq, item));
        if let Err(why) = put {
            return self.fail(from, plan, why);
        }
        let form = if frame.message_id() == MissionItemInt::ID { Form::Int } else { Form::Float };
        let complete = receiving.advance(form, now);
        self.receiving = Some(receiving);
        if complete {
            self.commit(from, plan);
        }
    }

    /// The station that sends a plan says something else than the next item.
    pub(super) fn acknowledged(&mut self, frame: &Frame<'_>) {
        let Some(ack) = self.own.addressed::<MissionAck>(frame) else { return };
        if ack.r#type != MavMissionResult::ACCEPTED
            && let Some(receiving) = self.receiving.filter(|receiving| receiving.is_with(frame, ack.mission_type))
        {
            self.abort();
            let (plan, why, by) = (receiving.plan, ack.r#type, receiving.from);
            self.event = Some(ComponentEvent::Failed { plan, why, by });
        }
    }
}
