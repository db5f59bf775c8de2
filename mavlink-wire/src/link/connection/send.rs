//! The half that sends.

use std::boxed::Box;
use std::io::ErrorKind;
use std::net::{SocketAddr, UdpSocket};
use std::string::{String, ToString};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use std::vec::Vec;

use super::stream::Stream;
use crate::frame::key::SETUP_SIGNING;
use crate::link::line::{End, Line};
use crate::link::shared::Shared;
use crate::link::{LinkError, Outbox, Parcel, Peer};
use crate::{ComponentId, Encode, EncodeError, Frame, Sender, SystemId};

/// The half of a [`Link`](super::Link) that sends. A clone is another handle of the same half: several threads may send.
#[derive(Clone)]
pub struct SendHalf {
    pub(super) shared: Arc<Shared>,
    pub(super) line: Option<Arc<Line<Box<dyn Stream>>>>,
    pub(super) outgoing: Arc<Mutex<Outgoing>>,
}

/// What makes frames, and what carries them.
pub(super) struct Outgoing {
    pub(super) outbox: Outbox,
    pub(super) carrier: Carrier,
}

pub(super) enum Carrier {
    Datagrams {
        socket: UdpSocket,
    },
    /// A connection or device, and what it has not taken yet of the last frame.
    Line {
        end: Option<End<Box<dyn Stream>>>,
        pending: Option<Parcel>,
    },
    /// A file is not written.
    Nothing,
}

impl SendHalf {
    /// Sends a message to the other end: with `udpin` to all peers, to each in its version of MAVLink, with one sequence number.
    /// Returns the number of peers: 0 if nobody is there now, which is no error.
    ///
    /// # Errors
    ///
    /// - [`LinkError::Full`]: the buffer stayed full for the time in [`Options`](crate::link::Options). The message was not sent.
    /// - [`LinkError::Encode`]: the version of a peer cannot carry the message; the other peers got it. Or it is a `SETUP_SIGNING`,
    ///   which may reach anybody: name a peer with [`send_to`](Self::send_to).
    /// - [`LinkError::Closed`], or an error of the system.
    pub fn send(&self, message: &(impl Encode + ?Sized)) -> Result<usize, LinkError> {
        if message.info().id == SETUP_SIGNING && self.shared.is_open_to_all {
            return Err(EncodeError::CarriesKey.into());
        }
        let mut outgoing = self.ready()?;
        let made = outgoing.outbox.encode_to_all(message);
        let sent = self.carry_all(&mut outgoing, made.parcels);
        made.error.map_or(sent, |error| Err(error.into()))
    }

    /// Sends a message to one peer: one of [`peers`](Self::peers), or any address on UDP.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send); and [`LinkError::Unreachable`] if that is not who is at the other end.
    pub fn send_to(&self, message: &(impl Encode + ?Sized), peer: Peer) -> Result<(), LinkError> {
        let mut outgoing = self.ready()?;
        let parcel = outgoing.outbox.encode_to(message, peer)?;
        self.carry(&mut outgoing, parcel).and_then(|count| is_sent(count, peer))
    }

    /// Sends a received frame byte for byte, for routers. To give it a sequence number or a signature of this link, call
    /// [`Sender::renumber`] before.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send). A frame with a [key](Frame::carries_key) is not forwarded.
    pub fn send_frame(&self, frame: &Frame<'_>) -> Result<usize, LinkError> {
        let mut outgoing = self.ready()?;
        let parcel = outgoing.outbox.forward_to_all(frame)?;
        self.carry(&mut outgoing, parcel)
    }

    /// Sends a received frame as it came to one peer.
    ///
    /// # Errors
    ///
    /// As of [`send_to`](Self::send_to).
    pub fn send_frame_to(&self, frame: &Frame<'_>, peer: Peer) -> Result<(), LinkError> {
        let mut outgoing = self.ready()?;
        let parcel = Outbox::forward(frame, [peer].into())?;
        self.carry(&mut outgoing, parcel).and_then(|count| is_sent(count, peer))
    }

    /// Which system sends.
    #[must_use]
    pub fn system_id(&self) -> SystemId {
        self.with_sender(|sender| sender.system_id())
    }

    /// Which component of it sends.
    #[must_use]
    pub fn component_id(&self) -> ComponentId {
        self.with_sender(|sender| sender.component_id())
    }

    /// Changes or reads the [`Sender`], for example to give it a key, save its time. Nothing is sent meanwhile.
    pub fn with_sender<R>(&self, change: impl FnOnce(&mut Sender) -> R) -> R {
        change(&mut self.lock().outbox.sender)
    }

    /// The peers now, the one heard last first. With `udpout` and `udpbcast`, those who answered.
    #[must_use]
    pub fn peers(&self) -> Vec<Peer> {
        self.shared.peers.all(Instant::now())
    }

    /// Forgets a peer, and returns whether it was one. If it sends again, it is a peer again.
    pub fn remove_peer(&self, peer: Peer) -> bool {
        self.shared.peers.remove(peer, Instant::now())
    }

    /// Whether there is a connection, or a device. UDP and files need none.
    #[must_use]
    pub fn is_connected(&self) -> bool {
        self.line.as_ref().is_none_or(|line| line.is_connected())
    }

