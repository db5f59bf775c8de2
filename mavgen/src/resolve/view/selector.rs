//! What a switch looks at: a field, or bits that are in every layout.

use super::beside::beside;
use super::piece::PlacedBits;
use super::spelling;
use super::words::Words;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, Label, Meaning, SwitchOn};
use crate::resolve::message_scope::MessageScope;
use crate::resolve::suggest::suggest;
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::Switch;

/// What a switch looks at.
pub(super) struct Selector {
    /// The name of its getter.
    pub(super) name: Label,
    /// What a message calls it.
    pub(super) title: String,
    /// Where it is read.
    pub(super) on: SwitchOn,
    /// The largest value.
    pub(super) most: u64,
    /// The enum of its values.
    pub(super) enum_: Option<EnumId>,
    /// Where it is defined.
    pub(super) span: Span,
    /// Where the switch names it.
    pub(super) named: Span,
}

/// Resolves what a switch looks at: a field, or bits that stand before it in every layout.
pub(super) fn resolve(
    scope: &MessageScope<'_, '_>,
    element: &Switch,
    words: &Words,
    common: &[PlacedBits<'_>],
    diagnostics: &mut Diagnostics,
) -> Option<Selector> {
    let message = match (&element.field, &element.bits) {
        (Some(field), None) => return on_field(scope, field, words, diagnostics),
        (None, Some(bits)) => return on_bits(bits, common, diagnostics),
        (None, None) => "a switch does not say what it looks at",
        (Some(_), Some(_)) => "a switch looks at a field and at bits",
    };
    let problem = Diagnostic::new(Code::SwitchOn, element.span, message);
    diagnostics.push(problem.help("write `field=\"…\"` or `bits=\"…\"`"));
    None
}

fn on_field(
    scope: &MessageScope<'_, '_>,
    text: &Text,
    words: &Words,
    diagnostics: &mut Diagnostics,
) -> Option<Selector> {
    let (place, found) = beside(scope, text, words, diagnostics)?;
    let (name, ty) = (&found.syntax.name, &found.syntax.ty);
    let Some(repr) = found.field.ty.scalar.repr().filter(|repr| !repr.is_signed()) else {
        let message = format!("`{}.{}` is `{}`, which no switch can look at", scope.name(), name.value, ty.value);
        let problem = Diagnostic::new(Code::SwitchOn, text.span, message).related(ty.span, "the field");
        diagnostics.push(problem.help("a switch looks at an unsigned integer"));
        return None;
    };
    Some(Selector {
        name: spelling::label(name),
        title: format!("`{}`", name.value),
        on: SwitchOn::Field(place, repr),
        most: repr.highest(),
        enum_: scope.enum_of(found.syntax),
        span: ty.span,
        named: text.span,
    })
}

fn on_bits(text: &Text, common: &[PlacedBits<'_>], diagnostics: &mut Diagnostics) -> Option<Selector> {
    let name = spelling::label(text);
    let members = || common.iter().filter_map(|piece| piece.member.as_ref());
    let Some((member, bits)) = members().find(|(member, _)| member.name == name) else {
        let message = format!("`{}` is not in every layout of the view", text.value);
        let problem = Diagnostic::new(Code::SwitchOn, text.span, message).label("no such bits outside of the switch");
        let names = members().map(|(_, bits)| bits.name.value.as_str());
        let problem = suggest(problem, &text.value, names, diagnostics);
        diagnostics.push(problem);
        return None;
    };
    let enum_ = match member.meaning {
        Meaning::Values(enum_) => Some(enum_),
        Meaning::Number { .. } | Meaning::Flag | Meaning::Scaled(_) => None,
    };
    let plain = !matches!(member.meaning, Meaning::Scaled(_)) && !member.signed && member.repeat.is_none();
    if !plain || member.width > 64 {
        let message = format!("`{}` is no plain number, which no switch can look at", text.value);
        let problem = Diagnostic::new(Code::SwitchOn, text.span, message).related(bits.span, "the bits");
        diagnostics.push(problem.help("a switch looks at up to 64 bits without sign, scale or repetition"));
        return None;
    }
    Some(Selector {
        name,
        title: format!("`{}`", text.value),
        on: SwitchOn::Bits { at: member.at, width: member.width },
        most: u64::MAX >> (64 - u32::from(member.width)),
        enum_,
        span: bits.width.span,
        named: text.span,
    })
}
