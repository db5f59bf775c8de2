//! What everything of a dialect is called in Rust: decided here once, for the whole dialect, and read by all that comes later.
//!
//! The spelling is [`super::spelling`]'s; here is what depends on other names.

mod check;
mod commands;
mod methods;
#[cfg(test)]
mod tests;

use std::collections::HashSet;

use super::spelling;
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
#[cfg(any(feature = "compare", doc))]
use crate::ir::Dialect;
use crate::ir::{Access, Enum, FieldIndex, Kept, Message, Partial, Record, Slots, Switch, SwitchOn, View};

pub(super) use commands::drop_rivals;
pub(super) use methods::{binding_methods, iterator, view_methods};

/// The names of a dialect, in the order of its model. A keyword is not raw here: `type`, not `r#type`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Names {
    /// The type that holds any message: `Autoquad`. One that a type has already takes the suffix `Dialect`.
    pub(crate) dialect: String,
    /// Of [`Dialect::messages`].
    pub(crate) messages: Vec<MessageNames>,
    /// Of [`Dialect::enums`].
    pub(crate) enums: Vec<EnumNames>,
}

/// The names of a message.
#[derive(Clone, Debug)]
pub(crate) struct MessageNames {
    /// The type: `GpsRawInt`.
    pub(crate) ty: String,
    /// The module and file: `gps_raw_int`.
    pub(crate) module: String,
    /// Of [`Message::fields`].
    pub(crate) fields: Vec<String>,
    /// The fields that have a getter and a setter beside them, in their order.
    pub(crate) accessors: Vec<FieldIndex>,
    /// The getters of [`Message::bindings`].
    pub(crate) bindings: Vec<String>,
    /// Of [`Message::views`].
    pub(crate) views: Vec<ViewNames>,
}

/// The names of a view.
#[derive(Clone, Debug)]
pub(crate) struct ViewNames {
    /// The type: `Esc32Status`.
    pub(crate) ty: String,
    /// The module and file: `esc32_status`.
    pub(crate) module: String,
    /// How the message gives it.
    pub(crate) access: AccessNames,
    /// The getter of the field that its switch looks at; `None` if there is no switch, or it looks at bits.
    pub(crate) switch: Option<String>,
    /// The getters of [`View::members`].
    pub(crate) members: Vec<String>,
}

/// What the methods of a message are called that give a view.
#[derive(Clone, Debug)]
pub(crate) enum AccessNames {
    /// A getter; `set_` before it is the setter.
    Once {
        /// `flight_sw`.
        getter: String,
    },
    /// Slots.
    Slots {
        /// The type of a slot: `Esc`.
        item: String,
        /// The getter: `esc`; `set_`, `push_` and, in private, `store_` stand before it.
        getter: String,
        /// The iterator: `escs`.
        items: String,
        /// The fields of a slot beside the view.
        keys: Vec<String>,
    },
    /// Values.
    Record {
        /// The getter: `gps`; `set_` and `with_` stand before it.
        getter: String,
        /// The fields of the record.
        values: Vec<String>,
    },
}

/// The names of an enum.
#[derive(Clone, Debug)]
pub(crate) struct EnumNames {
    /// The type: `MavState`. One that a message has already takes the suffix `Enum`.
    pub(crate) ty: String,
    /// The module and file: `mav_state`.
    pub(crate) module: String,
    /// Of [`Enum::entries`], without what they share.
    pub(crate) constants: Vec<String>,
    /// Names of entries in the definitions that are a constant of another entry: only several dialects together can have them.
    pub(crate) renamed: Vec<(String, String)>,
    /// Of [`Enum::entries`]: the typed commands, which only [`COMMANDS`] has.
    pub(crate) commands: Vec<Option<CommandNames>>,
}

/// The enum whose entries are typed commands.
pub(crate) const COMMANDS: &str = "MAV_CMD";

/// The names of a typed command.
#[derive(Clone, Debug)]
pub(crate) struct CommandNames {
    /// The type: `NavTakeoff`.
    pub(crate) ty: String,
    /// The module and file: `nav_takeoff`.
    pub(crate) module: String,
    /// Of [`crate::ir::Command::params`]: the fields. A param without a name, or one that is reserved, has none.
    pub(crate) fields: Vec<Option<String>>,
}

