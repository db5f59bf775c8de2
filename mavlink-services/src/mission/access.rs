//! Who asks whom for which plan.

use core::time::Duration;

use mavlink_wire::{Frame, Version};

use super::failure::Failure;
use crate::common::{MavAutopilot, MavMissionResult, MavMissionType, MavProtocolCapability, MissionAck};
use crate::{Address, Outgoing, Retry};

/// Who asks whom, for which plan, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Access {
    /// Who asks: the ids that its frames are sent with.
    pub own: Address,
    /// Whose plan: one component, without zeros.
    pub peer: Address,
    /// Mission, fence or rally points.
    pub plan: MavMissionType,
    /// Which messages carry the items.
    pub form: Form,
    /// The version of MAVLink that the peer is spoken to in. In MAVLink 1 no message says which plan it is about: one for the fence
    /// would change the mission, so such an operation fails before it begins.
    pub version: Version,
    /// How long an answer may take, and how often it is asked for: 1.5 s and five more times, as the guide recommends.
    pub retry: Retry,
    /// The same for single items: 250 ms, as the guide recommends, and twenty more times, because there are many of them.
    pub item_retry: Retry,
}

/// Which messages carry the items of a plan.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Form {
    /// `MISSION_ITEM_INT`, with positions to a centimetre: what everybody knows today. Also sent to who asks with the old
    /// `MISSION_REQUEST`, as the guide has it.
    #[default]
    Int,
    /// The old `MISSION_ITEM`, whose floats keep a position to about a metre: for vehicles that know nothing else, as AutoQuad.
    Float,
}

impl Form {
    /// What a vehicle knows, by the capabilities in its `AUTOPILOT_VERSION`; without one, by the autopilot in its `HEARTBEAT`:
    /// AutoQuad knows the old message, all others are taken for vehicles of today.
    ///
    /// If that is wrong, an upload and a download notice at the first item, after a while.
    #[must_use]
    pub fn of(capabilities: Option<MavProtocolCapability>, autopilot: MavAutopilot) -> Self {
        let says = |flag| capabilities.is_some_and(|capabilities| capabilities.contains(flag));
        let (int, float) = (says(MavProtocolCapability::MISSION_INT), says(MavProtocolCapability::MISSION_FLOAT));
        if !int && (float || autopilot == MavAutopilot::AUTOQUAD) { Self::Float } else { Self::Int }
    }

    pub(super) const fn other(self) -> Self {
        match self {
            Self::Int => Self::Float,
            Self::Float => Self::Int,
        }
    }
}

impl Access {
    /// The mission, with the usual patience, in MAVLink 2.
    #[must_use]
    pub const fn new(own: Address, peer: Address) -> Self {
        let retry = Retry { timeout: Duration::from_millis(1500), retries: 5 };
        let item_retry = Retry { timeout: Duration::from_millis(250), retries: 20 };
        Self { own, peer, plan: MavMissionType::MISSION, form: Form::Int, version: Version::V2, retry, item_retry }
    }

    /// The same for another plan: the fence or the rally points.
    #[must_use]
    pub const fn plan(self, plan: MavMissionType) -> Self {
        Self { plan, ..self }
    }

    /// Whether the messages can say which plan is meant.
    pub(super) fn check(&self) -> Result<(), Failure> {
        if self.version == Version::V1 && self.plan != MavMissionType::MISSION {
            Err(Failure::Version1)
        } else {
            Ok(())
        }
    }

    /// The message that ends a transfer.
    pub(super) fn ack(&self, result: MavMissionResult) -> Outgoing {
        ack(self.peer, self.plan, result, 0)
    }

    /// Whether a frame is of the peer; what it is about has to be looked at as well.
    pub(super) fn is_peer(&self, frame: &Frame<'_>) -> bool {
        self.peer.includes(Address::of(frame))
    }

    /// Whether a message to this target is for us, and of our plan.
    pub(super) fn concerns(&self, (system, component): (u8, u8), plan: MavMissionType) -> bool {
        self.plan == plan && self.own.is_target(system, component)
    }

    /// The peer's word on the transfer, if the frame is one.
    pub(super) fn acked(&self, frame: &Frame<'_>) -> Option<MissionAck> {
        let ack = frame.decode::<MissionAck>()?;
        self.concerns((ack.target_system, ack.target_component), ack.mission_type).then_some(ack)
    }
}

/// The message that ends a transfer or refuses something.
pub(super) fn ack(to: Address, plan: MavMissionType, result: MavMissionResult, opaque_id: u32) -> Outgoing {
    let (target_system, target_component) = to.target();
    MissionAck { target_system, target_component, r#type: result, mission_type: plan, opaque_id }.into()
}
