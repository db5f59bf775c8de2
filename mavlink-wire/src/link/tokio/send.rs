//! The half that sends.

use core::future::poll_fn;
use std::io::ErrorKind;
use std::net::SocketAddr;
use std::string::String;
use std::sync::{Arc, Mutex as Lock, MutexGuard as Guard, PoisonError};
use std::time::Instant;
use std::vec::Vec;

use ::tokio::net::UdpSocket;
use ::tokio::sync::{Mutex, MutexGuard};
use ::tokio::time::timeout;

use super::Common;
use super::ends::{Hand, Opened};
use crate::adapters::pause::is_interrupted;
use crate::frame::key::SETUP_SIGNING;
use crate::link::connection::{is_sent, of_sending};
use crate::link::line::{End, Line};
use crate::link::{LinkError, Outbox, Peer, Pending};
use crate::{ComponentId, Encode, EncodeError, Frame, Sender, SystemId};

/// The half of a [`Link`](super::Link) that sends. A clone is another handle of the same half: several tasks may send.
#[derive(Clone)]
pub struct SendHalf {
    common: Arc<Common>,
    line: Option<Arc<Line<Opened>>>,
    outbox: Arc<Lock<Outbox>>,
    /// Locked from the number of a frame to its last byte, so that frames go out in order.
    way: Arc<Mutex<Way>>,
}

/// What carries frames, and those that it has not taken yet.
struct Way {
    carrier: Carrier,
    pending: Pending,
}

impl Way {
    /// Of the frames after the first `kept` ones, keeps those that somebody gets; gives how many do.
    fn address(&mut self, kept: usize) -> usize {
        match &self.carrier {
            Carrier::Datagrams(_) => self.pending.receivers(),
            Carrier::Line { end: Some(end) } => self.pending.keep_for(end.peer, kept),
            Carrier::Line { end: None } | Carrier::Nothing => {
                self.pending.clear();
                0
            }
        }
    }
}

pub(super) enum Carrier {
    Datagrams(Arc<UdpSocket>),
    Line {
        end: Option<End<Hand>>,
    },
    /// A file is not written.
    Nothing,
}

impl SendHalf {
    pub(super) fn new(common: Arc<Common>, line: Option<Arc<Line<Opened>>>, outbox: Outbox, carrier: Carrier) -> Self {
        let way = Arc::new(Mutex::new(Way { carrier, pending: Pending::default() }));
        Self { common, line, outbox: Arc::new(Lock::new(outbox)), way }
    }

    /// Goes on with the first attempt to connect; whether it has succeeded.
    pub(super) fn try_first(&self) -> Result<bool, LinkError> {
        self.line.as_ref().map_or(Ok(true), |line| line.try_first())
    }

    /// Sends a message to the other end: with `udpin` to all peers, to each in its version of MAVLink, with one sequence number.
    /// Returns the number of peers: 0 if nobody is there now, which is no error. Cancel safe: the message was not sent, or
    /// goes out before the next one.
    ///
    /// # Errors
    ///
    /// - [`LinkError::Full`]: the buffer stayed full for the time in [`Options`](crate::link::Options). The message was not sent.
    /// - [`LinkError::Encode`]: the version of a peer cannot carry the message; the other peers got it. Or it is a `SETUP_SIGNING`,
    ///   which may reach anybody: name a peer with [`send_to`](Self::send_to).
    /// - [`LinkError::Closed`], or an error of the system.
    pub async fn send(&self, message: &(impl Encode + ?Sized)) -> Result<usize, LinkError> {
        self.check_key(message)?;
        let mut way = self.ready().await?;
        let made = self.lock().encode_to_all(message, &mut way.pending);
        let sent = self.carry(&mut way).await;
        made.map_or_else(|error| Err(error.into()), |()| sent)
    }

