//! Makes frames.

use crate::header::{STX_V1, STX_V2};
use crate::message::sent_length;
use crate::{Encode, EncodeError, MAX_FRAME, MAX_PAYLOAD, MessageInfo, Version, crc, put};

/// Where the payload lies in the buffer for both versions, so that a message is written by one piece of code.
const PAYLOAD: usize = 10;
/// Where a MAVLink 1 frame starts in the buffer: its header is shorter.
const START_V1: usize = 4;

/// Makes the frames of one component on one link: it counts them, which is how receivers notice losses.
#[derive(Clone, Debug)]
pub struct Sender {
    version: Version,
    system: u8,
    component: u8,
    sequence: u8,
}

impl Sender {
    /// A sender of MAVLink 1 frames: ids up to 255, no extension fields.
    pub fn v1(system: impl Into<u8>, component: impl Into<u8>) -> Self {
        Self::new(Version::V1, system.into(), component.into())
    }

    /// A sender of MAVLink 2 frames.
    pub fn v2(system: impl Into<u8>, component: impl Into<u8>) -> Self {
        Self::new(Version::V2, system.into(), component.into())
    }

    const fn new(version: Version, system: u8, component: u8) -> Self {
        Self { version, system, component, sequence: 0 }
    }

    /// The sequence number of the next frame.
    #[must_use]
    pub fn sequence(&self) -> u8 {
        self.sequence
    }

    /// Sets the sequence number of the next frame.
    pub fn set_sequence(&mut self, sequence: u8) {
        self.sequence = sequence;
    }

    /// Makes the next frame. It lies somewhere in `buffer`, not always at its start.
    ///
    /// # Errors
    ///
    /// MAVLink 1 cannot carry an id over 255. The sequence does not advance then.
    #[inline]
    pub fn encode<'b>(
        &mut self,
        message: &(impl Encode + ?Sized),
        buffer: &'b mut [u8; MAX_FRAME],
    ) -> Result<&'b [u8], EncodeError> {
        let info = message.info();
        if let Some(payload) = buffer.get_mut(PAYLOAD..).and_then(<[u8]>::first_chunk_mut) {
            message.write(payload);
        }
        self.seal(info, buffer)
    }

    /// Puts header and checksum around a written payload.
    fn seal<'b>(&mut self, info: &MessageInfo, buffer: &'b mut [u8; MAX_FRAME]) -> Result<&'b [u8], EncodeError> {
        let [id, id_high @ ..] = info.id.to_le_bytes();
        if self.version == Version::V1 && id_high != [0; 3] {
            return Err(EncodeError::IdTooLarge { id: info.id });
        }
        let payload = buffer.get(PAYLOAD..PAYLOAD + MAX_PAYLOAD).unwrap_or_default();
        let length = sent_length(info, self.version, payload);
        let start = match self.version {
            Version::V1 => {
                put(buffer, START_V1, [STX_V1, length as u8, self.sequence, self.system, self.component, id]);
                START_V1
            }
            Version::V2 => {
                let [id_middle, id_top, _] = id_high;
                let ids = [self.sequence, self.system, self.component, id, id_middle, id_top];
                put(buffer, 0, [STX_V2, length as u8, 0, 0]);
                put(buffer, 4, ids);
                0
            }
        };
        self.sequence = self.sequence.wrapping_add(1);
        let end = PAYLOAD + length;
        let checked = buffer.get(start + 1..end).unwrap_or_default();
        let checksum = crc::step(crc::checksum(checked), info.crc_extra);
        put(buffer, end, checksum);
        Ok(buffer.get(start..end + 2).unwrap_or_default())
    }
}
