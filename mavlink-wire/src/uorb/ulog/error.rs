//! Why a file cannot be read as a log.

use core::fmt;

/// Why [`Log::new`](super::Log::new) refuses a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LogError {
    /// The file does not begin as a ULog does.
    NotALog,
    /// The log needs a reader that knows more: of its incompatible flags these, byte and bits, are unknown.
    Incompatible {
        /// Index of the byte, 0 to 7.
        byte: u8,
        /// The unknown bits of it.
        bits: u8,
    },
}

impl fmt::Display for LogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotALog => f.write_str("not a ULog file: it does not begin with its magic bytes"),
            Self::Incompatible { byte, bits } => {
                write!(
                    f,
                    "this log has features that are not known here: incompatible flags {bits:#04x} in byte {byte}"
                )
            }
        }
    }
}

impl core::error::Error for LogError {}
