//! The datagram that is being searched.

use std::boxed::Box;
use std::io::{ErrorKind, Result};
use std::net::{SocketAddr, UdpSocket};
use std::time::{Duration, Instant};
use std::vec;

use crate::frame::key::{WIPES, wipe_around};

/// No datagram is longer.
pub(super) const MAX_DATAGRAM: usize = 65_536;

/// The last datagram; the search has still to see `start..end` of it.
#[derive(Clone)]
pub(super) struct Datagram {
    buffer: Box<[u8]>,
    start: usize,
    end: usize,
    /// Who sent it, until it is used up.
    pub(super) from: Option<SocketAddr>,
    /// A frame that carries a key was found, and is to be wiped once it is used.
    pub(super) found_key: bool,
}

/// What came of waiting for one.
pub(super) enum Wait {
    /// This many bytes came from there.
    Came(usize, SocketAddr),
    /// Nothing, within the time that was given here, or for a reason that passes.
    Nothing,
}

impl Datagram {
    pub(super) fn new() -> Self {
        Self { buffer: vec![0; MAX_DATAGRAM].into_boxed_slice(), start: 0, end: 0, from: None, found_key: false }
    }

    /// Overwrites the key that was handed over last, in pieces of former datagrams, too.
    pub(super) fn wipe_used_key(&mut self) {
        if WIPES && core::mem::take(&mut self.found_key) {
            wipe_around(&mut self.buffer, self.start, self.end);
        }
    }

    /// What is still to be searched.
    pub(super) fn rest(&self) -> &[u8] {
        self.buffer.get(self.start..self.end).unwrap_or_default()
    }

    /// What was searched.
    pub(super) fn used(&self) -> &[u8] {
        self.buffer.get(..self.start).unwrap_or_default()
    }

    /// Says how much is still to be searched.
    pub(super) fn leave(&mut self, rest: usize) {
        self.start = self.end.saturating_sub(rest);
    }

    /// Waits for the next datagram as the socket does, but no longer than `at_most`.
    pub(super) fn wait(&mut self, socket: &UdpSocket, at_most: Option<Duration>) -> Result<Wait> {
        let own = socket.read_timeout()?;
        let shorter = at_most.filter(|at_most| own.is_none_or(|own| own > *at_most));
        if shorter.is_some() {
            socket.set_read_timeout(shorter)?;
        }
        let received = socket.recv_from(&mut self.buffer);
        if shorter.is_some() {
            socket.set_read_timeout(own)?;
        }
        match received {
            Ok((length, from)) => {
                (self.start, self.end, self.from) = (0, length, Some(from));
                Ok(Wait::Came(length, from))
            }
            Err(error) if is_passing(error.kind()) => Ok(Wait::Nothing),
            Err(error) => Err(error),
        }
    }
}

/// What it holds is left out: it may be a key.
impl core::fmt::Debug for Datagram {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self { start, end, from, .. } = self;
        f.debug_struct("Datagram").field("start", start).field("end", end).field("from", from).finish_non_exhaustive()
    }
}

/// Whether to go on receiving as if nothing had happened.
fn is_passing(kind: ErrorKind) -> bool {
    matches!(kind, ErrorKind::Interrupted | ErrorKind::ConnectionReset | ErrorKind::ConnectionRefused)
}

/// What one call of `receive` has done so far, which is bounded in bytes and in time.
pub(super) struct Work {
    bytes: usize,
    began: Option<Instant>,
}

impl Work {
    pub(super) const NONE: Self = Self { bytes: 0, began: None };

    /// Bytes of a datagram to which a shorter one counts as well.
    const LEAST: usize = 64;

    pub(super) fn count(&mut self, bytes: usize) {
        self.bytes += bytes.max(Self::LEAST);
    }

    /// Whether to go on.
    pub(super) fn check(&mut self, socket: &UdpSocket, now: Instant) -> Result<()> {
        if self.bytes >= MAX_DATAGRAM {
            return Err(ErrorKind::WouldBlock.into());
        }
        let began = *self.began.get_or_insert(now);
        match socket.read_timeout()? {
            Some(timeout) if now > began && now.saturating_duration_since(began) >= timeout => {
                Err(ErrorKind::TimedOut.into())
            }
            _ => Ok(()),
        }
    }
}
