//! Makes frames.

use crate::header::{CHECKSUM, STX_V1, STX_V2};
use crate::message::sent_length;
use crate::message::wire::put;
use crate::{
    ComponentId, Encode, EncodeError, Frame, FrameBuf, MAX_FRAME, MAX_PAYLOAD, MessageInfo, SystemId, Version, crc,
};
#[cfg(feature = "signing")]
use crate::{Timestamp, header::SIGNED, signing::Signer};

/// Where the payload lies in the buffer for both versions, so that a message is written by one piece of code.
const PAYLOAD: usize = 10;
/// Where a MAVLink 1 frame starts in the buffer: its header is shorter.
const START_V1: usize = 4;

/// Makes the frames of one component on one link: it counts them, which is how receivers notice losses.
///
/// ```
/// # use mavlink_wire::{Encode, MessageInfo};
/// # const INFO: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
/// # struct Heartbeat;
/// # impl Encode for Heartbeat {
/// #     fn info(&self) -> &'static MessageInfo { INFO }
/// #     fn write(&self, payload: &mut [u8; 255]) { payload[..9].copy_from_slice(&[0, 0, 0, 0, 6, 8, 0, 4, 3]); }
/// # }
/// use mavlink_wire::{Frame, MAX_FRAME, Sender, Table};
///
/// // Component 190 of system 255, a ground station; a dialect's MavComponent does as well.
/// let (mut tx, mut buffer) = (Sender::v2(255, 190), [0; MAX_FRAME]);
/// for expected in 0..3 {
///     let bytes = tx.encode(&Heartbeat, &mut buffer)?;
///     assert_eq!(bytes[4], expected);
/// }
///
/// // A frame of somebody else, as the next one of this link.
/// let bytes = [0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
/// let frame = Frame::parse(&bytes, const { &Table::of(&[]) }).unwrap();
/// let next = tx.renumber(&frame)?;
/// assert!(next.as_frame().sequence() == 3 && next.as_frame().system_id() == 1);
/// # Ok::<(), mavlink_wire::EncodeError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Sender {
    version: Version,
    system_id: SystemId,
    component_id: ComponentId,
    sequence: u8,
    #[cfg(feature = "signing")]
    signer: Option<Signer>,
}

impl Sender {
    /// A sender of MAVLink 1 frames: ids up to 255, no extension fields.
    #[must_use]
    pub fn v1(system_id: impl Into<SystemId>, component_id: impl Into<ComponentId>) -> Self {
        Self::new(system_id.into(), component_id.into(), Version::V1)
    }

    /// A sender of MAVLink 2 frames.
    #[must_use]
    pub fn v2(system_id: impl Into<SystemId>, component_id: impl Into<ComponentId>) -> Self {
        Self::new(system_id.into(), component_id.into(), Version::V2)
    }

    /// A sender of frames of this version, also in a `const`.
    #[must_use]
    pub const fn new(system_id: SystemId, component_id: ComponentId, version: Version) -> Self {
        Self {
            version,
            system_id,
            component_id,
            sequence: 0,
            #[cfg(feature = "signing")]
            signer: None,
        }
    }

    /// The same sender, signing every frame. MAVLink 1 cannot.
    #[cfg(feature = "signing")]
    #[must_use]
    pub fn signed(self, signer: Signer) -> Self {
        Self { signer: Some(signer), ..self }
    }

    /// Signs every frame from now on, or none.
    #[cfg(feature = "signing")]
    pub fn set_signer(&mut self, signer: Option<Signer>) {
        self.signer = signer;
    }

    /// What signs the frames; its timestamp is to be saved.
    #[cfg(feature = "signing")]
    #[must_use]
    pub fn signer(&self) -> Option<&Signer> {
        self.signer.as_ref()
    }

    /// Tells the time to what signs the frames: see [`Signer::advance_time`].
    #[cfg(feature = "signing")]
    pub fn advance_time(&mut self, now: Timestamp) {
        if let Some(signer) = &mut self.signer {
            signer.advance_time(now);
        }
    }