    /// As [`send`](Self::send), but a connection or device gets the message only with the next [`flush`](Self::flush) or send: several
    /// messages then take one call of the system. When 64 messages are queued, they are written. UDP sends each at once.
    /// Cancel safe: the message was not queued, or goes out before the next one.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send).
    pub async fn queue(&self, message: &(impl Encode + ?Sized)) -> Result<usize, LinkError> {
        if self.line.is_none() {
            return self.send(message).await;
        }
        self.check_key(message)?;
        let mut way = self.current().await?;
        if way.pending.is_full() {
            self.write_pending(&mut way).await?;
        }
        if way.pending.is_full() {
            return self.full();
        }
        let kept = way.pending.len();
        self.lock().encode_to_all(message, &mut way.pending)?;
        Ok(way.address(kept))
    }

    /// Writes what is [queued](Self::queue). Cancel safe: what is not written goes out before the next message.
    ///
    /// # Errors
    ///
    /// [`LinkError::Full`]: the buffer stayed full for the time in [`Options`](crate::link::Options). The rest goes out before the next
    /// message. Else as of [`send`](Self::send).
    pub async fn flush(&self) -> Result<(), LinkError> {
        let mut way = self.current().await?;
        self.write_pending(&mut way).await?;
        if way.pending.is_empty() { Ok(()) } else { Err(LinkError::Full) }
    }

    /// Sends a message to one peer: one of [`peers`](Self::peers), or any address on UDP.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send); and [`LinkError::Unreachable`] if that is not who is at the other end.
    pub async fn send_to(&self, message: &(impl Encode + ?Sized), peer: Peer) -> Result<(), LinkError> {
        let mut way = self.ready().await?;
        self.lock().encode_to(message, peer, &mut way.pending)?;
        self.carry(&mut way).await.and_then(|count| is_sent(count, peer))
    }

    /// Sends a received frame byte for byte, for routers. To give it a sequence number or a signature of this link, call
    /// [`Sender::renumber`] before.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send). A frame with a [key](Frame::carries_key) is not forwarded.
    pub async fn send_frame(&self, frame: &Frame<'_>) -> Result<usize, LinkError> {
        let mut way = self.ready().await?;
        self.lock().forward_to_all(frame, &mut way.pending)?;
        self.carry(&mut way).await
    }

    /// Sends a received frame as it came to one peer.
    ///
    /// # Errors
    ///
    /// As of [`send_to`](Self::send_to).
    pub async fn send_frame_to(&self, frame: &Frame<'_>, peer: Peer) -> Result<(), LinkError> {
        let mut way = self.ready().await?;
        Outbox::forward_to(frame, peer, &mut way.pending)?;
        self.carry(&mut way).await.and_then(|count| is_sent(count, peer))
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

    /// Changes or reads the [`Sender`], for example to give it a key, save its time.
    pub fn with_sender<R>(&self, change: impl FnOnce(&mut Sender) -> R) -> R {
        change(&mut self.lock().sender)
    }

    /// The peers now, the one heard last first. With `udpout` and `udpbcast`, those who answered.
    #[must_use]
    pub fn peers(&self) -> Vec<Peer> {
        self.common.shared.peers.all(Instant::now())
    }

    /// Forgets a peer, and returns whether it was one. If it sends again, it is a peer again.
    pub fn remove_peer(&self, peer: Peer) -> bool {
        self.common.shared.peers.remove(peer, Instant::now())
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
        self.common.shared.local
    }

    /// Closes the link: every call ends with [`LinkError::Closed`], also those that wait.
    pub fn close(&self) {
        self.common.close();
        if let Some(line) = &self.line {
            line.shut();
        }
    }

    /// Whoever panicked while holding it had changed nothing by halves.
    fn lock(&self) -> Guard<'_, Outbox> {
        self.outbox.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Anybody may be at the other end of some links: no key goes to all.
    fn check_key(&self, message: &(impl Encode + ?Sized)) -> Result<(), LinkError> {
        let is_key = message.info().id == SETUP_SIGNING && self.common.shared.is_open_to_all;
        if is_key { Err(EncodeError::CarriesKey.into()) } else { Ok(()) }
    }

    /// Gets ready to send: connected if that is possible, and rid of what is left of former frames.
    async fn ready(&self) -> Result<MutexGuard<'_, Way>, LinkError> {
        let mut way = self.current().await?;
        self.write_pending(&mut way).await?;
        if way.pending.is_empty() { Ok(way) } else { self.full() }
    }