impl Names {
    /// Names a dialect, also one with errors, and reports what collides.
    pub(crate) fn check(partial: &Partial, diagnostics: &mut Diagnostics) -> Self {
        let Partial { dialect, lost, .. } = partial;
        let mut messages = dialect.messages.iter().map(MessageNames::of).collect_vec();
        let lost = lost.iter().map(|message| spelling::type_name(&message.name.text));
        let taken: HashSet<String> = messages.iter().map(|message| message.ty.clone()).chain(lost).collect();
        let mut enums = dialect.enums.iter().map(|enum_| EnumNames::of(enum_, &taken)).collect_vec();
        let types = check::types(partial, &messages, &enums, diagnostics);
        let dialect_name = check::dialect(&dialect.name, &types, diagnostics);
        check::fields(partial, &messages, diagnostics);
        check::constants(dialect, &enums, diagnostics);
        commands::name(dialect, &mut enums, diagnostics);
        for (message, names) in dialect.messages.iter().zip(&mut messages) {
            names.accessors = methods::check(message, names, diagnostics);
        }
        Self { dialect: dialect_name, messages, enums }
    }

    /// The names of a dialect without errors.
    #[cfg(feature = "compare")]
    pub(crate) fn of(dialect: &Dialect) -> Self {
        let partial = Partial { dialect: dialect.clone(), lost: Vec::new(), lost_views: Vec::new() };
        Self::check(&partial, &mut Diagnostics::default())
    }

    /// Drops the names of what does not stay.
    pub(crate) fn cut(&mut self, kept: &Kept) {
        kept.cut_messages(&mut self.messages);
        kept.cut_enums(&mut self.enums);
    }
}

impl MessageNames {
    /// The names of a message, without accessors so far: those hang on its other methods.
    fn of(message: &Message) -> Self {
        Self {
            ty: spelling::type_name(&message.name.text),
            module: spelling::item_module_name(&message.name.text),
            fields: message.fields.iter().map(|field| spelling::field_name(&field.name.text)).collect_vec(),
            accessors: Vec::new(),
            bindings: message.bindings.iter().map(|binding| spelling::label(&binding.name)).collect_vec(),
            views: message.views.iter().map(ViewNames::of).collect_vec(),
        }
    }
}

impl ViewNames {
    fn of(view: &View) -> Self {
        let switch = view.switch.as_ref().and_then(|Switch { name, on, .. }| match on {
            SwitchOn::Field(..) => Some(spelling::label(name)),
            SwitchOn::Bits { .. } => None,
        });
        Self {
            ty: spelling::type_name(&view.name.text),
            module: spelling::item_module_name(&view.name.text),
            access: match &view.access {
                Access::Once { getter } => AccessNames::Once { getter: spelling::label(getter) },
                Access::Slots(Slots { item, items, keys, .. }) => AccessNames::Slots {
                    item: spelling::type_name(&item.text),
                    getter: spelling::field_name(&item.text),
                    items: spelling::label(items),
                    keys: keys.iter().map(|key| spelling::label(&key.name)).collect_vec(),
                },
                Access::Record(Record { getter, values }) => AccessNames::Record {
                    getter: spelling::label(getter),
                    values: values.iter().map(|value| spelling::label(&value.name)).collect_vec(),
                },
            },
            switch,
            members: view.members.iter().map(|member| spelling::label(&member.name)).collect_vec(),
        }
    }
}

impl EnumNames {
    fn of(enum_: &Enum, messages: &HashSet<String>) -> Self {
        let ty = spelling::type_name(&enum_.name.text);
        let entries = enum_.entries.iter().map(|entry| entry.name.text.as_str());
        let own = enum_.entries.iter().filter(|entry| entry.origin.file == enum_.defined_in);
        let own = own.map(|entry| entry.name.text.as_str()).collect_vec();
        Self {
            ty: if messages.contains(&ty) { spelling::suffixed(&ty, "Enum") } else { ty },
            module: spelling::item_module_name(&enum_.name.text),
            constants: spelling::constant_names(&enum_.name.text, &own, &entries.collect_vec()),
            renamed: Vec::new(),
            commands: vec![None; enum_.entries.len()],
        }
    }
}
