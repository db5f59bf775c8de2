//! Addresses of components: system id and component id.

use core::fmt;

use mavlink_wire::{ComponentId, Frame, SystemId, Targeted};

/// A component of a system. As a target, and where you wait for a sender, zero stands for all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Address {
    /// The system.
    pub system_id: SystemId,
    /// The component of it.
    pub component_id: ComponentId,
}

impl Address {
    /// All components of all systems.
    pub const EVERYBODY: Self = Self { system_id: SystemId::BROADCAST, component_id: ComponentId::BROADCAST };

    /// This component of this system.
    #[must_use]
    pub fn new(system_id: impl Into<SystemId>, component_id: impl Into<ComponentId>) -> Self {
        Self { system_id: system_id.into(), component_id: component_id.into() }
    }

    /// The sender of a frame.
    #[must_use]
    pub fn of(frame: &Frame<'_>) -> Self {
        Self { system_id: frame.system_id(), component_id: frame.component_id() }
    }

    /// Whether this address includes the other: both are the same, or a zero here stands for all.
    #[must_use]
    pub fn includes(self, other: Self) -> bool {
        (self.system_id.is_broadcast() || self.system_id == other.system_id)
            && (self.component_id.is_broadcast() || self.component_id == other.component_id)
    }

    /// Whether a message with these target ids is for this component; 0 is for all.
    #[must_use]
    pub fn is_target(self, target_system: u8, target_component: u8) -> bool {
        Self::new(target_system, target_component).includes(self)
    }

    /// The message in a frame, if it is for this component.
    pub(crate) fn addressed<M: Targeted>(self, frame: &Frame<'_>) -> Option<M> {
        let mut message: M = frame.decode()?;
        let (Some(system), Some(component)) = message.target_mut() else { return None };
        self.is_target(*system, *component).then_some(message)
    }

    /// The target ids of a message to this one.
    pub(crate) fn target(self) -> (u8, u8) {
        // Ids over 255 do not come out of frames, and `Address::new` takes what becomes a byte.
        (self.system_id.to_u32() as u8, self.component_id.to_u32() as u8)
    }
}

/// The two numbers: `1/190`.
impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.system_id, self.component_id)
    }
}
