//! The first bytes of a frame: where everything else lies.

use crate::{FrameError, Version};

/// First byte of a MAVLink 1 frame.
pub(crate) const STX_V1: u8 = 0xFE;
/// First byte of a MAVLink 2 frame.
pub(crate) const STX_V2: u8 = 0xFD;
/// The one incompatibility flag: a signature follows the checksum.
pub(crate) const SIGNED: u8 = 0x01;
/// Bytes of a signature: link id, timestamp, hash.
pub(crate) const SIGNATURE: usize = 13;
/// Bytes of the checksum.
pub(crate) const CHECKSUM: usize = 2;

/// What the first bytes say about a frame's layout.
#[derive(Clone, Copy)]
pub(crate) struct Header {
    pub(crate) version: Version,
    payload_length: u8,
    signed: bool,
}

impl Header {
    /// Reads the start of a frame: as little as tells the frame's length.
    #[inline]
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, FrameError> {
        match *bytes {
            [STX_V2, payload_length, flags, ..] => match flags & !SIGNED {
                0 => Ok(Self { version: Version::V2, payload_length, signed: flags == SIGNED }),
                _ => Err(FrameError::IncompatFlags { flags }),
            },
            [STX_V1, payload_length, ..] => Ok(Self { version: Version::V1, payload_length, signed: false }),
            [STX_V2, ..] => Err(FrameError::Incomplete { needed: 3 }),
            [STX_V1] => Err(FrameError::Incomplete { needed: 2 }),
            [found, ..] => Err(FrameError::NotStx { found }),
            [] => Err(FrameError::Incomplete { needed: 1 }),
        }
    }

    /// Bytes before the payload.
    #[inline]
    pub(crate) const fn length(self) -> usize {
        match self.version {
            Version::V1 => 6,
            Version::V2 => 10,
        }
    }

    /// Bytes before the checksum.
    #[inline]
    pub(crate) const fn checked_length(self) -> usize {
        self.length() + self.payload_length as usize
    }

    /// Bytes of the whole frame, at most [`MAX_FRAME`](crate::MAX_FRAME).
    #[inline]
    pub(crate) const fn frame_length(self) -> usize {
        self.checked_length() + CHECKSUM + if self.signed { SIGNATURE } else { 0 }
    }

    /// The message id in the frame that this header was read from.
    #[inline]
    pub(crate) fn id(self, frame: &[u8]) -> u32 {
        let end = match self.version {
            Version::V1 => frame.get(5).map(|&id| u32::from(id)),
            // The last byte of the header is the top byte of the id: one load and a shift.
            Version::V2 => frame.get(6..).and_then(<[u8]>::first_chunk).map(|end| u32::from_le_bytes(*end) >> 8),
        };
        end.unwrap_or_default()
    }
}
