//! Frames in UDP datagrams, from and to several peers. Needs the feature `std`.
//!
//! ```
//! # use mavlink_wire::{Encode, MessageInfo, Sender, Table};
//! # const INFO: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
//! # struct Heartbeat;
//! # impl Encode for Heartbeat {
//! #     fn info(&self) -> &'static MessageInfo { INFO }
//! #     fn write(&self, payload: &mut [u8; 255]) { payload[..9].copy_from_slice(&[0, 0, 0, 0, 6, 8, 0, 4, 3]); }
//! # }
//! # static TABLE: Table<'static> = Table::of(&[INFO]);
//! use mavlink_wire::udp::Endpoint;
//! use std::net::UdpSocket;
//!
//! // A ground station listens on 0.0.0.0:14550; what it hears from, it can answer.
//! let mut station = Endpoint::new(UdpSocket::bind("127.0.0.1:0")?, &TABLE, Sender::v2(255, 190));
//! # let mut vehicle = Endpoint::new(UdpSocket::bind("127.0.0.1:0")?, &TABLE, Sender::v2(1, 1));
//! # vehicle.send_to(&Heartbeat, station.socket().local_addr()?)?;
//! # let mut frames = 1..;
//! loop {
//!     let (frame, peer) = station.receive()?;
//!     println!("{peer}: {}/{} sends message {}", frame.system_id(), frame.component_id(), frame.message_id());
//!     station.send_to(&Heartbeat, peer)?;
//! #   if frames.next() == Some(1) { break; }
//! }
//! station.send_to_all(&Heartbeat)?;
//! # let answers = [vehicle.receive()?.0.sequence(), vehicle.receive()?.0.sequence()];
//! # assert_eq!(answers, [0, 1]);
//! # Ok::<(), std::io::Error>(())
//! ```

mod peers;

use std::boxed::Box;
use std::io::{Error, ErrorKind, Result};
use std::net::{SocketAddr, UdpSocket};
use std::time::Instant;
use std::vec;

use crate::link::incoming::Incoming;
use crate::parser::not_told;
use crate::{Encode, EncodeError, Frame, MAX_FRAME, Sender, Statistics, Table};
use peers::Peers;

/// No datagram is longer.
const MAX_DATAGRAM: usize = 65_536;

/// How many peers are remembered if nothing else is said.
const PEERS: usize = 16;

/// A socket that sends one frame a datagram, and receives several.
///
/// A datagram is a stream of its own: a frame that goes on in the next one is not found. Whoever sent a verified frame is a
/// peer. Of these 16 are remembered, or as many as [`with_peer_limit`](Self::with_peer_limit) says; the one that was not
/// heard for longest is forgotten first. Peers are no proof: anybody can send a datagram.
#[derive(Debug)]
pub struct Endpoint<'t> {
    socket: UdpSocket,
    sender: Sender,
    peers: Peers,
    incoming: Incoming<'t, Box<[u8]>>,
    /// Who sent the datagram that is being searched.
    from: Option<SocketAddr>,
}

impl<'t> Endpoint<'t> {
    /// An endpoint that sends what this sender makes, and verifies the messages of this table.
    #[must_use]
    pub fn new(socket: UdpSocket, table: &'t Table<'t>, sender: Sender) -> Self {
        let incoming = Incoming::with_buffer(table, vec![0; MAX_DATAGRAM].into_boxed_slice());
        Self { socket, sender, peers: Peers::new(PEERS), incoming, from: None }
    }

    /// The same with room for so many peers.
    #[must_use]
    pub fn with_peer_limit(mut self, limit: usize) -> Self {
        self.peers = Peers::new(limit);
        self
    }

    /// The next frame, and who sent it; waits for it as the socket does.
    ///
    /// Datagrams without a frame do not make a timeout longer, but for what the last wait takes: at most twice the time.
    ///
    /// # Errors
    ///
    /// What the socket says: a timeout or [`ErrorKind::WouldBlock`] where one was asked for. Interruptions are not among
    /// them, and neither is the news that a datagram of ours reached nobody (Windows gives that to the receiver).
    pub fn receive(&mut self) -> Result<(Frame<'_>, SocketAddr)> {
        self.receive_reporting_bad_checksums(not_told)
    }

