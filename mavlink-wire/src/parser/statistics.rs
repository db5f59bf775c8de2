//! What a parser counts.

/// What a [`Parser`](crate::Parser) found so far, and what it could make nothing of.
///
/// Frames that never arrived are not seen here: [`Losses`](crate::Losses) counts them by their numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub struct Statistics {
    /// Frames handed over, the unverified ones among them.
    pub frames: u64,
    /// Frames of messages that the table does not have.
    pub unverified: u64,
    /// Frames whose checksum was wrong: damaged, or of a message that the sender defines otherwise.
    ///
    /// A start of a frame inside of one that was counted is not counted again. Garbage counts, too, where it looks like
    /// the start of a frame.
    pub bad_checksums: u64,
    /// Bytes that belong to no frame that was handed over: garbage, damaged frames, the times of a log.
    pub skipped_bytes: u64,
}

impl Statistics {
    /// Nothing so far.
    pub(crate) const NONE: Self = Self { frames: 0, unverified: 0, bad_checksums: 0, skipped_bytes: 0 };

    /// Of two parsers together.
    #[cfg(feature = "std")]
    pub(crate) const fn plus(self, other: Self) -> Self {
        Self {
            frames: self.frames + other.frames,
            unverified: self.unverified + other.unverified,
            bad_checksums: self.bad_checksums + other.bad_checksums,
            skipped_bytes: self.skipped_bytes + other.skipped_bytes,
        }
    }
}
