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
use crate::link::sending::sending;
use crate::link::shared::Shared;
use crate::link::{LinkError, Outbox, Peer, Pending};
use crate::{ComponentId, Encode, EncodeError, Frame, Sender, SystemId};

/// The half of a [`Link`](super::Link) that sends. A clone is another handle of the same half: several threads may send.
#[derive(Clone)]
pub struct SendHalf {
    pub(super) shared: Arc<Shared>,
    pub(super) line: Option<Arc<Line<Box<dyn Stream>>>>,
    pub(super) way: Arc<Mutex<Way>>,
}

/// What makes frames, and what carries them.
pub(super) struct Way {
    pub(super) outbox: Outbox,
    pub(super) carrier: Carrier,
    /// What a connection or device has not taken yet. Datagrams go out at once.
    pub(super) pending: Pending,
}

impl Way {
    /// Of the frames after the first `kept` ones, keeps those that are for who is at the other end of a connection; gives how many.
    fn address(&mut self, kept: usize) -> usize {
        match &self.carrier {
            Carrier::Line { end: Some(end) } => self.pending.keep_for(end.peer, kept),
            _ => {
                self.pending.clear();
                0
            }
        }
    }
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

sending! {}

impl SendHalf {
    /// Changes or reads the [`Sender`], for example to give it a key, save its time. Nothing is sent meanwhile.
    pub fn with_sender<R>(&self, change: impl FnOnce(&mut Sender) -> R) -> R {
        change(&mut self.way.lock().unwrap_or_else(PoisonError::into_inner).outbox.sender)
    }

    /// Closes the link: every call ends with [`LinkError::Closed`], also one that waits in another thread, within a fifth of a
    /// second.
    pub fn close(&self) {
        self.shared.close();
        if let Some(line) = &self.line {
            line.shut();
        }
    }

    fn shared(&self) -> &Shared {
        &self.shared
    }

    /// Waits until nobody else sends. Whoever panicked meanwhile had changed nothing by halves.
    fn lock(&self) -> Result<MutexGuard<'_, Way>, LinkError> {
        self.shared.check()?;
        Ok(self.way.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn with_outbox<R>(&self, way: &mut Way, make: impl FnOnce(&mut Outbox, &mut Pending) -> R) -> R {
        make(&mut way.outbox, &mut way.pending)
    }

    /// Sends frames to those that get them; gives to how many.
    fn carry(&self, way: &mut Way) -> Result<usize, LinkError> {
        if let Way { carrier: Carrier::Datagrams { socket }, pending, .. } = way {
            return self.send_datagrams(socket, pending);
        }
        let count = way.address(0);
        self.write_pending(way)?;
        // A connection that was lost meanwhile has taken nothing for sure.
        let is_there = matches!(way.carrier, Carrier::Line { end: Some(_) });
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
    fn write_pending(&self, way: &mut Way) -> Result<(), LinkError> {
        let Way { carrier: Carrier::Line { end }, pending, .. } = way else { return Ok(()) };
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
