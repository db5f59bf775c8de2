//! `char[N]` fields.

use core::fmt;

use super::wire::Wire;
use crate::TooLong;

/// Text in a fixed field: up to the first NUL, or all `N` bytes. Bytes after a NUL are kept.
///
/// ```
/// use mavlink_wire::Chars;
///
/// let id: Chars<16> = "RC1_MIN".try_into()?;
/// assert_eq!(id, "RC1_MIN");
/// assert_eq!(Chars::<4>::truncated("Grüße"), "Grü");
/// # Ok::<_, mavlink_wire::TooLong>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Chars<const N: usize>(pub [u8; N]);

impl<const N: usize> Chars<N> {
    /// As much of the text as fits, cut between two characters.
    #[must_use]
    pub const fn truncated(text: &str) -> Self {
        let mut length = if text.len() < N { text.len() } else { N };
        while !text.is_char_boundary(length) {
            length -= 1;
        }
        let mut chars = [0; N];
        let mut to: &mut [u8] = &mut chars;
        let (mut from, _) = match text.as_bytes().split_at_checked(length) {
            Some(halves) => halves,
            None => (text.as_bytes(), text.as_bytes()),
        };
        while let ([byte, room @ ..], [next, rest @ ..]) = (to, from) {
            *byte = *next;
            (to, from) = (room, rest);
        }
        Self(chars)
    }

    /// The bytes up to the first NUL.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        self.0.split(|&byte| byte == 0).next().unwrap_or_default()
    }

    /// The text up to the first NUL.
    ///
    /// # Errors
    ///
    /// The sender wrote something that is not UTF-8; [`as_bytes`](Self::as_bytes) has it.
    pub fn to_str(&self) -> Result<&str, core::str::Utf8Error> {
        core::str::from_utf8(self.as_bytes())
    }
}

impl<const N: usize> Default for Chars<N> {
    fn default() -> Self {
        Self([0; N])
    }
}

impl<const N: usize> TryFrom<&str> for Chars<N> {
    type Error = TooLong;

    fn try_from(text: &str) -> Result<Self, TooLong> {
        if text.len() <= N { Ok(Self::truncated(text)) } else { Err(TooLong { length: text.len(), capacity: N }) }
    }
}

impl<const N: usize> PartialEq<str> for Chars<N> {
    fn eq(&self, other: &str) -> bool {
        self.as_bytes() == other.as_bytes()
    }
}

impl<const N: usize> PartialEq<&str> for Chars<N> {
    fn eq(&self, other: &&str) -> bool {
        self == *other
    }
}

impl<const N: usize> fmt::Debug for Chars<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        debug(self.as_bytes(), f)
    }
}

impl<const N: usize> fmt::Display for Chars<N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        display(self.as_bytes(), f)
    }
}

impl<const N: usize> Wire for Chars<N> {
    const SIZE: usize = N;

    #[inline(always)]
    fn read(bytes: &[u8], offset: usize) -> Self {
        Self(Wire::read(bytes, offset))
    }

    #[inline(always)]
    fn write(self, bytes: &mut [u8], offset: usize) {
        self.0.write(bytes, offset);
    }
}

/// Like a `str`, or like a byte string literal if it is not UTF-8.
pub(crate) fn debug(bytes: &[u8], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    match core::str::from_utf8(bytes) {
        Ok(text) => fmt::Debug::fmt(text, f),
        Err(_) => write!(f, "b\"{}\"", bytes.escape_ascii()),
    }
}

/// The text; U+FFFD where it is not UTF-8.
fn display(bytes: &[u8], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    match core::str::from_utf8(bytes) {
        Ok(text) => f.pad(text),
        Err(_) => bytes.utf8_chunks().try_for_each(|chunk| {
            f.write_str(chunk.valid())?;
            if chunk.invalid().is_empty() { Ok(()) } else { f.write_str("\u{fffd}") }
        }),
    }
}
