//! Frames to anything that is written.

use std::io::{ErrorKind, Result, Write};

use crate::adapters::outgoing::Outgoing;
use crate::{Encode, Frame, Sender};

/// Writes frames to `W`, each by one call of [`Write::write`] if the link takes it whole.
#[derive(Debug)]
pub struct FrameWriter<W> {
    inner: W,
    outgoing: Outgoing,
}

impl<W: Write> FrameWriter<W> {
    /// A writer of what this sender makes.
    #[must_use]
    pub const fn new(inner: W, sender: Sender) -> Self {
        Self { inner, outgoing: Outgoing::new(sender) }
    }

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
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => Ok(()),
            result => result,
        }
    }

    fn write_pending(&mut self) -> Result<()> {
        while !self.outgoing.pending().is_empty() {
            match self.inner.write(self.outgoing.pending()) {
                Ok(0) => return Err(ErrorKind::WriteZero.into()),
                Ok(count) => self.outgoing.advance(count),
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }
}

impl<W> FrameWriter<W> {
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
    pub fn get_ref(&self) -> &W {
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
