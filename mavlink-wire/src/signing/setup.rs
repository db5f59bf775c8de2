//! The message that carries a key.

use super::{Key, SigningError};
use crate::frame::SETUP_SIGNING;
use crate::message::wire::{get, put};
use crate::{Encode, Frame, MAX_PAYLOAD, MessageInfo, Timestamp};

static INFO: MessageInfo =
    MessageInfo::new(SETUP_SIGNING, "SETUP_SIGNING", 71, 42).target_system(8).target_component(9);

/// A `SETUP_SIGNING` (message 256, MAVLink 2 only): gives a component its key, or tells it to sign no more.
///
/// Like the dialect's message of that name, but its key is not shown by `Debug`, is overwritten when dropped, and
/// cannot be sent to everybody by mistake. Send it over a link that is secure by other means, a cable; whoever
/// overhears it has the key.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setup {
    target_system: u8,
    target_component: u8,
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
        system: impl Into<u8>,
        component: impl Into<u8>,
        key: Key,
        timestamp: Timestamp,
    ) -> Result<Self, SigningError> {
        match (system.into(), component.into()) {
            (system, component) if system == 0 || component == 0 => Err(SigningError::Broadcast { system, component }),
            (target_system, target_component) => Ok(Self { target_system, target_component, key, timestamp }),
        }
    }

    /// Tells this component to sign no more: key and timestamp are zero.
    ///
    /// # Errors
    ///
    /// [`SigningError::Broadcast`]: system or component is 0, which means all of them.
    pub fn off(system: impl Into<u8>, component: impl Into<u8>) -> Result<Self, SigningError> {
        Self::new(system, component, Key::new([0; 32]), Timestamp::ZERO)
    }

    /// The message in a frame. The addressee may be anybody, zero included: compare it with yourself.
    #[must_use]
    pub fn read(frame: &Frame<'_>) -> Option<Self> {
        let ours = frame.carries_key() && frame.crc_extra() == INFO.crc_extra;
        ours.then(|| frame.payload()).map(|payload| Self {
            target_system: get(payload, 8),
            target_component: get(payload, 9),
            key: Key::new(get(payload, 10)),
            timestamp: Timestamp::new(get(payload, 0)),
        })
    }

    /// The addressed system; 0 is every system.
    #[must_use]
    pub const fn target_system(&self) -> u8 {
        self.target_system
    }

    /// The addressed component; 0 is every component.
    #[must_use]
    pub const fn target_component(&self) -> u8 {
        self.target_component
    }

    /// The key, and the timestamp to start from; `None` means to sign no more.
    #[must_use]
    pub fn key(&self) -> Option<(&Key, Timestamp)> {
        (!self.key.is_zero() || self.timestamp != Timestamp::ZERO).then_some((&self.key, self.timestamp))
    }
}

impl Encode for Setup {
    fn info(&self) -> &'static MessageInfo {
        &INFO
    }

    fn write(&self, payload: &mut [u8; MAX_PAYLOAD]) {
        put(payload, 0, self.timestamp.units());
        put(payload, 8, self.target_system);
        put(payload, 9, self.target_component);
        put(payload, 10, *self.key.as_bytes());
    }
}
