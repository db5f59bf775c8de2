//! Finds the frames in a stream of bytes that may be cut anywhere and damaged anywhere.

mod held;
mod losses;
pub(crate) mod prefixes;
mod search;
mod sightings;
mod statistics;
pub(crate) mod table;
pub(crate) mod work;

pub use losses::{Arrival, Losses, Received};
pub use statistics::Statistics;
pub use table::Table;

use held::Held;
use search::{Search, Step};

use crate::Frame;
use crate::frame::Facts;
use crate::frame::key::WIPES;
use crate::header::Header;

/// Finds frames in a stream of bytes, wherever it is cut into chunks.
///
/// What is found depends on the bytes alone, not on the cuts. After a wrong checksum or a false start the search goes on
/// with the next byte, so that a damaged frame costs only itself. The work for a byte is bounded, whatever the bytes are. With
/// the feature `fast-crc`, frames that lie within one chunk are not copied. A parser takes some 900 bytes of memory, or 1,300
/// with `fast-crc`.
///
/// ```
/// use mavlink_wire::{Parser, Table};
///
/// let mut parser = Parser::new(const { &Table::of(&[]) });
/// let mut chunk: &[u8] = &[0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
/// while let Some(frame) = parser.next(&mut chunk) {
///     assert_eq!((frame.message_id(), frame.crc_extra(), frame.payload().len()), (0, 50, 9));
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
/// - so it is elsewhere, as behind damage, if the parser knows its message: if the last two frames of it that stood behind
///   another frame, or at the beginning, had the same `crc_extra` as this one. That is remembered for the eight messages that
///   were seen last;
/// - else it is handed over only if no known frame starts inside of it. That may be one that ends behind it, by its header:
///   then another one has to start directly behind.
///
/// So the first frames of an unknown message may be lost if they stand behind damage and carry known ones, which are handed
/// over then. And who sends frames that nobody signs can make a parser believe in any message.
///
/// A frame waits for ten more bytes at most, or for [`finish`](Self::finish), and only if bytes in it look like the start of
/// a known one.
// Small fields lie in front: that makes the code smaller which reaches for them.
#[derive(Clone, Debug)]
#[repr(C)]
pub struct Parser<'t> {
    /// With fewer held bytes there is nothing new to find out.
    needed: usize,
    held: Held,
    search: Search<'t>,
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
        self.next_reporting_bad_checksums(input, not_told)
    }

    /// The next frame, as [`next`](Self::next) gives it. `bad_checksum` is told the message of each frame that
    /// [`Statistics::bad_checksums`] counts: if it is often the same one, both sides define it otherwise.
    ///
    /// ```
    /// use mavlink_wire::{Parser, Table};
    ///
    /// # let mut parser = Parser::new(const { &Table::of(&[]) });
    /// # let mut chunk: &[u8] = &[0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x44];
    /// let mut suspect = None;
    /// while let Some(frame) = parser.next_reporting_bad_checksums(&mut chunk, |id| suspect = Some(id)) {
    ///     println!("message {}", frame.message_id());
    /// }
    /// # assert_eq!(suspect, Some(0));
    /// ```
    #[inline]
    pub fn next_reporting_bad_checksums<'s, 'i: 's>(
        &'s mut self,
        input: &mut &'i [u8],
        mut bad_checksum: impl FnMut(u32),
    ) -> Option<Frame<'s>> {
        self.wipe_used_key();
        if IN_PLACE && self.held.is_empty() {
            return self.search_in_place(input, &mut bad_checksum);
        }
        if let Some((header, facts)) = self.resume(input, false, &mut bad_checksum) {
            return Some(self.held_frame(header, facts));
        }
        if IN_PLACE && self.held.is_empty() { self.search_in_place(input, &mut bad_checksum) } else { None }
    }

    /// Searches `input` as it lies there, when nothing is held.
    #[inline]
    fn search_in_place<'i>(&mut self, input: &mut &'i [u8], bad_checksum: &mut impl FnMut(u32)) -> Option<Frame<'i>> {
        loop {
            let bytes = *input;
            match self.search.look(bytes, false, bad_checksum) {
                Ok((header, facts)) => {
                    let (frame, rest) = bytes.split_at_checked(header.frame_length()).unwrap_or_default();
                    *input = rest;
                    return Some(Frame::with_facts(frame, header, facts));
                }
                Err(Step::Wait { needed }) => {
                    self.needed = needed;
                    self.held.fill(needed, input, false);
                    return None;
                }
                Err(Step::Pass { count }) => *input = bytes.get(count..).unwrap_or_default(),
            }
        }
    }

    /// The frames behind an unfinished one: call it when the stream has ended, or paused for long, until it gives `None`.
    ///
    /// A damaged byte can look like the start of a long frame, which then waits for bytes that do not come. This gives it
    /// up and searches what was waiting with it. What comes afterwards is a new stream.
    pub fn finish(&mut self) -> Option<Frame<'_>> {
        self.finish_reporting_bad_checksums(not_told)
    }

    /// The frames behind an unfinished one, as [`finish`](Self::finish) gives them. `bad_checksum` is told the message of each
    /// frame that [`Statistics::bad_checksums`] counts.
    pub fn finish_reporting_bad_checksums(&mut self, mut bad_checksum: impl FnMut(u32)) -> Option<Frame<'_>> {
        self.wipe_used_key();
        let found = self.resume(&mut &[][..], true, &mut bad_checksum);
        if found.is_none() {
            self.search.restart();
        }
        found.map(|(header, facts)| self.held_frame(header, facts))
    }

    /// Overwrites the key that was handed over last.
    #[inline]
    fn wipe_used_key(&mut self) {
        if WIPES && core::mem::take(&mut self.search.found_key) {
            self.held.wipe_used();
        }
    }

    /// Drops what waits for more bytes, unlike [`finish`](Self::finish), which searches it, and forgets what is known about other
    /// messages: for a link that was opened again. The [`statistics`](Self::statistics) go on, and leave it out.
    pub fn reset(&mut self) {
        self.held.release(self.held.bytes().len());
        self.held.wipe_used();
        self.search.reset();
        self.needed = 0;
    }

    /// What was found since the parser was made.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.search.statistics
    }

    /// Whether bytes are held that wait for the rest of a frame.
    #[cfg(feature = "std")]
    pub(crate) fn is_waiting(&self) -> bool {
        !self.held.is_empty()
    }

    /// The last of the bytes that were held and are used, so many of them; a held frame that was handed over ends with them.
    pub(crate) fn released(&self, count: usize) -> &[u8] {
        self.held.released(count)
    }

    /// The frame that was found last, among the held bytes.
    fn held_frame(&self, header: Header, facts: Facts) -> Frame<'_> {
        Frame::with_facts(self.released(header.frame_length()), header, facts)
    }

    /// Searches the held bytes for a frame, and takes more of `input` as it goes on.
    fn resume(
        &mut self,
        input: &mut &[u8],
        at_end: bool,
        bad_checksum: &mut impl FnMut(u32),
    ) -> Option<(Header, Facts)> {
        let chunk = *input;
        while self.is_to_resume(input, at_end) {
            self.needed = 1;
            let found = self.search.look(self.held.bytes(), at_end, bad_checksum);
            match &found {
                Ok((header, _)) => self.held.release(header.frame_length()),
                Err(Step::Wait { needed }) => self.needed = *needed,
                Err(Step::Pass { count }) => self.held.release(*count),
            }
            if IN_PLACE {
                self.held.give_back(chunk, input);
            }
            if let Ok(found) = found {
                return Some(found);
            }
        }
        None
    }

    /// Whether there are held bytes to be searched, enough of them. What is taken of `input` is no more than that, so that the
    /// search soon goes on in place; or as much as there is room for, where many frames seem to start and few do.
    #[cfg_attr(feature = "fast-crc", inline(always))]
    fn is_to_resume(&mut self, input: &mut &[u8], at_end: bool) -> bool {
        if at_end || IN_PLACE && self.held.is_empty() {
            !self.held.is_empty()
        } else {
            self.held.fill(self.needed, input, !IN_PLACE || self.search.is_contested())
        }
    }
}

/// Whether frames that lie within a chunk are left there. It takes a second search loop, and so is bought with flash.
const IN_PLACE: bool = cfg!(feature = "fast-crc");

/// For those who need not know of which message a bad checksum was. One function, because each closure would have a parser
/// compiled for itself.
pub(crate) fn not_told(_: u32) {}
