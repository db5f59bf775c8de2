//! The half that sends.

use core::future::poll_fn;
use std::collections::VecDeque;
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
use crate::frame::key::SETUP_SIGNING;
use crate::link::connection::{is_sent, of_sending};
use crate::link::line::{End, Line};
use crate::link::{LinkError, Outbox, Parcel, Peer};
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
    pending: VecDeque<Parcel>,
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
        let way = Arc::new(Mutex::new(Way { carrier, pending: VecDeque::new() }));
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
        if message.info().id == SETUP_SIGNING && self.common.shared.is_open_to_all {
            return Err(EncodeError::CarriesKey.into());
        }
        let mut way = self.ready().await?;
        let made = self.lock().encode_to_all(message);
        let sent = self.carry(&mut way, made.parcels).await;
        made.error.map_or(sent, |error| Err(error.into()))
    }

    /// Sends a message to one peer: one of [`peers`](Self::peers), or any address on UDP.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send); and [`LinkError::Unreachable`] if that is not who is at the other end.
    pub async fn send_to(&self, message: &(impl Encode + ?Sized), peer: Peer) -> Result<(), LinkError> {
        let mut way = self.ready().await?;
        let parcel = self.lock().encode_to(message, peer)?;
        self.carry(&mut way, [parcel].into()).await.and_then(|count| is_sent(count, peer))
    }

    /// Sends a received frame byte for byte, for routers. To give it a sequence number or a signature of this link, call
    /// [`Sender::renumber`] before.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send). A frame with a [key](Frame::carries_key) is not forwarded.
    pub async fn send_frame(&self, frame: &Frame<'_>) -> Result<usize, LinkError> {
        let mut way = self.ready().await?;
        let parcel = self.lock().forward_to_all(frame)?;
        self.carry(&mut way, [parcel].into()).await
    }

    /// Sends a received frame as it came to one peer.
    ///
    /// # Errors
    ///
    /// As of [`send_to`](Self::send_to).
    pub async fn send_frame_to(&self, frame: &Frame<'_>, peer: Peer) -> Result<(), LinkError> {
        let mut way = self.ready().await?;
        let parcel = Outbox::forward(frame, [peer].into())?;
        self.carry(&mut way, [parcel].into()).await.and_then(|count| is_sent(count, peer))
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

    /// Gets ready to send: connected if that is possible, and rid of what is left of the last frame.
    async fn ready(&self) -> Result<MutexGuard<'_, Way>, LinkError> {
        let mut way = self.common.unless_closed(self.way.lock()).await?;
        let Way { carrier, pending } = &mut *way;
        if let (Carrier::Line { end }, Some(line)) = (carrier, &self.line)
            && line.refresh_writer(end)?
        {
            // The rest of a frame means nothing to somebody else.
            pending.clear();
        }
        self.write_pending(&mut way).await?;
        if !way.pending.is_empty() {
            self.common.shared.counters.count_unsent();
            return Err(LinkError::Full);
        }
        Ok(way)
    }

    /// Sends frames to those that get them; gives to how many.
    async fn carry(&self, way: &mut Way, parcels: Vec<Parcel>) -> Result<usize, LinkError> {
        let there = match &way.carrier {
            Carrier::Datagrams(_) => None,
            Carrier::Line { end: Some(end) } => Some(end.peer),
            Carrier::Line { end: None } | Carrier::Nothing => return Ok(0),
        };
        way.pending.extend(parcels);
        way.pending.retain(|parcel| there.is_none_or(|there| parcel.to.contains(&there)));
        let count = way.pending.iter().map(|parcel| parcel.to.len()).sum();
        self.write_pending(way).await?;
        // A connection that was lost meanwhile has taken nothing for sure.
        let count = if matches!(way.carrier, Carrier::Line { end: None }) { 0 } else { count };
        self.common.shared.counters.count_sent(count);
        Ok(count)
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
    async fn send_datagrams(&self, socket: &UdpSocket, pending: &mut VecDeque<Parcel>) -> Result<(), LinkError> {
        let mut error = None;
        while let Some(parcel) = pending.front_mut() {
            let Some(to) = parcel.to.last() else {
                pending.pop_front();
                continue;
            };
            if let Some(to) = to.address()
                && let Err(reason) = socket.send_to(parcel.bytes(), to).await
            {
                self.common.shared.counters.count_unsent();
                error.get_or_insert(of_sending(reason, to));
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
        pending: &mut VecDeque<Parcel>,
    ) -> Result<(), LinkError> {
        while let (Some(open), Some(parcel)) = (end.as_mut(), pending.front_mut()) {
            if parcel.bytes().is_empty() {
                pending.pop_front();
                continue;
            }
            match poll_fn(|context| open.stream.poll_write(context, parcel.bytes())).await {
                Ok(count) if count > 0 => parcel.advance(count),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                taken => {
                    pending.clear();
                    self.common.shared.counters.count_unsent();
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
