//! Frames in one buffer, as they come over a link.

use std::ops::Range;

use mavlink::dialects::common::MavMessage;
use mavlink::{MavHeader, MavlinkVersion, Message as _};
use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::{Dialect as _, Frame, Version};

/// Frames that both sides can read. What one side needs for one job lies together, so that nobody pays for the other.
#[derive(Clone, Debug, Default)]
pub struct Corpus {
    /// All frames, one after the other.
    pub bytes: Vec<u8>,
    /// Where each of them lies.
    pub frames: Vec<Place>,
    /// The messages as we decode them.
    pub ours: Vec<Autoquad>,
    /// The messages as rust-mavlink decodes them.
    pub theirs: Vec<MavMessage>,
}

/// A frame of a corpus.
#[derive(Clone, Debug)]
pub struct Place {
    /// In the corpus.
    pub frame: Range<usize>,
    /// In the corpus.
    pub payload: Range<usize>,
    /// MAVLink 1 or 2.
    pub version: Version,
    /// Message id.
    pub id: u32,
    /// Who sent it.
    pub header: MavHeader,
}

/// Why a frame is no part of a corpus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// rust-mavlink's `common` does not have the message, or has another definition of it.
    Unknown,
    /// rust-mavlink refuses a value of an enum and with it the message.
    Value,
}

impl Corpus {
    /// Adds a frame.
    ///
    /// # Errors
    /// rust-mavlink cannot read it.
    pub fn push(&mut self, bytes: &[u8]) -> Result<(), Refusal> {
        let frame = Frame::parse(bytes, Autoquad::TABLE).map_err(|_| Refusal::Unknown)?;
        let ours = frame.message().ok_or(Refusal::Unknown)?;
        if MavMessage::default_message_from_id(frame.message_id()).is_none()
            || MavMessage::extra_crc(frame.message_id()) != frame.crc_extra()
        {
            return Err(Refusal::Unknown);
        }
        let theirs = MavMessage::parse(their_version(frame.version()), frame.message_id(), frame.payload());
        let theirs = theirs.map_err(|_| Refusal::Value)?;
        let header = MavHeader {
            system_id: frame.system_id().to_u32(),
            component_id: frame.component_id().to_u32() as u8,
            sequence: frame.sequence(),
        };
        let start = self.bytes.len();
        self.bytes.extend_from_slice(bytes);
        let payload = start + if frame.version() == Version::V1 { 6 } else { 10 };
        self.frames.push(Place {
            frame: start..self.bytes.len(),
            payload: payload..payload + frame.payload().len(),
            version: frame.version(),
            id: frame.message_id(),
            header,
        });
        self.ours.push(ours);
        self.theirs.push(theirs);
        Ok(())
    }

    /// Each frame with its bytes.
    pub fn iter(&self) -> impl Iterator<Item = (&Place, &[u8])> {
        self.frames.iter().map(|place| (place, self.bytes.get(place.frame.clone()).unwrap_or_default()))
    }

    /// Each frame with its payload.
    pub fn payloads(&self) -> impl Iterator<Item = (&Place, &[u8])> {
        self.frames.iter().map(|place| (place, self.bytes.get(place.payload.clone()).unwrap_or_default()))
    }
}

/// The version as rust-mavlink spells it.
#[must_use]
pub fn their_version(version: Version) -> MavlinkVersion {
    match version {
        Version::V1 => MavlinkVersion::V1,
        Version::V2 => MavlinkVersion::V2,
    }
}
