//! What generated uORB messages implement.

use super::{Field, Place};

/// A uORB message, made by `mavgen` of its `.msg` files.
pub trait Topic: Copy + 'static {
    /// Name of the message, `EscStatus`.
    const NAME: &'static str;

    /// The topics that carry it, `["esc_status"]`: what logs call it. The first is the one that it is named after.
    const TOPICS: &'static [&'static str];

    /// Its fields, for binding by name.
    const FIELDS: &'static [Field];

    /// A value of which nothing is known: what a log does not have is read as this.
    const UNKNOWN: Self;

    /// As many places as [`places`](super::places) says: `[Place; N]`.
    type Places: Copy + AsRef<[Place]> + AsMut<[Place]> + 'static;

    /// Places of a log that has none of the fields.
    const ABSENT: Self::Places;

    /// Reads a record by its places: first those of the fields, then those of the fields of each nested message. What is not
    /// there is [`UNKNOWN`](Self::UNKNOWN).
    fn read(places: &[Place], record: &[u8]) -> Self;
}
