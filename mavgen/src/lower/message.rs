//! A message: its fields, its methods and its documentation.

use super::items::Items;
use super::named::{NamedAccess, NamedField, NamedMessage, spelled};
use super::{docs, types};
use crate::collect::CollectVec as _;
use crate::docs::line;
use crate::internal::Internal;
use crate::ir::{self, Invalid, Message, Scalar, Scope, Sentinel, Values};
use crate::rust::{Alias, Cell, Default, Docs, Field, Frame, Gives, Paragraph, Seen, Struct, Target};

impl<'d> Items<'d> {
    /// The items of a message; `conflicts` are lines about what other dialects have in its place.
    pub(super) fn message(self, at: usize, conflicts: Vec<String>) -> Result<Struct<'d>, Internal> {
        let message = self.message_at(at)?;
        let mut methods = self.accessors(message)?;
        methods.extend(self.bindings(message)?);
        Ok(Struct {
            ident: message.ty(),
            alias: docs::alias(&message.model.name.text, message.ty()),
            docs: self.message_docs(message, conflicts)?,
            deprecated: self.deprecation(&message.model.origin),
            fields: message.fields().map(|field| self.message_field(message, field)).try_collect_vec()?,
            methods,
            seen: seen(message)?,
            frame: frame(message),
        })
    }

    fn message_field(self, message: NamedMessage<'d>, field: NamedField<'d>) -> Result<Field<'d>, Internal> {
        let model = field.model;
        let secret = message.model.secret().is_some_and(|secret| secret.offset == model.offset);
        Ok(Field {
            ident: field.ident,
            element: self.element(field)?,
            shape: types::shape(model),
            default: match model.ty.scalar {
                Scalar::Version(version) => Default::Version(version),
                _ => Default::Zero,
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
        let facts = [facts].into_iter().chain(docs::reference(file, &name.text)).collect_vec();
        let mut paragraphs = docs::description(&message.origin);
        let given = self.overlay_methods(named)?;
        paragraphs.extend([
            Paragraph::Lines(facts),
            Paragraph::Lines(conflicts),
            Paragraph::Lines(given),
            wire_table(message),
        ]);
        Ok(Docs(paragraphs))
    }

    /// What overlays give the message beside its fields.
    fn overlay_methods(self, message: NamedMessage<'d>) -> Result<Vec<String>, Internal> {
        let views = (0..message.model.views.len()).map(|at| {
            let view = message.view(at)?;
            let (getter, what) = match view.access()? {
                NamedAccess::Once(getter) => (getter, "packed bits".to_owned()),
                NamedAccess::Slots(slots) => (slots.items, "packed bits".to_owned()),
                NamedAccess::Record(record) => {
                    let condition = self.condition(message, view)?.map(|asked| format!(" if {asked}"));
                    (record.getter, format!("values{}", condition.unwrap_or_default()))
                }
            };
            Ok(format!("- [`Self::{getter}()`]: {what}, as `{}`.", view.ty()))
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
        facts.extend(field.invalid.as_ref().map(|invalid| sentinel_sentence(invalid, field)));
        let mut sentences = Vec::new();
        if !facts.is_empty() {
            sentences.push(docs::capitalised(&format!("{}.", facts.join("; "))));
        }
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

/// The getters of what overlays see in the message.
fn seen(message: NamedMessage<'_>) -> Result<Vec<Seen<'_>>, Internal> {
    let under = |condition: bool| if condition { Gives::Maybe } else { Gives::One };
    let bound =
        message.bindings().map(|(binding, getter)| Ok(Seen { getter, gives: under(binding.condition.is_some()) }));
    let views = (0..message.model.views.len()).map(|at| {
        let view = message.view(at)?;
        Ok(match view.access()? {
            NamedAccess::Once(getter) => Seen { getter, gives: under(view.model.condition.is_some()) },
            NamedAccess::Slots(slots) => Seen { getter: slots.items, gives: Gives::Each },
            NamedAccess::Record(record) => Seen { getter: record.getter, gives: under(view.model.condition.is_some()) },
        })
    });
    bound.chain(views).try_collect_vec()
}

fn frame(message: NamedMessage<'_>) -> Frame<'_> {
    let NamedMessage { model, .. } = message;
    let target = |field: Option<&ir::Field>| {
        let field = message.named(field?)?;
        Some(Target { field: field.ident, offset: field.model.offset })
    };
    Frame {
        id: model.id,
        name: &model.name.text,
        crc_extra: model.crc_extra,
        len_v1: model.len_v1,
        len_v2: model.len_v2,
        target_system: target(model.target_system()),
        target_component: target(model.target_component()),
    }
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

/// `65535 means not known`.
fn sentinel_sentence(invalid: &Invalid, field: &ir::Field) -> String {
    let value = match invalid.sentinel {
        Sentinel::Integer(value) => value.to_string(),
        Sentinel::Float(value) => value.to_string(),
        Sentinel::NotANumber => "NaN".to_owned(),
    };
    match (invalid.scope, field.ty.array) {
        (Scope::Each, None) => format!("{value} means not known"),
        (Scope::Each, Some(_)) => format!("{value} means that an element is not known"),
        (Scope::Whole, _) => format!("{value} in the first element means that none is known"),
        (Scope::First, _) => format!("{value} means that the first element is not known"),
    }
}