    /// Connected, if that is possible.
    async fn current(&self) -> Result<MutexGuard<'_, Way>, LinkError> {
        let mut way = self.common.unless_closed(self.way.lock()).await?;
        let Way { carrier, pending } = &mut *way;
        if let (Carrier::Line { end }, Some(line)) = (carrier, &self.line)
            && line.refresh_writer(end)?
        {
            // The rest of a frame means nothing to somebody else.
            self.drop_pending(pending);
        }
        Ok(way)
    }

    /// A message finds no room.
    fn full<T>(&self) -> Result<T, LinkError> {
        self.common.shared.counters.count_unsent(1);
        Err(LinkError::Full)
    }

    fn drop_pending(&self, pending: &mut Pending) {
        self.common.shared.counters.count_unsent(pending.len());
        pending.clear();
    }

    /// Sends frames to those that get them; gives to how many.
    async fn carry(&self, way: &mut Way) -> Result<usize, LinkError> {
        let count = way.address(0);
        self.write_pending(way).await?;
        // A connection that was lost meanwhile has taken nothing for sure.
        Ok(if matches!(way.carrier, Carrier::Line { end: None }) { 0 } else { count })
    }

    /// Writes what is pending, as far as there is room within the timeout. What is not written stays, also if this is dropped.
    async fn write_pending(&self, way: &mut Way) -> Result<(), LinkError> {
        let limit = self.common.shared.send_timeout;
        let Way { carrier, pending } = way;
        let written = match (carrier, &self.line) {
            (Carrier::Datagrams(socket), _) => timeout(limit, self.send_datagrams(socket, pending)),
            (Carrier::Line { end }, Some(line)) => {
                return match self.common.unless_closed(timeout(limit, self.write(line, end, pending))).await? {
                    Ok(written) => written,
                    Err(_) => Ok(()),
                };
            }
            _ => return Ok(()),
        };
        self.common.unless_closed(written).await?.unwrap_or(Ok(()))
    }

    /// Sends each frame to each who gets it. What fails for one is still sent to the others; the first error is given.
    async fn send_datagrams(&self, socket: &UdpSocket, pending: &mut Pending) -> Result<(), LinkError> {
        let mut error = None;
        while let Some(parcel) = pending.front_mut() {
            let Some(to) = parcel.to.last() else {
                pending.pop();
                continue;
            };
            if let Some(to) = to.address() {
                match socket.send_to(parcel.bytes(), to).await {
                    Ok(_) => self.common.shared.counters.count_sent(1),
                    Err(reason) => {
                        self.common.shared.counters.count_unsent(1);
                        error.get_or_insert(of_sending(reason, to));
                    }
                }
            }
            parcel.to.pop();
        }
        error.map_or(Ok(()), Err)
    }

    /// Writes to a connection, or notices that it is lost.
    async fn write(
        &self,
        line: &Line<Opened>,
        end: &mut Option<End<Hand>>,
        pending: &mut Pending,
    ) -> Result<(), LinkError> {
        while let Some(open) = end.as_mut()
            && !pending.is_empty()
        {
            match poll_fn(|context| pending.write(|frames| open.stream.poll_write(context, frames))).await {
                Ok(count) if count > 0 => self.common.shared.counters.count_sent(pending.advance(count)),
                Err(error) if is_interrupted(&error) => {}
                taken => {
                    self.drop_pending(pending);
                    line.lose(end, &taken.map_or_else(|error| error, |_| ErrorKind::WriteZero.into()));
                    line.check()?;
                }
            }
        }
        Ok(())
    }
}

impl core::fmt::Debug for SendHalf {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("SendHalf").field("common", &self.common).finish_non_exhaustive()
    }
}
