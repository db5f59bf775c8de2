//! What an endpoint sends.

use std::io::{Error, Result};
use std::net::SocketAddr;
use std::time::Instant;

use super::Endpoint;
use crate::frame::key::{SETUP_SIGNING, wipe};
#[cfg(feature = "signing")]
use crate::link::clock;
use crate::{Encode, EncodeError, Frame, MAX_FRAME, Version};

impl Endpoint<'_> {
    /// Sends a message to this address, a peer or not; to a peer in its version.
    ///
    /// # Errors
    ///
    /// [`InvalidInput`](std::io::ErrorKind::InvalidInput) around an [`EncodeError`] if the message cannot be carried;
    /// else what the socket says.
    pub fn send_to(&mut self, message: &(impl Encode + ?Sized), to: SocketAddr) -> Result<()> {
        let theirs = self.peers.version_of(to, Instant::now());
        let version = self.only_version().or(theirs).unwrap_or(self.sender.version());
        let mut buffer = [0; MAX_FRAME];
        let frame = self.encode(message, version, &mut buffer);
        let sent = frame.and_then(|frame| self.socket.send_to(frame, to)).map(drop);
        if message.info().id == SETUP_SIGNING {
            wipe(&mut buffer);
        }
        sent
    }

    /// Sends a message to all peers under one number, to each in its version. Gives to how many: none, if there is no peer now.
    ///
    /// # Errors
    ///
    /// As of [`send_to`](Self::send_to). What fails for one peer is still sent to the others; the first error is given. A
    /// `SETUP_SIGNING` is refused ([`EncodeError::CarriesKey`]): anybody may be a peer, and a key goes to one who is named.
    pub fn send_to_all(&mut self, message: &(impl Encode + ?Sized)) -> Result<usize> {
        if message.info().id == SETUP_SIGNING {
            return Err(EncodeError::CarriesKey.into());
        }
        let (peers, sequence) = (self.peers.peers(Instant::now()), self.sender.sequence());
        let (only, mut sent, mut numbered) = (self.only_version(), Sent::NONE, false);
        for version in [Version::V1, Version::V2] {
            let mut to = peers.iter().filter(|peer| only.unwrap_or(peer.version) == version).peekable();
            if to.peek().is_none() {
                continue;
            }
            self.sender.set_sequence(sequence);
            let mut buffer = [0; MAX_FRAME];
            match self.encode(message, version, &mut buffer) {
                Ok(frame) => {
                    numbered = true;
                    to.for_each(|peer| sent.count(self.socket.send_to(frame, peer.address)));
                }
                Err(error) => sent.count(Err(error)),
            }
        }
        self.sender.set_sequence(sequence.wrapping_add(numbered.into()));
        sent.result()
    }

    /// Sends a frame as it came, to the byte, to this address.
    ///
    /// # Errors
    ///
    /// [`InvalidInput`](std::io::ErrorKind::InvalidInput) around an [`EncodeError`] if it carries a [key](Frame::carries_key); else what the socket
    /// says.
    pub fn send_frame_to(&mut self, frame: &Frame<'_>, to: SocketAddr) -> Result<()> {
        self.socket.send_to(forwardable(frame)?, to).map(drop)
    }

    /// Sends a frame as it came, to the byte, to all peers. Gives to how many: none, if there is no peer now.
    ///
    /// # Errors
    ///
    /// As of [`send_frame_to`](Self::send_frame_to). What fails for one peer is still sent to the others; the first error is
    /// given.
    pub fn send_frame_to_all(&mut self, frame: &Frame<'_>) -> Result<usize> {
        let (bytes, mut sent) = (forwardable(frame)?, Sent::NONE);
        for peer in self.peers.peers(Instant::now()) {
            sent.count(self.socket.send_to(bytes, peer.address));
        }
        sent.result()
    }

    /// The version for all peers, if there is one: a signature needs that of the sender.
    fn only_version(&self) -> Option<Version> {
        #[cfg(feature = "signing")]
        if self.sender.signer().is_some() {
            return Some(self.sender.version());
        }
        None
    }

    /// Makes the next frame, in this version.
    fn encode<'b>(
        &mut self,
        message: &(impl Encode + ?Sized),
        version: Version,
        buffer: &'b mut [u8; MAX_FRAME],
    ) -> Result<&'b [u8]> {
        #[cfg(feature = "signing")]
        if let Some(verifier) = &self.verifier {
            self.sender.advance_time(clock::now().max(verifier.timestamp()));
        }
        let own = self.sender.version();
        self.sender.set_version(version);
        let frame = self.sender.encode(message, buffer);
        self.sender.set_version(own);
        Ok(frame?)
    }
}

/// What was sent to several.
struct Sent {
    count: usize,
    error: Option<Error>,
}

impl Sent {
    const NONE: Self = Self { count: 0, error: None };

    fn count(&mut self, sent: Result<usize>) {
        match sent {
            Ok(_) => self.count += 1,
            Err(error) => {
                self.error.get_or_insert(error);
            }
        }
    }

    fn result(self) -> Result<usize> {
        self.error.map_or(Ok(self.count), Err)
    }
}

/// The bytes of a frame that may go on.
fn forwardable<'b>(frame: &Frame<'b>) -> Result<&'b [u8]> {
    if frame.carries_key() { Err(EncodeError::CarriesKey.into()) } else { Ok(frame.bytes()) }
}
