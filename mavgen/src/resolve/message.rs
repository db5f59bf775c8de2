//! Messages by themselves: their fields, layout and checksum. Enums come later.

use std::collections::HashMap;

use super::boolean::{self, Attribute};
use super::lost::Poisoned;
use super::origin::{lifecycle, origin};
use super::version::Version;
use super::{field_type, number, units};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FieldType, FileIndex, LARGEST_ID, Layout, Limits, MOST_FIELDS, Origin, Scalar};
use crate::order;
use crate::read::Loaded;
use crate::syntax::{Field, Message};

/// Payload lengths have 8 bits.
const LONGEST_PAYLOAD: usize = 255;

/// What a message says for itself.
pub(super) struct Draft<'a> {
    pub(super) syntax: &'a Message,
    pub(super) id: u32,
    /// In the order of the XML; as many as in `syntax`.
    pub(super) fields: Vec<DraftField<'a>>,
    pub(super) layout: Layout,
    pub(super) origin: Origin,
}

/// What a field says for itself. What needs the other fields or the enums is worked out later.
pub(super) struct DraftField<'a> {
    pub(super) syntax: &'a Field,
    pub(super) ty: FieldType,
    pub(super) extension: bool,
    pub(super) limits: Limits,
    pub(super) display_bitmask: bool,
    pub(super) instance: bool,
    pub(super) origin: Origin,
}

/// The messages of all files.
#[derive(Default)]
pub(super) struct Drafts<'a> {
    pub(super) messages: Vec<Draft<'a>>,
    /// Fields of messages that cannot be read: what is wrong with the field itself is still worth a word.
    pub(super) lost: Vec<DraftField<'a>>,
}

/// Reads the messages of all files; those that cannot be are reported.
pub(super) fn drafts<'a>(
    loaded: &'a Loaded,
    versions: &[Version],
    poisoned: &Poisoned,
    diagnostics: &mut Diagnostics,
) -> Drafts<'a> {
    let mut drafts = Drafts::default();
    for ((index, file), version) in loaded.files.iter().enumerate().zip(versions) {
        for (position, syntax) in file.messages.iter().enumerate() {
            if !poisoned.near(syntax.span) {
                check_presence(syntax, diagnostics);
            }
            match resolve(syntax, (FileIndex(index), version.seen_by(position)), diagnostics) {
                Ok(draft) => drafts.messages.push(draft),
                Err(fields) => drafts.lost.extend(fields),
            }
        }
    }
    drafts
}

/// Reads a message; the fields that can be read are the error.
fn resolve<'a>(
    syntax: &'a Message,
    around: (FileIndex, u8),
    diagnostics: &mut Diagnostics,
) -> Result<Draft<'a>, Vec<DraftField<'a>>> {
    let id = id(syntax, diagnostics);
    let base = base_count(syntax, diagnostics);
    let mut fields = Vec::new();
    for (position, element) in syntax.fields.iter().enumerate() {
        fields.extend(field(element, around, position >= base, diagnostics));
    }
    check_fields(syntax, diagnostics);
    let lifecycle = lifecycle(&syntax.lifecycle, diagnostics);
    let origin = origin(around.0, syntax.span, &syntax.description, lifecycle);
    if fields.len() < syntax.fields.len() {
        return Err(fields);
    }
    check_version_fields(syntax, &fields, diagnostics);
    check_instances(syntax, &fields, diagnostics);
    match (id, layout(syntax, &fields, diagnostics)) {
        (Some(id), Some(layout)) => Ok(Draft { syntax, id, fields, layout, origin }),
        _ => Err(fields),
    }
}

fn id(syntax: &Message, diagnostics: &mut Diagnostics) -> Option<u32> {
    let text = &syntax.id;
    let number = number::count(&text.value);
    let id = number.and_then(|id| u32::try_from(id).ok()).filter(|&id| id <= LARGEST_ID);
    if id.is_none() {
        let label = if number.is_some() { "more than 24 bits" } else { "not a decimal number" };
        let message = format!("message id `{}` is not a number from 0 to {LARGEST_ID}", text.value);
        diagnostics.push(Diagnostic::new(Code::MessageId, text.span, message).label(label));
    }
    id
}

/// Checks that there are fields, before and after `<extensions/>`.
fn check_presence(syntax: &Message, diagnostics: &mut Diagnostics) {
    let (name, count) = (&syntax.name, syntax.fields.len());
    if count == 0 {
        let message = format!("message `{}` has no fields", name.value);
        diagnostics.push(Diagnostic::new(Code::NoFields, name.span, message));
        return;
    }
    let Some(extensions) = syntax.extensions.first() else { return };
    if extensions.value == 0 {
        let message = format!("`<extensions/>` stands before the first field of `{}`", name.value);
        let problem = Diagnostic::new(Code::Extensions, extensions.span, message);
        diagnostics.push(problem.help("at least one field has to be there in MAVLink 1 as well"));
    } else if extensions.value >= count {
        let message = format!("no field of message `{}` follows `<extensions/>`", name.value);
        diagnostics
            .push(Diagnostic::new(Code::EmptyExtensions, extensions.span, message).label("pymavlink refuses it"));
    }
}

fn base_count(syntax: &Message, diagnostics: &mut Diagnostics) -> usize {
    if let [first, second, ..] = &syntax.extensions[..] {
        let message = format!("`<extensions/>` stands twice in message `{}`", syntax.name.value);
        let problem = Diagnostic::new(Code::Extensions, second.span, message);
        diagnostics.push(problem.related(first.span, "the first one"));
    }
    syntax.extensions.first().map_or(syntax.fields.len(), |extensions| extensions.value)
}

