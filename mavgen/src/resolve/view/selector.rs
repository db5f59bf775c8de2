//! What a switch looks at: a field, or bits that are in every layout.

use super::piece::PlacedBits;
use super::words::{Words, beside};
use crate::diag::{Code, Diagnostic};
use crate::ir::{EnumId, Meaning, Switch, SwitchOn};
use crate::resolve::message_scope::MessageScope;
use crate::resolve::{names, suggest};
use crate::source::Span;
use crate::syntax::{Text, overlay};

pub(super) struct Selector {
    pub(super) switch: Switch,
    /// The enum of its values.
    pub(super) enum_: Option<EnumId>,
    /// Where its width is defined.
    pub(super) span: Span,
}

impl Selector {
    pub(super) fn title(&self) -> String {
        format!("`{}`", self.switch.name.name.text)
    }

    pub(super) fn most(&self) -> u64 {
        self.switch.on.highest()
    }
}

/// Resolves what a switch looks at: a field, or bits that stand before it in every layout.
pub(super) fn resolve(
    scope: &mut MessageScope<'_, '_>,
    element: &overlay::Switch,
    words: &Words,
    common: &[PlacedBits<'_>],
) -> Option<Selector> {
    let message = match (&element.field, &element.bits) {
        (Some(field), None) => return on_field(scope, field, words),
        (None, Some(bits)) => return on_bits(scope, bits, common),
        (None, None) => "a switch does not say what it looks at",
        (Some(_), Some(_)) => "a switch looks at a field and at bits",
    };
    let problem = Diagnostic::new(Code::SwitchOn, element.span, message);
    scope.refuse(problem.help("write `field=\"…\"` or `bits=\"…\"`"))
}

fn on_field(scope: &mut MessageScope<'_, '_>, text: &Text, words: &Words) -> Option<Selector> {
    let (place, found) = beside(scope, text, words)?;
    let Some(repr) = found.field.ty.scalar.repr().filter(|repr| !repr.is_signed()) else {
        let why = ("no switch can look at", "a switch looks at an unsigned integer");
        return scope.refuse_type(Code::SwitchOn, text.span, found, why);
    };
    let name = names::label(&found.syntax.name);
    Some(Selector {
        switch: Switch { name, on: SwitchOn::Field(place, repr), span: text.span },
        enum_: scope.enum_of(found.syntax),
        span: found.syntax.ty.span,
    })
}

fn on_bits(scope: &mut MessageScope<'_, '_>, text: &Text, common: &[PlacedBits<'_>]) -> Option<Selector> {
    let name = names::label(text);
    let members = common.iter().filter_map(|piece| piece.member.as_ref());
    let Some((member, bits)) = members.clone().find(|(member, _)| member.name == name) else {
        let message = format!("`{}` is not in every layout of the view", text.value);
        let problem = Diagnostic::new(Code::SwitchOn, text.span, message).label("no such bits outside of the switch");
        let mut names = members.map(|(_, bits)| bits.name.value.as_str());
        suggest::report(problem, &text.value, &mut names, scope.diagnostics);
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
        return scope.refuse(problem.help("a switch looks at up to 64 bits without sign, scale or repetition"));
    }
    let on = SwitchOn::Bits { at: member.at, width: member.width };
    Some(Selector { switch: Switch { name, on, span: text.span }, enum_, span: bits.width.span })
}