    /// The next frame, as [`receive`](Self::receive) gives it. `bad_checksum` is told the message of each frame that
    /// [`Statistics::bad_checksums`] counts: if it is often the same one, both sides define it otherwise.
    ///
    /// # Errors
    ///
    /// As [`receive`](Self::receive).
    pub fn receive_reporting_bad_checksums(
        &mut self,
        mut bad_checksum: impl FnMut(u32),
    ) -> Result<(Frame<'_>, SocketAddr)> {
        let mut began: Option<Instant> = None;
        loop {
            if let Some(from) = self.from {
                if let Some(found) = self.incoming.find(&mut bad_checksum) {
                    let frame = self.incoming.frame(&found);
                    if frame.is_verified() {
                        self.peers.hear(from);
                    }
                    return Ok((frame, from));
                }
                self.incoming.take_end();
                self.from = None;
            }
            match began {
                None => began = Some(Instant::now()),
                Some(began) if has_timed_out(&self.socket, began)? => return Err(ErrorKind::TimedOut.into()),
                Some(_) => {}
            }
            match self.socket.recv_from(self.incoming.space()) {
                Ok((length, from)) => {
                    self.incoming.fill(length, true);
                    self.from = Some(from);
                }
                Err(error) if is_passing(error.kind()) => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// Sends a message to this address, a peer or not.
    ///
    /// # Errors
    ///
    /// [`ErrorKind::InvalidInput`] around an [`EncodeError`] if the sender cannot carry the message;
    /// else what the socket says.
    pub fn send_to(&mut self, message: &(impl Encode + ?Sized), to: SocketAddr) -> Result<()> {
        let mut buffer = [0; MAX_FRAME];
        self.socket.send_to(encode(&mut self.sender, message, &mut buffer)?, to).map(drop)
    }

    /// Sends a message to all peers, as one frame with one number.
    ///
    /// # Errors
    ///
    /// As of [`send_to`](Self::send_to). What fails for one peer is still sent to the others; the first error is given.
    pub fn send_to_all(&mut self, message: &(impl Encode + ?Sized)) -> Result<()> {
        let mut buffer = [0; MAX_FRAME];
        let frame = encode(&mut self.sender, message, &mut buffer)?;
        send_all(&self.socket, frame, self.peers.iter())
    }

    /// Sends a frame as it came, to the byte, to this address.
    ///
    /// # Errors
    ///
    /// [`ErrorKind::InvalidInput`] around an [`EncodeError`] if it carries a [key](Frame::carries_key); else what the socket
    /// says.
    pub fn send_frame_to(&mut self, frame: &Frame<'_>, to: SocketAddr) -> Result<()> {
        self.socket.send_to(forwarded(frame)?, to).map(drop)
    }

    /// Sends a frame as it came, to the byte, to all peers.
    ///
    /// # Errors
    ///
    /// As of [`send_frame_to`](Self::send_frame_to). What fails for one peer is still sent to the others; the first error is
    /// given.
    pub fn send_frame_to_all(&mut self, frame: &Frame<'_>) -> Result<()> {
        send_all(&self.socket, forwarded(frame)?, self.peers.iter())
    }

    /// Who was heard, the last one first.
    #[must_use]
    pub fn peers(&self) -> impl ExactSizeIterator<Item = SocketAddr> {
        self.peers.iter()
    }

    /// What was found so far in all datagrams, and what could not be read.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.incoming.statistics()
    }

    /// What makes the frames.
    pub fn sender(&mut self) -> &mut Sender {
        &mut self.sender
    }

    /// The socket, for timeouts and the like.
    #[must_use]
    pub fn socket(&self) -> &UdpSocket {
        &self.socket
    }
}

/// Whether to go on receiving as if nothing had happened.
fn is_passing(kind: ErrorKind) -> bool {
    matches!(kind, ErrorKind::Interrupted | ErrorKind::ConnectionReset | ErrorKind::ConnectionRefused)
}

/// Whether this began longer ago than the socket is to wait.
fn has_timed_out(socket: &UdpSocket, began: Instant) -> Result<bool> {
    Ok(socket.read_timeout()?.is_some_and(|timeout| began.elapsed() >= timeout))
}

fn encode<'b>(
    sender: &mut Sender,
    message: &(impl Encode + ?Sized),
    buffer: &'b mut [u8; MAX_FRAME],
) -> Result<&'b [u8]> {
    sender.encode(message, buffer).map_err(|error| Error::new(ErrorKind::InvalidInput, error))
}

fn forwarded<'b>(frame: &Frame<'b>) -> Result<&'b [u8]> {
    if frame.carries_key() {
        Err(Error::new(ErrorKind::InvalidInput, EncodeError::CarriesKey))
    } else {
        Ok(frame.bytes())
    }
}

fn send_all(socket: &UdpSocket, frame: &[u8], to: impl Iterator<Item = SocketAddr>) -> Result<()> {
    to.map(|peer| socket.send_to(frame, peer).map(drop)).fold(Ok(()), Result::and)
}
