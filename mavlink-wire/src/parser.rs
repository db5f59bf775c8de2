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

/// A frame, and where it lies: at the end of the bytes of the input that were used, or of those that were held.
pub(crate) struct Found {
    header: Header,
    facts: Facts,
    held: bool,
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
        let before = *input;
        let found = self.find(input)?;
        let used = before.len() - input.len();
        Some(self.frame(found, before.get(..used).unwrap_or_default()))
    }

    /// The frames behind an unfinished one: call it when the stream has ended, or paused for long, until it gives `None`.
    ///
    /// A damaged byte can look like the start of a long frame, which then waits for bytes that do not come. This gives it
    /// up and searches what was waiting with it. What comes afterwards is a new stream.
    pub fn finish(&mut self) -> Option<Frame<'_>> {
        let found = self.find_at_end()?;
        Some(self.frame(found, &[]))
    }

    /// What was found since the parser was made.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.search.statistics
    }

    /// [`next`](Self::next) without the borrow, for those who own the input as well.
    #[inline]
    pub(crate) fn find(&mut self, input: &mut &[u8]) -> Option<Found> {
        if !self.held.is_empty() {
            if let Some(found) = self.resume(input, false) {
                return Some(found);
            }
            if !self.held.is_empty() {
                return None;
            }
        }
        loop {
            match self.search.look(input, false) {
                Sight::Frame(header, facts) => {
                    skip(input, header.frame_length());
                    return Some(Found { header, facts, held: false });
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

    /// [`finish`](Self::finish) without the borrow.
    pub(crate) fn find_at_end(&mut self) -> Option<Found> {
        let found = self.resume(&mut &[][..], true);
        if found.is_none() {
            self.search.restart();
        }
        found
    }

    /// The frame that was found last; `used` are the bytes that the input lost to it.
    #[inline]
    pub(crate) fn frame<'s>(&'s self, found: Found, used: &'s [u8]) -> Frame<'s> {
        let bytes = if found.held { self.held.released() } else { used };
        let start = bytes.len().saturating_sub(found.header.frame_length());
        Frame::with_facts(bytes.get(start..).unwrap_or_default(), found.header, found.facts)
    }

    /// Searches the held bytes for a frame, which may end in `input`. Of `input`, only what belongs to that frame is
    /// used, so that the search returns to it, and to whole chunks, as soon as no earlier byte is left.
    fn resume(&mut self, input: &mut &[u8], at_end: bool) -> Option<Found> {
        if !at_end && self.held.length() + input.len() < self.needed {
            self.wait(self.needed, input);
            return None;
        }
        let mut borrowed = 0;
        while !self.held.is_empty() {
            match self.search.look(self.held.with_borrowed(borrowed), at_end) {
                Sight::Frame(header, facts) => {
                    self.held.release(header.frame_length(), input);
                    self.needed = 0;
                    return Some(Found { header, facts, held: true });
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

fn skip(input: &mut &[u8], count: usize) {
    *input = input.get(count..).unwrap_or_default();
}
