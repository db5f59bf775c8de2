//! Views: layouts of bits over the fields of a message, or values in them.

mod access;
mod exact;
mod layout;
mod meaning;
mod piece;
mod ranges;
mod scaling;
mod sentinel;
mod switch;
mod words;

use super::message_scope::MessageScope;
use super::{names, origin};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic};
use crate::ir::View;
use crate::syntax::overlay::{self, Part, Piece};

/// Resolves a view; what is wrong with it is reported. Where the words are not clear, the rest is not looked at.
pub(super) fn resolve<'a>(scope: &mut MessageScope<'_, 'a>, element: &'a overlay::View) -> Option<View> {
    check_members(scope, element);
    let condition = scope.condition(&element.condition);
    let name = names::name(&element.name);
    let origin = origin::origin(scope.file, element.span, &element.description, None);
    let Some(words) = &element.words else {
        let access = access::of_values(scope, element, condition)?;
        let (words, invalid, members) = (Vec::new(), Vec::new(), Vec::new());
        return Some(View { name, words, width: 0, access, condition, invalid, switch: None, members, origin });
    };
    let words = words::resolve(scope, words)?;
    let access = access::of_words(scope, element, &words);
    let invalid = sentinel::sentinels(scope, element, &words, condition);
    let (members, switch) = layout::resolve(scope, element, &words);
    let (access, width, words) = (access?, words.width, words.list);
    Some(View { name, words, width, access, condition, invalid, switch, members, origin })
}

fn all_bits(element: &overlay::View) -> Vec<&overlay::Bits> {
    let mut pieces = Vec::new();
    for part in &element.parts {
        match part {
            Part::Piece(piece) => pieces.push(piece),
            Part::Switch(switch) => pieces.extend(switch.cases.iter().flat_map(|case| &case.pieces)),
        }
    }
    let bits = pieces.into_iter().filter_map(|piece| match piece {
        Piece::Bits(bits) => Some(&**bits),
        Piece::Reserved(_) => None,
    });
    bits.collect_vec()
}

/// A view has something to say, and its names are names.
fn check_members(scope: &mut MessageScope<'_, '_>, element: &overlay::View) {
    let bits = all_bits(element);
    names::check(&element.name, "a view", scope.diagnostics);
    if scope.whole && bits.is_empty() && element.values.is_empty() {
        let message = format!("view `{}` has no members", element.name.value);
        let problem = Diagnostic::new(Code::EmptyView, element.name.span, message);
        scope.report(problem.help(match element.words {
            Some(_) => "add `<bits name=\"…\" at=\"…\" width=\"…\"/>`",
            None => "add `<value name=\"…\" field=\"…\"/>`, or `words` and `<bits>`",
        }));
    }
    if let (Some(words), Some(value)) = (&element.words, element.values.first()) {
        let problem = Diagnostic::new(Code::ViewKind, value.span, "a value belongs to a view without `words`");
        let problem = problem.related(words.span, "the words");
        scope.report(problem.help("write another view for the values"));
    }
    let mut names = Vec::new();
    names.extend(bits.iter().map(|bits| (&bits.name, "bits")));
    names.extend(element.keys.iter().map(|key| (&key.name, "a key")));
    names.extend(element.values.iter().map(|value| (&value.name, "a value")));
    names.extend(element.item.iter().map(|name| (name, "an item")));
    names.extend(element.items.iter().map(|name| (name, "an iterator")));
    names.into_iter().for_each(|(name, what)| names::check(name, what, scope.diagnostics));
}
