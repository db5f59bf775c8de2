//! What things are called in Rust.

use super::{Internal, Items};
use crate::ir::{Binding, Entry, Enum, Field, Key, Label, Member, Message, Name, Slots, Switch, View};
use crate::lower::spelling::{field_name, is_keyword};

impl<'d> Items<'d> {
    pub(super) fn message_type(self, message: &'d Message) -> &'d str {
        rust(&message.name)
    }

    pub(super) fn enum_name(self, one: &'d Enum) -> &'d str {
        rust(&one.name)
    }

    pub(super) fn constant(self, entry: &'d Entry) -> &'d str {
        rust(&entry.name)
    }

    pub(super) fn field_name(self, field: &'d Field) -> &'d str {
        rust(&field.name)
    }

    /// The fields that have a getter and a setter beside them.
    pub(super) fn fields_with_accessors(self, message: &'d Message) -> Result<Vec<&'d Field>, Internal> {
        let at = self.dialect.messages.iter().position(|other| std::ptr::eq(other, message));
        let names =
            at.and_then(|at| self.names.messages.get(at)).ok_or_else(|| Internal::new("a message has no names"))?;
        names.accessors.iter().map(|&index| self.field(message, index)).collect()
    }

    pub(super) fn view_type(self, view: &'d View) -> &'d str {
        rust(&view.name)
    }

    pub(super) fn slot_type(self, slots: &'d Slots) -> &'d str {
        rust(&slots.item)
    }

    /// `esc`: the getter of a slot, and what its setters are named after.
    pub(super) fn slot_getter(self, slots: &'d Slots) -> String {
        field_name(&slots.item.text)
    }

    pub(super) fn slot_iterator(self, slots: &Slots) -> String {
        slots.items.rust()
    }

    pub(super) fn once_getter(self, getter: &Label) -> String {
        getter.rust()
    }

    pub(super) fn slot_field(self, key: &Key) -> String {
        key.name.rust()
    }

    pub(super) fn member_getter(self, member: &Member) -> String {
        member.name.rust()
    }

    pub(super) fn switch_getter(self, switch: &Switch) -> String {
        switch.name.rust()
    }

    pub(super) fn binding_getter(self, binding: &Binding) -> String {
        binding.name.rust()
    }
}

fn rust(name: &Name) -> &str {
    &name.rust
}

/// A name as it is written: a keyword raw.
pub(super) fn spelled(name: &str) -> String {
    if is_keyword(name) { format!("r#{name}") } else { name.to_owned() }
}