    /// Which system sends.
    #[must_use]
    pub const fn system_id(&self) -> SystemId {
        self.system_id
    }

    /// Which component of it sends.
    #[must_use]
    pub const fn component_id(&self) -> ComponentId {
        self.component_id
    }

    /// MAVLink 1 or 2.
    #[must_use]
    pub const fn version(&self) -> Version {
        self.version
    }

    /// Sends in this version from now on, as when the other side turns out to speak MAVLink 2.
    pub fn set_version(&mut self, version: Version) {
        self.version = version;
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
    /// MAVLink 1 can carry neither an id over 255 nor a signature. Nothing advances then.
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

    /// Makes a received frame the next of this link: with this sender's sequence number, and with its signature or
    /// none.
    ///
    /// The version stays, and so do system and component, which say who speaks: take a sender for each of those that
    /// are forwarded. Without need for a number or a signature, forward [`Frame::bytes`] as they came.
    ///
    /// # Errors
    ///
    /// A `SETUP_SIGNING` is never forwarded, and a MAVLink 1 frame cannot be signed. Nothing advances then.
    pub fn renumber(&mut self, frame: &Frame<'_>) -> Result<FrameBuf, EncodeError> {
        if frame.carries_key() {
            return Err(EncodeError::CarriesKey);
        }
        let mut next = FrameBuf::from(*frame);
        next.set_sequence(self.sequence);
        #[cfg(feature = "signing")]
        if let Some(signer) = &mut self.signer {
            next.sign(signer)?;
        }
        self.sequence = self.sequence.wrapping_add(1);
        Ok(next)
    }

    /// Puts header, checksum and signature around a written payload.
    fn seal<'b>(&mut self, info: &MessageInfo, buffer: &'b mut [u8; MAX_FRAME]) -> Result<&'b [u8], EncodeError> {
        let payload = buffer.get(PAYLOAD..PAYLOAD + MAX_PAYLOAD).unwrap_or_default();
        let length = sent_length(info, self.version, payload);
        let start = self.put_header(info, length, buffer)?;
        self.sequence = self.sequence.wrapping_add(1);
        let end = PAYLOAD + length;
        let checked = buffer.get(start + 1..end).unwrap_or_default();
        let checksum = crc::step(crc::checksum(checked), info.crc_extra);
        put(buffer, end, checksum);
        let end = end + CHECKSUM;
        #[cfg(feature = "signing")]
        let end = match &mut self.signer {
            Some(signer) => signer.sign(buffer, end),
            None => end,
        };
        Ok(buffer.get(start..end).unwrap_or_default())
    }

    /// Puts the header in front of a payload of `length` bytes; gives the start of the frame.
    #[inline]
    fn put_header(
        &self,
        info: &MessageInfo,
        length: usize,
        buffer: &mut [u8; MAX_FRAME],
    ) -> Result<usize, EncodeError> {
        let [id, id_high @ ..] = info.id.to_le_bytes();
        let (system_id, component_id) = (self.system_id.to_u8(), self.component_id.to_u8());
        let flags = self.incompat_flags();
        match self.version {
            Version::V1 if id_high != [0; 3] => Err(EncodeError::IdTooLarge { message_id: info.id }),
            Version::V1 if flags != 0 => Err(EncodeError::SignatureInV1 { message_id: info.id }),
            Version::V1 => {
                put(buffer, START_V1, [STX_V1, length as u8, self.sequence, system_id, component_id, id]);
                Ok(START_V1)
            }
            Version::V2 => {
                let [id_middle, id_top, _] = id_high;
                put(buffer, 0, [STX_V2, length as u8, flags, 0]);
                put(buffer, 4, [self.sequence, system_id, component_id, id, id_middle, id_top]);
                Ok(0)
            }
        }
    }

    const fn incompat_flags(&self) -> u8 {
        #[cfg(feature = "signing")]
        if self.signer.is_some() {
            return SIGNED;
        }
        0
    }
}
