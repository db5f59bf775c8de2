//! Frames that own their bytes, and may change.

use super::{Facts, Frame};
use crate::header::CHECKSUM;
use crate::message::wire::{put, zero_extended};
#[cfg(feature = "signing")]
use crate::{EncodeError, header::SIGNED, signing::Signer};
use crate::{MAX_FRAME, Version, crc};

/// A frame that owns its bytes: to be kept while the parser goes on, or to be changed and sent again.
///
/// The checksum stays right whatever is changed, also in a frame of an unknown message: its
/// [`crc_extra`](Frame::crc_extra) is known from the checksum it came with.
///
/// ```
/// use mavlink_wire::{FrameBuf, Parser, Table};
///
/// # let mut parser = Parser::new(const { &Table::of(&[]) });
/// # let mut chunk: &[u8] = &[0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
/// let mut queue = vec![];
/// while let Some(frame) = parser.next(&mut chunk) {
///     queue.push(FrameBuf::from(frame));
/// }
/// for (frame, sequence) in queue.iter_mut().zip(7..) {
///     frame.set_sequence(sequence);
///     assert_eq!(frame.as_frame().sequence(), sequence);
/// }
/// # assert_eq!(queue.len(), 1);
/// ```
#[derive(Clone, Copy)]
pub struct FrameBuf {
    bytes: [u8; MAX_FRAME],
    /// Ranges in `bytes`; they fit by construction.
    length: u16,
    payload: (u8, u8),
    facts: Facts,
}

impl FrameBuf {
    /// The frame.
    #[must_use]
    pub fn as_frame(&self) -> Frame<'_> {
        let (start, length) = (usize::from(self.payload.0), usize::from(self.payload.1));
        Frame {
            bytes: self.bytes(),
            payload: self.bytes.get(start..start + length).unwrap_or_default(),
            facts: self.facts,
        }
    }

    /// The whole frame, to be sent.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        self.bytes.get(..usize::from(self.length)).unwrap_or_default()
    }

    /// Gives the frame another sequence number, and takes its signature away, which was that of the old one.
    pub fn set_sequence(&mut self, sequence: u8) {
        let at = self.as_frame().place(2, 4);
        put(&mut self.bytes, at, sequence);
        self.seal(0);
    }

    /// Takes the signature away, as for a log (MAVLink guide, "Message Signing"): the frame of a sender that does not
    /// sign.
    ///
    /// A frame that is not signed stays as it is.
    pub fn strip_signature(&mut self) {
        if self.as_frame().incompat_flags() != 0 {
            self.seal(0);
        }
    }

    /// Signs the frame for another link, in place of the signature that it may have.
    ///
    /// # Errors
    ///
    /// MAVLink 1 has no signatures; a frame that [carries a key](Frame::carries_key) is not to be sent on. The frame
    /// and the signer stay as they were then.
    #[cfg(feature = "signing")]
    pub fn sign(&mut self, signer: &mut Signer) -> Result<(), EncodeError> {
        let frame = self.as_frame();
        if frame.carries_key() {
            return Err(EncodeError::CarriesKey);
        }
        if frame.version() == Version::V1 {
            return Err(EncodeError::SignatureInV1 { message_id: self.facts.id });
        }
        self.seal(SIGNED);
        self.length = signer.sign(&mut self.bytes, usize::from(self.length)) as u16;
        Ok(())
    }

    /// Completes the frame after a change, up to the checksum.
    fn seal(&mut self, incompat_flags: u8) {
        if self.as_frame().version() == Version::V2 {
            put(&mut self.bytes, 2, incompat_flags);
        }
        let end = usize::from(self.payload.0) + usize::from(self.payload.1);
        let checked = self.bytes.get(1..end).unwrap_or_default();
        let checksum = crc::step(crc::checksum(checked), self.facts.crc_extra);
        put(&mut self.bytes, end, checksum);
        self.length = (end + CHECKSUM) as u16;
    }
}

impl From<Frame<'_>> for FrameBuf {
    fn from(frame: Frame<'_>) -> Self {
        Self {
            bytes: zero_extended(frame.bytes),
            length: frame.bytes.len() as u16,
            payload: (frame.payload_start() as u8, frame.payload.len() as u8),
            facts: frame.facts,
        }
    }
}

impl core::fmt::Debug for FrameBuf {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.as_frame().fmt(f)
    }
}

impl PartialEq for FrameBuf {
    fn eq(&self, other: &Self) -> bool {
        self.as_frame() == other.as_frame()
    }
}

impl Eq for FrameBuf {}

impl core::hash::Hash for FrameBuf {
    fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
        self.as_frame().hash(state);
    }
}

/// All of its bytes.
impl AsRef<[u8]> for FrameBuf {
    fn as_ref(&self) -> &[u8] {
        self.bytes()
    }
}
