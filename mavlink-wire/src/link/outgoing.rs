//! What the writers share: a sender, and the frame that is on its way.

use crate::{Encode, EncodeError, Frame, MAX_FRAME, Sender};

/// A sender, and what is not written yet of its last frame.
#[derive(Clone, Debug)]
pub(crate) struct Outgoing {
    pub(crate) sender: Sender,
    buffer: [u8; MAX_FRAME],
    start: usize,
    end: usize,
}

impl Outgoing {
    pub(crate) const fn new(sender: Sender) -> Self {
        Self { sender, buffer: [0; MAX_FRAME], start: 0, end: 0 }
    }

    /// What is still to be written.
    pub(crate) fn pending(&self) -> &[u8] {
        self.buffer.get(self.start..self.end).unwrap_or_default()
    }

    /// Says how many of these bytes were written.
    pub(crate) fn advance(&mut self, count: usize) {
        self.start = self.end.min(self.start + count);
    }

    /// Makes a frame to be written. The one before must be written.
    pub(crate) fn encode(&mut self, message: &(impl Encode + ?Sized)) -> Result<(), EncodeError> {
        let buffer = self.buffer.as_ptr().addr();
        let frame = self.sender.encode(message, &mut self.buffer)?;
        self.start = frame.as_ptr().addr() - buffer;
        self.end = self.start + frame.len();
        Ok(())
    }

    /// Takes a frame to be written as it is. The one before must be written.
    pub(crate) fn put_frame(&mut self, frame: &Frame<'_>) -> Result<(), EncodeError> {
        if frame.carries_key() {
            return Err(EncodeError::CarriesKey);
        }
        self.buffer.iter_mut().zip(frame.bytes()).for_each(|(to, from)| *to = *from);
        (self.start, self.end) = (0, frame.bytes().len());
        Ok(())
    }
}
