//! Messages: their fields, lengths and checksum.

use std::collections::{HashMap, HashSet};
use std::ptr;

use super::field::{self, Surroundings};
use super::layout::{self, Lengths};
use super::losses::Losses;
use super::origin::Described;
use super::version::Version;
use super::{crc, field_type, number, spelling};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{self, Field, FieldType, FileIndex, Scalar};
use crate::read::Loaded;
use crate::syntax::{self, Message};

/// pymavlink's limit on the fields of a message.
const MOST_FIELDS: usize = 64;

/// Ids have 24 bits.
const LARGEST_ID: u32 = 0xFF_FFFF;

/// Payload lengths have 8 bits.
const LONGEST_PAYLOAD: usize = 255;

/// A message without its enums and `invalid` values, beside the syntax that it came from.
pub(super) struct Draft<'a> {
    /// The message.
    pub(super) message: ir::Message,
    /// Where it was written; it has as many fields.
    pub(super) syntax: &'a Message,
}

impl<'a> Draft<'a> {
    /// The fields with their syntax.
    pub(super) fn fields(&self) -> impl Iterator<Item = (&Field, &'a syntax::Field)> {
        self.message.fields.iter().zip(&self.syntax.fields)
    }
}

/// Reads the messages of all files; those that cannot be are reported and left out.
pub(super) fn drafts<'a>(
    loaded: &'a Loaded,
    versions: &[Version],
    losses: &Losses,
    diagnostics: &mut Diagnostics,
) -> Vec<Draft<'a>> {
    let mut drafts = Vec::new();
    for ((index, file), version) in loaded.files.iter().enumerate().zip(versions) {
        for (position, syntax) in file.messages.iter().enumerate() {
            let around = Surroundings { file: FileIndex(index), version: version.seen_by(position), extension: false };
            let whole = !losses.near(syntax.span);
            let message = resolve(syntax, around, whole, diagnostics);
            drafts.extend(message.map(|message| Draft { message, syntax }));
        }
    }
    drafts
}

/// A field of a message that cannot be read: what is wrong with the field itself is still worth a word.
pub(super) struct Lost<'a> {
    /// Its type.
    pub(super) ty: FieldType,
    /// Where it was written.
    pub(super) syntax: &'a syntax::Field,
}

/// The fields of the messages that are no drafts, those whose type is one.
pub(super) fn lost<'a>(loaded: &'a Loaded, drafts: &[Draft<'_>]) -> Vec<Lost<'a>> {
    let drafted: HashSet<*const Message> = drafts.iter().map(|draft| ptr::from_ref(draft.syntax)).collect();
    let messages = loaded.files.iter().flat_map(|file| &file.messages);
    let lost = messages.filter(|&message| !drafted.contains(&ptr::from_ref(message)));
    let fields = lost.flat_map(|message| &message.fields);
    fields.filter_map(|syntax| Some(Lost { ty: field_type::named(&syntax.ty)?, syntax })).collect()
}

fn resolve(syntax: &Message, around: Surroundings, whole: bool, diagnostics: &mut Diagnostics) -> Option<ir::Message> {
    let id = id(syntax, diagnostics);
    if whole {
        check_presence(syntax, diagnostics);
    }
    let base = base_count(syntax, diagnostics);
    let resolved: Vec<Option<Field>> = (syntax.fields.iter().enumerate())
        .map(|(position, field)| {
            let around = Surroundings { extension: position >= base, ..around };
            field::resolve(field, around, diagnostics)
        })
        .collect();
    check_fields(syntax, diagnostics);
    let described = Described {
        file: around.file,
        span: syntax.span,
        description: syntax.description.as_ref(),
        lifecycle: syntax.lifecycle.as_ref(),
    };
    let origin = described.origin(diagnostics);
    let mut fields = resolved.into_iter().collect::<Option<Vec<Field>>>()?;
    check_version_fields(syntax, &fields, diagnostics);
    check_instances(syntax, &fields, diagnostics);
    let (len_v1, len_v2) = lengths(syntax, &mut fields, diagnostics)?;
    let mut message = ir::Message {
        id: id?,
        name: spelling::name(&syntax.name),
        crc_extra: 0,
        len_v1,
        len_v2,
        fields,
        views: Vec::new(),
        bindings: Vec::new(),
        origin,
    };
    message.crc_extra = crc::crc_extra(&message.name.text, message.wire_order());
    Some(message)
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

/// How many fields stand before `<extensions/>`.
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

fn check_version_fields(syntax: &Message, fields: &[Field], diagnostics: &mut Diagnostics) {
    let mut versions =
        fields.iter().zip(&syntax.fields).filter(|(field, _)| matches!(field.ty.scalar, Scalar::Version(_)));
    if let (Some((_, first)), Some((_, second))) = (versions.next(), versions.next()) {
        let message = format!("`uint8_t_mavlink_version` stands twice in message `{}`", syntax.name.value);
        let problem = Diagnostic::new(Code::SecondVersionField, second.ty.span, message);
        diagnostics.push(problem.related(first.ty.span, "the first one").help("one field with the version is enough"));
    }
}

fn check_instances(syntax: &Message, fields: &[Field], diagnostics: &mut Diagnostics) {
    let mut instances = fields.iter().zip(&syntax.fields).filter(|(field, _)| field.instance);
    if let (Some((_, first)), Some((_, second))) = (instances.next(), instances.next()) {
        let message = format!("message `{}` has more than one instance field", syntax.name.value);
        let problem = Diagnostic::new(Code::Instance, second.name.span, message);
        diagnostics.push(problem.related(first.name.span, "the first one"));
    }
}

/// Places the fields and checks that the payload is one.
fn lengths(syntax: &Message, fields: &mut [Field], diagnostics: &mut Diagnostics) -> Option<(u8, u8)> {
    let Lengths { v1, v2 } = layout::place(fields);
    if v2 > LONGEST_PAYLOAD {
        let what = if v1 > LONGEST_PAYLOAD || v1 == v2 { "" } else { " with its extensions" };
        let message =
            format!("the payload of `{}` is {v2} bytes long{what}; {LONGEST_PAYLOAD} are allowed", syntax.name.value);
        let problem = Diagnostic::new(Code::PayloadTooLong, syntax.name.span, message);
        diagnostics.push(problem.label(sum(fields, v2)));
    }
    Some((u8::try_from(v1).ok()?, u8::try_from(v2).ok()?))
}

/// How a length comes about: `2 × uint64_t + 200 × uint8_t = 16 + 200 = 216`.
fn sum(fields: &[Field], total: usize) -> String {
    let mut elements: Vec<(&str, usize, usize)> = Vec::new();
    for field in fields {
        let (name, size) = (field.ty.scalar.wire_name(), field.ty.scalar.size());
        let count = field.size() / size;
        match elements.iter_mut().find(|(other, ..)| *other == name) {
            Some((_, sum, _)) => *sum += count,
            None => elements.push((name, count, size)),
        }
    }
    elements.sort_by_key(|&(_, _, size)| std::cmp::Reverse(size));
    let counts: Vec<String> = elements.iter().map(|(name, count, _)| format!("{count} × {name}")).collect();
    let bytes: Vec<String> = elements.iter().map(|(_, count, size)| (count * size).to_string()).collect();
    if bytes.len() < 2 {
        return format!("{} = {total} bytes", counts.concat());
    }
    format!("{} = {} = {total} bytes", counts.join(" + "), bytes.join(" + "))
}
