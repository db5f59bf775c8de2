//! What all items are made of: messages, fields, views, enums and commands of the wire model beside what they are called in
//! Rust.

use super::link::{Placement, Union};
use super::names::{CommandNames, EnumNames, MessageNames, Names, SlotNames, ViewNames};
use super::spelling::is_keyword;
use crate::internal::Internal;
use crate::ir::{
    Binding, Command, Dialect, Entry, Enum, EnumId, Field, FieldIndex, FileIndex, Key, Lifecycle, Member, Message,
    Origin, Param, Scalar, Slots, Valid, Values, View,
};
use crate::rust::{Element, EnumType, Literal, Shape};

/// What the items of a dialect are made of.
#[derive(Clone, Copy)]
pub(super) struct Items<'d> {
    /// All that is generated, of however many dialects.
    pub(super) dialect: &'d Dialect,
    /// What everything in it is called.
    pub(super) names: &'d Names,
    /// The dialects, if there are several.
    pub(super) union: Option<&'d Union>,
    /// The folder of the file that is being made.
    pub(super) placement: Placement,
    /// Whether `<deprecated>` becomes `#[deprecated]`.
    pub(super) deprecated: bool,
}

#[derive(Clone, Copy)]
pub(super) struct NamedMessage<'d> {
    pub(super) model: &'d Message,
    pub(super) names: &'d MessageNames,
}

#[derive(Clone, Copy)]
pub(super) struct NamedField<'d> {
    pub(super) model: &'d Field,
    pub(super) ident: &'d str,
}

#[derive(Clone, Copy)]
pub(super) struct NamedView<'d> {
    pub(super) message: NamedMessage<'d>,
    pub(super) model: &'d View,
    pub(super) names: &'d ViewNames,
}

/// The slots that a message gives a view in.
#[derive(Clone, Copy)]
pub(super) struct NamedSlots<'d> {
    pub(super) view: NamedView<'d>,
    pub(super) model: &'d Slots,
    pub(super) names: &'d SlotNames,
}

#[derive(Clone, Copy)]
pub(super) struct NamedEnum<'d> {
    pub(super) model: &'d Enum,
    pub(super) names: &'d EnumNames,
}

#[derive(Clone, Copy)]
pub(super) struct NamedCommand<'d> {
    pub(super) entry: &'d Entry,
    pub(super) model: &'d Command,
    pub(super) names: &'d CommandNames,
}

impl<'d> Items<'d> {
    /// Those of one dialect.
    pub(super) fn of(valid: Valid<'d>, names: &'d Names, deprecated: bool) -> Self {
        Self { dialect: valid.dialect(), names, union: None, placement: Placement::Shared, deprecated }
    }

    /// Those of several, which were legal when they were linked.
    pub(super) fn of_several(union: &'d Union, deprecated: bool) -> Self {
        let Union { all, names, .. } = union;
        Self { dialect: all, names, union: Some(union), placement: Placement::Shared, deprecated }
    }

