//! Frames that are on their way out. Their storage is used again: sending allocates nothing once it has run for a while.

use core::fmt;
use std::boxed::Box;
use std::collections::VecDeque;
use std::io::IoSlice;
use std::vec::Vec;

use super::Peer;
use crate::MAX_FRAME;
use crate::frame::key::wipe;

/// Frames that wait at most before they are written.
pub(super) const QUEUE: usize = 64;

/// Frames in order, and empty ones to be filled again.
#[derive(Debug, Default)]
pub(crate) struct Pending {
    frames: VecDeque<Parcel>,
    spare: Vec<Parcel>,
}

/// A frame, and who gets it. It may carry a key: then it is wiped when it is emptied or dropped.
pub(crate) struct Parcel {
    /// Boxed, so that no copy of a key stays behind where a parcel has been.
    pub(super) buffer: Box<[u8; MAX_FRAME]>,
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) carries_key: bool,
    pub(crate) to: Vec<Peer>,
}

impl Pending {
    /// An empty parcel for these.
    pub(super) fn parcel(&mut self, to: impl IntoIterator<Item = Peer>) -> Parcel {
        let mut parcel = self.spare.pop().unwrap_or_else(Parcel::new);
        parcel.to.extend(to);
        parcel
    }

    pub(super) fn push(&mut self, parcel: Parcel) {
        self.frames.push_back(parcel);
    }

    /// Empties a parcel, and keeps it to be filled again.
    pub(super) fn recycle(&mut self, mut parcel: Parcel) {
        if self.spare.len() < QUEUE {
            parcel.clear();
            self.spare.push(parcel);
        }
    }

    pub(crate) fn front_mut(&mut self) -> Option<&mut Parcel> {
        self.frames.front_mut()
    }

    /// Is done with the first frame.
    pub(crate) fn pop(&mut self) {
        if let Some(parcel) = self.frames.pop_front() {
            self.recycle(parcel);
        }
    }

    pub(super) fn clear(&mut self) {
        while !self.is_empty() {
            self.pop();
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    pub(super) fn is_full(&self) -> bool {
        self.frames.len() >= QUEUE
    }

    pub(super) fn len(&self) -> usize {
        self.frames.len()
    }

    /// To how many the frames go.
    #[cfg(feature = "tokio")]
    pub(super) fn receivers(&self) -> usize {
        self.frames.iter().map(|parcel| parcel.to.len()).sum()
    }

    /// Of the frames after the first `kept` ones, keeps those that this one gets; gives how many.
    pub(super) fn keep_for(&mut self, there: Peer, kept: usize) -> usize {
        let mut place = kept;
        while let Some(parcel) = self.frames.get(place) {
            if parcel.to.contains(&there) {
                place += 1;
            } else if let Some(parcel) = self.frames.remove(place) {
                self.recycle(parcel);
            }
        }
        place - kept
    }

    /// Lets something write the frames, as many as go into one call; gives what it gives.
    pub(super) fn write<R>(&self, write: impl FnOnce(&[IoSlice<'_>]) -> R) -> R {
        if let (Some(only), 1) = (self.frames.front(), self.frames.len()) {
            return write(&[IoSlice::new(only.bytes())]);
        }
        let mut slices = [IoSlice::new(&[]); QUEUE];
        let count = self.frames.len().min(QUEUE);
        for (slice, parcel) in slices.iter_mut().zip(&self.frames) {
            *slice = IoSlice::new(parcel.bytes());
        }
        write(slices.get(..count).unwrap_or_default())
    }

    /// Says how many bytes were written; gives how many frames are written to their ends.
    pub(super) fn advance(&mut self, mut count: usize) -> usize {
        let before = self.frames.len();
        while let Some(parcel) = self.frames.front_mut() {
            let length = parcel.bytes().len();
            parcel.start += length.min(count);
            if count < length {
                break;
            }
            count -= length;
            self.pop();
        }
        before - self.frames.len()
    }
}

impl Parcel {
    fn new() -> Self {
        Self { buffer: Box::new([0; MAX_FRAME]), start: 0, end: 0, carries_key: false, to: Vec::new() }
    }

    /// What is still to be sent.
    pub(crate) fn bytes(&self) -> &[u8] {
        self.buffer.get(self.start..self.end).unwrap_or_default()
    }

    fn clear(&mut self) {
        self.wipe_key();
        (self.start, self.end, self.carries_key) = (0, 0, false);
        self.to.clear();
    }

    fn wipe_key(&mut self) {
        if self.carries_key {
            wipe(&mut self.buffer[..]);
        }
    }
}

impl Drop for Parcel {
    fn drop(&mut self) {
        self.wipe_key();
    }
}

/// The bytes are left out: they may be a key.
impl fmt::Debug for Parcel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Parcel").field("length", &self.bytes().len()).field("to", &self.to).finish_non_exhaustive()
    }
}
