//! `<bind>`: an enum on a field that the definitions give none.

use super::super::message_scope::MessageScope;
use super::super::names;
use super::super::origin::or_empty;
use super::super::uses::{EnumUse, UsePlace};
use crate::diag::{Code, Diagnostic};
use crate::ir::Binding;
use crate::syntax::overlay::Bind;

pub(super) fn resolve<'a>(scope: &mut MessageScope<'_, 'a>, element: &'a Bind) -> Option<Binding> {
    names::check(&element.name, "a binding", scope.diagnostics);
    let condition = scope.condition(&element.condition);
    let enum_ = scope.enums.find(&element.enum_, scope.diagnostics);
    let found = scope.field(&element.field)?;
    let span = element.field.span;
    let Some(repr) = found.scalar_repr() else {
        return scope.refuse_type(
            Code::Bind,
            span,
            found,
            ("cannot carry an enum", "an enum can be bound to a scalar integer"),
        );
    };
    if let Some(own) = &found.syntax.enum_ {
        let message = format!("`{}.{}` carries enum `{}` already", scope.name(), element.field.value, own.value);
        let problem = Diagnostic::new(Code::Bind, span, message).related(own.span, "as the definitions say");
        return scope.refuse(problem.help("a field carries one enum; leave the binding out"));
    }
    let enum_ = enum_?;
    let place = (UsePlace::Field(repr), found.syntax.ty.span);
    scope.enum_uses.push(EnumUse { enum_, name: &element.enum_, place });
    Some(Binding {
        name: names::label(&element.name),
        field: found.index,
        enum_,
        condition,
        description: or_empty(&element.description),
    })
}
