//! From a message to the bytes for each who gets them: in the version of each, under one number.

use std::time::Instant;
use std::vec::Vec;

use super::peers::Target;
use super::{Peer, Peers, Pending};
#[cfg(feature = "signing")]
use crate::adapters::clock;
use crate::frame::key::SETUP_SIGNING;
use crate::{Encode, EncodeError, Frame, Sender, Version};

/// A sender, and whom it sends to.
#[derive(Debug)]
pub(crate) struct Outbox {
    pub(crate) sender: Sender,
    /// The version for all, whatever they speak.
    pub(crate) only: Option<Version>,
    peers: Peers,
    /// Whom the last message for all went to: kept for its storage.
    targets: Vec<Target>,
}

impl Outbox {
    pub(crate) const fn new(sender: Sender, peers: Peers) -> Self {
        Self { sender, only: None, peers, targets: Vec::new() }
    }

    /// Makes the frame of a message to one, a peer or not.
    pub(crate) fn encode_to(
        &mut self,
        message: &(impl Encode + ?Sized),
        to: Peer,
        pending: &mut Pending,
    ) -> Result<(), EncodeError> {
        let Target { peer, version } = self.peers.target(to, Instant::now());
        self.encode(message, self.version_for(version), [peer], pending)
    }

    /// Makes the frames of a message to all that there are, under one number: at most one in each version. What the version of some
    /// cannot carry still goes to the others.
    pub(crate) fn encode_to_all(
        &mut self,
        message: &(impl Encode + ?Sized),
        pending: &mut Pending,
    ) -> Result<(), EncodeError> {
        let (mut targets, sequence) = (core::mem::take(&mut self.targets), self.sender.sequence());
        self.peers.targets(Instant::now(), &mut targets);
        for target in &mut targets {
            target.version = Some(self.version_for(target.version));
        }
        let (mut all, mut is_made) = (Ok(()), false);
        for version in [Version::V1, Version::V2] {
            let mut to = targets.iter().filter(|to| to.version == Some(version)).map(|to| to.peer).peekable();
            if to.peek().is_none() {
                continue;
            }
            self.sender.set_sequence(sequence);
            match self.encode(message, version, to, pending) {
                Ok(()) => is_made = true,
                Err(error) => all = Err(error),
            }
        }
        self.sender.set_sequence(sequence.wrapping_add(is_made.into()));
        self.targets = targets;
        all
    }

    /// Makes a frame as it came, to the byte, for one.
    pub(crate) fn forward_to(frame: &Frame<'_>, to: Peer, pending: &mut Pending) -> Result<(), EncodeError> {
        Self::forward(frame, [to], pending)
    }

    /// Makes a frame as it came, to the byte, for all that there are.
    pub(crate) fn forward_to_all(&mut self, frame: &Frame<'_>, pending: &mut Pending) -> Result<(), EncodeError> {
        self.peers.targets(Instant::now(), &mut self.targets);
        Self::forward(frame, self.targets.iter().map(|to| to.peer), pending)
    }

    fn forward(
        frame: &Frame<'_>,
        to: impl IntoIterator<Item = Peer>,
        pending: &mut Pending,
    ) -> Result<(), EncodeError> {
        if frame.carries_key() {
            return Err(EncodeError::CarriesKey);
        }
        let mut parcel = pending.parcel(to);
        parcel.buffer.iter_mut().zip(frame.bytes()).for_each(|(to, from)| *to = *from);
        parcel.end = frame.bytes().len();
        pending.push(parcel);
        Ok(())
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
        to: impl IntoIterator<Item = Peer>,
        pending: &mut Pending,
    ) -> Result<(), EncodeError> {
        #[cfg(feature = "signing")]
        if self.sender.signer().is_some() {
            self.sender.advance_time(clock::now().max(self.peers.time()));
        }
        let mut parcel = pending.parcel(to);
        parcel.carries_key = message.info().id == SETUP_SIGNING;
        let own = self.sender.version();
        self.sender.set_version(version);
        let first = parcel.buffer.as_ptr().addr();
        let encoded = self.sender.encode(message, &mut parcel.buffer).map(|frame| (frame.as_ptr().addr(), frame.len()));
        self.sender.set_version(own);
        match encoded {
            Ok((start, length)) => {
                (parcel.start, parcel.end) = (start - first, start - first + length);
                pending.push(parcel);
                Ok(())
            }
            Err(error) => {
                pending.recycle(parcel);
                Err(error)
            }
        }
    }
}