    /// Why there is no connection now.
    #[must_use]
    pub fn trouble(&self) -> Option<String> {
        self.line.as_ref().and_then(|line| line.trouble())
    }

    /// The address on which `udpin` and `tcpin` listen. If you gave port 0, it has the port that the system chose.
    #[must_use]
    pub fn local_addr(&self) -> Option<SocketAddr> {
        self.shared.local
    }

    /// Closes the link: every call ends with [`LinkError::Closed`], also one that waits in another thread, within a fifth of a
    /// second.
    pub fn close(&self) {
        self.shared.close();
        if let Some(line) = &self.line {
            line.shut();
        }
    }

    /// Whoever panicked while holding it had changed nothing by halves.
    fn lock(&self) -> MutexGuard<'_, Outgoing> {
        self.outgoing.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Gets ready to send: connected if that is possible, and rid of what is left of the last frame.
    fn ready(&self) -> Result<MutexGuard<'_, Outgoing>, LinkError> {
        self.shared.check()?;
        let mut outgoing = self.lock();
        let (Carrier::Line { end, pending }, Some(line)) = (&mut outgoing.carrier, &self.line) else {
            return Ok(outgoing);
        };
        if line.refresh_writer(end)? {
            // The rest of a frame means nothing to somebody else.
            *pending = None;
        }
        self.write_pending(line, end, pending)?;
        if pending.is_some() {
            self.shared.counters.count_unsent();
            return Err(LinkError::Full);
        }
        Ok(outgoing)
    }

    fn carry_all(&self, outgoing: &mut Outgoing, parcels: Vec<Parcel>) -> Result<usize, LinkError> {
        let mut all = Ok(0);
        for parcel in parcels {
            let sent = self.carry(outgoing, parcel);
            all = all.and_then(|count| sent.map(|more| count + more));
        }
        all
    }

    /// Sends a frame to those that get it; gives to how many.
    fn carry(&self, outgoing: &mut Outgoing, parcel: Parcel) -> Result<usize, LinkError> {
        match (&mut outgoing.carrier, &self.line) {
            (Carrier::Datagrams { socket }, _) => self.send_datagrams(socket, &parcel),
            (Carrier::Line { end, pending }, Some(line)) => {
                let there = end.as_ref().map(|end| end.peer);
                if !there.is_some_and(|there| parcel.to.contains(&there)) {
                    return Ok(0);
                }
                *pending = Some(parcel);
                self.write_pending(line, end, pending)?;
                let is_there = end.is_some();
                self.shared.counters.count_sent(is_there.into());
                Ok(is_there.into())
            }
            _ => Ok(0),
        }
    }

    fn send_datagrams(&self, socket: &UdpSocket, parcel: &Parcel) -> Result<usize, LinkError> {
        let (mut count, mut error) = (0, None);
        for to in parcel.to.iter().filter_map(Peer::address) {
            match socket.send_to(parcel.bytes(), to) {
                Ok(_) => count += 1,
                Err(reason) => {
                    self.shared.counters.count_unsent();
                    error.get_or_insert(of_sending(reason, to));
                }
            }
        }
        self.shared.counters.count_sent(count);
        error.map_or(Ok(count), Err)
    }

    /// Writes what is left of a frame, as far as there is room within the timeout.
    fn write_pending(
        &self,
        line: &Line<Box<dyn Stream>>,
        end: &mut Option<End<Box<dyn Stream>>>,
        pending: &mut Option<Parcel>,
    ) -> Result<(), LinkError> {
        let mut limit = self.shared.send_timeout;
        let deadline = Instant::now() + limit;
        while let (Some(open), Some(parcel)) = (end.as_mut(), pending.as_mut()) {
            if parcel.bytes().is_empty() {
                *pending = None;
                break;
            }
            match open.stream.write_within(parcel.bytes(), limit) {
                Ok(count) if count > 0 => parcel.advance(count),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => break,
                taken => {
                    *pending = None;
                    self.shared.counters.count_unsent();
                    line.lose(end, &taken.map_or_else(|error| error, |_| ErrorKind::WriteZero.into()));
                    line.check()?;
                }
            }
            if limit == Duration::ZERO {
                break;
            }
            limit = deadline.saturating_duration_since(Instant::now());
        }
        Ok(())
    }
}

/// Why a datagram was not sent.
pub(in crate::link) fn of_sending(error: std::io::Error, to: SocketAddr) -> LinkError {
    match error.kind() {
        ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::OutOfMemory => LinkError::Full,
        ErrorKind::PermissionDenied => LinkError::NoPermission { address: Peer::from(to).to_string() },
        _ => LinkError::Unreachable { address: Peer::from(to).to_string(), reason: error },
    }
}

/// An error, if somebody in particular has got nothing.
pub(in crate::link) fn is_sent(count: usize, peer: Peer) -> Result<(), LinkError> {
    if count > 0 {
        return Ok(());
    }
    let reason = ErrorKind::NotConnected.into();
    Err(LinkError::Unreachable { address: peer.to_string(), reason })
}

impl core::fmt::Debug for SendHalf {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("SendHalf").field("shared", &self.shared).finish_non_exhaustive()
    }
}
