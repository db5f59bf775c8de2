//! What the readers share: a parser, and the bytes that it has still to see.

use super::chunk::Chunk;
use crate::frame::{Outline, SETUP_SIGNING};
use crate::{Frame, MAX_FRAME, Parser, Statistics, Table};

/// Bytes without a frame after which a call returns. Counted by `u32`: a `usize` may have 16 bits.
pub(crate) const ENOUGH: u32 = 65_536;

/// A parser and its input, in a buffer `B`.
#[derive(Clone, Debug)]
pub(crate) struct Incoming<'t, B> {
    parser: Parser<'t>,
    chunk: Chunk<B>,
    ended: bool,
}

/// A frame that was found, and where: a frame itself could not be kept while the search may go on.
#[derive(Clone, Copy)]
pub(crate) struct Found {
    outline: Outline,
    /// Held by the parser, else in the input; at the end of what was used of either.
    held: bool,
}

impl Found {
    /// The parser's next frame, in the input or held.
    pub(crate) fn next(parser: &mut Parser<'_>, input: &mut &[u8], bad_checksum: &mut impl FnMut(u32)) -> Option<Self> {
        let all = input.as_ptr_range();
        let frame = parser.next_reporting_bad_checksums(input, bad_checksum)?;
        Some(Self { outline: Outline::of(&frame), held: !all.contains(&frame.bytes().as_ptr()) })
    }

    /// The next frame in what waits for bytes that do not come.
    pub(crate) fn finish(parser: &mut Parser<'_>, bad_checksum: &mut impl FnMut(u32)) -> Option<Self> {
        let frame = parser.finish_reporting_bad_checksums(bad_checksum)?;
        Some(Self { outline: Outline::of(&frame), held: true })
    }

    /// Whether the frame [carries a key](Frame::carries_key).
    pub(crate) fn carries_key(&self) -> bool {
        self.outline.message_id() == SETUP_SIGNING
    }

    /// The frame, if it was the parser's last one; `used` is what is used of the input.
    pub(crate) fn frame<'f>(&self, parser: &'f Parser<'_>, used: &'f [u8]) -> Frame<'f> {
        self.outline.at_end_of(if self.held { parser.released(MAX_FRAME) } else { used })
    }
}

impl<'t, const N: usize> Incoming<'t, [u8; N]> {
    pub(crate) const fn new(table: &'t Table<'t>) -> Self {
        const { assert!(N > 0, "nothing can be read into an empty buffer") }
        Self { parser: Parser::new(table), chunk: Chunk::new([0; N]), ended: false }
    }
}

impl<B> Incoming<'_, B> {
    pub(crate) fn statistics(&self) -> Statistics {
        self.parser.statistics()
    }
}

impl<B: AsRef<[u8]> + AsMut<[u8]>> Incoming<'_, B> {
    /// The next frame in what was read; `None` when more has to be read, or nothing comes any more. `bad_checksum` is
    /// told the message of each frame that is counted as damaged.
    pub(crate) fn find(&mut self, bad_checksum: &mut impl FnMut(u32)) -> Option<Found> {
        let found = self.next(bad_checksum);
        if found.is_none() && self.ended { Found::finish(&mut self.parser, bad_checksum) } else { found }
    }

    /// The next frame in what was read, and then in what waits for bytes that do not come.
    pub(crate) fn finish(&mut self, bad_checksum: &mut impl FnMut(u32)) -> Option<Found> {
        self.next(bad_checksum).or_else(|| Found::finish(&mut self.parser, bad_checksum))
    }

    fn next(&mut self, bad_checksum: &mut impl FnMut(u32)) -> Option<Found> {
        self.chunk.wipe_used_key();
        self.chunk.find(&mut self.parser, bad_checksum)
    }

    /// The frame that was found last.
    pub(crate) fn frame(&self, found: &Found) -> Frame<'_> {
        found.frame(&self.parser, self.chunk.used())
    }

    /// Where to read to, when nothing is found any more.
    pub(crate) fn space(&mut self) -> &mut [u8] {
        self.chunk.space()
    }

    /// Takes what was read, which is the end of the stream if it is nothing. Gives back how many bytes there are now.
    pub(crate) fn fill(&mut self, count: usize) -> u32 {
        self.ended = count == 0;
        self.chunk.fill(count).try_into().unwrap_or(ENOUGH)
    }

    /// Whether the stream has ended. It is said once: a file may grow.
    pub(crate) fn take_end(&mut self) -> bool {
        core::mem::take(&mut self.ended)
    }
}
