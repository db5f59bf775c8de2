//! What bits mean: a flag, values of an enum, a number, or a number that stands for another.

use super::{exact, scaling};
use crate::diag::{Code, Diagnostic};
use crate::ir::{Meaning, Scaled};
use crate::resolve::message_scope::MessageScope;
use crate::resolve::origin::non_empty;
use crate::resolve::uses::{EnumUse, UsePlace};
use crate::syntax::Text;
use crate::syntax::overlay::Bits;

/// The widest integer that an enum, or the arithmetic of scaled values, can have.
const WIDEST: u8 = 64;

/// Resolves the meaning of `width` bits.
pub(super) fn resolve<'a>(
    scope: &mut MessageScope<'_, 'a>,
    bits: &'a Bits,
    (width, signed): (u8, bool),
) -> Option<Meaning> {
    if let (Some(text), true, 1) = (&bits.signed, signed, width) {
        let problem =
            Diagnostic::new(Code::BitsKind, text.span, "one bit has no sign").related(bits.width.span, "the width");
        return scope.refuse(problem.help("two's complement needs at least 2 bits"));
    }
    if let Some(name) = &bits.enum_ {
        return values(scope, bits, name, width);
    }
    let units = non_empty(&bits.units);
    let is_scaled = bits.scale.is_some() || bits.bias.is_some() || bits.exact.is_some();
    if !is_scaled {
        let flag = width == 1 && units.is_none();
        return Some(if flag { Meaning::Flag } else { Meaning::Number { units } });
    }
    if width > WIDEST {
        return scope.refuse(too_wide(bits, "scaled values have"));
    }
    let line = scaling::line(scope, bits, (width, signed))?;
    let exact = match &bits.exact {
        Some(text) => Some(exact::resolve(scope, bits, text, line, (width, signed))?),
        None => None,
    };
    let scaling::Line { factor, bias, divisor } = line;
    Some(Meaning::Scaled(Scaled { factor, bias, divisor, units, exact }))
}

fn values<'a>(scope: &mut MessageScope<'_, 'a>, bits: &'a Bits, name: &'a Text, width: u8) -> Option<Meaning> {
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
            scope.report(problem.help("leave one of them out"));
        }
    }
    if width > WIDEST {
        return scope.refuse(too_wide(bits, "an enum has"));
    }
    let enum_ = scope.enums.find(name, scope.diagnostics)?;
    scope.enum_uses.push(EnumUse { enum_, name, place: (UsePlace::Bits(width), bits.width.span) });
    Some(Meaning::Values(enum_))
}

fn too_wide(bits: &Bits, what: &str) -> Diagnostic {
    let message = format!("`{}` is {} bits wide; {what} at most {WIDEST}", bits.name.value, bits.width.value);
    Diagnostic::new(Code::BitsKind, bits.width.span, message).help("make it a plain number, or fewer bits")
}
