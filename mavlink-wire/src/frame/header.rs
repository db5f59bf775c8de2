//! The first bytes of a frame: where everything else lies.

use crate::FrameError;
#[cfg(feature = "fast-crc")]
use crate::{parser::work, seek};

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

/// A number of bytes, kept as time wants it or as flash does.
#[cfg(feature = "fast-crc")]
type Length = usize;
/// A number of bytes, kept as time wants it or as flash does.
#[cfg(not(feature = "fast-crc"))]
type Length = u32;

/// A number of bytes, as others count them.
#[cfg_attr(feature = "fast-crc", expect(clippy::unnecessary_cast, reason = "only there it is the same type"))]
const fn whole(length: Length) -> usize {
    length as usize
}

/// Bytes of a header of MAVLink 1.
const V1: Length = 6;
/// Bytes of a header of MAVLink 2.
const V2: Length = 10;
/// Bytes of the longest header.
pub(crate) const LONGEST: usize = 10;

/// What the first bytes say about a frame's layout.
#[derive(Clone, Copy)]
pub(crate) struct Header {
    length: Length,
    checked_length: Length,
    frame_length: Length,
}

impl Header {
    /// Reads the start of a frame: as little as tells the frame's length.
    #[inline]
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, FrameError> {
        let (length, needed) = match bytes.first() {
            Some(&STX_V2) => (V2, 3),
            Some(&STX_V1) => (V1, 2),
            Some(&found) => return Err(FrameError::NotStx { found }),
            None => return Err(FrameError::Incomplete { needed: 1 }),
        };
        let Some([_, payload, flags @ ..]) = bytes.get(..needed) else {
            return Err(FrameError::Incomplete { needed });
        };
        let flags = flags.first().copied().unwrap_or_default();
        if flags & !SIGNED != 0 {
            return Err(FrameError::IncompatFlags { flags });
        }
        let checked_length = length + Length::from(*payload);
        let frame_length = checked_length + (CHECKSUM + SIGNATURE * usize::from(flags)) as Length;
        Ok(Self { length, checked_length, frame_length })
    }

    /// Bytes before the payload.
    #[inline]
    pub(crate) fn length(self) -> usize {
        whole(self.length)
    }

    /// Bytes of the payload.
    #[inline]
    pub(crate) const fn payload_length(self) -> usize {
        whole(self.checked_length - self.length)
    }

    /// Bytes before the checksum.
    #[inline]
    pub(crate) const fn checked_length(self) -> usize {
        whole(self.checked_length)
    }

    /// Bytes of the whole frame, at most [`MAX_FRAME`](crate::MAX_FRAME).
    #[inline]
    pub(crate) const fn frame_length(self) -> usize {
        whole(self.frame_length)
    }

    /// Whether this is of MAVLink 2.
    #[inline]
    pub(crate) const fn is_v2(self) -> bool {
        self.length == V2
    }

    /// The message id in the bytes that this header was read from, if the header is whole.
    #[inline]
    pub(crate) fn id(self, bytes: &[u8]) -> Option<u32> {
        // The last byte of the header is the top byte of the id: one load and a shift.
        let end = bytes.get(..self.length())?.last_chunk().map(|end| u32::from_le_bytes(*end))?;
        Some(if self.is_v2() { end >> 8 } else { end >> 24 })
    }
}

/// Whether a frame may start with this byte.
pub(crate) const fn is_start(byte: u8) -> bool {
    matches!(byte, STX_V1 | STX_V2)
}

/// How many bytes further the next frame may start, if none starts with the first byte.
#[cfg(feature = "fast-crc")]
#[inline]
pub(crate) fn to_next_start(bytes: &[u8]) -> usize {
    let count = match bytes.get(1..).unwrap_or_default() {
        [next, ..] if is_start(*next) => 1,
        others => 1 + seek::first(others, is_start).unwrap_or(others.len()),
    };
    work::count(count);
    count
}

/// How many bytes further the next frame may start, if none starts with the first byte.
#[cfg(not(feature = "fast-crc"))]
pub(crate) fn to_next_start(_: &[u8]) -> usize {
    1
}
