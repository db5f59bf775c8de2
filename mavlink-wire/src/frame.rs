//! Frames: a header, a payload, a checksum, perhaps a signature.

mod buffer;
pub mod crc;
pub(crate) mod header;
mod id;
pub(crate) mod key;
#[cfg(any(feature = "std", feature = "embedded-io", feature = "embedded-io-async"))]
mod outline;
mod timestamp;
mod version;

pub use buffer::FrameBuf;
pub use id::{ComponentId, SystemId};
#[cfg(any(feature = "std", feature = "embedded-io", feature = "embedded-io-async"))]
pub(crate) use outline::Outline;
pub use timestamp::Timestamp;
pub use version::Version;

use self::header::{Header, STX_V2};
pub(crate) use self::key::SETUP_SIGNING;
use crate::reflect::Reflected;
use crate::{Dialect, FieldInfo, FrameError, Message, MessageInfo, Table};

/// A frame whose checksum was verified; a view of the received bytes.
///
/// A [`Parser`](crate::Parser) finds frames in a stream; [`parse`](Self::parse) reads one whose place is known.
///
/// ```
/// use mavlink_wire::{Frame, FrameError, Table, Version};
///
/// let bytes = [0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
/// let nothing = const { &Table::of(&[]) };
/// let frame = Frame::parse(&bytes, nothing)?;
/// assert_eq!((frame.version(), frame.message_id()), (Version::V1, 0));
/// assert!(frame.system_id() == 1 && frame.component_id() == 1);
/// assert_eq!((frame.payload(), frame.is_verified()), (&[0, 0, 0, 0, 6, 8, 0, 4, 3][..], false));
/// assert_eq!(Frame::parse(&bytes[..12], nothing), Err(FrameError::Incomplete { needed: 17 }));
/// # Ok::<(), FrameError>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Frame<'a> {
    bytes: &'a [u8],
    payload: &'a [u8],
    facts: Facts,
}

/// What verification found out.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Facts {
    pub(crate) id: u32,
    pub(crate) crc_extra: u8,
    pub(crate) verified: bool,
}

/// What may be a frame, by its header. Its message is looked up only where it matters: most false frames fail before.
#[derive(Clone, Copy)]
pub(crate) struct Candidate {
    pub(crate) header: Header,
    pub(crate) id: u32,
}

impl Candidate {
    /// Reads a header.
    #[inline]
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, FrameError> {
        let header = Header::read(bytes)?;
        let id = header.id(bytes).ok_or(FrameError::Incomplete { needed: header.frame_length() })?;
        Ok(Self { header, id })
    }

    /// The facts of the frame, if it is whole, and its checksum is right; `checksum` calculates that of its first bytes.
    #[inline]
    pub(crate) fn verify(
        self,
        bytes: &[u8],
        table: &Table<'_>,
        checksum: impl FnOnce(usize) -> u16,
    ) -> Result<Facts, FrameError> {
        let (end, length) = (self.header.checked_length(), self.header.frame_length());
        let Some(sent) = bytes.get(..length).and_then(|frame| frame.get(end..)).and_then(<[u8]>::first_chunk) else {
            return Err(FrameError::Incomplete { needed: length });
        };
        let wrong = FrameError::Checksum { message_id: self.id };
        let crc_extra = crc::byte_between(checksum(end), u16::from_le_bytes(*sent)).ok_or(wrong)?;
        let known = table.get(self.id);
        if known.is_some_and(|info| info.crc_extra != crc_extra) {
            return Err(wrong);
        }
        Ok(Facts { id: self.id, crc_extra, verified: known.is_some() })
    }

    /// Whether the message is known, and has this length: a payload of MAVLink 2 leaves zeros out, and the sender may know
    /// more fields.
    pub(crate) fn is_likely(self, table: &Table<'_>) -> bool {
        table
            .get(self.id)
            .is_some_and(|info| self.header.is_v2() || self.header.payload_length() == usize::from(info.len_v1))
    }
}

