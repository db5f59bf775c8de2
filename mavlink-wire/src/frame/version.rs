//! The versions of the protocol.

use core::fmt;

/// MAVLink 1 or 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Version {
    /// MAVLink 1: ids up to 255, no extension fields, no signature.
    V1,
    /// MAVLink 2.
    V2,
}

/// `MAVLink 1` or `MAVLink 2`.
impl fmt::Display for Version {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::V1 => "MAVLink 1",
            Self::V2 => "MAVLink 2",
        })
    }
}