    pub(super) fn file_name(self, index: FileIndex) -> Result<&'d str, Internal> {
        let file = self.dialect.file(index).map(|file| file.name.as_str());
        file.ok_or_else(|| Internal::new(format!("there is no file {}", index.0)))
    }

    /// Whether naming the item makes the compiler warn.
    pub(super) fn is_deprecated(self, origin: &Origin) -> bool {
        self.deprecated && matches!(origin.lifecycle, Some(Lifecycle::Deprecated(_)))
    }

    pub(super) fn message_at(self, at: usize) -> Result<NamedMessage<'d>, Internal> {
        let (model, names) = beside(&self.dialect.messages, &self.names.messages, at, "message")?;
        Ok(NamedMessage { model, names })
    }

    pub(super) fn enum_at(self, id: EnumId) -> Result<NamedEnum<'d>, Internal> {
        let (model, names) = beside(&self.dialect.enums, &self.names.enums, id.0, "enum")?;
        Ok(NamedEnum { model, names })
    }

    /// The enum behind an id, as others name it.
    pub(super) fn enum_type(self, id: EnumId) -> Result<EnumType<'d>, Internal> {
        let NamedEnum { model, names } = self.enum_at(id)?;
        let deprecated = self.is_deprecated(&model.origin);
        Ok(EnumType { id, ident: &names.ty, int: model.repr.into(), flags: model.bitmask, deprecated })
    }

    /// The type of one element of a field.
    pub(super) fn element(self, field: NamedField<'d>) -> Result<Element<'d>, Internal> {
        match field.model.values {
            Some(Values::Typed(id)) => self.enum_type(id).map(Element::Enum),
            Some(Values::Converted(_)) | None => Ok(Element::plain(field.model.ty.scalar)),
        }
    }

    /// A number as a value of a field: the constant of its enum, if there is one that can be named without a warning.
    pub(super) fn literal(self, field: NamedField<'d>, number: i128) -> Result<Literal<'d>, Internal> {
        let element = self.element(field)?;
        if let Element::Enum(one) = element {
            let mut entries = self.enum_at(one.id)?.entries().filter(|(entry, _)| i128::from(entry.value) == number);
            if let Some((entry, constant)) = entries.next()
                && !self.is_deprecated(&entry.origin)
            {
                return Ok(Literal::Constant(one, constant));
            }
        }
        Ok(Literal::Number(element, number))
    }
}

impl<'d> NamedMessage<'d> {
    pub(super) fn ty(self) -> &'d str {
        &self.names.ty
    }

    pub(super) fn field(self, index: FieldIndex) -> Result<NamedField<'d>, Internal> {
        let (model, ident) = beside(&self.model.fields, &self.names.fields, index.0, "field")?;
        Ok(NamedField { model, ident })
    }

    /// The fields in the order of the XML.
    pub(super) fn fields(self) -> impl Iterator<Item = NamedField<'d>> {
        self.model.fields.iter().zip(&self.names.fields).map(|(model, ident)| NamedField { model, ident })
    }

    /// What overlays bind to fields, with the getters.
    pub(super) fn bindings(self) -> impl Iterator<Item = (&'d Binding, &'d str)> {
        self.model.bindings.iter().zip(self.names.bindings.iter().map(String::as_str))
    }

    pub(super) fn view(self, at: usize) -> Result<NamedView<'d>, Internal> {
        let (model, names) = beside(&self.model.views, &self.names.views, at, "view")?;
        Ok(NamedView { message: self, model, names })
    }

    pub(super) fn views(self) -> impl Iterator<Item = NamedView<'d>> {
        let views = self.model.views.iter().zip(&self.names.views);
        views.map(move |(model, names)| NamedView { message: self, model, names })
    }
}

impl NamedField<'_> {
    /// How many elements it has, and in what.
    pub(super) fn shape(self) -> Shape {
        match (self.model.ty.array, self.model.ty.scalar) {
            (None, _) => Shape::One,
            (Some(n), Scalar::Char) => Shape::Chars(n.get()),
            (Some(n), _) => Shape::Array(n.get()),
        }
    }
}

impl<'d> NamedView<'d> {
    pub(super) fn ty(self) -> &'d str {
        &self.names.ty
    }

    /// The method by which a message gives it, or all slots of it.
    pub(super) fn getter(self) -> &'d str {
        self.names.slots.as_ref().map_or(&self.names.getter, |slots| &slots.items)
    }

    /// The fields that are copied, with those of the slot or record.
    pub(super) fn keys(self) -> impl Iterator<Item = (&'d Key, &'d str)> {
        self.model.keys().iter().zip(self.names.keys.iter().map(String::as_str))
    }

    pub(super) fn members(self) -> impl Iterator<Item = (&'d Member, &'d str)> {
        self.model.members.iter().zip(self.names.members.iter().map(String::as_str))
    }

    /// The getter of the field that the switch looks at.
    pub(super) fn switch_getter(self) -> Result<&'d str, Internal> {
        let getter = self.names.switch.as_deref();
        getter.ok_or_else(|| Internal::new(format!("the switch of {} has no getter", self.ty())))
    }
}

impl<'d> NamedEnum<'d> {
    /// The entries, with their constants.
    pub(super) fn entries(self) -> impl Iterator<Item = (&'d Entry, &'d str)> {
        self.model.entries.iter().zip(self.names.constants.iter().map(String::as_str))
    }

    /// The typed commands, by number.
    pub(super) fn commands(self) -> impl Iterator<Item = NamedCommand<'d>> {
        let each = self.model.entries.iter().zip(&self.names.commands);
        each.filter_map(|(entry, names)| {
            Some(NamedCommand { entry, model: entry.command.as_ref()?, names: names.as_ref()? })
        })
    }
}

impl<'d> NamedCommand<'d> {
    /// The params, each with its field, if it has one.
    pub(super) fn params(self) -> impl Iterator<Item = (&'d Param, Option<&'d str>)> {
        self.model.params.iter().zip(self.names.fields.iter().map(Option::as_deref))
    }
}

/// What stands at a place of a model, and its names at the same place.
pub(super) fn beside<'d, M, N>(
    models: &'d [M],
    names: &'d [N],
    at: usize,
    what: &str,
) -> Result<(&'d M, &'d N), Internal> {
    models.get(at).zip(names.get(at)).ok_or_else(|| Internal::new(format!("there is no {what} {at}")))
}

/// A name as it is written: a keyword raw.
pub(super) fn spelled(name: &str) -> String {
    if is_keyword(name) { format!("r#{name}") } else { name.to_owned() }
}