impl<'a> Frame<'a> {
    /// Reads the frame at the start of `bytes`, as a datagram carries it. What follows it is left alone:
    /// `frame.bytes().len()` says where.
    ///
    /// # Errors
    ///
    /// The bytes do not start with a whole, undamaged frame that may be read.
    #[inline]
    pub fn parse(bytes: &'a [u8], table: &Table<'_>) -> Result<Self, FrameError> {
        let candidate = Candidate::read(bytes)?;
        let facts = candidate.verify(bytes, table, |end| crc::checksum(bytes.get(1..end).unwrap_or_default()))?;
        let length = candidate.header.frame_length();
        Ok(Self::with_facts(bytes.get(..length).unwrap_or_default(), candidate.header, facts))
    }

    /// The frame that these are the bytes of, and of which [`Candidate::verify`] found these facts.
    #[inline]
    pub(crate) fn with_facts(bytes: &'a [u8], header: Header, facts: Facts) -> Self {
        Self { bytes, payload: bytes.get(header.length()..header.checked_length()).unwrap_or_default(), facts }
    }

    /// Where something lies in a frame of this version.
    fn place(&self, at_v1: usize, at_v2: usize) -> usize {
        match self.version() {
            Version::V1 => at_v1,
            Version::V2 => at_v2,
        }
    }

    /// Where the payload lies.
    fn payload_start(&self) -> usize {
        self.place(6, 10)
    }

    fn byte(&self, at_v1: usize, at_v2: usize) -> u8 {
        self.bytes.get(self.place(at_v1, at_v2)).copied().unwrap_or_default()
    }

    /// MAVLink 1 or 2.
    #[inline]
    #[must_use]
    pub fn version(&self) -> Version {
        if self.bytes.first() == Some(&STX_V2) { Version::V2 } else { Version::V1 }
    }

    /// Counts the frames of a sender, modulo 256: a gap is a loss.
    #[must_use]
    pub fn sequence(&self) -> u8 {
        self.byte(2, 4)
    }

    /// Id of the sending system.
    #[must_use]
    pub fn system_id(&self) -> SystemId {
        SystemId::from_u8(self.byte(3, 5))
    }

    /// Id of the sending component of that system.
    #[must_use]
    pub fn component_id(&self) -> ComponentId {
        ComponentId::from_u8(self.byte(4, 6))
    }

    /// Id of the message.
    #[inline]
    #[must_use]
    pub fn message_id(&self) -> u32 {
        self.facts.id
    }

