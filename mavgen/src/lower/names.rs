//! What everything of a dialect is called in Rust: decided here once, for the whole dialect, and read by all that comes later.
//!
//! The spelling is [`super::spelling`]'s; here is what depends on other names.

mod check;
mod commands;
pub(super) mod methods;
#[cfg(test)]
mod tests;

use std::collections::HashSet;

use super::spelling;
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
#[cfg(any(feature = "compare", doc))]
use crate::ir::Dialect;
use crate::ir::{Access, Enum, FieldIndex, Kept, Message, Partial, Record, Slots, SwitchOn, View};

pub(super) use check::dialect_type;
pub(super) use commands::drop_rivals;

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

#[derive(Clone, Debug)]
pub(crate) struct ViewNames {
    /// The type: `Esc32Status`.
    pub(crate) ty: String,
    /// The module and file: `esc32_status`.
    pub(crate) module: String,
    /// The getter on the message, `flight_sw`, or that of one slot, `esc`. Other methods have a prefix before it: `set_flight_sw`.
    pub(crate) getter: String,
    /// Of a view that a message gives in slots.
    pub(crate) slots: Option<SlotNames>,
    /// Of [`View::keys`].
    pub(crate) keys: Vec<String>,
    /// The getter of the field that its switch looks at; `None` if there is no switch, or it looks at bits.
    pub(crate) switch: Option<String>,
    /// The getters of [`View::members`].
    pub(crate) members: Vec<String>,
}

#[derive(Clone, Debug)]
pub(crate) struct SlotNames {
    /// The type of a slot: `Esc`.
    pub(crate) ty: String,
    /// The iterator: `escs`.
    pub(crate) items: String,
}

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
        let dialect_name = dialect_type(&dialect.name, "Dialect", &types, diagnostics);
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
        let switch = view.switch.as_ref().filter(|switch| matches!(switch.on, SwitchOn::Field(..)));
        let (getter, slots) = match &view.access {
            Access::Once { getter } | Access::Record(Record { getter, .. }) => (spelling::label(getter), None),
            Access::Slots(Slots { item, items, .. }) => {
                let slots = SlotNames { ty: spelling::type_name(&item.text), items: spelling::label(items) };
                (spelling::field_name(&item.text), Some(slots))
            }
        };
        Self {
            ty: spelling::type_name(&view.name.text),
            module: spelling::item_module_name(&view.name.text),
            getter,
            slots,
            keys: view.keys().iter().map(|key| spelling::label(&key.name)).collect_vec(),
            switch: switch.map(|switch| spelling::label(&switch.name)),
            members: view.members.iter().map(|member| spelling::label(&member.name)).collect_vec(),
        }
    }
}

impl EnumNames {
    fn of(enum_: &Enum, messages: &HashSet<String>) -> Self {
        let entries = enum_.entries.iter().map(|entry| entry.name.text.as_str());
        let own = enum_.entries.iter().filter(|entry| entry.origin.file == enum_.defined_in);
        let own = own.map(|entry| entry.name.text.as_str()).collect_vec();
        Self::new(&enum_.name.text, messages, spelling::constant_names(&enum_.name.text, &own, &entries.collect_vec()))
    }

    /// Those of an enum beside these types of messages.
    pub(super) fn new(xml: &str, messages: &HashSet<String>, constants: Vec<String>) -> Self {
        let ty = spelling::type_name(xml);
        Self {
            ty: if messages.contains(&ty) { spelling::suffixed(&ty, "Enum") } else { ty },
            module: spelling::item_module_name(xml),
            renamed: Vec::new(),
            commands: vec![None; constants.len()],
            constants,
        }
    }
}
