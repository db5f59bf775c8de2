//! The half that sends.

use std::boxed::Box;
use std::io::ErrorKind;
use std::net::{SocketAddr, UdpSocket};
use std::string::{String, ToString};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use std::vec::Vec;

use super::stream::Stream;
use crate::adapters::pause::{is_interrupted, is_not_now};
use crate::frame::key::SETUP_SIGNING;
use crate::link::line::{End, Line};
use crate::link::shared::Shared;
use crate::link::{LinkError, Outbox, Peer, Pending};
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
    /// What a connection or device has not taken yet. Datagrams go out at once.
    pub(super) pending: Pending,
}

pub(super) enum Carrier {
    Datagrams {
        socket: UdpSocket,
    },
    /// A connection or device.
    Line {
        end: Option<End<Box<dyn Stream>>>,
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
        self.check_key(message)?;
        let mut outgoing = self.ready()?;
        let Outgoing { outbox, pending, .. } = &mut *outgoing;
        let made = outbox.encode_to_all(message, pending);
        let sent = self.carry(&mut outgoing);
        made.map_or_else(|error| Err(error.into()), |()| sent)
    }

    /// As [`send`](Self::send), but a connection or device gets the message only with the next [`flush`](Self::flush) or send: several
    /// messages then take one call of the system. When 64 messages are queued, they are written. UDP sends each at once.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send).
    pub fn queue(&self, message: &(impl Encode + ?Sized)) -> Result<usize, LinkError> {
        if self.line.is_none() {
            return self.send(message);
        }
        self.check_key(message)?;
        let mut outgoing = self.current()?;
        if outgoing.pending.is_full() {
            self.write_pending(&mut outgoing)?;
        }
        if outgoing.pending.is_full() {
            return self.full();
        }
        let Outgoing { outbox, pending, carrier } = &mut *outgoing;
        let kept = pending.len();
        outbox.encode_to_all(message, pending)?;
        Ok(address(carrier, pending, kept))
    }

    /// Writes what is [queued](Self::queue).
    ///
    /// # Errors
    ///
    /// [`LinkError::Full`]: the buffer stayed full for the time in [`Options`](crate::link::Options). The rest goes out before the next
    /// message. Else as of [`send`](Self::send).
    pub fn flush(&self) -> Result<(), LinkError> {
        self.shared.check()?;
        let mut outgoing = self.lock();
        self.write_pending(&mut outgoing)?;
        if outgoing.pending.is_empty() { Ok(()) } else { Err(LinkError::Full) }
    }

    /// Sends a message to one peer: one of [`peers`](Self::peers), or any address on UDP.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send); and [`LinkError::Unreachable`] if that is not who is at the other end.
    pub fn send_to(&self, message: &(impl Encode + ?Sized), peer: Peer) -> Result<(), LinkError> {
        let mut outgoing = self.ready()?;
        let Outgoing { outbox, pending, .. } = &mut *outgoing;
        outbox.encode_to(message, peer, pending)?;
        self.carry(&mut outgoing).and_then(|count| is_sent(count, peer))
    }

    /// Sends a received frame byte for byte, for routers. To give it a sequence number or a signature of this link, call
    /// [`Sender::renumber`] before.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send). A frame with a [key](Frame::carries_key) is not forwarded.
    pub fn send_frame(&self, frame: &Frame<'_>) -> Result<usize, LinkError> {
        let mut outgoing = self.ready()?;
        let Outgoing { outbox, pending, .. } = &mut *outgoing;
        outbox.forward_to_all(frame, pending)?;
        self.carry(&mut outgoing)
    }

    /// Sends a received frame as it came to one peer.
    ///
    /// # Errors
    ///
    /// As of [`send_to`](Self::send_to).
    pub fn send_frame_to(&self, frame: &Frame<'_>, peer: Peer) -> Result<(), LinkError> {
        let mut outgoing = self.ready()?;
        Outbox::forward_to(frame, peer, &mut outgoing.pending)?;
        self.carry(&mut outgoing).and_then(|count| is_sent(count, peer))
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

    /// Anybody may be at the other end of some links: no key goes to all.
    fn check_key(&self, message: &(impl Encode + ?Sized)) -> Result<(), LinkError> {
        let is_key = message.info().id == SETUP_SIGNING && self.shared.is_open_to_all;
        if is_key { Err(EncodeError::CarriesKey.into()) } else { Ok(()) }
    }

    /// Gets ready to send: connected if that is possible, and rid of what is left of former frames.
    fn ready(&self) -> Result<MutexGuard<'_, Outgoing>, LinkError> {
        let mut outgoing = self.current()?;
        self.write_pending(&mut outgoing)?;
        if outgoing.pending.is_empty() { Ok(outgoing) } else { self.full() }
    }

