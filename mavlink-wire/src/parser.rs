//! Finds the frames in a stream of bytes that may be cut anywhere and damaged anywhere.

use memchr::memchr2;

use crate::frame::Facts;
use crate::header::{Header, STX_V1, STX_V2};
use crate::{Frame, FrameError, MAX_FRAME, Table, zero_extended};

/// Finds frames in a stream of bytes, wherever it is cut into chunks.
///
/// What is found depends on the bytes alone, not on the cuts. After a wrong checksum or a false start the search goes on
/// with the next byte, so that a damaged frame costs only itself. Frames that lie within one chunk are not copied.
///
/// A frame of an unknown message is handed over, unverified, wherever some `crc_extra` explains its checksum. Of the places
/// in damaged bytes that look like the start of one, one in 256 passes, and takes known frames that lie in it along.
///
/// ```
/// use mavlink_wire::{Parser, Table};
///
/// let mut parser = Parser::new(const { &Table::of(&[]) });
/// let mut chunk: &[u8] = &[0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
/// while let Some(frame) = parser.next(&mut chunk) {
///     assert_eq!((frame.id(), frame.crc_extra(), frame.payload().len()), (0, 50, 9));
/// }
/// assert!(chunk.is_empty());
/// ```
#[derive(Clone, Debug)]
pub struct Parser<'t> {
    table: &'t Table<'t>,
    /// Bytes of earlier chunks: first those of the frame that was handed out last, then the beginning of another.
    held: [u8; MAX_FRAME],
    length: usize,
    handed_out: usize,
}

impl<'t> Parser<'t> {
    /// A parser that verifies the messages of this table, and hands over others unverified.
    #[must_use]
    pub const fn new(table: &'t Table<'t>) -> Self {
        Self { table, held: [0; MAX_FRAME], length: 0, handed_out: 0 }
    }

    /// The next frame; `input` moves behind what was used. `None` when `input` is used up: the beginning of a frame at
    /// its end is kept until the next chunk comes.
    #[inline]
    pub fn next<'s, 'i: 's>(&'s mut self, input: &mut &'i [u8]) -> Option<Frame<'s>> {
        if self.length > 0 {
            if let Some((header, facts)) = self.resume(input, false) {
                return Some(Frame::with_facts(&self.held, header, facts));
            }
            if self.length > 0 {
                return None;
            }
        }
        loop {
            match Frame::parse(input, self.table) {
                Ok(frame) => {
                    skip(input, frame.bytes().len());
                    return Some(frame);
                }
                Err(FrameError::Incomplete { .. }) => {
                    self.hold(core::mem::take(input));
                    return None;
                }
                Err(error) => skip(input, to_next_start(input, error)),
            }
        }
    }

    /// The frames behind an unfinished one: call it when the stream has ended, or paused for long, until it gives `None`.
    ///
    /// A damaged byte can look like the start of a long frame, which then waits for bytes that do not come. This gives it
    /// up and searches what was waiting with it.
    pub fn finish(&mut self) -> Option<Frame<'_>> {
        let (header, facts) = self.resume(&mut &[][..], true)?;
        Some(Frame::with_facts(&self.held, header, facts))
    }

    /// Searches the held bytes for a frame, which may end in `input`. Of `input`, only what belongs to that frame is
    /// used, so that the search returns to it, and to whole chunks, as soon as no earlier byte is left.
    fn resume(&mut self, input: &mut &[u8], at_end: bool) -> Option<(Header, Facts)> {
        let handed_out = core::mem::take(&mut self.handed_out);
        self.release(handed_out);
        let mut borrowed = 0;
        while self.length > 0 {
            let bytes = self.held.get(..self.length + borrowed).unwrap_or_default();
            match Facts::of(bytes, self.table) {
                Ok((header, facts)) => {
                    self.handed_out = header.frame_length();
                    skip(input, self.handed_out.saturating_sub(self.length));
                    self.length = self.length.max(self.handed_out);
                    return Some((header, facts));
                }
                Err(FrameError::Incomplete { needed }) if !at_end => {
                    borrowed = self.borrow(needed, input);
                    if self.length + borrowed < needed {
                        self.length += borrowed;
                        skip(input, borrowed);
                        return None;
                    }
                }
                Err(error) => {
                    let held = self.held.get(..self.length).unwrap_or_default();
                    self.release(to_next_start(held, error));
                    borrowed = 0;
                }
            }
        }
        None
    }

    /// Puts bytes of `input` behind the held ones, as many as a frame of `needed` bytes lacks; gives their number.
    fn borrow(&mut self, needed: usize, input: &[u8]) -> usize {
        let free = self.held.get_mut(self.length..needed).unwrap_or_default();
        free.iter_mut().zip(input).map(|(to, from)| *to = *from).count()
    }

    /// Keeps the beginning of a frame.
    fn hold(&mut self, bytes: &[u8]) {
        self.held = zero_extended(bytes);
        self.length = bytes.len();
    }

    /// Drops the first held bytes.
    fn release(&mut self, count: usize) {
        if count > 0 {
            let kept = zero_extended(self.held.get(count..self.length).unwrap_or_default());
            self.held = kept;
            self.length = self.length.saturating_sub(count);
        }
    }
}

/// How far it is from the start of something that is no frame to the next byte that may start one.
#[inline]
fn to_next_start(bytes: &[u8], error: FrameError) -> usize {
    match error {
        // The common case while searching: nothing was found out about the first byte but that it starts nothing.
        FrameError::NotStx { .. } => memchr2(STX_V1, STX_V2, bytes).unwrap_or(bytes.len()),
        _ => 1,
    }
}

fn skip(input: &mut &[u8], count: usize) {
    *input = input.get(count..).unwrap_or_default();
}
