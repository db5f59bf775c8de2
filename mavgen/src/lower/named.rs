//! Parts of the wire model beside what they are called in Rust.

use super::names::{AccessNames, CommandNames, EnumNames, MessageNames, ViewNames};
use super::spelling::is_keyword;
use crate::internal::Internal;
use crate::ir::{
    Access, Binding, Command, Entry, Enum, Field, FieldIndex, Key, Member, Message, Param, Record, Slots, View,
};

/// A message.
#[derive(Clone, Copy)]
pub(crate) struct NamedMessage<'d> {
    pub(super) model: &'d Message,
    pub(super) names: &'d MessageNames,
}

/// A field.
#[derive(Clone, Copy)]
pub(super) struct NamedField<'d> {
    pub(super) model: &'d Field,
    pub(super) ident: &'d str,
}

/// A view.
#[derive(Clone, Copy)]
pub(super) struct NamedView<'d> {
    pub(super) model: &'d View,
    pub(super) names: &'d ViewNames,
}

/// How a message gives a view.
#[derive(Clone, Copy)]
pub(super) enum NamedAccess<'d> {
    /// Once, by this getter.
    Once(&'d str),
    /// Once a slot.
    Slots(NamedSlots<'d>),
    /// Once, as a record of values.
    Record(NamedRecord<'d>),
}

/// The slots that a message gives a view in.
#[derive(Clone, Copy)]
pub(super) struct NamedSlots<'d> {
    pub(super) model: &'d Slots,
    /// The type of a slot.
    pub(super) item: &'d str,
    /// The getter of one.
    pub(super) getter: &'d str,
    /// The iterator.
    pub(super) items: &'d str,
    keys: &'d [String],
}

/// A record of values.
#[derive(Clone, Copy)]
pub(super) struct NamedRecord<'d> {
    model: &'d Record,
    /// The getter.
    pub(super) getter: &'d str,
    values: &'d [String],
}

/// An enum.
#[derive(Clone, Copy)]
pub(super) struct NamedEnum<'d> {
    pub(super) model: &'d Enum,
    pub(super) names: &'d EnumNames,
}

impl<'d> NamedMessage<'d> {
    /// The type.
    pub(super) fn ty(self) -> &'d str {
        &self.names.ty
    }

    /// The field behind an index.
    pub(super) fn field(self, index: FieldIndex) -> Result<NamedField<'d>, Internal> {
        let found = self.model.fields.get(index.0).zip(self.names.fields.get(index.0));
        let (model, ident) = found.ok_or_else(|| Internal::new(format!("{} has no field {}", self.ty(), index.0)))?;
        Ok(NamedField { model, ident })
    }

    /// The fields in the order of the XML.
    pub(super) fn fields(self) -> impl Iterator<Item = NamedField<'d>> {
        self.model.fields.iter().zip(&self.names.fields).map(|(model, ident)| NamedField { model, ident })
    }

    /// The field that this one is, if it is one of the message's.
    pub(super) fn named(self, field: &Field) -> Option<NamedField<'d>> {
        self.fields().find(|named| named.model.offset == field.offset)
    }

    /// What overlays bind to fields, with the getters.
    pub(super) fn bindings(self) -> impl Iterator<Item = (&'d Binding, &'d str)> {
        self.model.bindings.iter().zip(self.names.bindings.iter().map(String::as_str))
    }

    /// The view behind a place.
    pub(super) fn view(self, at: usize) -> Result<NamedView<'d>, Internal> {
        let found = self.model.views.get(at).zip(self.names.views.get(at));
        let (model, names) = found.ok_or_else(|| Internal::new(format!("{} has no view {at}", self.ty())))?;
        Ok(NamedView { model, names })
    }
}

impl<'d> NamedView<'d> {
    /// The type.
    pub(super) fn ty(self) -> &'d str {
        &self.names.ty
    }

    /// The members, with their getters.
    pub(super) fn members(self) -> impl Iterator<Item = (&'d Member, &'d str)> {
        self.model.members.iter().zip(self.names.members.iter().map(String::as_str))
    }

    /// The getter of the field that the switch looks at.
    pub(super) fn switch_getter(self) -> Result<&'d str, Internal> {
        let getter = self.names.switch.as_deref();
        getter.ok_or_else(|| Internal::new(format!("the switch of {} has no getter", self.ty())))
    }

    /// How the message gives it.
    pub(super) fn access(self) -> Result<NamedAccess<'d>, Internal> {
        match (&self.model.access, &self.names.access) {
            (Access::Once { .. }, AccessNames::Once { getter }) => Ok(NamedAccess::Once(getter)),
            (Access::Slots(model), AccessNames::Slots { item, getter, items, keys }) => {
                Ok(NamedAccess::Slots(NamedSlots { model, item, getter, items, keys }))
            }
            (Access::Record(model), AccessNames::Record { getter, values }) => {
                Ok(NamedAccess::Record(NamedRecord { model, getter, values }))
            }
            _ => Err(Internal::new(format!("{} is named as what it is not", self.ty()))),
        }
    }
}

impl<'d> NamedSlots<'d> {
    /// What a slot carries beside the view, with its fields.
    pub(super) fn keys(self) -> impl Iterator<Item = (&'d Key, &'d str)> {
        self.model.keys.iter().zip(self.keys.iter().map(String::as_str))
    }
}

impl<'d> NamedRecord<'d> {
    /// The values, with the fields of the record.
    pub(super) fn values(self) -> impl Iterator<Item = (&'d Key, &'d str)> {
        self.model.values.iter().zip(self.values.iter().map(String::as_str))
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

/// A typed command.
#[derive(Clone, Copy)]
pub(super) struct NamedCommand<'d> {
    pub(super) entry: &'d Entry,
    pub(super) model: &'d Command,
    pub(super) names: &'d CommandNames,
}

impl<'d> NamedCommand<'d> {
    /// The params, each with its field, if it has one.
    pub(super) fn params(self) -> impl Iterator<Item = (&'d Param, Option<&'d str>)> {
        self.model.params.iter().zip(self.names.fields.iter().map(Option::as_deref))
    }
}

/// A name as it is written: a keyword raw.
pub(super) fn spelled(name: &str) -> String {
    if is_keyword(name) { format!("r#{name}") } else { name.to_owned() }
}
