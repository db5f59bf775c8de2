//! Payloads that no sender made, and what a decoder and encoder have to make of them.

use mavlink_wire::{Encode, MAX_PAYLOAD, MessageInfo, Version};

use crate::random::Random;

/// What fills a payload.
#[derive(Clone, Copy, Debug)]
pub enum Fill {
    /// Any bytes: values that no entry names, flags that nobody knows.
    Random,
    /// Mostly zeros, so that payloads end in them.
    Sparse,
    /// Every aligned `float` is a signalling NaN of either sign.
    SignallingNan,
}

impl Fill {
    /// Every kind.
    pub const ALL: [Self; 3] = [Self::Random, Self::Sparse, Self::SignallingNan];

    /// A payload of this length.
    pub fn payload(self, length: usize, random: &mut Random) -> Vec<u8> {
        let byte = |at: usize| match (self, at % 4) {
            (Self::Sparse, _) if random.below(8) > 0 => 0,
            (Self::SignallingNan, 2) => 0x80 | random.number() as u8 & 0x3F,
            (Self::SignallingNan, 3) => 0x7F | random.number() as u8 & 0x80,
            (Self::SignallingNan, _) => random.number() as u8 | 1,
            _ => random.number() as u8,
        };
        (0..length).map(byte).collect()
    }
}

/// What MAVLink 1 and MAVLink 2 carry of a message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Canonical {
    /// The base fields, all of them.
    pub v1: Vec<u8>,
    /// All fields, without zeros at the end, but at least one byte.
    pub v2: Vec<u8>,
}

impl Canonical {
    /// What a receiver that knows the message understands of this payload: bytes that are missing are zero, bytes too many
    /// mean nothing.
    pub fn of(payload: &[u8], info: &MessageInfo) -> Self {
        let (mut v1, mut v2) = (payload.to_vec(), payload.to_vec());
        v1.resize(info.len_v1.into(), 0);
        v2.resize(info.len_v2.into(), 0);
        while v2.len() > 1 && v2.ends_with(&[0]) {
            v2.pop();
        }
        Self { v1, v2 }
    }

    /// What the runtime sends of a message.
    pub fn sent(message: &dyn Encode) -> Self {
        let payload = |version| message.payload(version, &mut [0x5A; MAX_PAYLOAD]).to_vec();
        Self { v1: payload(Version::V1), v2: payload(Version::V2) }
    }
}
