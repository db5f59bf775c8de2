//! Views: layouts of bits over the fields of a message, or values in them.

mod beside;
mod branches;
mod case;
mod coverage;
mod exact;
mod layout;
mod meaning;
mod piece;
mod place;
mod ranges;
mod scaling;
mod selector;
mod sentinel;
mod slots;
mod switch;
mod units;
mod values;
mod words;

use super::message_scope::{EnumUse, MessageScope, condition};
use super::{spelling, text};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Origin, View};
use crate::syntax::overlay::{self, Part, Piece};
use words::Words;

/// Resolves a view; what is wrong with it is reported. Where the words are not clear, the rest is not looked at.
pub(super) fn resolve<'a>(
    scope: &MessageScope<'_, 'a>,
    element: &'a overlay::View,
    enum_uses: &mut Vec<EnumUse<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<View> {
    check_members(scope, element, diagnostics);
    let condition = condition(scope, &element.condition, diagnostics);
    let name = spelling::name(&element.name);
    let origin = Origin {
        file: scope.file,
        overlays: Vec::new(),
        span: element.span,
        description: text::or_empty(element.description.as_ref()),
        lifecycle: None,
    };
    let Some(words) = &element.words else {
        let access = values::access(scope, element, condition, diagnostics)?;
        return Some(View::of_values(name, access, condition, origin));
    };
    let words = words::resolve(scope, words, diagnostics)?;
    let access = slots::access(scope, element, &words, diagnostics);
    let invalid = sentinel::sentinels(scope, element, &words, condition, diagnostics);
    let layout::Layout { members, switch } = layout::resolve(scope, element, &words, enum_uses, diagnostics);
    let Words { list: words, width, .. } = words;
    Some(View { name, words, width, access: access?, condition, invalid, switch, members, origin })
}

/// Every `<bits>` of a view.
pub(super) fn all_bits(element: &overlay::View) -> Vec<&overlay::Bits> {
    let mut all = Vec::new();
    for part in &element.parts {
        match part {
            Part::Piece(piece) => all.extend(bits(piece)),
            Part::Switch(switch) => {
                switch.cases.iter().for_each(|case| all.extend(case.pieces.iter().filter_map(bits)))
            }
        }
    }
    all
}

fn bits(piece: &Piece) -> Option<&overlay::Bits> {
    match piece {
        Piece::Bits(bits) => Some(bits),
        Piece::Reserved(_) => None,
    }
}

/// A view has something to say, and its names are names.
fn check_members(scope: &MessageScope<'_, '_>, element: &overlay::View, diagnostics: &mut Diagnostics) {
    spelling::check(&element.name, "a view", diagnostics);
    if scope.whole && all_bits(element).is_empty() && element.values.is_empty() {
        let message = format!("view `{}` has no members", element.name.value);
        let problem = Diagnostic::new(Code::EmptyView, element.name.span, message);
        diagnostics.push(problem.help(match element.words {
            Some(_) => "add `<bits name=\"…\" at=\"…\" width=\"…\"/>`",
            None => "add `<value name=\"…\" field=\"…\"/>`, or `words` and `<bits>`",
        }));
    }
    if let (Some(words), Some(value)) = (&element.words, element.values.first()) {
        let problem = Diagnostic::new(Code::ViewKind, value.span, "a value belongs to a view without `words`");
        let problem = problem.related(words.span, "the words");
        diagnostics.push(problem.help("write another view for the values"));
    }
    all_bits(element).iter().for_each(|bits| spelling::check(&bits.name, "bits", diagnostics));
    element.keys.iter().for_each(|key| spelling::check(&key.name, "a key", diagnostics));
    element.values.iter().for_each(|value| spelling::check(&value.name, "a value", diagnostics));
    for (name, what) in [(&element.item, "an item"), (&element.items, "an iterator")] {
        name.iter().for_each(|name| spelling::check(name, what, diagnostics));
    }
}
