//! Fields of messages, each for itself.

use super::boolean::{self, Attribute};
use super::origin::origin;
use super::{field_type, limits, units};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FieldType, FileIndex, Limits, Origin, Scalar};
use crate::syntax;

/// What a field takes from the message around it.
#[derive(Clone, Copy)]
pub(super) struct Surroundings {
    pub(super) file: FileIndex,
    /// The version that `uint8_t_mavlink_version` stands for.
    pub(super) version: u8,
    /// Whether the field stands after `<extensions/>`.
    pub(super) extension: bool,
}

/// What a field says for itself. What needs the other fields or the enums is worked out later.
pub(super) struct DraftField<'a> {
    pub(super) syntax: &'a syntax::Field,
    pub(super) ty: FieldType,
    pub(super) extension: bool,
    pub(super) limits: Limits,
    pub(super) display_bitmask: bool,
    pub(super) instance: bool,
    pub(super) origin: Origin,
}

/// Reads a field.
pub(super) fn resolve<'a>(
    field: &'a syntax::Field,
    around: Surroundings,
    diagnostics: &mut Diagnostics,
) -> Option<DraftField<'a>> {
    let limits = limits::resolve([&field.min, &field.max, &field.increment], f64::is_finite, diagnostics);
    let instance = boolean::read(&field.instance, Attribute::AnyText("instance"), diagnostics);
    units::check(&field.units, diagnostics);
    let ty = field_type::resolve(&field.ty, around.version, diagnostics)?;
    check_target(field, ty, diagnostics);
    Some(DraftField {
        syntax: field,
        ty,
        extension: around.extension,
        limits,
        display_bitmask: display_bitmask(field, ty, diagnostics),
        instance,
        origin: origin(around.file, field.span, &field.description, None),
    })
}

/// Reads `display`, whose only value is `bitmask`, which only integers can be shown as.
fn display_bitmask(field: &syntax::Field, ty: FieldType, diagnostics: &mut Diagnostics) -> bool {
    let Some(display) = field.display.as_ref().filter(|display| !display.value.is_empty()) else {
        return false;
    };
    let reason = if display.value != "bitmask" {
        format!("`{}` is no way to display a field", display.value)
    } else if ty.scalar.is_float() || ty.scalar == Scalar::Char {
        format!("a field of type `{}` cannot be displayed as a bitmask", field.ty.value)
    } else {
        return true;
    };
    let problem = Diagnostic::new(Code::Display, display.span, reason).label("ignored");
    diagnostics.push(problem.help("the only one is `display=\"bitmask\"`, for integers"));
    false
}

/// Frames are addressed by these two fields, and addresses are one byte.
fn check_target(field: &syntax::Field, ty: FieldType, diagnostics: &mut Diagnostics) {
    let name = field.name.value.as_str();
    let plain = FieldType { scalar: Scalar::U8, array: None };
    if matches!(name, "target_system" | "target_component") && ty != plain {
        let message = format!("`{name}` is a `{}` and will not be taken for an address", field.ty.value);
        let problem = Diagnostic::new(Code::TargetType, field.ty.span, message);
        diagnostics.push(problem.help("system and component ids are `uint8_t`"));
    }
}
