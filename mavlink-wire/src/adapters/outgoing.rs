//! What the writers share: a sender, and the frame that is on its way.

use crate::frame::key::{SETUP_SIGNING, WIPES, wipe};
use crate::{Encode, EncodeError, Frame, MAX_FRAME, Sender};

/// A sender, and what is not written yet of its last frame.
#[derive(Clone)]
pub(crate) struct Outgoing {
    pub(crate) sender: Sender,
    buffer: [u8; MAX_FRAME],
    start: usize,
    end: usize,
    /// The frame carries a key, and is to be wiped once it is written.
    carries_key: bool,
}

impl Outgoing {
    pub(crate) const fn new(sender: Sender) -> Self {
        Self { sender, buffer: [0; MAX_FRAME], start: 0, end: 0, carries_key: false }
    }

    /// What is still to be written.
    pub(crate) fn pending(&self) -> &[u8] {
        self.buffer.get(self.start..self.end).unwrap_or_default()
    }

    /// Says how many of these bytes were written.
    pub(crate) fn advance(&mut self, count: usize) {
        self.start = self.end.min(self.start + count);
        if self.start == self.end {
            self.wipe_key();
        }
    }

    /// Makes a frame to be written. The one before must be written.
    pub(crate) fn encode(&mut self, message: &(impl Encode + ?Sized)) -> Result<(), EncodeError> {
        self.carries_key = message.info().id == SETUP_SIGNING;
        let buffer = self.buffer.as_ptr().addr();
        let frame = match self.sender.encode(message, &mut self.buffer) {
            Ok(frame) => frame,
            Err(error) => {
                self.wipe_key();
                return Err(error);
            }
        };
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

    fn wipe_key(&mut self) {
        if WIPES && core::mem::take(&mut self.carries_key) {
            wipe(&mut self.buffer);
        }
    }
}

/// What is not written of a key when the link is given up.
#[cfg(feature = "signing")]
impl Drop for Outgoing {
    fn drop(&mut self) {
        self.wipe_key();
    }
}

/// The bytes are left out: they may be a key.
impl core::fmt::Debug for Outgoing {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Self { sender, start, end, .. } = self;
        f.debug_struct("Outgoing")
            .field("sender", sender)
            .field("start", start)
            .field("end", end)
            .finish_non_exhaustive()
    }
}
