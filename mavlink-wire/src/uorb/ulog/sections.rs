//! The parts of a log: what was written first, and what was appended after a crash.

use super::LogError;

/// Magic bytes, a version and a time.
const HEADER: usize = 16;
const MAGIC: &[u8] = b"ULog\x01\x12\x35";

/// Length of the record of flag bits: 8 compatible, 8 incompatible, and three offsets of appended data.
const FLAG_BITS: [u8; 3] = [40, 0, b'B'];
/// The one incompatible flag that is known: data was appended.
const APPENDED: u8 = 1;

/// Iterates over the parts of a file that have records, each of whole records but perhaps for its last.
#[derive(Clone, Debug)]
pub(super) struct Sections<'a> {
    file: &'a [u8],
    at: usize,
    appended: [usize; 3],
}

impl<'a> Sections<'a> {
    pub(super) fn of(file: &'a [u8]) -> Result<Self, LogError> {
        if !file.starts_with(MAGIC) || file.len() < HEADER {
            return Err(LogError::NotALog);
        }
        Ok(Self { file, at: HEADER, appended: appended(file)? })
    }

    /// Time at which the log starts.
    pub(super) fn start(&self) -> u64 {
        self.file.get(8..).and_then(<[u8]>::first_chunk).map_or(0, |bytes| u64::from_le_bytes(*bytes))
    }

    /// Offset in the file of the end of the part that was given last.
    pub(super) const fn offset(&self) -> usize {
        self.at
    }

    /// Whether that part was the last.
    pub(super) const fn is_last(&self) -> bool {
        self.at >= self.file.len()
    }
}

impl<'a> Iterator for Sections<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        if self.is_last() {
            return None;
        }
        let end = self.appended.iter().copied().filter(|at| *at > self.at).fold(self.file.len(), usize::min);
        let section = self.file.get(self.at..end);
        self.at = end;
        section
    }
}

/// Where data was appended; zero where it was not.
fn appended(file: &[u8]) -> Result<[usize; 3], LogError> {
    let mut offsets = [0; 3];
    let Some(flags) = file.get(HEADER..).and_then(|rest| rest.strip_prefix(&FLAG_BITS)) else { return Ok(offsets) };
    let Some((incompatible, rest)) = flags.get(8..40).and_then(<[u8]>::split_first_chunk::<8>) else {
        return Ok(offsets);
    };
    for (byte, bits) in (0..).zip(incompatible) {
        let bits = if byte == 0 { bits & !APPENDED } else { *bits };
        if bits != 0 {
            return Err(LogError::Incompatible { byte, bits });
        }
    }
    if incompatible.first().is_some_and(|bits| bits & APPENDED != 0) {
        for (offset, bytes) in offsets.iter_mut().zip(rest.as_chunks().0) {
            // An offset that does not fit lies behind the end of the file, too.
            *offset = usize::try_from(u64::from_le_bytes(*bytes)).unwrap_or(usize::MAX);
        }
    }
    Ok(offsets)
}