/// Checks the number of fields and that their names differ.
fn check_fields(syntax: &Message, diagnostics: &mut Diagnostics) {
    let (name, count) = (&syntax.name, syntax.fields.len());
    if let Some(beyond) = syntax.fields.get(MOST_FIELDS) {
        let message = format!("message `{}` has {count} fields; {MOST_FIELDS} are allowed", name.value);
        let problem = Diagnostic::new(Code::TooManyFields, beyond.span, message);
        diagnostics.push(problem.label("one too many"));
    }
    let mut seen = HashMap::new();
    for field in &syntax.fields {
        if let Some(first) = seen.insert(field.name.value.as_str(), field.name.span) {
            let message = format!("field `{}` stands twice in message `{}`", field.name.value, name.value);
            let problem = Diagnostic::new(Code::DuplicateField, field.name.span, message);
            diagnostics.push(problem.label("second field of this name").related(first, "first field of this name"));
        }
    }
}

fn check_version_fields(syntax: &Message, fields: &[DraftField<'_>], diagnostics: &mut Diagnostics) {
    let mut versions = fields.iter().filter(|field| matches!(field.ty.scalar, Scalar::Version(_)));
    if let (Some(first), Some(second)) = (versions.next(), versions.next()) {
        let message = format!("`uint8_t_mavlink_version` stands twice in message `{}`", syntax.name.value);
        let problem = Diagnostic::new(Code::SecondVersionField, second.syntax.ty.span, message);
        let problem = problem.related(first.syntax.ty.span, "the first one");
        diagnostics.push(problem.help("one field with the version is enough"));
    }
}

fn check_instances(syntax: &Message, fields: &[DraftField<'_>], diagnostics: &mut Diagnostics) {
    let mut instances = fields.iter().filter(|field| field.instance);
    if let (Some(first), Some(second)) = (instances.next(), instances.next()) {
        let message = format!("message `{}` has more than one instance field", syntax.name.value);
        let problem = Diagnostic::new(Code::Instance, second.syntax.name.span, message);
        diagnostics.push(problem.related(first.syntax.name.span, "the first one"));
    }
}

fn layout(syntax: &Message, fields: &[DraftField<'_>], diagnostics: &mut Diagnostics) -> Option<Layout> {
    let name = &syntax.name;
    let placed = fields.iter().map(|field| (field.syntax.name.value.as_str(), field.ty, field.extension));
    match Layout::of(&name.value, &placed.collect_vec()) {
        Ok(layout) => Some(layout),
        Err((v1, v2)) => {
            let what = if v1 > LONGEST_PAYLOAD || v1 == v2 { "" } else { " with its extensions" };
            let message =
                format!("the payload of `{}` is {v2} bytes long{what}; {LONGEST_PAYLOAD} are allowed", name.value);
            diagnostics.refuse(Diagnostic::new(Code::PayloadTooLong, name.span, message).label(sum(fields, v2)))
        }
    }
}

/// How a length comes about: `2 × uint64_t + 200 × uint8_t = 16 + 200 = 216`.
fn sum(fields: &[DraftField<'_>], total: usize) -> String {
    let mut elements: Vec<(&str, usize, usize)> = Vec::new();
    for field in fields {
        let (name, size) = (field.ty.scalar.wire_name(), field.ty.scalar.size());
        let count = field.ty.size() / size;
        match elements.iter_mut().find(|(other, ..)| *other == name) {
            Some((_, sum, _)) => *sum += count,
            None => elements.push((name, count, size)),
        }
    }
    order::sort_by_key(&mut elements, |&(_, _, size)| std::cmp::Reverse(size));
    let counts: Vec<String> = elements.iter().map(|(name, count, _)| format!("{count} × {name}")).collect_vec();
    let bytes = elements.iter().map(|(_, count, size)| (count * size).to_string()).collect_vec();
    if bytes.len() < 2 {
        return format!("{} = {total} bytes", counts.concat());
    }
    format!("{} = {} = {total} bytes", counts.join(" + "), bytes.join(" + "))
}

fn field<'a>(
    field: &'a Field,
    (file, version): (FileIndex, u8),
    extension: bool,
    diagnostics: &mut Diagnostics,
) -> Option<DraftField<'a>> {
    let limits = number::limits([&field.min, &field.max, &field.increment], f64::is_finite, diagnostics);
    let instance = boolean::read(&field.instance, Attribute::AnyText("instance"), diagnostics);
    units::check(&field.units, diagnostics);
    let ty = field_type::resolve(&field.ty, version, diagnostics)?;
    check_target(field, ty, diagnostics);
    Some(DraftField {
        syntax: field,
        ty,
        extension,
        limits,
        display_bitmask: display_bitmask(field, ty, diagnostics),
        instance,
        origin: origin(file, field.span, &field.description, None),
    })
}

/// Reads `display`, whose only value is `bitmask`, which only integers can be shown as.
fn display_bitmask(field: &Field, ty: FieldType, diagnostics: &mut Diagnostics) -> bool {
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
fn check_target(field: &Field, ty: FieldType, diagnostics: &mut Diagnostics) {
    let name = field.name.value.as_str();
    let plain = FieldType { scalar: Scalar::U8, array: None };
    if matches!(name, "target_system" | "target_component") && ty != plain {
        let message = format!("`{name}` is a `{}` and will not be taken for an address", field.ty.value);
        let problem = Diagnostic::new(Code::TargetType, field.ty.span, message);
        diagnostics.push(problem.help("system and component ids are `uint8_t`"));
    }
}
