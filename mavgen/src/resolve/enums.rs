//! Enums: the values of one `<enum>` element, and the model of a merged enum.

use super::boolean::{self, Attribute};
use super::losses::Losses;
use super::merge::{Enums, Merged};
use super::origin::Described;
use super::width::Width;
use super::{command, lifecycle, number, spelling};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{self, FileIndex, Lifecycle, Origin};
use crate::read::Loaded;
use crate::syntax;

/// One `<enum>` element with every value filled in.
pub(super) struct Block<'a> {
    pub(super) file: FileIndex,
    pub(super) syntax: &'a syntax::Enum,
    pub(super) bitmask: bool,
    /// In document order.
    pub(super) entries: Vec<Entry<'a>>,
    /// The largest value; zero if there is none.
    pub(super) highest: u128,
    /// Whether every entry is there, and has its value: if not, automatic values are guesses.
    pub(super) exact: bool,
}

/// An entry and its value, which automatic assignment can carry beyond 64 bits until [`crate::resolve`] refuses it.
#[derive(Clone, Copy)]
pub(super) struct Entry<'a> {
    pub(super) file: FileIndex,
    pub(super) syntax: &'a syntax::Entry,
    pub(super) value: u128,
    pub(super) auto: bool,
}

impl<'a> Block<'a> {
    /// Reads the values of one element: an entry without one gets the largest so far plus one, so the first gets 1.
    pub(super) fn read(
        file: FileIndex,
        syntax: &'a syntax::Enum,
        losses: &Losses,
        diagnostics: &mut Diagnostics,
    ) -> Self {
        let bitmask = boolean::read(syntax.bitmask.as_ref(), Attribute::OnlyTrue("bitmask"), diagnostics);
        let exact = !losses.near(syntax.span);
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
        self.entries.push(Entry { file: self.file, syntax, value, auto: syntax.value.is_none() });
    }

    /// The smallest value.
    pub(super) fn start(&self) -> Option<u128> {
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

/// The model of an enum.
pub(super) fn model(
    loaded: &Loaded,
    merged: &Merged<'_>,
    width: Width,
    enums: &Enums<'_>,
    diagnostics: &mut Diagnostics,
) -> ir::Enum {
    let Width { owner, repr, .. } = width;
    let mut entries = Vec::with_capacity(merged.entries.len());
    for entry in &merged.entries {
        let syntax = entry.syntax;
        let described = Described {
            file: entry.file,
            span: syntax.span,
            description: syntax.description.as_ref(),
            lifecycle: syntax.lifecycle.as_ref(),
        };
        entries.push(ir::Entry {
            name: spelling::name(&syntax.name),
            // What does not fit has been refused, and no model comes out.
            value: u64::try_from(entry.value).unwrap_or(u64::MAX),
            auto: entry.auto,
            command: command::resolve(&merged.name.value, entry, enums, diagnostics),
            origin: described.origin(diagnostics),
        });
    }
    let (named_in, oldest) = merged.oldest(loaded);
    let mut origin = origin(merged, owner, diagnostics);
    if merged.refined.in_use {
        lifecycle::tell(&mut origin);
    }
    ir::Enum {
        name: spelling::name(oldest),
        named_in,
        bitmask: merged.bitmask(owner),
        repr,
        entries,
        defined_in: owner,
        origin,
    }
}

/// Place of the first definition, first description that is not empty, stage of life of the owner's.
///
/// The stage goes with the owner so that a dialect that adds entries to a deprecated enum does not revive it.
fn origin(merged: &Merged<'_>, owner: FileIndex, diagnostics: &mut Diagnostics) -> Origin {
    let mut lifecycle: Option<Lifecycle> = None;
    let mut description = "";
    for block in &merged.blocks {
        let element = block.syntax;
        let described = Described {
            file: block.file,
            span: element.span,
            description: None,
            lifecycle: element.lifecycle.as_ref(),
        };
        let own = described.origin(diagnostics).lifecycle;
        if block.file == owner && lifecycle.is_none() {
            lifecycle = own;
        }
        if let (true, Some(text)) = (description.is_empty(), &element.description) {
            description = &text.value;
        }
    }
    Origin {
        file: merged.file,
        overlays: Vec::new(),
        span: merged.span,
        description: description.to_owned(),
        lifecycle,
    }
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
