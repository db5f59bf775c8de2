//! A frame without its bytes: for those who own the bytes, and can lend them only afterwards.

use super::{Facts, Frame};

/// What a [`Frame`] knows about its bytes.
#[derive(Clone, Copy)]
pub(crate) struct Outline {
    length: usize,
    payload: (usize, usize),
    facts: Facts,
}

impl Outline {
    pub(crate) fn of(frame: &Frame<'_>) -> Self {
        let start = frame.payload_start();
        Self { length: frame.bytes.len(), payload: (start, start + frame.payload.len()), facts: frame.facts }
    }

    /// Id of the message.
    pub(crate) fn message_id(&self) -> u32 {
        self.facts.id
    }

    /// The frame that ends where these bytes end.
    pub(crate) fn at_end_of<'b>(&self, bytes: &'b [u8]) -> Frame<'b> {
        let bytes = bytes.get(bytes.len().saturating_sub(self.length)..).unwrap_or_default();
        let payload = bytes.get(self.payload.0..self.payload.1).unwrap_or_default();
        Frame { bytes, payload, facts: self.facts }
    }
}
