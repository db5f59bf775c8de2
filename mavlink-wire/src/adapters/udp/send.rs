//! What an endpoint sends.

use std::io::{Error, Result};
use std::net::SocketAddr;

use super::Endpoint;
use crate::frame::key::SETUP_SIGNING;
use crate::link::{Outbox, Peer};
use crate::{Encode, EncodeError, Frame};

impl Endpoint<'_> {
    /// Sends a message to this address, a peer or not; to a peer in its version.
    ///
    /// # Errors
    ///
    /// [`InvalidInput`](std::io::ErrorKind::InvalidInput) around an [`EncodeError`] if the message cannot be carried;
    /// else what the socket says.
    pub fn send_to(&mut self, message: &(impl Encode + ?Sized), to: SocketAddr) -> Result<()> {
        self.outbox.encode_to(message, to.into(), &mut self.pending)?;
        self.carry().result().map(drop)
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
        let made = self.outbox.encode_to_all(message, &mut self.pending);
        let sent = self.carry();
        Sent { error: made.err().map(Error::from).or(sent.error), ..sent }.result()
    }

    /// Sends a frame as it came, to the byte, to this address.
    ///
    /// # Errors
    ///
    /// [`InvalidInput`](std::io::ErrorKind::InvalidInput) around an [`EncodeError`] if it carries a [key](Frame::carries_key); else what the socket
    /// says.
    pub fn send_frame_to(&mut self, frame: &Frame<'_>, to: SocketAddr) -> Result<()> {
        Outbox::forward_to(frame, to.into(), &mut self.pending)?;
        self.carry().result().map(drop)
    }

    /// Sends a frame as it came, to the byte, to all peers. Gives to how many: none, if there is no peer now.
    ///
    /// # Errors
    ///
    /// As of [`send_frame_to`](Self::send_frame_to). What fails for one peer is still sent to the others; the first error is
    /// given.
    pub fn send_frame_to_all(&mut self, frame: &Frame<'_>) -> Result<usize> {
        self.outbox.forward_to_all(frame, &mut self.pending)?;
        self.carry().result()
    }

    /// Sends each frame to each who gets it.
    fn carry(&mut self) -> Sent {
        let mut sent = Sent { count: 0, error: None };
        while let Some(parcel) = self.pending.front_mut() {
            for to in parcel.to.iter().filter_map(Peer::address) {
                match self.socket.send_to(parcel.bytes(), to) {
                    Ok(_) => sent.count += 1,
                    Err(error) => sent.error = sent.error.or(Some(error)),
                }
            }
            self.pending.pop();
        }
        sent
    }
}

/// What was sent to several.
struct Sent {
    count: usize,
    error: Option<Error>,
}

impl Sent {
    fn result(self) -> Result<usize> {
        self.error.map_or(Ok(self.count), Err)
    }
}
