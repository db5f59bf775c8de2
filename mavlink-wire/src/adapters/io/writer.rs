//! Frames to anything that is written.

use std::io::{ErrorKind, Result, Write};

use crate::adapters::frame_writer::frame_writer;
use crate::adapters::outgoing::Outgoing;
use crate::adapters::pause::{is_not_now, uninterrupted};
use crate::{Encode, Frame, Sender};

frame_writer!();

impl<W: Write> FrameWriter<W> {
    /// Sends a message. If the link takes only a part of the frame now, the rest is kept and goes out before the next one.
    ///
    /// # Errors
    ///
    /// - [`ErrorKind::InvalidInput`] around an [`EncodeError`](crate::EncodeError): the sender cannot carry the message.
    /// - [`ErrorKind::WouldBlock`] or [`ErrorKind::TimedOut`]: the link has not yet taken the frame before. This one was not
    ///   sent, and has no number: send it again.
    /// - What else `W` says: the link has failed in the middle of a frame. What is left of it is kept.
    pub fn send(&mut self, message: &(impl Encode + ?Sized)) -> Result<()> {
        self.write_pending()?;
        self.outgoing.encode(message)?;
        self.try_write_pending()
    }

    /// Sends a received frame as it came, to the byte. One that is to have a number, or a signature, of this link is made by
    /// [`Sender::renumber`] before.
    ///
    /// # Errors
    ///
    /// As of [`send`](Self::send); what is not carried is a frame with a [key](Frame::carries_key).
    pub fn send_frame(&mut self, frame: &Frame<'_>) -> Result<()> {
        self.write_pending()?;
        self.outgoing.put_frame(frame)?;
        self.try_write_pending()
    }

    /// Writes what is left of the last frame, and flushes `W`.
    ///
    /// # Errors
    ///
    /// What `W` says.
    pub fn flush(&mut self) -> Result<()> {
        self.write_pending()?;
        self.inner.flush()
    }

    /// Writes what is left of the last frame. A link that takes no more for now is no error: the rest is kept.
    fn try_write_pending(&mut self) -> Result<()> {
        match self.write_pending() {
            Err(error) if is_not_now(&error) => Ok(()),
            result => result,
        }
    }

    fn write_pending(&mut self) -> Result<()> {
        while !self.outgoing.pending().is_empty() {
            match uninterrupted(|| self.inner.write(self.outgoing.pending()))? {
                0 => return Err(ErrorKind::WriteZero.into()),
                count => self.outgoing.advance(count),
            }
        }
        Ok(())
    }
}
