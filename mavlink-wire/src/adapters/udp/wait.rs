//! Waiting for a datagram.

use std::io::{Error, ErrorKind, Result};
use std::net::UdpSocket;
use std::time::Instant;

use super::Endpoint;
use crate::adapters::pause::{is_not_now, is_passing};
use crate::link::MAX_CHUNK;

impl Endpoint<'_> {
    /// Waits for the next datagram, or until the rest of a frame has been waited for long enough.
    pub(super) fn wait(&mut self, work: &mut Work) -> Result<()> {
        let began = Instant::now();
        work.check(&self.socket, began)?;
        let own = self.socket.read_timeout()?;
        let limit = self.inbox.patience();
        let shorter = limit.filter(|limit| own.is_none_or(|own| own > *limit));
        if shorter.is_some() {
            self.socket.set_read_timeout(shorter)?;
        }
        let came = self.socket.recv_from(self.inbox.space());
        if shorter.is_some() {
            self.socket.set_read_timeout(own)?;
        }
        let waited = began.elapsed();
        match came {
            Ok((length, from)) => {
                self.inbox.fill(length, from.into(), waited);
                work.count(length);
                Ok(())
            }
            Err(error) if is_passing(&error) => Ok(()),
            Err(error) if is_not_now(&error) => {
                // The caller may want to wait longer than for the rest of a frame: the next check says.
                let ours = limit.is_some_and(|limit| waited >= limit);
                if self.inbox.give_up() || ours { Ok(()) } else { Err(error) }
            }
            Err(error) => Err(error),
        }
    }
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

    fn count(&mut self, bytes: usize) {
        self.bytes += bytes.max(Self::LEAST);
    }

    /// Whether to go on.
    fn check(&mut self, socket: &UdpSocket, now: Instant) -> Result<()> {
        if self.bytes >= MAX_CHUNK {
            return Err(ErrorKind::WouldBlock.into());
        }
        let began = *self.began.get_or_insert(now);
        match socket.read_timeout()? {
            Some(timeout) if now > began && now.saturating_duration_since(began) >= timeout => {
                Err(Error::from(ErrorKind::TimedOut))
            }
            _ => Ok(()),
        }
    }
}
