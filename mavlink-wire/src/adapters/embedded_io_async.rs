//! Frames over the traits of `embedded-io-async`: UARTs and sockets of firmware with async tasks. Needs the feature
//! `embedded-io-async`.
//!
//! ```
//! # use mavlink_wire::{Encode, MessageInfo, Sender, Table};
//! # const INFO: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
//! # struct Heartbeat;
//! # impl Encode for Heartbeat {
//! #     fn info(&self) -> &'static MessageInfo { INFO }
//! #     fn write(&self, payload: &mut [u8; 255]) { payload[..9].copy_from_slice(&[0, 0, 0, 0, 6, 8, 0, 4, 3]); }
//! # }
//! # static TABLE: Table<'static> = Table::of(&[INFO]);
//! use mavlink_wire::embedded_io_async::{FrameReader, FrameWriter, ReceiveError, SendError};
//!
//! async fn talk<E>(
//!     rx: impl embedded_io_async::Read<Error = E>,
//!     tx: impl embedded_io_async::Write<Error = E>,
//! ) -> Result<(), SendError<E>> {
//!     let (mut reader, mut writer) = (FrameReader::new(rx, &TABLE), FrameWriter::new(tx, Sender::v1(1, 1)));
//!     loop {
//!         match reader.receive().await {
//!             Ok(Some(frame)) if frame.message_id() == 0 => writer.send(&Heartbeat).await?,
//!             Ok(Some(_)) | Err(ReceiveError::NothingYet) => {}
//!             Ok(None) => return Ok(()),
//!             Err(ReceiveError::Link(error)) => return Err(SendError::Link(error)),
//!         }
//!     }
//! }
//! ```
//!
//! # Timeouts and dropped futures
//!
//! [`ErrorKind::TimedOut`] is handed on and loses nothing: read again later. A writer keeps what the link did not take of a
//! frame, and writes it first the next time, so that no frame is torn. [`ErrorKind::Interrupted`] is tried again at once.
//!
//! A timeout is that of the link, for the next byte. While bytes come that make no frame, as at a wrong baud rate, a reader
//! goes on reading, but no further than 64 KiB: then it says [`ReceiveError::NothingYet`], so that its caller can look at the
//! clock.
//!
//! A future that is dropped before it is ready, as by a timeout, loses nothing if those of `R` and `W` lose nothing: what was
//! read is kept, and what was not written of a frame goes out before the next one.

use ::embedded_io_async::{Error, ErrorKind, Read, Write};

use crate::adapters::incoming::{ENOUGH, Incoming};
use crate::adapters::outgoing::Outgoing;
use crate::parser::not_told;
use crate::{Encode, Frame, Sender, Statistics, Table};

pub use crate::error::{ReceiveError, SendError};

/// Reads frames from `R`, up to `N` bytes at once.
#[derive(Clone, Debug)]
pub struct FrameReader<'t, R, const N: usize = 64> {
    inner: R,
    incoming: Incoming<'t, [u8; N]>,
}

impl<'t, R> FrameReader<'t, R> {
    /// A reader of 64 bytes at once that verifies the messages of this table, and hands over others unverified.
    #[must_use]
    pub const fn new(inner: R, table: &'t Table<'t>) -> Self {
        Self::with_read_size(inner, table)
    }
}

impl<'t, R, const N: usize> FrameReader<'t, R, N> {
    /// A reader of up to `N` bytes at once.
    #[must_use]
    pub const fn with_read_size(inner: R, table: &'t Table<'t>) -> Self {
        Self { inner, incoming: Incoming::new(table) }
    }

    /// What was found so far, and what could not be read.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.incoming.statistics()
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

    /// What is read from.
    #[must_use]
    pub const fn get_ref(&self) -> &R {
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

impl<R: Read, const N: usize> FrameReader<'_, R, N> {
    /// The next frame; `None` at the end of the stream, when what waited for more bytes was searched as well.
    ///
    /// # Errors
    ///
    /// - [`ReceiveError::NothingYet`]: 64 KiB were read, and no frame was found. Nothing is lost: call it again.
    /// - [`ReceiveError::Link`]: what `R` says, except for [`ErrorKind::Interrupted`]. Nothing is lost: read again if it was a
    ///   timeout.
    pub async fn receive(&mut self) -> Result<Option<Frame<'_>>, ReceiveError<R::Error>> {
        self.receive_reporting_bad_checksums(not_told).await
    }

