//! A plan is given.

use mavlink_wire::Frame;

use super::Component;
use crate::common::{
    MavMissionResult, MavMissionType, MissionCount, MissionRequest, MissionRequestInt, MissionRequestList,
    MissionRequestPartialList,
};
use crate::mission::access::Form;
use crate::mission::{MissionItem, Plans};
use crate::{Address, Outgoing};

impl<P: Plans> Component<P> {
    /// A station asks for something.
    pub(super) fn asked(&mut self, frame: &Frame<'_>) {
        let from = Address::of(frame);
        if let Some(request) = self.own.addressed::<MissionRequestInt>(frame) {
            self.give(from, request.mission_type, request.seq, Form::Int);
        } else if let Some(request) = self.own.addressed::<MissionRequest>(frame) {
            self.give(from, request.mission_type, request.seq, Form::Float);
        } else if let Some(request) = self.own.addressed::<MissionRequestList>(frame) {
            self.count(from, request.mission_type);
        } else if let Some(request) = self.own.addressed::<MissionRequestPartialList>(frame) {
            match self.range(request.mission_type, request.start_index, request.end_index) {
                Ok((first, last)) => self.part = Some((from, request.mission_type, first, last)),
                Err(why) => self.acknowledge(from, request.mission_type, why),
            }
        }
    }

    /// Gives an item to who asks for it.
    pub(super) fn give(&mut self, to: Address, plan: MavMissionType, seq: u16, form: Form) {
        match (self.plans.item(plan, seq), self.plans.count(plan)) {
            (Some(item), _) => self.answer = Some(self.marked(item, plan, seq).message(seq, to, plan, form)),
            (None, Ok(_)) => self.acknowledge(to, plan, MavMissionResult::INVALID_SEQUENCE),
            (None, Err(why)) => self.acknowledge(to, plan, why),
        }
    }

    /// The item, with the mark where the vehicle is.
    pub(super) fn marked(&self, item: MissionItem, plan: MavMissionType, seq: u16) -> MissionItem {
        MissionItem { current: plan == MavMissionType::MISSION && seq == self.current, ..item }
    }

    pub(super) fn count(&mut self, to: Address, plan: MavMissionType) {
        match self.plans.count(plan) {
            Ok(count) => {
                let (target_system, target_component) = to.target();
                let opaque_id = self.plans.id(plan);
                let count = MissionCount { target_system, target_component, count, mission_type: plan, opaque_id };
                self.answer = Some(count.into());
            }
            Err(why) => self.acknowledge(to, plan, why),
        }
    }

    /// The indices from first to last, if the plan has them all; -1 is the last one there is.
    pub(super) fn range(&self, plan: MavMissionType, first: i16, last: i16) -> Result<(u16, u16), MavMissionResult> {
        let count = self.plans.count(plan)?;
        let last = if last == -1 { count.checked_sub(1) } else { u16::try_from(last).ok() };
        match (u16::try_from(first), last) {
            (Ok(first), Some(last)) if first <= last && last < count => Ok((first, last)),
            _ => Err(MavMissionResult::INVALID_SEQUENCE),
        }
    }

    /// The next one of the items that were asked for at once.
    pub(super) fn next_of_part(&mut self) -> Option<Outgoing> {
        let (to, plan, first, last) = self.part.take()?;
        let item = self.plans.item(plan, first)?;
        self.part = (first < last).then_some((to, plan, first.saturating_add(1), last));
        Some(self.marked(item, plan, first).message(first, to, plan, Form::Int))
    }
}
