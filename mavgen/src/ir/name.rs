//! Names, as the definitions spell them.

use std::fmt;
use std::hash::{Hash, Hasher};

use crate::source::Span;

/// A name in the definitions, and where it was written.
///
/// Two names are equal wherever they stand: the place is for messages alone, and `Debug` does not show it. What a language makes
/// of a name is not here.
#[derive(Clone)]
pub struct Name {
    /// As the definitions spell it, which is what checksums are made of: `GPS_RAW_INT`, `Index`.
    pub text: String,
    /// Where it was written.
    pub span: Span,
}

impl Name {
    /// What keeps a text from being a name in the definitions, or from leaving something to make a name of.
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
}

impl PartialEq for Name {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl Eq for Name {}

impl Hash for Name {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.text.hash(state);
    }
}

/// As text.
impl fmt::Debug for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.text.fmt(f)
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