    /// Connected, if that is possible.
    fn current(&self) -> Result<MutexGuard<'_, Outgoing>, LinkError> {
        self.shared.check()?;
        let mut outgoing = self.lock();
        let Outgoing { carrier, pending, .. } = &mut *outgoing;
        if let (Carrier::Line { end }, Some(line)) = (carrier, &self.line)
            && line.refresh_writer(end)?
        {
            // The rest of a frame means nothing to somebody else.
            self.drop_pending(pending);
        }
        Ok(outgoing)
    }

    /// A message finds no room.
    fn full<T>(&self) -> Result<T, LinkError> {
        self.shared.counters.count_unsent(1);
        Err(LinkError::Full)
    }

    fn drop_pending(&self, pending: &mut Pending) {
        self.shared.counters.count_unsent(pending.len());
        pending.clear();
    }

    /// Sends frames to those that get them; gives to how many.
    fn carry(&self, outgoing: &mut Outgoing) -> Result<usize, LinkError> {
        let Outgoing { carrier, pending, .. } = outgoing;
        if let Carrier::Datagrams { socket } = carrier {
            return self.send_datagrams(socket, pending);
        }
        let count = address(carrier, pending, 0);
        self.write_pending(outgoing)?;
        // A connection that was lost meanwhile has taken nothing for sure.
        let is_there = matches!(outgoing.carrier, Carrier::Line { end: Some(_) });
        Ok(if is_there { count } else { 0 })
    }

    /// Sends each frame to each who gets it. What fails for one is still sent to the others; the first error is given.
    fn send_datagrams(&self, socket: &UdpSocket, pending: &mut Pending) -> Result<usize, LinkError> {
        let (mut count, mut error) = (0, None);
        while let Some(parcel) = pending.front_mut() {
            for to in parcel.to.iter().filter_map(Peer::address) {
                match socket.send_to(parcel.bytes(), to) {
                    Ok(_) => count += 1,
                    Err(reason) => {
                        self.shared.counters.count_unsent(1);
                        error.get_or_insert(of_sending(reason, to));
                    }
                }
            }
            pending.pop();
        }
        self.shared.counters.count_sent(count);
        error.map_or(Ok(count), Err)
    }

    /// Writes what is left of frames, as far as there is room within the timeout.
    fn write_pending(&self, outgoing: &mut Outgoing) -> Result<(), LinkError> {
        let Outgoing { carrier: Carrier::Line { end }, pending, .. } = outgoing else { return Ok(()) };
        let Some(line) = &self.line else { return Ok(()) };
        let (mut limit, mut deadline) = (self.shared.send_timeout, None);
        while let Some(open) = end.as_mut()
            && !pending.is_empty()
        {
            match pending.write(|frames| open.stream.write_within(frames, limit)) {
                Ok(count) if count > 0 => self.shared.counters.count_sent(pending.advance(count)),
                Err(error) if is_interrupted(&error) => {}
                Err(error) if is_not_now(&error) => break,
                taken => {
                    self.drop_pending(pending);
                    line.lose(end, &taken.map_or_else(|error| error, |_| ErrorKind::WriteZero.into()));
                    line.check()?;
                }
            }
            if limit == Duration::ZERO || pending.is_empty() {
                break;
            }
            let now = Instant::now();
            limit = deadline.get_or_insert(now + limit).saturating_duration_since(now);
        }
        Ok(())
    }
}

/// Of the frames after the first `kept` ones, keeps those that are for who is at the other end of a connection; gives how many.
fn address(carrier: &Carrier, pending: &mut Pending, kept: usize) -> usize {
    match carrier {
        Carrier::Line { end: Some(end) } => pending.keep_for(end.peer, kept),
        _ => {
            pending.clear();
            0
        }
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
