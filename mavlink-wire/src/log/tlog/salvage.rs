//! What is left in the `.mavlink` logs of AutoQuad's QGroundControl.
//!
//! They look like tlogs, but since December 2012 their times have the lowest byte first, and every frame lacks its last eight
//! bytes: the checksum, and the end of the payload (`MAVLinkProtocol.cc`: the buffer is cut by the size of the time). So
//! nothing in them can be verified, and no parser finds a frame. What is there can still be read:
//!
//! ```
//! # use mavlink_wire::{MessageInfo, Table};
//! # const INFO: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
//! # static TABLE: Table<'static> = Table::of(&[INFO]);
//! # let log = [0, 0x80, 0x3c, 0xba, 0x7f, 0xed, 4, 0, 0xfe, 9, 0, 1, 1, 0, 1, 2, 3];
//! use mavlink_wire::tlog::salvage::records;
//!
//! for record in records(&log, &TABLE) {
//!     println!("{} µs: message {:?} {:?}, {} bytes missing", record.time_us, record.message_id(), record.payload(), record.missing());
//! #   assert_eq!((record.message_id(), record.payload(), record.missing()), (Some(0), &[1, 2, 3][..], 6));
//! }
//! # assert_eq!(records(&log, &TABLE).count(), 1);
//! ```
//!
//! Before a payload is decoded, look up what its last bytes are: missing bytes read as zero.
//!
//! # What is taken for a record
//!
//! Eight bytes that are a time of the years 2012 to 2099, lowest first, and the start of a MAVLink 1 frame, of which as much is
//! there as its length says; and, because that proves little, also
//!
//! - a time within a day of the record before, and a message of the table, with the length that it has; or
//! - behind it another such time, within a day of this one, and the start of a frame; or
//! - a time within a day of the record before, and the end of the log.
//!
//! In the last two cases none of the first may start in it: its length is damaged then, and reaches over other records.
//!
//! Everything else is skipped, byte by byte. Frames of fewer than two bytes of payload are so short here that they have no
//! length any more: they are skipped, too.

use super::{DAY_US, TIME};
use crate::header::STX_V1;
use crate::seek;
use crate::{ComponentId, SystemId, Table};

/// Times that may be: the years 2012 to 2099.
const YEARS_US: core::ops::Range<u64> = 1_325_376_000_000_000..4_102_444_800_000_000;

/// Bytes of the header of a MAVLink 1 frame.
const HEADER: usize = 6;

/// Bytes that are missing of every frame, of which two were the checksum.
const MISSING: usize = 8;

/// Reads such a log. The table says which messages there may be, and how long they are.
#[must_use]
pub const fn records<'b, 't>(log: &'b [u8], table: &'t Table<'t>) -> Records<'b, 't> {
    Records { rest: log, table, time_us: None, skipped: 0, skipped_before: 0 }
}

/// What is left of a message, not verified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Record<'b> {
    /// When it was received: Unix time in µs, as the clock of the ground station had it.
    pub time_us: u64,
    /// Bytes between the record before and this one, which belong to none.
    pub skipped: u64,
    frame: &'b [u8],
}

/// The records of a log: made by [`records`].
#[derive(Clone, Debug)]
pub struct Records<'b, 't> {
    rest: &'b [u8],
    table: &'t Table<'t>,
    /// Of the record before.
    time_us: Option<u64>,
    /// Bytes skipped since the record before, and before it.
    skipped: u64,
    skipped_before: u64,
}

impl<'b> Record<'b> {
    /// Number of the frame; `None` if it is not there, as in frames of up to two bytes of payload.
    #[must_use]
    pub fn sequence(&self) -> Option<u8> {
        self.frame.get(2).copied()
    }

    /// Id of the sending system; `None` if it is not there, as in frames of up to three bytes of payload.
    #[must_use]
    pub fn system_id(&self) -> Option<SystemId> {
        self.frame.get(3).map(|&id| SystemId::from_u8(id))
    }

    /// Id of the sending component; `None` if it is not there, as in frames of up to four bytes of payload.
    #[must_use]
    pub fn component_id(&self) -> Option<ComponentId> {
        self.frame.get(4).map(|&id| ComponentId::from_u8(id))
    }

