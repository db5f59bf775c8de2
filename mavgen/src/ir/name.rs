//! Names, as the definitions spell them, and labels, which overlays give: what they are shown as, whatever a language makes of them.

use std::fmt;
use std::hash::{Hash, Hasher};

use heck::ToSnakeCase;

use crate::collect::CollectVec as _;
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

/// The name of something that an overlay says of bits: a member, a key, a getter.
///
/// It is shown in snake case, with the unit that its values are in: `ageOfStatus` in milliseconds is `age_of_status_ms`. Two
/// labels that are shown alike are one name.
#[derive(Clone, Debug)]
pub struct Label {
    /// As the overlay spells it.
    pub name: Name,
    /// The unit as words: `ms`, `m_per_s`.
    pub suffix: Option<String>,
}

impl Label {
    /// A label without a unit.
    pub(crate) fn plain(name: Name) -> Self {
        Self { name, suffix: None }
    }

    /// What tables, JSON and columns call it: `age_ms`. Keywords of a language are not known here.
    pub fn shown(&self) -> String {
        let name = self.name.text.to_snake_case();
        match &self.suffix {
            Some(suffix) => format!("{name}_{suffix}"),
            None => name,
        }
    }
}

impl PartialEq for Label {
    fn eq(&self, other: &Self) -> bool {
        self.shown() == other.shown()
    }
}

impl Eq for Label {}

/// As it is shown.
impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.shown())
    }
}

/// The label of a param as words: `Horiz. Move Limit` is `horiz_move_limit`. A label may be any text; `None` if it has no letter and
/// no digit of ASCII.
pub(crate) fn param_words(label: &str) -> Option<String> {
    let words: String = label.chars().map(|one| if one.is_ascii_alphanumeric() { one } else { '_' }).collect();
    Some(words.to_snake_case()).filter(|words| !words.is_empty())
}

/// A unit as words: `mv`, `cdegc`, `m_per_s`; empty if nothing of it can be one.
pub(crate) fn unit_words(unit: &str) -> String {
    let spelled = unit.replace('/', " per ").replace('%', " percent ").replace('µ', "u");
    let words = spelled.split(|letter: char| !letter.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_ascii_lowercase).collect_vec().join("_")
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

    #[test]
    fn units() {
        for (unit, expected) in
            [("mV", "mv"), ("cdegC", "cdegc"), ("m/s", "m_per_s"), ("c%", "c_percent"), ("mm/s^2", "mm_per_s_2")]
        {
            assert_eq!(unit_words(unit), expected);
        }
    }
}