    /// The next frame, as [`receive`](Self::receive) gives it. `bad_checksum` is told the message of each frame that
    /// [`Statistics::bad_checksums`] counts: if it is often the same one, both sides define it otherwise.
    ///
    /// # Errors
    ///
    /// As [`receive`](Self::receive).
    pub async fn receive_reporting_bad_checksums(
        &mut self,
        mut bad_checksum: impl FnMut(u32),
    ) -> Result<Option<Frame<'_>>, ReceiveError<R::Error>> {
        let mut read = 0;
        loop {
            if let Some(found) = self.incoming.find(&mut bad_checksum) {
                return Ok(Some(self.incoming.frame(&found)));
            }
            if self.incoming.take_end() {
                return Ok(None);
            }
            if read >= ENOUGH {
                return Err(ReceiveError::NothingYet);
            }
            match self.inner.read(self.incoming.space()).await {
                Ok(count) => read += self.incoming.fill(count),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(ReceiveError::Link(error)),
            }
        }
    }
}

/// Writes frames to `W`.
#[derive(Clone, Debug)]
pub struct FrameWriter<W> {
    inner: W,
    outgoing: Outgoing,
}

impl<W> FrameWriter<W> {
    /// A writer of what this sender makes.
    #[must_use]
    pub const fn new(inner: W, sender: Sender) -> Self {
        Self { inner, outgoing: Outgoing::new(sender) }
    }

    /// Whether a part of the last frame is not written yet.
    #[must_use]
    pub fn is_pending(&self) -> bool {
        !self.outgoing.pending().is_empty()
    }

    /// What makes the frames.
    pub fn sender(&mut self) -> &mut Sender {
        &mut self.outgoing.sender
    }

    /// What is written to.
    #[must_use]
    pub const fn get_ref(&self) -> &W {
        &self.inner
    }

    /// What is written to. What else is written to it must not come between the parts of a frame.
    pub fn get_mut(&mut self) -> &mut W {
        &mut self.inner
    }

    /// What was written to. What is left of the last frame is lost.
    pub fn into_inner(self) -> W {
        self.inner
    }
}

impl<W: Write> FrameWriter<W> {
    /// Sends a message. It may still lie in a buffer of `W`: see [`flush`](Self::flush). If the link takes only a part of the
    /// frame before a timeout, the rest is kept and goes out before the next one.
    ///
    /// # Errors
    ///
    /// - [`SendError::Encode`]: the sender cannot carry the message.
    /// - [`SendError::Link`] with [`ErrorKind::TimedOut`]: the link has not yet taken the frame before. This one was not sent,
    ///   and has no number: send it again.
    /// - What else `W` says: the link has failed in the middle of a frame. What is left of it is kept.
    pub async fn send(&mut self, message: &(impl Encode + ?Sized)) -> Result<(), SendError<W::Error>> {
        self.write_pending().await?;
        self.outgoing.encode(message).map_err(SendError::Encode)?;
        self.try_write_pending().await
    }

    /// Sends a received frame as it came, to the byte. One that is to have a number, or a signature, of this link is made by
    /// [`Sender::renumber`] before.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send); what is not carried is a frame with a [key](Frame::carries_key).
    pub async fn send_frame(&mut self, frame: &Frame<'_>) -> Result<(), SendError<W::Error>> {
        self.write_pending().await?;
        self.outgoing.put_frame(frame).map_err(SendError::Encode)?;
        self.try_write_pending().await
    }

    /// Writes what is left of the last frame, and waits until `W` has sent everything.
    ///
    /// # Errors
    ///
    /// The link has failed, or has not taken everything in its time.
    pub async fn flush(&mut self) -> Result<(), SendError<W::Error>> {
        self.write_pending().await?;
        self.inner.flush().await.map_err(SendError::Link)
    }

    /// Writes what is left of the last frame. A link that takes no more for now is no error: the rest is kept.
    async fn try_write_pending(&mut self) -> Result<(), SendError<W::Error>> {
        match self.write_pending().await {
            Err(SendError::Link(error)) if error.kind() == ErrorKind::TimedOut => Ok(()),
            result => result,
        }
    }

    async fn write_pending(&mut self) -> Result<(), SendError<W::Error>> {
        while !self.outgoing.pending().is_empty() {
            match self.inner.write(self.outgoing.pending()).await {
                Ok(0) => return Err(SendError::NothingTaken),
                Ok(count) => self.outgoing.advance(count),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(SendError::Link(error)),
            }
        }
        Ok(())
    }
}
