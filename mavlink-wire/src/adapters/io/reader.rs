//! Frames from anything that is read.

use std::io::{ErrorKind, Read, Result};

use crate::adapters::incoming::{ENOUGH, Incoming};
use crate::parser::not_told;
use crate::{Frame, Statistics, Table};

/// Bytes that are read at once.
const CHUNK: usize = 4096;

/// Reads frames from `R`, which needs no buffer of its own: 4096 bytes are read at once.
#[derive(Debug)]
pub struct FrameReader<'t, R> {
    inner: R,
    incoming: Incoming<'t, [u8; CHUNK]>,
}

impl<'t, R: Read> FrameReader<'t, R> {
    /// A reader that verifies the messages of this table, and hands over others unverified.
    #[must_use]
    pub const fn new(inner: R, table: &'t Table<'t>) -> Self {
        Self { inner, incoming: Incoming::new(table) }
    }

    /// The next frame. `None` at the end, when what waited for more bytes was searched as well; a file that has grown since
    /// can be read on.
    ///
    /// One call does bounded work: after 64 KiB without a frame it says [`ErrorKind::WouldBlock`], "nothing yet", whatever `R`
    /// is.
    ///
    /// # Errors
    ///
    /// [`ErrorKind::WouldBlock`] or a timeout: nothing is lost, call it again. Else what `R` says, except for
    /// [`ErrorKind::Interrupted`].
    pub fn receive(&mut self) -> Result<Option<Frame<'_>>> {
        self.receive_reporting_bad_checksums(not_told)
    }

    /// The next frame, as [`receive`](Self::receive) gives it. `bad_checksum` is told the message of each frame that
    /// [`Statistics::bad_checksums`] counts: if it is often the same one, both sides define it otherwise.
    ///
    /// # Errors
    ///
    /// As [`receive`](Self::receive).
    pub fn receive_reporting_bad_checksums(&mut self, mut bad_checksum: impl FnMut(u32)) -> Result<Option<Frame<'_>>> {
        let mut read = 0;
        loop {
            if let Some(found) = self.incoming.find(&mut bad_checksum) {
                return Ok(Some(self.incoming.frame(&found)));
            }
            if self.incoming.take_end() {
                return Ok(None);
            }
            if read >= ENOUGH {
                return Err(ErrorKind::WouldBlock.into());
            }
            match self.inner.read(self.incoming.space()) {
                Ok(count) => read += self.incoming.fill(count),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// The frames that there are without reading more, for a link that pauses: call it until it gives `None`. An unfinished
    /// frame is given up, and what came behind it is searched: see [`Parser::finish`](crate::Parser::finish).
    pub fn finish(&mut self) -> Option<Frame<'_>> {
        self.finish_reporting_bad_checksums(not_told)
    }

    /// The frames that there are without reading more, as [`finish`](Self::finish) gives them. `bad_checksum` is told the
    /// message of each frame that [`Statistics::bad_checksums`] counts.
    pub fn finish_reporting_bad_checksums(&mut self, mut bad_checksum: impl FnMut(u32)) -> Option<Frame<'_>> {
        let found = self.incoming.finish(&mut bad_checksum)?;
        Some(self.incoming.frame(&found))
    }
}

impl<R> FrameReader<'_, R> {
    /// What was found so far, and what could not be read.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.incoming.statistics()
    }

    /// What is read from.
    #[must_use]
    pub fn get_ref(&self) -> &R {
        &self.inner
    }

    /// What is read from. Bytes that are taken out of it are missing here.
    pub fn get_mut(&mut self) -> &mut R {
        &mut self.inner
    }

    /// What was read from. Bytes that were read, and are no frame yet, are lost.
    pub fn into_inner(self) -> R {
        self.inner
    }
}
