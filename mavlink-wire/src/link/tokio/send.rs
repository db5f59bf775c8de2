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
use crate::link::sending::sending;
use crate::link::shared::Shared;
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

sending! { async await }

impl SendHalf {
    pub(super) fn new(common: Arc<Common>, line: Option<Arc<Line<Opened>>>, outbox: Outbox, carrier: Carrier) -> Self {
        let way = Arc::new(Mutex::new(Way { carrier, pending: Pending::default() }));
        Self { common, line, outbox: Arc::new(Lock::new(outbox)), way }
    }

    /// Changes or reads the [`Sender`], for example to give it a key, save its time.
    pub fn with_sender<R>(&self, change: impl FnOnce(&mut Sender) -> R) -> R {
        change(&mut self.outbox().sender)
    }

    /// Closes the link: every call ends with [`LinkError::Closed`], also those that wait.
    pub fn close(&self) {
        self.common.close();
        if let Some(line) = &self.line {
            line.shut();
        }
    }

    fn shared(&self) -> &Shared {
        &self.common.shared
    }

    /// Waits until nobody else sends.
    async fn lock(&self) -> Result<MutexGuard<'_, Way>, LinkError> {
        self.common.unless_closed(self.way.lock()).await
    }

    fn with_outbox<R>(&self, way: &mut Way, make: impl FnOnce(&mut Outbox, &mut Pending) -> R) -> R {
        make(&mut self.outbox(), &mut way.pending)
    }

    /// Whoever panicked while holding it had changed nothing by halves.
    fn outbox(&self) -> Guard<'_, Outbox> {
        self.outbox.lock().unwrap_or_else(PoisonError::into_inner)
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
        let limit = self.shared().send_timeout;
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
                    Ok(_) => self.shared().counters.count_sent(1),
                    Err(reason) => {
                        self.shared().counters.count_unsent(1);
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
                Ok(count) if count > 0 => self.shared().counters.count_sent(pending.advance(count)),
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
