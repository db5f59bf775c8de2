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

mod send;
mod wait;

use std::io::{ErrorKind, Result};
use std::net::{SocketAddr, UdpSocket};
use std::time::{Duration, Instant};
use std::vec::Vec;

use crate::link::{Inbox, Outbox, Peer, Peers, Pending};
use crate::parser::not_told;
#[cfg(feature = "signing")]
use crate::signing::Verifier;
use crate::{Frame, Sender, Statistics, Table};
use wait::Work;

/// How long the rest of a frame is waited for, while nothing comes. Bridges send it within milliseconds.
pub(crate) const SILENCE: Duration = Duration::from_millis(250);

/// A socket that sends one frame a datagram, and receives several, or parts of one.
///
/// # Peers
///
/// Whoever sent a verified frame is a peer for 3 seconds, or as long as [`with_peer_expiry`](Self::with_peer_expiry) says:
/// who sends a heartbeat each second stays one. There are 16 at most, or as many as [`with_peer_limit`](Self::with_peer_limit)
/// says; while all are heard, nobody pushes one of them out. Peers are no proof, since anybody can send a datagram, unless
/// the endpoint has a `Verifier` (feature `signing`): then only a signed frame makes a peer.
///
/// Each peer is spoken to in its own version of MAVLink: in MAVLink 2, once it has sent that. All get the numbers of one
/// sequence, so that what goes to one of several is a gap for the others. Who signs sends what the [`Sender`] says.
///
/// # Streams
///
/// The datagrams of an address are one stream: a frame may be cut into several, as bridges from serial ports do, and datagrams
/// of others may come between. If the rest does not come within a quarter of a second of silence, what came behind the
/// beginning is searched without it.
///
/// [`Link`](crate::link::Link) is the same for whom an address is enough; this is for a socket of your own.
#[derive(Debug)]
pub struct Endpoint<'t> {
    socket: UdpSocket,
    inbox: Inbox<'t>,
    outbox: Outbox,
    /// Empty between two calls.
    pending: Pending,
}

impl<'t> Endpoint<'t> {
    /// An endpoint that sends what this sender makes, and verifies the messages of this table.
    #[must_use]
    pub fn new(socket: UdpSocket, table: &'t Table<'t>, sender: Sender) -> Self {
        let peers = Peers::new();
        Self {
            socket,
            outbox: Outbox::new(sender, peers.clone()),
            pending: Pending::default(),
            inbox: Inbox::new(table, peers, SILENCE),
        }
    }

    /// The same with room for so many peers.
    #[must_use]
    pub fn with_peer_limit(self, limit: usize) -> Self {
        self.inbox.peers.set_limit(limit);
        self
    }

    /// The same that forgets a peer when it has been silent for so long.
    #[must_use]
    pub fn with_peer_expiry(self, silence: Duration) -> Self {
        self.inbox.peers.set_expiry(silence);
        self
    }

    /// The same that hands over only what this verifier trusts, by the clock of the system, and takes only those for peers
    /// who sign. What this side signs is never dated before what it received.
    #[cfg(feature = "signing")]
    #[must_use]
    pub fn with_verifier(mut self, verifier: Verifier) -> Self {
        self.inbox.verifier = Some(verifier);
        self
    }

    /// What says which frames to trust; its timestamp and streams are to be saved.
    #[cfg(feature = "signing")]
    pub fn verifier(&mut self) -> Option<&mut Verifier> {
        self.inbox.verifier.as_mut()
    }

    /// How many frames the verifier refused.
    #[cfg(feature = "signing")]
    #[must_use]
    pub fn refused_frames(&self) -> u64 {
        self.inbox.refused
    }

    /// The next frame, and who sent it; waits for it as the socket does.
    ///
    /// One call does bounded work: after 64 KiB without a frame it says [`ErrorKind::WouldBlock`], "nothing yet", also on a
    /// socket that blocks. Datagrams without a frame do not make a timeout longer, but for what the last wait takes: at most
    /// twice the time.
    ///
    /// # Errors
    ///
    /// [`ErrorKind::WouldBlock`] or a timeout: nothing is lost, call it again. Else what the socket says; interruptions are not
    /// among it, and neither is the news that a datagram of ours reached nobody (Windows gives that to the receiver).
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
        let mut work = Work::NONE;
        let delivery = loop {
            match self.inbox.find(&mut bad_checksum) {
                Some(delivery) => break delivery,
                None => self.wait(&mut work)?,
            }
        };
        // Every peer that an endpoint hears has an address.
        let frame = self.inbox.frame(&delivery).and_then(|(frame, peer)| Some((frame, peer.address()?)));
        frame.ok_or_else(|| ErrorKind::WouldBlock.into())
    }

    /// The peers, the one that was heard last in front.
    #[must_use]
    pub fn peers(&self) -> impl ExactSizeIterator<Item = SocketAddr> + use<'t> {
        let peers: Vec<_> = self.inbox.peers.all(Instant::now()).iter().filter_map(Peer::address).collect();
        peers.into_iter()
    }

    /// Forgets a peer, and what its parser holds; whether it was one. If it sends again, it is a peer again.
    pub fn remove_peer(&mut self, peer: SocketAddr) -> bool {
        self.inbox.remove(peer.into())
    }

    /// What was found so far in all datagrams, and what could not be read.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.inbox.statistics()
    }

    /// What makes the frames.
    pub fn sender(&mut self) -> &mut Sender {
        &mut self.outbox.sender
    }

    /// The socket, for timeouts and the like.
    #[must_use]
    pub fn socket(&self) -> &UdpSocket {
        &self.socket
    }
}
