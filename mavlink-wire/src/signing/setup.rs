//! The message that carries a key.

use super::{Key, SigningError};
use crate::frame::SETUP_SIGNING;
use crate::message::wire::{copy, get, put};
use crate::{ComponentId, Encode, Frame, MAX_PAYLOAD, MessageInfo, SystemId, Timestamp};

static INFO: MessageInfo =
    MessageInfo::new(SETUP_SIGNING, "SETUP_SIGNING", 71, 42).target_system(8).target_component(9);

/// A `SETUP_SIGNING` (message 256, MAVLink 2 only) to be sent: gives a component its key, or tells it to sign no more.
///
/// Like the dialect's message of that name, but its key is not shown by `Debug`, is overwritten when dropped, and
/// cannot be sent to everybody by mistake. Send it over a link that is secure by other means, a cable; whoever
/// overhears it has the key.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setup {
    target_system: SystemId,
    target_component: ComponentId,
    key: Key,
    timestamp: Timestamp,
}

impl Setup {
    /// Gives this component the key. `timestamp` is the time, for receivers without a clock.
    ///
    /// # Errors
    ///
    /// [`SigningError::Broadcast`]: system or component is 0, which means all of them.
    pub fn new(
        target_system: impl Into<SystemId>,
        target_component: impl Into<ComponentId>,
        key: Key,
        timestamp: Timestamp,
    ) -> Result<Self, SigningError> {
        let (system_id, component_id) = (target_system.into(), target_component.into());
        if system_id.is_broadcast() || component_id.is_broadcast() {
            return Err(SigningError::Broadcast { system_id, component_id });
        }
        Ok(Self { target_system: system_id, target_component: component_id, key, timestamp })
    }

    /// Tells this component to sign no more: key and timestamp are zero.
    ///
    /// # Errors
    ///
    /// [`SigningError::Broadcast`]: system or component is 0, which means all of them.
    pub fn off(
        target_system: impl Into<SystemId>,
        target_component: impl Into<ComponentId>,
    ) -> Result<Self, SigningError> {
        Self::new(target_system, target_component, Key::new([0; 32]), Timestamp::ZERO)
    }

    /// The message in a frame; `None` if it is another message.
    #[must_use]
    pub fn decode(frame: &Frame<'_>) -> Option<ReceivedSetup> {
        let ours = frame.carries_key() && frame.crc_extra() == INFO.crc_extra;
        ours.then(|| frame.payload()).map(|payload| ReceivedSetup {
            target_system: SystemId::from_u8(get(payload, 8)),
            target_component: ComponentId::from_u8(get(payload, 9)),
            key: Key::new(get(payload, 10)),
            timestamp: Timestamp::new(get(payload, 0)),
        })
    }
}

impl Encode for Setup {
    fn info(&self) -> &'static MessageInfo {
        &INFO
    }

    fn write(&self, payload: &mut [u8; MAX_PAYLOAD]) {
        put(payload, 0, self.timestamp.units());
        put(payload, 8, self.target_system.to_u8());
        put(payload, 9, self.target_component.to_u8());
        copy(self.key.as_bytes(), payload.get_mut(10..).unwrap_or_default());
    }
}

/// A `SETUP_SIGNING` that was received: made by [`Setup::decode`].
///
/// It cannot be sent, so that a key that came for everybody goes on to nobody. Its key is not shown by `Debug`, and is
/// overwritten when dropped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReceivedSetup {
    target_system: SystemId,
    target_component: ComponentId,
    key: Key,
    timestamp: Timestamp,
}

impl ReceivedSetup {
    /// The addressed system: compare it with your own id, or ask whether it [is everybody](SystemId::is_broadcast).
    #[must_use]
    pub const fn target_system(&self) -> SystemId {
        self.target_system
    }

    /// The addressed component.
    #[must_use]
    pub const fn target_component(&self) -> ComponentId {
        self.target_component
    }

    /// The key, and the timestamp to start from; `None` means to sign no more.
    #[must_use]
    pub fn key(&self) -> Option<(&Key, Timestamp)> {
        (!self.key.is_zero() || self.timestamp != Timestamp::ZERO).then_some((&self.key, self.timestamp))
    }
}
