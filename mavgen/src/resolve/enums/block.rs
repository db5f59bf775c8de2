//! The values of one `<enum>` element.

use super::super::boolean::{self, Attribute};
use super::super::lost::Poisoned;
use super::super::number;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::FileIndex;
use crate::syntax;

/// One `<enum>` element with every value filled in.
pub(in crate::resolve) struct Block<'a> {
    pub(in crate::resolve) file: FileIndex,
    pub(in crate::resolve) syntax: &'a syntax::Enum,
    pub(in crate::resolve) bitmask: bool,
    /// In document order.
    pub(in crate::resolve) entries: Vec<ValuedEntry<'a>>,
    /// The largest value; zero if there is none.
    pub(in crate::resolve) highest: u128,
    /// Whether every entry is there, and has its value: if not, automatic values are guesses.
    pub(in crate::resolve) exact: bool,
}

/// An entry and its value, which automatic assignment can carry beyond 64 bits until [`crate::resolve`] refuses it.
#[derive(Clone, Copy)]
pub(in crate::resolve) struct ValuedEntry<'a> {
    pub(in crate::resolve) file: FileIndex,
    pub(in crate::resolve) syntax: &'a syntax::Entry,
    pub(in crate::resolve) value: u128,
    pub(in crate::resolve) auto: bool,
}

/// Of so many entries a problem gives the names; of the rest it says how many they are.
const NAMED: usize = 3;

impl ValuedEntry<'_> {
    /// Entries in a text, each with its value.
    pub(in crate::resolve) fn list(entries: &[&Self]) -> String {
        let (named, rest) = entries.split_at(entries.len().min(NAMED));
        let named = named.iter().map(|entry| format!("{} = {}", entry.syntax.name.value, entry.value));
        let rest = (!rest.is_empty()).then(|| format!("{} more", rest.len()));
        named.chain(rest).collect_vec().join(", ")
    }
}

impl<'a> Block<'a> {
    /// Reads the values of one element: an entry without one gets the largest so far plus one, so the first gets 1.
    pub(in crate::resolve) fn read(
        file: FileIndex,
        syntax: &'a syntax::Enum,
        poisoned: &Poisoned,
        diagnostics: &mut Diagnostics,
    ) -> Self {
        let bitmask = boolean::read(&syntax.bitmask, Attribute::OnlyTrue("bitmask"), diagnostics);
        let exact = !poisoned.near(syntax.span);
        let mut block = Self { file, syntax, bitmask, entries: Vec::new(), highest: 0, exact };
        if exact && syntax.entries.is_empty() {
            let message = format!("enum `{}` has no entries", syntax.name.value);
            diagnostics.push(Diagnostic::new(Code::EmptyEnum, syntax.name.span, message));
        }
        for entry in &syntax.entries {
            block.add(entry, diagnostics);
        }
        block
    }

    fn add(&mut self, syntax: &'a syntax::Entry, diagnostics: &mut Diagnostics) {
        let value = match &syntax.value {
            None => self.highest + 1,
            Some(text) => match number::unsigned(&text.value) {
                Ok(value) => u128::from(value),
                Err(why) => {
                    let message = format!("the value `{}` is not a number from 0 to 2^64 - 1", text.value);
                    let problem = Diagnostic::new(Code::BadValue, text.span, message).label(why);
                    diagnostics.push(match meant(&text.value) {
                        Some(meant) => problem.help(meant),
                        None => problem,
                    });
                    self.exact = false;
                    return;
                }
            },
        };
        self.highest = self.highest.max(value);
        self.entries.push(ValuedEntry { file: self.file, syntax, value, auto: syntax.value.is_none() });
    }

    /// The smallest value.
    pub(in crate::resolve) fn start(&self) -> Option<u128> {
        self.entries.iter().map(|entry| entry.value).min()
    }
}

/// How the value of a plain expression is written: C's shifts, `1 << 7` and with suffixes, and sums of flags, `1|4`.
fn meant(text: &str) -> Option<String> {
    let text = text.trim_matches(|c: char| c.is_whitespace() || matches!(c, '(' | ')'));
    let number = |text: &str| {
        let text = text.trim_matches(|c: char| c.is_whitespace() || matches!(c, '(' | ')'));
        number::unsigned(text.trim_end_matches(['u', 'U', 'l', 'L'])).ok()
    };
    let term = |text: &str| match text.split_once("<<") {
        Some((base, shift)) => {
            let (base, shift) = (number(base)?, u32::try_from(number(shift)?).ok()?);
            base.checked_shl(shift).filter(|shifted| shifted >> shift == base)
        }
        None => number(text),
    };
    let value = text.split('|').map(term).try_fold(0, |sum, term| Some(sum | term?))?;
    Some(match value.is_power_of_two() {
        true => format!("write `2**{}` or `{value:#x}`", value.trailing_zeros()),
        false => format!("write `{value:#x}`"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn expressions_have_values() {
        for (text, help) in [
            ("1<<7", Some("write `2**7` or `0x80`")),
            ("(1 << 63)", Some("write `2**63` or `0x8000000000000000`")),
            ("1UL<<3", Some("write `2**3` or `0x8`")),
            ("1|4", Some("write `0x5`")),
            ("(1<<0)|(1<<2)", Some("write `0x5`")),
            ("3<<1", Some("write `0x6`")),
            ("1<<64", None),
            ("-1", None),
            ("FLAG", None),
            ("1|", None),
            ("", None),
        ] {
            assert_eq!(meant(text).as_deref(), help, "{text}");
        }
    }
}
