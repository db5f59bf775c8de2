//! From a message to the bytes for each who gets them: in the version of each, under one number.

use core::fmt;
use std::boxed::Box;
use std::time::Instant;
use std::vec::Vec;

use super::peers::Target;
use super::{Peer, Peers};
#[cfg(feature = "signing")]
use crate::adapters::clock;
use crate::frame::key::{SETUP_SIGNING, wipe};
use crate::{Encode, EncodeError, Frame, MAX_FRAME, Sender, Version};

/// A sender, and whom it sends to.
#[derive(Debug)]
pub(crate) struct Outbox {
    pub(crate) sender: Sender,
    /// The version for all, whatever they speak.
    pub(crate) only: Option<Version>,
    peers: Peers,
}

/// A frame, and who gets it. It may carry a key: then it is wiped when it is dropped.
pub(crate) struct Parcel {
    /// Boxed, so that no copy of a key stays behind where a parcel has been.
    buffer: Box<[u8; MAX_FRAME]>,
    start: usize,
    end: usize,
    carries_key: bool,
    pub(crate) to: Vec<Peer>,
}

/// What is made of one message: at most a frame in each version.
#[derive(Debug, Default)]
pub(crate) struct Parcels {
    pub(crate) parcels: Vec<Parcel>,
    /// Why some peers get none.
    pub(crate) error: Option<EncodeError>,
}

impl Outbox {
    pub(crate) const fn new(sender: Sender, peers: Peers) -> Self {
        Self { sender, only: None, peers }
    }

    /// A message to one, a peer or not.
    pub(crate) fn encode_to(&mut self, message: &(impl Encode + ?Sized), to: Peer) -> Result<Parcel, EncodeError> {
        let Target { peer, version } = self.peers.target(to, Instant::now());
        self.encode(message, self.version_for(version), [peer].into())
    }

    /// A message to all that there are, under one number. What the version of some cannot carry still goes to the others.
    pub(crate) fn encode_to_all(&mut self, message: &(impl Encode + ?Sized)) -> Parcels {
        let (targets, sequence) = (self.peers.targets(Instant::now()), self.sender.sequence());
        let mut all = Parcels::default();
        for version in [Version::V1, Version::V2] {
            let to: Vec<_> =
                targets.iter().filter(|to| self.version_for(to.version) == version).map(|to| to.peer).collect();
            if to.is_empty() {
                continue;
            }
            self.sender.set_sequence(sequence);
            match self.encode(message, version, to) {
                Ok(parcel) => all.parcels.push(parcel),
                Err(error) => all.error = Some(error),
            }
        }
        self.sender.set_sequence(sequence.wrapping_add((!all.parcels.is_empty()).into()));
        all
    }

    /// A frame as it came, to the byte.
    pub(crate) fn forward(frame: &Frame<'_>, to: Vec<Peer>) -> Result<Parcel, EncodeError> {
        if frame.carries_key() {
            return Err(EncodeError::CarriesKey);
        }
        let mut buffer = Box::new([0; MAX_FRAME]);
        buffer.iter_mut().zip(frame.bytes()).for_each(|(to, from)| *to = *from);
        Ok(Parcel { buffer, start: 0, end: frame.bytes().len(), carries_key: false, to })
    }

    /// A frame as it came, to all that there are.
    pub(crate) fn forward_to_all(&self, frame: &Frame<'_>) -> Result<Parcel, EncodeError> {
        let to = self.peers.targets(Instant::now()).iter().map(|to| to.peer).collect();
        Self::forward(frame, to)
    }

    /// Which version somebody is spoken to in. A signature needs that of the sender.
    fn version_for(&self, theirs: Option<Version>) -> Version {
        #[cfg(feature = "signing")]
        if self.sender.signer().is_some() {
            return self.sender.version();
        }
        self.only.or(theirs).unwrap_or(self.sender.version())
    }

    /// Makes the next frame, in this version.
    fn encode(
        &mut self,
        message: &(impl Encode + ?Sized),
        version: Version,
        to: Vec<Peer>,
    ) -> Result<Parcel, EncodeError> {
        #[cfg(feature = "signing")]
        self.sender.advance_time(clock::now().max(self.peers.time()));
        let carries_key = message.info().id == SETUP_SIGNING;
        let mut parcel = Parcel { buffer: Box::new([0; MAX_FRAME]), start: 0, end: 0, carries_key, to };
        let own = self.sender.version();
        self.sender.set_version(version);
        let first = parcel.buffer.as_ptr().addr();
        let encoded = self.sender.encode(message, &mut parcel.buffer).map(|frame| (frame.as_ptr().addr(), frame.len()));
        self.sender.set_version(own);
        let (start, length) = encoded?;
        (parcel.start, parcel.end) = (start - first, start - first + length);
        Ok(parcel)
    }
}

impl Parcel {
    /// What is still to be sent.
    pub(crate) fn bytes(&self) -> &[u8] {
        self.buffer.get(self.start..self.end).unwrap_or_default()
    }

    /// Says how many of these bytes were sent.
    pub(crate) fn advance(&mut self, count: usize) {
        self.start = self.end.min(self.start + count);
    }
}

impl Drop for Parcel {
    fn drop(&mut self) {
        if self.carries_key {
            wipe(&mut self.buffer[..]);
        }
    }
}

/// The bytes are left out: they may be a key.
impl fmt::Debug for Parcel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Parcel").field("length", &self.bytes().len()).field("to", &self.to).finish_non_exhaustive()
    }
}
