//! Log files of ground stations: a time and a frame, again and again.
//!
//! A `.tlog`, as MAVProxy, Mission Planner and QGroundControl write it, is a Unix time in µs, eight bytes with the highest first,
//! and the frame as it came, without anything around (pymavlink: `mavutil.mavlogfile`). [`entries`] reads one that is in
//! memory, and [`encode`] makes entries, without std. With the feature `std` there are readers and writers of files:
//!
#![cfg_attr(feature = "std", doc = "```")]
#![cfg_attr(not(feature = "std"), doc = "```ignore")]
//! # use mavlink_wire::{Frame, MessageInfo, Table};
//! # const INFO: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
//! # static TABLE: Table<'static> = Table::of(&[INFO]);
//! # let bytes = [0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
//! # let frame = Frame::parse(&bytes, &TABLE)?;
//! # let mut file = Vec::new();
//! use mavlink_wire::tlog::{Reader, Writer};
//!
//! let mut writer = Writer::new(&mut file);
//! writer.write(1_700_000_000_000_000, &frame)?;
//!
//! let mut reader = Reader::new(&file[..], &TABLE);
//! while let Some(entry) = reader.read()? {
//!     let time = entry.time_us.map_or_else(|| "?".into(), |us| (us as f64 / 1e6).to_string());
//!     println!("{time} s: message {}", entry.frame.message_id());
//! #   assert_eq!((entry.time_us, entry.frame), (Some(1_700_000_000_000_000), frame));
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Damage
//!
//! Where there is no entry, readers go on with the next byte. A verified frame is found wherever it is, an unverified one only
//! behind a plausible time: one that is within a day of the time before. Of a frame behind damage the time may be damaged
//! as well; if it is not plausible, the time before is given, or none where there is none before. An entry that is cut off at
//! the end is skipped.
//!
//! A file of frames without times is no log: read it by a [`Parser`](crate::Parser).

#[cfg(feature = "std")]
mod reader;
pub mod salvage;
mod scan;
#[cfg(feature = "std")]
mod writer;

#[cfg(feature = "std")]
pub use reader::Reader;
#[cfg(feature = "std")]
pub use writer::Writer;

use crate::{Frame, FrameBuf, MAX_FRAME, Table};
use scan::{Scan, Sight};

/// Bytes of a time.
const TIME: usize = 8;

/// Microseconds of a day: so far from the time before, a time is plausible.
const DAY_US: u64 = 24 * 60 * 60 * 1_000_000;

/// Times that are plausible without one before: the years 2000 to 2099.
pub(crate) const CENTURY_US: core::ops::Range<u64> = 946_684_800_000_000..4_102_444_800_000_000;

/// Bytes of the longest entry.
pub const MAX_ENTRY: usize = TIME + MAX_FRAME;

/// A frame of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Entry<'b> {
    /// When it was received: Unix time in µs, as the clock of the ground station had it. `None` if that is not known, because
    /// the log begins with damage.
    pub time_us: Option<u64>,
    /// What was received.
    pub frame: Frame<'b>,
    /// Bytes between the entry before and this one, which belong to none.
    pub skipped: u64,
}

/// Reads a log that is in memory. The frames are checked against this table, like those of a [`Parser`](crate::Parser).
#[must_use]
pub const fn entries<'b, 't>(log: &'b [u8], table: &'t Table<'t>) -> Entries<'b, 't> {
    Entries { rest: log, scan: Scan::new(table) }
}

/// The entries of a log that is in memory: made by [`entries`].
#[derive(Clone, Debug)]
pub struct Entries<'b, 't> {
    rest: &'b [u8],
    scan: Scan<'t>,
}

impl Entries<'_, '_> {
    /// Bytes so far that belong to no entry.
    #[must_use]
    pub fn skipped_bytes(&self) -> u64 {
        self.scan.skipped_bytes()
    }
}

impl<'b> Iterator for Entries<'b, '_> {
    type Item = Entry<'b>;

    fn next(&mut self) -> Option<Entry<'b>> {
        while !self.rest.is_empty() {
            let (used, entry) = match self.scan.look(self.rest, true, |_| ()) {
                Sight::Entry(entry) => (TIME + entry.frame.bytes().len(), Some(entry)),
                Sight::Nothing { passed } => (passed, None),
                Sight::Unfinished => (self.rest.len(), None),
            };
            self.rest = self.rest.get(used..).unwrap_or_default();
            if entry.is_some() {
                return entry;
            }
        }
        None
    }
}

/// Makes an entry. As the MAVLink guide asks of logs ("Message Signing"), a signature is taken away, and a frame that carries
/// a [key](Frame::carries_key) is left out: that gives `None`.
#[must_use]
pub fn encode<'b>(time_us: u64, frame: &Frame<'_>, buffer: &'b mut [u8; MAX_ENTRY]) -> Option<&'b [u8]> {
    if frame.carries_key() {
        return None;
    }
    let mut unsigned = FrameBuf::from(*frame);
    unsigned.strip_signature();
    let bytes = time_us.to_be_bytes().into_iter().chain(unsigned.bytes().iter().copied());
    let length = buffer.iter_mut().zip(bytes).map(|(to, from)| *to = from).count();
    buffer.get(..length)
}