    /// Id of the message; `None` if it is not there, as in frames of up to five bytes of payload.
    #[must_use]
    pub fn message_id(&self) -> Option<u32> {
        self.frame.get(5).map(|&id| id.into())
    }

    /// The payload, as far as it is there.
    #[must_use]
    pub fn payload(&self) -> &'b [u8] {
        self.frame.get(HEADER..).unwrap_or_default()
    }

    /// How many bytes are missing at the end of the payload: six, or all if it had fewer.
    #[must_use]
    pub fn missing(&self) -> usize {
        self.frame.get(1).map_or(0, |&length| usize::from(length) - self.payload().len())
    }
}

impl<'b> Iterator for Records<'b, '_> {
    type Item = Record<'b>;

    fn next(&mut self) -> Option<Record<'b>> {
        while !self.rest.is_empty() {
            // No time and start of a frame, no record.
            let others = self.rest.get(TIME..).unwrap_or_default();
            self.skip(seek::first(others, |byte| byte == STX_V1).unwrap_or(self.rest.len()));
            if let Some((time_us, frame)) = self.record() {
                self.rest = self.rest.get(TIME + frame.len()..).unwrap_or_default();
                self.time_us = Some(time_us);
                let skipped = core::mem::take(&mut self.skipped);
                self.skipped_before += skipped;
                return Some(Record { time_us, skipped, frame });
            }
            self.skip(1);
        }
        None
    }
}

impl Records<'_, '_> {
    /// Bytes so far that belong to no record.
    #[must_use]
    pub fn skipped_bytes(&self) -> u64 {
        self.skipped_before + self.skipped
    }

    fn skip(&mut self, count: usize) {
        let count = count.min(self.rest.len());
        self.rest = self.rest.get(count..).unwrap_or_default();
        self.skipped += count as u64;
    }
}

impl<'b> Records<'b, '_> {
    /// Time and frame at this place, if it is to be believed.
    fn record(&self) -> Option<(u64, &'b [u8])> {
        let (time_us, frame, behind) = split(self.rest)?;
        let near = self.time_us.is_none_or(|before| is_near(before, time_us));
        let stands = || match start(behind) {
            Some((next_us, _)) => is_near(time_us, next_us),
            None => near && behind.is_empty(),
        };
        let believed = near && self.is_known(frame) || stands() && !self.carries_known(time_us, frame);
        believed.then_some((time_us, frame))
    }

    /// Whether a frame is of a message of the table, and as long.
    fn is_known(&self, frame: &[u8]) -> bool {
        let (Some(&length), Some(&id)) = (frame.get(1), frame.get(HEADER - 1)) else { return false };
        self.table.get(id.into()).is_some_and(|info| info.len_v1 == length)
    }

    /// Whether a known record starts inside of the record at this place.
    fn carries_known(&self, time_us: u64, frame: &[u8]) -> bool {
        let mut inside = (1..TIME + frame.len()).filter_map(|at| split(self.rest.get(at..)?));
        inside.any(|(inner_us, inner, _)| is_near(time_us, inner_us) && self.is_known(inner))
    }
}

fn is_near(time_us: u64, other_us: u64) -> bool {
    time_us.abs_diff(other_us) <= DAY_US
}

/// The time at the start of these bytes, as much of the frame as was written, and what follows.
fn split(bytes: &[u8]) -> Option<(u64, &[u8], &[u8])> {
    let (time_us, frame) = start(bytes)?;
    let written = (usize::from(*frame.get(1)?) + HEADER + 2).checked_sub(MISSING)?;
    let (frame, behind) = frame.split_at_checked(written)?;
    (frame.len() >= 2).then_some((time_us, frame, behind))
}

/// The time at the start of these bytes and what follows it, if it may be a time, and a frame may follow.
fn start(bytes: &[u8]) -> Option<(u64, &[u8])> {
    let (time, frame) = bytes.split_first_chunk::<TIME>()?;
    let time_us = u64::from_le_bytes(*time);
    (YEARS_US.contains(&time_us) && frame.first() == Some(&STX_V1)).then_some((time_us, frame))
}
