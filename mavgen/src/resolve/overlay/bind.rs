//! `<bind>`: an enum on a field that the definitions give none.

use super::super::width::integer;
use super::super::{origin, spelling};
use super::carrier::{Carrier, CarrierPlace};
use super::{Found, Scene, condition};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::Binding;
use crate::syntax::Text;
use crate::syntax::overlay::Bind;

/// Resolves a binding; what is wrong with it is reported.
pub(super) fn resolve<'a>(
    scene: &Scene<'_, 'a>,
    element: &'a Bind,
    carriers: &mut Vec<Carrier<'a>>,
    diagnostics: &mut Diagnostics,
) -> Option<Binding> {
    spelling::check(&element.name, "a binding", diagnostics);
    let condition = condition(scene, &element.condition, diagnostics);
    let values = scene.values(&element.values, diagnostics);
    let found = scene.field(&element.field, diagnostics)?;
    let Some(repr) = integer(found.field.ty.scalar).filter(|_| found.field.ty.array.is_none()) else {
        diagnostics.push(unsuitable(scene, &element.field, found));
        return None;
    };
    if let Some(own) = &found.syntax.values {
        diagnostics.push(carries(scene, element, own));
        return None;
    }
    let values = values?;
    let place = CarrierPlace::Field(repr, found.syntax.ty.span);
    carriers.push(Carrier { values, name: &element.values, place });
    Some(Binding {
        name: spelling::label(&element.name),
        field: found.index,
        values,
        condition,
        description: origin::or_empty(element.description.as_ref()),
    })
}

fn unsuitable(scene: &Scene<'_, '_>, name: &Text, found: Found<'_>) -> Diagnostic {
    let ty = &found.syntax.ty;
    let message = format!("`{}.{}` is `{}`, which cannot carry an enum", scene.name(), name.value, ty.value);
    let problem = Diagnostic::new(Code::Bind, name.span, message).related(ty.span, "the field");
    problem.help("an enum can be bound to a scalar integer")
}

fn carries(scene: &Scene<'_, '_>, element: &Bind, own: &Text) -> Diagnostic {
    let (message, field) = (scene.name(), &element.field.value);
    let message = format!("`{message}.{field}` carries enum `{}` already", own.value);
    let problem = Diagnostic::new(Code::Bind, element.field.span, message).related(own.span, "as the definitions say");
    problem.help("a field carries one enum; leave the binding out")
}
