//! Where a vehicle has its plans.

use super::item::MissionItem;
use crate::common::{MavMissionResult, MavMissionType};

/// What a transfer replaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Replaced {
    /// The whole plan, by so many items.
    All {
        /// How many.
        count: u16,
    },
    /// The items from the first to the last of these indices, all of which the plan has.
    Part {
        /// Index of the first item.
        first: u16,
        /// Index of the last item.
        last: u16,
    },
}

/// The plans of a vehicle.
///
/// A plan is replaced in one step: [`commit`](Self::commit) comes when all items are there; until then, and after
/// [`abort`](Self::abort), the old one stands. [`PlanStore`](super::PlanStore) keeps two copies for that. Implement it to check items,
/// or to keep plans elsewhere. `MavMissionType` is `MISSION`, `FENCE`, `RALLY` or what a station sends; a plan that the vehicle does not
/// have is `Err(MavMissionResult::UNSUPPORTED)`.
pub trait Plans {
    /// How many items a plan has.
    ///
    /// # Errors
    ///
    /// Why there is no such plan.
    fn count(&self, plan: MavMissionType) -> Result<u16, MavMissionResult>;

    /// An item of a plan.
    fn item(&self, plan: MavMissionType, seq: u16) -> Option<MissionItem>;

    /// A number that becomes another one when the plan changes, so that stations need not fetch it again; 0 if there is none.
    fn id(&self, plan: MavMissionType) -> u32 {
        let _ = plan;
        0
    }

    /// Begins to replace a plan, or a part of it. What was begun before and not committed is void.
    ///
    /// # Errors
    ///
    /// Why not: `NO_SPACE`, `UNSUPPORTED`, `DENIED` …
    fn begin(&mut self, plan: MavMissionType, replaced: Replaced) -> Result<(), MavMissionResult>;

    /// Takes the next item.
    ///
    /// # Errors
    ///
    /// What is wrong with it. The transfer is over then.
    fn put(&mut self, plan: MavMissionType, seq: u16, item: MissionItem) -> Result<(), MavMissionResult>;

    /// Puts the new plan into force.
    ///
    /// # Errors
    ///
    /// Why not: the old one stands.
    fn commit(&mut self, plan: MavMissionType) -> Result<(), MavMissionResult>;

    /// Forgets what was begun.
    fn abort(&mut self, plan: MavMissionType);
}

impl<P: Plans + ?Sized> Plans for &mut P {
    fn count(&self, plan: MavMissionType) -> Result<u16, MavMissionResult> {
        (**self).count(plan)
    }

    fn item(&self, plan: MavMissionType, seq: u16) -> Option<MissionItem> {
        (**self).item(plan, seq)
    }

    fn id(&self, plan: MavMissionType) -> u32 {
        (**self).id(plan)
    }

    fn begin(&mut self, plan: MavMissionType, replaced: Replaced) -> Result<(), MavMissionResult> {
        (**self).begin(plan, replaced)
    }

    fn put(&mut self, plan: MavMissionType, seq: u16, item: MissionItem) -> Result<(), MavMissionResult> {
        (**self).put(plan, seq, item)
    }

    fn commit(&mut self, plan: MavMissionType) -> Result<(), MavMissionResult> {
        (**self).commit(plan)
    }

    fn abort(&mut self, plan: MavMissionType) {
        (**self).abort(plan);
    }
}
