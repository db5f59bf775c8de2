//! Views: layouts of bits over the fields of a message.

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
mod sentinel;
mod slots;
mod switch;
mod units;
mod words;

use super::overlay::{Carrier, Scene, condition};
use super::{origin, spelling};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Origin, View};
use crate::syntax::overlay::{self, Part, Piece};

/// Resolves a view; what is wrong with it is reported. Where the words are not clear, the rest is not looked at.
pub(super) fn resolve<'a>(
    scene: &Scene<'_, 'a>,
    element: &'a overlay::View,
    carriers: &mut Vec<Carrier<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<View> {
    check_members(scene, element, diagnostics);
    let condition = condition(scene, &element.condition, diagnostics);
    let words = words::resolve(scene, &element.words, diagnostics)?;
    let access = slots::access(scene, element, &words, diagnostics);
    let invalid = sentinel::blanks(scene, element, &words, diagnostics);
    let layout = layout::resolve(scene, element, &words, carriers, diagnostics);
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
            file: scene.file,
            overlays: Vec::new(),
            span: element.span,
            description: origin::or_empty(element.description.as_ref()),
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
fn check_members(scene: &Scene<'_, '_>, element: &overlay::View, diagnostics: &mut Diagnostics) {
    spelling::check(&element.name, "a view", diagnostics);
    if scene.whole && all_bits(element).next().is_none() {
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
