//! Finds the frames in a stream of bytes that may be cut anywhere and damaged anywhere.

mod belief;
mod held;
mod search;

use held::Held;
use search::{Search, Sight};

use crate::frame::Facts;
use crate::header::Header;
use crate::{Frame, Statistics, Table};

/// Finds frames in a stream of bytes, wherever it is cut into chunks.
///
/// What is found depends on the bytes alone, not on the cuts. After a wrong checksum or a false start the search goes on
/// with the next byte, so that a damaged frame costs only itself. Frames that lie within one chunk are not copied. A parser
/// takes some 650 bytes of memory.
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
/// assert_eq!(parser.statistics().unverified, 1);
/// ```
///
/// # Unknown messages
///
/// A frame of a message that the table does not have is handed over, unverified, if some `crc_extra` explains its checksum.
/// Of the places in damaged bytes that look like the start of one, one in 256 passes that. Such a false frame must not take
/// the frames along that lie in it, and a true one may carry a whole frame in its payload (a tunnel, a file transfer), which
/// must not be taken for a frame of this stream. So:
///
/// - behind a frame, or at the beginning of the stream, and directly before the start of another, or at the end, it is
///   handed over whatever it carries;
/// - elsewhere, as behind damage, only if no verified frame starts inside of it. Else that one is handed over.
///
/// If bytes in it look like the start of a known frame, it is handed over as soon as the bytes behind it have decided that,
/// or [`finish`](Self::finish) is called; all others at once.
#[derive(Clone, Debug)]
pub struct Parser<'t> {
    search: Search<'t>,
    held: Held,
    /// With fewer held bytes there is nothing new to find out.
    needed: usize,
}

impl<'t> Parser<'t> {
    /// A parser that verifies the messages of this table, and hands over others unverified.
    #[must_use]
    pub const fn new(table: &'t Table<'t>) -> Self {
        Self { search: Search::new(table), held: Held::EMPTY, needed: 0 }
    }

    /// The next frame; `input` moves behind what was used. `None` when `input` is used up: the beginning of a frame at
    /// its end is kept until the next chunk comes.
    #[inline]
    pub fn next<'s, 'i: 's>(&'s mut self, input: &mut &'i [u8]) -> Option<Frame<'s>> {
        self.next_telling(input, &mut not_told)
    }

    /// The next frame; `bad_checksum` is told the message of each frame that is counted as damaged.
    #[inline]
    pub(crate) fn next_telling<'s, 'i: 's>(
        &'s mut self,
        input: &mut &'i [u8],
        bad_checksum: &mut impl FnMut(u32),
    ) -> Option<Frame<'s>> {
        if !self.held.is_empty() {
            if let Some((header, facts)) = self.resume(input, false, bad_checksum) {
                return Some(self.held_frame(header, facts));
            }
            if !self.held.is_empty() {
                return None;
            }
        }
        loop {
            let bytes = *input;
            match self.search.look(bytes, false, bad_checksum) {
                Sight::Frame(header, facts) => {
                    skip(input, header.frame_length());
                    return Some(Frame::with_facts(bytes, header, facts));
                }
                Sight::Unfinished { needed } => {
                    self.held.reset();
                    self.wait(needed, input);
                    return None;
                }
                Sight::Nothing { passed } => skip(input, passed),
            }
        }
    }

    /// The frames behind an unfinished one: call it when the stream has ended, or paused for long, until it gives `None`.
    ///
    /// A damaged byte can look like the start of a long frame, which then waits for bytes that do not come. This gives it
    /// up and searches what was waiting with it. What comes afterwards is a new stream.
    pub fn finish(&mut self) -> Option<Frame<'_>> {
        self.finish_telling(&mut not_told)
    }

    /// The frames behind an unfinished one; `bad_checksum` is told the message of each frame that is counted as damaged.
    pub(crate) fn finish_telling(&mut self, bad_checksum: &mut impl FnMut(u32)) -> Option<Frame<'_>> {
        let found = self.resume(&mut &[][..], true, bad_checksum);
        if found.is_none() {
            self.search.restart();
        }
        found.map(|(header, facts)| self.held_frame(header, facts))
    }

    /// What was found since the parser was made.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.search.statistics
    }

    /// The bytes that were held and are used; a held frame that was handed over ends with them.
    pub(crate) fn released(&self) -> &[u8] {
        self.held.released()
    }

    /// The frame that was found last, among the held bytes.
    fn held_frame(&self, header: Header, facts: Facts) -> Frame<'_> {
        let released = self.released();
        let start = released.len().saturating_sub(header.frame_length());
        Frame::with_facts(released.get(start..).unwrap_or_default(), header, facts)
    }

    /// Searches the held bytes for a frame, which may end in `input`. Of `input`, only what belongs to that frame is
    /// used, so that the search returns to it, and to whole chunks, as soon as no earlier byte is left.
    fn resume(
        &mut self,
        input: &mut &[u8],
        at_end: bool,
        bad_checksum: &mut impl FnMut(u32),
    ) -> Option<(Header, Facts)> {
        if !at_end && self.held.length() + input.len() < self.needed {
            self.wait(self.needed, input);
            return None;
        }
        let mut borrowed = 0;
        while !self.held.is_empty() {
            match self.search.look(self.held.with_borrowed(borrowed), at_end, bad_checksum) {
                Sight::Frame(header, facts) => {
                    self.held.release(header.frame_length(), input);
                    self.needed = 0;
                    return Some((header, facts));
                }
                Sight::Unfinished { needed } => {
                    borrowed = self.held.borrow(needed, input);
                    if self.held.length() + borrowed < needed {
                        self.wait(needed, input);
                        return None;
                    }
                }
                Sight::Nothing { passed } => {
                    self.held.release(passed, input);
                    borrowed = 0;
                }
            }
        }
        None
    }

    /// Keeps all of `input`, which is not enough.
    fn wait(&mut self, needed: usize, input: &mut &[u8]) {
        self.held.keep(needed, input);
        self.needed = needed;
    }
}

/// For those who need not know of which message a bad checksum was. One function, because each closure would have a parser
/// compiled for itself.
pub(crate) fn not_told(_: u32) {}

fn skip(input: &mut &[u8], count: usize) {
    *input = input.get(count..).unwrap_or_default();
}
