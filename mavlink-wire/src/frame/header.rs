//! The first bytes of a frame: where everything else lies.

use crate::FrameError;

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
    length: usize,
    checked_length: usize,
    frame_length: usize,
}

impl Header {
    /// Reads the start of a frame: as little as tells the frame's length.
    #[inline]
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, FrameError> {
        let (length, needed) = match bytes.first() {
            Some(&STX_V2) => (10, 3),
            Some(&STX_V1) => (6, 2),
            Some(&found) => return Err(FrameError::NotStx { found }),
            None => return Err(FrameError::Incomplete { needed: 1 }),
        };
        let Some([_, payload_length, flags @ ..]) = bytes.get(..needed) else {
            return Err(FrameError::Incomplete { needed });
        };
        let flags = flags.first().copied().unwrap_or_default();
        if flags & !SIGNED != 0 {
            return Err(FrameError::IncompatFlags { flags });
        }
        let checked_length = length + usize::from(*payload_length);
        Ok(Self { length, checked_length, frame_length: checked_length + CHECKSUM + SIGNATURE * usize::from(flags) })
    }

    /// Bytes before the payload.
    #[inline]
    pub(crate) const fn length(self) -> usize {
        self.length
    }

    /// Bytes before the checksum.
    #[inline]
    pub(crate) const fn checked_length(self) -> usize {
        self.checked_length
    }

    /// Bytes of the whole frame, at most [`MAX_FRAME`](crate::MAX_FRAME).
    #[inline]
    pub(crate) const fn frame_length(self) -> usize {
        self.frame_length
    }

    /// The message id in the bytes that this header was read from, if the header is whole.
    #[inline]
    pub(crate) fn id(self, bytes: &[u8]) -> Option<u32> {
        // The last byte of the header is the top byte of the id: one load and a shift.
        let end = bytes.get(..self.length)?.last_chunk().map(|end| u32::from_le_bytes(*end))?;
        Some(if self.length == 10 { end >> 8 } else { end >> 24 })
    }
}

/// How many bytes further the next frame may start, if none starts with the first byte.
#[cfg(feature = "fast-crc")]
#[inline]
pub(crate) fn to_next_start(bytes: &[u8]) -> usize {
    let others = bytes.get(1..).unwrap_or_default();
    1 + memchr::memchr2(STX_V1, STX_V2, others).unwrap_or(others.len())
}

/// How many bytes further the next frame may start, if none starts with the first byte.
#[cfg(not(feature = "fast-crc"))]
pub(crate) fn to_next_start(_: &[u8]) -> usize {
    1
}