    /// The payload as it was received: perhaps without trailing zeros, perhaps longer than the message is known here.
    #[inline]
    #[must_use]
    pub fn payload(&self) -> &'a [u8] {
        self.payload
    }

    /// Flags that a receiver must understand; here 0 or 0x01, signed. Always 0 in MAVLink 1.
    #[must_use]
    pub fn incompat_flags(&self) -> u8 {
        match self.version() {
            Version::V1 => 0,
            Version::V2 => self.byte(0, 2),
        }
    }

    /// Flags that a receiver may ignore. Always 0 in MAVLink 1.
    #[must_use]
    pub fn compat_flags(&self) -> u8 {
        match self.version() {
            Version::V1 => 0,
            Version::V2 => self.byte(0, 3),
        }
    }

    /// The signature, if the frame has one. It is not verified: `signing::Verifier` does that (feature `signing`).
    #[must_use]
    pub fn signature(&self) -> Option<Signature<'a>> {
        if self.incompat_flags() == 0 { None } else { self.bytes.last_chunk().map(|bytes| Signature { bytes }) }
    }

    /// The whole frame, to be forwarded as it came.
    #[inline]
    #[must_use]
    pub fn bytes(&self) -> &'a [u8] {
        self.bytes
    }

    /// Whether this is a `SETUP_SIGNING` (message 256), whose payload is a secret key: neither forward nor log it.
    ///
    /// It goes to one system over a link that is secure by other means (MAVLink guide, "Message Signing"). By id alone:
    /// what only looks like one is better kept, too. [`Sender::renumber`](crate::Sender::renumber) refuses it, and
    /// `Debug` leaves the payload out.
    #[inline]
    #[must_use]
    pub fn carries_key(&self) -> bool {
        self.facts.id == SETUP_SIGNING
    }

    /// Whether it is `RADIO_STATUS`: telemetry radios put that into the stream, without a key, and it is about one link.
    pub(crate) fn is_of_radio(&self) -> bool {
        self.facts.id == 109
    }

    /// Whether the table knew the message. If not, some `crc_extra` explains the checksum, which damage achieves in 1 of
    /// 256 cases: forward such a frame, but do not act on it.
    #[inline]
    #[must_use]
    pub fn is_verified(&self) -> bool {
        self.facts.verified
    }

    /// The `crc_extra` that explains the checksum.
    #[inline]
    #[must_use]
    pub fn crc_extra(&self) -> u8 {
        self.facts.crc_extra
    }

    /// The message, if the frame carries an `M` and the sender has the same definition of it.
    #[inline]
    #[must_use]
    pub fn decode<M: Message>(&self) -> Option<M> {
        if self.facts.id == M::ID && self.facts.crc_extra == M::INFO.crc_extra {
            Some(M::decode(self.payload))
        } else {
            None
        }
    }

    /// The message, if the dialect has it and the sender has the same definition of it.
    #[inline]
    #[must_use]
    pub fn message<D: Dialect>(&self) -> Option<D> {
        if self.belongs_to::<D>() { D::decode(self.facts.id, self.payload) } else { None }
    }

    /// Reads the message into `message`; `false`, and `message` as it was, where [`message`](Self::message) gives `None`.
    #[inline]
    pub fn decode_into<D: Dialect>(&self, message: &mut D) -> bool {
        self.belongs_to::<D>() && message.decode_into(self.facts.id, self.payload)
    }

    /// The message without its type: names, values, units. `None` where [`message`](Self::message) gives `None`.
    #[must_use]
    pub fn reflect<D: Dialect>(&self) -> Option<Reflected<'a>> {
        self.reflect_as(D::TABLE.get(self.facts.id)?, D::fields(self.facts.id)?)
    }

    /// The message as these tables describe it, if the frame carries that message and the sender has the same definition
    /// of it. They need not be a dialect's: a program can make them at run time.
    #[must_use]
    pub fn reflect_as(&self, info: &'a MessageInfo, fields: &'a [FieldInfo]) -> Option<Reflected<'a>> {
        if self.facts.id == info.id && self.facts.crc_extra == info.crc_extra {
            Some(Reflected::new(info, fields, self.payload))
        } else {
            None
        }
    }

    /// The frame may have been checked against another table than the dialect's.
    #[inline]
    fn belongs_to<D: Dialect>(&self) -> bool {
        matches!(D::TABLE.get(self.facts.id), Some(info) if info.crc_extra == self.facts.crc_extra)
    }
}

/// All of its bytes.
impl AsRef<[u8]> for Frame<'_> {
    fn as_ref(&self) -> &[u8] {
        self.bytes
    }
}

impl core::fmt::Debug for Frame<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let payload = if self.carries_key() { &"secret" as &dyn core::fmt::Debug } else { &self.payload };
        f.debug_struct("Frame")
            .field("version", &self.version())
            .field("sequence", &self.sequence())
            .field("system_id", &self.system_id())
            .field("component_id", &self.component_id())
            .field("message_id", &self.facts.id)
            .field("payload", payload)
            .field("signature", &self.signature())
            .field("verified", &self.facts.verified)
            .finish()
    }
}

/// The signature of a MAVLink 2 frame, as it was received.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
pub struct Signature<'a> {
    bytes: &'a [u8; 13],
}

impl<'a> Signature<'a> {
    /// Which of the sender's links.
    #[must_use]
    pub fn link_id(&self) -> u8 {
        self.bytes[0]
    }

    /// When it was made, by the sender's clock.
    #[must_use]
    pub fn timestamp(&self) -> Timestamp {
        let [_, a, b, c, d, e, f, ..] = *self.bytes;
        Timestamp::from_bytes([a, b, c, d, e, f])
    }

    /// Link id, timestamp (6 bytes), hash (6 bytes).
    #[must_use]
    pub fn bytes(&self) -> &'a [u8; 13] {
        self.bytes
    }
}
