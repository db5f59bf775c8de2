//! A message: its fields, its methods and its documentation.

use super::docs;
use super::items::{Items, NamedField, NamedMessage, spelled};
use crate::collect::CollectVec as _;
use crate::docs::line;
use crate::internal::Internal;
use crate::ir::{self, Access, Condition, Message, Scalar, Values};
use crate::rust::{Alias, Cell, Docs, Field, Frame, Gives, Paragraph, Struct};

impl<'d> Items<'d> {
    /// The items of a message; `conflicts` are lines about what other dialects have in its place.
    pub(super) fn message(self, at: usize, conflicts: Vec<String>) -> Result<Struct<'d>, Internal> {
        let message = self.message_at(at)?;
        Ok(Struct {
            ident: message.ty(),
            alias: docs::alias(&message.model.name.text, message.ty()),
            docs: self.message_docs(message, conflicts)?,
            deprecated: self.deprecation(&message.model.origin),
            fields: message.fields().map(|field| self.message_field(message, field)).try_collect_vec()?,
            methods: self.accessors(message)?,
            seen: seen(message),
            frame: frame(message),
        })
    }

    fn message_field(self, message: NamedMessage<'d>, field: NamedField<'d>) -> Result<Field<'d>, Internal> {
        let model = field.model;
        let secret = message.model.secret().is_some_and(|secret| secret.offset == model.offset);
        Ok(Field {
            ident: field.ident,
            element: self.element(field)?,
            shape: field.shape(),
            version: match model.ty.scalar {
                Scalar::Version(version) => Some(version),
                _ => None,
            },
            docs: self.field_docs(field, secret)?,
            secret,
            carries: model.values.map(|values| self.enum_type(values.id())).transpose()?,
            wire: model,
        })
    }

    /// The description, the facts of the frame and the wire table.
    fn message_docs(self, named: NamedMessage<'d>, conflicts: Vec<String>) -> Result<Docs<'d>, Internal> {
        let message = named.model;
        let file = self.file_name(message.origin.file)?;
        let Message { id, name, crc_extra, len_v1, len_v2, .. } = message;
        let length = match (len_v1 == len_v2, *id > 255) {
            (true, _) if *len_v2 == 1 => "1 byte".to_owned(),
            (true, _) => format!("{len_v2} bytes"),
            (false, true) => format!("{len_v2} bytes, {len_v1} without extensions"),
            (false, false) => format!("{len_v2} bytes, {len_v1} in MAVLink 1"),
        };
        let reach = if *id > 255 { "; MAVLink 2 only" } else { "" };
        let facts = format!("`{}`, message {id} of `{file}`: {length}, CRC_EXTRA {crc_extra}{reach}.", name.text);
        let mut paragraphs = docs::description(&message.origin);
        let given = self.overlay_methods(named)?;
        paragraphs.extend([
            docs::facts(facts, file, &name.text),
            Paragraph::Lines(conflicts),
            Paragraph::Lines(given),
            wire_table(message),
        ]);
        Ok(Docs(paragraphs))
    }

    /// What overlays give the message beside its fields.
    fn overlay_methods(self, message: NamedMessage<'d>) -> Result<Vec<String>, Internal> {
        let views = message.views().map(|view| {
            let what = match (&view.model.access, self.condition(view)?) {
                (Access::Once { .. } | Access::Slots(_), _) => "packed bits".to_owned(),
                (Access::Record(_), None) => "values".to_owned(),
                (Access::Record(_), Some(asked)) => format!("values if {asked}"),
            };
            Ok(format!("- [`Self::{}()`]: {what}, as `{}`.", view.getter(), view.ty()))
        });
        let bindings = message.bindings().map(|(binding, getter)| {
            let (field, bound) = (message.field(binding.field)?.ident, self.enum_type(binding.enum_)?);
            Ok(format!("- [`Self::{getter}()`]: `{}`, as {}.", spelled(field), docs::link(bound.ident)))
        });
        views.chain(bindings).try_collect_vec()
    }

    /// The description; then units, range, enum, sentinel, whether MAVLink 1 has it and whether it is a secret.
    fn field_docs(self, named: NamedField<'d>, secret: bool) -> Result<Docs<'d>, Internal> {
        let field = named.model;
        let mut facts = docs::quantity(field.units.as_deref(), field.multiplier.as_deref(), &field.limits);
        facts.extend(field.invalid.map(|invalid| docs::not_known(invalid, field.ty.array.is_some())));
        let mut sentences = docs::sentence(&facts).into_iter().collect_vec();
        if let Some(Values::Converted(id)) = field.values {
            let (name, to) = (named.ident, self.enum_type(id)?);
            sentences.push(format!("A number: [`Self::{name}()`] gives it as {}.", docs::link(to.ident)));
        }
        if field.extension {
            sentences.push("Extension: MAVLink 1 does not carry it.".to_owned());
        }
        if field.instance {
            sentences.push("Tells apart the instances that one sender reports.".to_owned());
        }
        if secret {
            sentences.push("Secret: `Debug`, reflection and `defmt` do not show it.".to_owned());
        }
        if field.origin.description.trim().is_empty() && sentences.is_empty() {
            sentences.push(format!("`{}`, a `{}`.", field.name.text, xml_type(field)));
        }
        Ok(Docs(vec![Paragraph::said(field.origin.description.as_str(), sentences)]))
    }
}

/// The name by which a deprecated message is used.
pub(super) fn alias<'d>(message: &Struct<'d>, module: &'d str) -> Option<Alias<'d>> {
    let Struct { ident, alias, docs, deprecated, .. } = message;
    let told = docs.0.iter().filter(|paragraph| !matches!(paragraph, Paragraph::Table(..)));
    // It stands one module higher than the file that its docs are made for, and so do its links.
    let higher = told.cloned().map(|paragraph| match paragraph {
        Paragraph::Lines(lines) => {
            Paragraph::Lines(lines.iter().map(|line| line.replace("](super::", "](")).collect_vec())
        }
        other => other,
    });
    let (docs, deprecated) = (Docs(higher.collect_vec()), deprecated.clone()?);
    Some(Alias { ident, alias: *alias, docs, deprecated, module })
}

fn seen(message: NamedMessage<'_>) -> Vec<(&str, Gives)> {
    let under = |condition: Option<Condition>| if condition.is_some() { Gives::Maybe } else { Gives::One };
    let bound = message.bindings().map(|(binding, getter)| (getter, under(binding.condition)));
    let views = message.views().map(|view| {
        let gives = if view.names.slots.is_some() { Gives::Each } else { under(view.model.condition) };
        (view.getter(), gives)
    });
    bound.chain(views).collect_vec()
}

fn frame(message: NamedMessage<'_>) -> Frame<'_> {
    let wire = message.model;
    let target = |field: Option<&ir::Field>| {
        let offset = field?.offset;
        Some((message.fields().find(|named| named.model.offset == offset)?.ident, offset))
    };
    Frame { wire, target_system: target(wire.target_system()), target_component: target(wire.target_component()) }
}

/// What lies where in the payload.
fn wire_table(message: &Message) -> Paragraph<'_> {
    let row = |field: &ir::Field| {
        let extension = if field.extension { " (extension)" } else { "" };
        let units = field.units.as_deref().map(line).unwrap_or_default();
        let name = format!("`{}`{extension}", field.name.text);
        [field.offset.to_string(), name, format!("`{}`", xml_type(field)), units].map(Cell::Plain).to_vec()
    };
    let rows = message.wire_order().into_iter().map(row).collect_vec();
    Paragraph::Table(vec!["offset", "field", "type", "units"], rows)
}

/// The type in the spelling of the XML: `uint16_t[4]`.
fn xml_type(field: &ir::Field) -> String {
    let scalar = match field.ty.scalar {
        Scalar::Version(_) => "uint8_t_mavlink_version",
        other => other.wire_name(),
    };
    field.ty.array.map_or_else(|| scalar.to_owned(), |n| format!("{scalar}[{n}]"))
}
