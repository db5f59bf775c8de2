//! Plans in memory.

use super::item::MissionItem;
use super::plans::{Plans, Replaced};
use crate::common::{MavMissionResult, MavMissionType};

/// Mission, fence and rally points in storage of yours: arrays, slices or vectors of items, as long as the plans may become.
///
/// ```
/// use mavlink_services::common::MavMissionType;
/// use mavlink_services::mission::{MissionItem, Plan, PlanStore, Plans};
///
/// // Up to 20 items each; twice, because the old plan stands until the new one is there.
/// let plan = || Plan::new([MissionItem::DEFAULT; 20], [MissionItem::DEFAULT; 20]);
/// let store = PlanStore { mission: plan(), fence: plan(), rally: plan() };
/// assert_eq!(store.count(MavMissionType::FENCE), Ok(0));
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct PlanStore<S> {
    /// The mission.
    pub mission: Plan<S>,
    /// The fence.
    pub fence: Plan<S>,
    /// The rally points.
    pub rally: Plan<S>,
}

/// A plan, and room for the one that will replace it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Plan<S> {
    active: S,
    count: u16,
    id: u32,
    staged: S,
    staged_count: u16,
}

impl<S: AsRef<[MissionItem]> + AsMut<[MissionItem]>> Plan<S> {
    /// No items yet, in storage that should be of the same length.
    #[must_use]
    pub const fn new(active: S, staged: S) -> Self {
        Self { active, count: 0, id: 0, staged, staged_count: 0 }
    }

    /// The items.
    pub fn items(&self) -> &[MissionItem] {
        self.active.as_ref().get(..usize::from(self.count)).unwrap_or_default()
    }

    /// A number that says which items these are; 0 if there are none.
    pub fn id(&self) -> u32 {
        self.id
    }

    /// How many items there is room for.
    fn capacity(&self) -> usize {
        self.active.as_ref().len().min(self.staged.as_ref().len())
    }

    fn begin(&mut self, replaced: Replaced) -> Result<(), MavMissionResult> {
        let count = match replaced {
            Replaced::All { count } => count,
            Replaced::Part { .. } => self.count,
        };
        if usize::from(count) > self.capacity() {
            return Err(MavMissionResult::NO_SPACE);
        }
        self.staged_count = count;
        if let Replaced::Part { .. } = replaced {
            self.staged.as_mut().iter_mut().zip(self.active.as_ref()).for_each(|(to, from)| *to = *from);
        }
        Ok(())
    }

    fn put(&mut self, seq: u16, item: MissionItem) -> Result<(), MavMissionResult> {
        let place = self.staged.as_mut().get_mut(usize::from(seq)).ok_or(MavMissionResult::NO_SPACE)?;
        *place = item;
        Ok(())
    }

    fn commit(&mut self) {
        core::mem::swap(&mut self.active, &mut self.staged);
        (self.count, self.staged_count) = (self.staged_count, 0);
        self.id = identify(self.items());
    }
}

/// FNV-1a over all that the items are; never 0 if there are any.
fn identify(items: &[MissionItem]) -> u32 {
    let mut hash = 0x811c_9dc5_u32;
    let mut add = |word: u32| {
        for byte in word.to_le_bytes() {
            hash = (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
        }
    };
    for item in items {
        let flags = u32::from(item.autocontinue);
        add(u32::from(item.command.0) | u32::from(item.frame.0) << 16 | flags << 24);
        item.params.iter().for_each(|param| add(param.to_bits()));
        add(item.x.cast_unsigned());
        add(item.y.cast_unsigned());
        add(item.z.to_bits());
    }
    if items.is_empty() { 0 } else { hash.max(1) }
}

impl<S: AsRef<[MissionItem]> + AsMut<[MissionItem]>> PlanStore<S> {
    /// The plan of this kind.
    fn plan(&self, plan: MavMissionType) -> Result<&Plan<S>, MavMissionResult> {
        match plan {
            MavMissionType::MISSION => Ok(&self.mission),
            MavMissionType::FENCE => Ok(&self.fence),
            MavMissionType::RALLY => Ok(&self.rally),
            _ => Err(MavMissionResult::UNSUPPORTED),
        }
    }

    fn plan_mut(&mut self, plan: MavMissionType) -> Result<&mut Plan<S>, MavMissionResult> {
        match plan {
            MavMissionType::MISSION => Ok(&mut self.mission),
            MavMissionType::FENCE => Ok(&mut self.fence),
            MavMissionType::RALLY => Ok(&mut self.rally),
            _ => Err(MavMissionResult::UNSUPPORTED),
        }
    }
}

impl<S: AsRef<[MissionItem]> + AsMut<[MissionItem]>> Plans for PlanStore<S> {
    fn count(&self, plan: MavMissionType) -> Result<u16, MavMissionResult> {
        Ok(self.plan(plan)?.count)
    }

    fn item(&self, plan: MavMissionType, seq: u16) -> Option<MissionItem> {
        self.plan(plan).ok()?.items().get(usize::from(seq)).copied()
    }

    fn id(&self, plan: MavMissionType) -> u32 {
        self.plan(plan).map_or(0, Plan::id)
    }

    fn begin(&mut self, plan: MavMissionType, replaced: Replaced) -> Result<(), MavMissionResult> {
        self.plan_mut(plan)?.begin(replaced)
    }

    fn put(&mut self, plan: MavMissionType, seq: u16, item: MissionItem) -> Result<(), MavMissionResult> {
        self.plan_mut(plan)?.put(seq, item)
    }

    fn commit(&mut self, plan: MavMissionType) -> Result<(), MavMissionResult> {
        self.plan_mut(plan).map(Plan::commit)
    }

    fn abort(&mut self, _plan: MavMissionType) {}
}
