//! Views: layouts of bits over the fields of a message.

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
mod words;

use super::message_scope::{EnumUse, MessageScope, condition};
use super::{spelling, text};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Origin, View};
use crate::syntax::overlay::{self, Part, Piece};

/// Resolves a view; what is wrong with it is reported. Where the words are not clear, the rest is not looked at.
pub(super) fn resolve<'a>(
    scope: &MessageScope<'_, 'a>,
    element: &'a overlay::View,
    enum_uses: &mut Vec<EnumUse<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<View> {
    check_members(scope, element, diagnostics);
    let condition = condition(scope, &element.condition, diagnostics);
    let words = words::resolve(scope, &element.words, diagnostics)?;
    let access = slots::access(scope, element, &words, diagnostics);
    let invalid = sentinel::sentinels(scope, element, &words, condition, diagnostics);
    let layout = layout::resolve(scope, element, &words, enum_uses, diagnostics);
    Some(View {
        name: spelling::name(&element.name),
        words: words.list,
        width: words.width,
        access: access?,
        condition,
        invalid,
        switch: layout.switch,
        members: layout.members,
        origin: Origin {
            file: scope.file,
            overlays: Vec::new(),
            span: element.span,
            description: text::or_empty(element.description.as_ref()),
            lifecycle: None,
        },
    })
}

/// Every `<bits>` of a view.
pub(super) fn all_bits(element: &overlay::View) -> impl Iterator<Item = &overlay::Bits> {
    let pieces = element.parts.iter().flat_map(|part| {
        let (piece, switch) = match part {
            Part::Piece(piece) => (Some(piece), None),
            Part::Switch(switch) => (None, Some(switch)),
        };
        let cases = switch.into_iter().flat_map(|switch| &switch.cases);
        piece.into_iter().chain(cases.flat_map(|case| &case.pieces))
    });
    pieces.filter_map(|piece| match piece {
        Piece::Bits(bits) => Some(&**bits),
        Piece::Reserved(_) => None,
    })
}

/// A view has something to say, and its names are names.
fn check_members(scope: &MessageScope<'_, '_>, element: &overlay::View, diagnostics: &mut Diagnostics) {
    spelling::check(&element.name, "a view", diagnostics);
    if scope.whole && all_bits(element).next().is_none() {
        let message = format!("view `{}` has no members", element.name.value);
        let problem = Diagnostic::new(Code::EmptyView, element.name.span, message);
        diagnostics.push(problem.help("add `<bits name=\"…\" at=\"…\" width=\"…\"/>`"));
    }
    all_bits(element).for_each(|bits| spelling::check(&bits.name, "bits", diagnostics));
    element.keys.iter().for_each(|key| spelling::check(&key.name, "a key", diagnostics));
    for (name, what) in [(&element.item, "an item"), (&element.items, "an iterator")] {
        name.iter().for_each(|name| spelling::check(name, what, diagnostics));
    }
}
