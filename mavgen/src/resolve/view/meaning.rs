//! What bits mean: a flag, values of an enum, a number, or a number that stands for another.

use super::{exact, scaling};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Meaning, Scaled};
use crate::resolve::message_scope::{EnumUse, MessageScope, UsePlace};
use crate::resolve::text;
use crate::syntax::Text;
use crate::syntax::overlay::Bits;

/// The widest integer that an enum, or the arithmetic of scaled values, can have.
const WIDEST: u8 = 64;

/// Resolves the meaning of `width` bits.
pub(super) fn resolve<'a>(
    scope: &MessageScope<'_, 'a>,
    bits: &'a Bits,
    (width, signed): (u8, bool),
    enum_uses: &mut Vec<EnumUse<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<Meaning> {
    if let (Some(text), true, 1) = (&bits.signed, signed, width) {
        let message = "one bit has no sign";
        let problem = Diagnostic::new(Code::BitsKind, text.span, message).related(bits.width.span, "the width");
        diagnostics.push(problem.help("two's complement needs at least 2 bits"));
        return None;
    }
    if let Some(name) = &bits.enum_ {
        return values(scope, bits, (name, width), enum_uses, diagnostics);
    }
    let units = text::non_empty(bits.units.as_ref());
    let is_scaled = bits.scale.is_some() || bits.bias.is_some() || bits.exact.is_some();
    if !is_scaled {
        let flag = width == 1 && units.is_none();
        return Some(if flag { Meaning::Flag } else { Meaning::Number { units } });
    }
    if width > WIDEST {
        diagnostics.push(too_wide(bits, "scaled values have"));
        return None;
    }
    let line = scaling::line(bits, (width, signed), diagnostics)?;
    let exact = match &bits.exact {
        Some(text) => Some(exact::resolve(bits, text, line, (width, signed), diagnostics)?),
        None => None,
    };
    let scaling::Line { factor, bias, divisor } = line;
    Some(Meaning::Scaled(Scaled { factor, bias, divisor, units, exact }))
}

fn values<'a>(
    scope: &MessageScope<'_, 'a>,
    bits: &'a Bits,
    (name, width): (&'a Text, u8),
    enum_uses: &mut Vec<EnumUse<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<Meaning> {
    let others = [
        ("signed", &bits.signed),
        ("scale", &bits.scale),
        ("bias", &bits.bias),
        ("units", &bits.units),
        ("exact", &bits.exact),
    ];
    for (attribute, text) in others {
        if let Some(text) = text {
            let message = format!("`{}` has an enum, and `{attribute}` is for numbers", bits.name.value);
            let problem = Diagnostic::new(Code::BitsKind, text.span, message).related(name.span, "the enum");
            diagnostics.push(problem.help("leave one of them out"));
        }
    }
    if width > WIDEST {
        diagnostics.push(too_wide(bits, "an enum has"));
        return None;
    }
    let enum_ = scope.enum_(name, diagnostics)?;
    enum_uses.push(EnumUse { enum_, name, place: UsePlace::Bits(width, bits.width.span) });
    Some(Meaning::Values(enum_))
}

fn too_wide(bits: &Bits, what: &str) -> Diagnostic {
    let message = format!("`{}` is {} bits wide; {what} at most {WIDEST}", bits.name.value, bits.width.value);
    Diagnostic::new(Code::BitsKind, bits.width.span, message).help("make it a plain number, or fewer bits")
}
