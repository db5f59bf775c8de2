//! Names, as the definitions spell them.

use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};

use crate::source::Span;

/// A name in the definitions, where it was written, and what it is called in Rust.
///
/// The spelling of the definitions is what checksums are made of; the Rust spelling is what a user types. Two names are equal
/// wherever they stand: the place is for messages alone, and `Debug` does not show it.
#[derive(Clone)]
pub struct Name {
    /// As the definitions spell it: `GPS_RAW_INT`, `Index`.
    pub text: String,
    /// As Rust spells it: `GpsRawInt`, `index`; a keyword as a field is `type` here, and written `r#type`.
    pub rust: String,
    /// Where it was written.
    pub span: Span,
}

impl Name {
    /// What keeps a text from being a name in the definitions, or from leaving something to be a name in Rust.
    pub(crate) fn fault(text: &str) -> Option<&'static str> {
        if text.is_empty() {
            Some("empty")
        } else if !text.bytes().all(|byte| byte == b'_' || byte.is_ascii_alphanumeric()) {
            Some("has other characters")
        } else if text.starts_with(|first: char| first.is_ascii_digit()) {
            Some("begins with a digit")
        } else if text.bytes().all(|byte| byte == b'_') {
            Some("nothing but underscores")
        } else {
            None
        }
    }

    /// What two names are compared by.
    fn key(&self) -> (&str, &str) {
        (&self.text, &self.rust)
    }
}

impl PartialEq for Name {
    fn eq(&self, other: &Self) -> bool {
        self.key() == other.key()
    }
}

impl Eq for Name {}

impl PartialOrd for Name {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Name {
    fn cmp(&self, other: &Self) -> Ordering {
        self.key().cmp(&other.key())
    }
}

impl Hash for Name {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.key().hash(state);
    }
}

impl fmt::Debug for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Name").field("text", &self.text).field("rust", &self.rust).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spellings() {
        for name in ["A", "_a", "a1", "GPS_RAW_INT", "_1"] {
            assert_eq!(Name::fault(name), None, "{name}");
        }
        for name in ["", "_", "__", "1A", "a-b", "a b", "é", "a.b"] {
            assert!(Name::fault(name).is_some(), "{name}");
        }
    }
}
