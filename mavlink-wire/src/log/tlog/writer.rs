//! Logs to anything that is written.

use std::io::{Result, Write};

use super::{MAX_ENTRY, encode};
use crate::Frame;

/// Writes a log to `W`, which should have a buffer: [`std::io::BufWriter`].
#[derive(Clone, Debug)]
pub struct Writer<W> {
    inner: W,
}

impl<W: Write> Writer<W> {
    /// A writer to the start or the end of a log.
    #[must_use]
    pub const fn new(inner: W) -> Self {
        Self { inner }
    }

    /// Writes a frame, and when it was received: Unix time in µs. Signatures, and frames that carry a key, are left out: see
    /// [`encode`].
    ///
    /// # Errors
    ///
    /// What `W` says. It may have taken a part of the entry, over which readers go on with the next.
    pub fn write(&mut self, time_us: u64, frame: &Frame<'_>) -> Result<()> {
        let mut buffer = [0; MAX_ENTRY];
        match encode(time_us, frame, &mut buffer) {
            Some(entry) => self.inner.write_all(entry),
            None => Ok(()),
        }
    }

    /// Flushes `W`.
    ///
    /// # Errors
    ///
    /// What `W` says.
    pub fn flush(&mut self) -> Result<()> {
        self.inner.flush()
    }

    /// What was written to.
    pub fn into_inner(self) -> W {
        self.inner
    }
}
