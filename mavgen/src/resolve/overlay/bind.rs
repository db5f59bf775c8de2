//! `<bind>`: an enum on a field that the definitions give none.

use super::super::message_scope::{EnumUse, Found, MessageScope, UsePlace, condition};
use super::super::{spelling, text};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::Binding;
use crate::syntax::Text;
use crate::syntax::overlay::Bind;

/// Resolves a binding; what is wrong with it is reported.
pub(super) fn resolve<'a>(
    scope: &MessageScope<'_, 'a>,
    element: &'a Bind,
    enum_uses: &mut Vec<EnumUse<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<Binding> {
    spelling::check(&element.name, "a binding", diagnostics);
    let condition = condition(scope, &element.condition, diagnostics);
    let enum_ = scope.enum_(&element.enum_, diagnostics);
    let found = scope.field(&element.field, diagnostics)?;
    let Some(repr) = found.field.ty.scalar.repr().filter(|_| found.field.ty.array.is_none()) else {
        diagnostics.push(unsuitable(scope, &element.field, found));
        return None;
    };
    if let Some(own) = &found.syntax.enum_ {
        diagnostics.push(carries(scope, element, own));
        return None;
    }
    let enum_ = enum_?;
    let place = UsePlace::Field(repr, found.syntax.ty.span);
    enum_uses.push(EnumUse { enum_, name: &element.enum_, place });
    Some(Binding {
        name: spelling::label(&element.name),
        field: found.index,
        enum_,
        condition,
        description: text::or_empty(element.description.as_ref()),
    })
}

fn unsuitable(scope: &MessageScope<'_, '_>, name: &Text, found: Found<'_>) -> Diagnostic {
    let ty = &found.syntax.ty;
    let message = format!("`{}.{}` is `{}`, which cannot carry an enum", scope.name(), name.value, ty.value);
    let problem = Diagnostic::new(Code::Bind, name.span, message).related(ty.span, "the field");
    problem.help("an enum can be bound to a scalar integer")
}

fn carries(scope: &MessageScope<'_, '_>, element: &Bind, own: &Text) -> Diagnostic {
    let (message, field) = (scope.name(), &element.field.value);
    let message = format!("`{message}.{field}` carries enum `{}` already", own.value);
    let problem = Diagnostic::new(Code::Bind, element.field.span, message).related(own.span, "as the definitions say");
    problem.help("a field carries one enum; leave the binding out")
}
