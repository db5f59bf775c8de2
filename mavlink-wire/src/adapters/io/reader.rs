//! Frames from anything that is read.

use std::io::{ErrorKind, Read, Result};

use crate::adapters::frame_reader::frame_reader;
use crate::adapters::incoming::{ENOUGH, Incoming};
use crate::adapters::pause::uninterrupted;
use crate::parser::not_told;
use crate::{Frame, Statistics, Table};

frame_reader!(4096);

impl<R: Read, const N: usize> FrameReader<'_, R, N> {
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
            let count = uninterrupted(|| self.inner.read(self.incoming.space()))?;
            read += self.incoming.fill(count);
        }
    }
}
