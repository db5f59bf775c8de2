//! Every mention of an enum in the model, in one place: whatever gains one is visited here, and the compiler asks for it.

use super::{
    Access, Binding, Command, Condition, Entry, Enum, EnumId, Field, Key, Meaning, Member, Message, Param, Record,
    Scaled, Slots, Switch, SwitchOn, Values, View, ViewSentinel,
};

/// The visits of messages and of enums, to look at ids or to change them.
macro_rules! visits {
    ($message:ident $enum:ident $condition:ident $($mut:ident)?) => {
        /// Visits every enum that a message names.
        pub(crate) fn $message(message: & $($mut)? Message, visit: &mut dyn FnMut(& $($mut)? EnumId)) {
            let Message { fields, views, bindings, id: _, name: _, crc_extra: _, len_v1: _, len_v2: _, origin: _ } = message;
            for Field {
                values, name: _, ty: _, offset: _, extension: _, units: _, invalid: _, limits: _, multiplier: _, default: _,
                print_format: _, display_bitmask: _, instance: _, origin: _,
            } in fields {
                if let Some(Values::Typed(id) | Values::Converted(id)) = values {
                    visit(id);
                }
            }
            for View {
                condition, members, access: _, invalid: _, switch: _, name: _, words: _, width: _, origin: _,
            } in views {
                $condition(condition, visit);
                for Member { meaning, name: _, at: _, width: _, signed: _, repeat: _, presence: _, description: _ } in members {
                    match meaning {
                        Meaning::Values(id) => visit(id),
                        Meaning::Flag | Meaning::Number { units: _ } | Meaning::Scaled(_) => {}
                    }
                }
            }
            for Binding { enum_, condition, name: _, field: _, description: _ } in bindings {
                visit(enum_);
                $condition(condition, visit);
            }
        }

        fn $condition(condition: & $($mut)? Option<Condition>, visit: &mut dyn FnMut(& $($mut)? EnumId)) {
            if let Some(Condition { enum_: Some(id), field: _, value: _ }) = condition {
                visit(id);
            }
        }

        /// Visits every enum that the params of an enum of commands name.
        pub(crate) fn $enum(enum_: & $($mut)? Enum, visit: &mut dyn FnMut(& $($mut)? EnumId)) {
            let Enum { entries, name: _, named_in: _, bitmask: _, repr: _, defined_in: _, origin: _ } = enum_;
            for Entry { command, name: _, value: _, auto: _, origin: _ } in entries {
                let Some(Command { params, has_location: _, is_destination: _, mission_only: _ }) = command else { continue };
                for Param {
                    enum_, index: _, label: _, units: _, limits: _, default: _, reserved: _, origin: _,
                } in params {
                    if let Some(id) = enum_ {
                        visit(id);
                    }
                }
            }
        }
    };
}

visits!(enums_of_message enums_of_enum of_condition);
visits!(enums_of_message_mut enums_of_enum_mut of_condition_mut mut);

/// What names no enum so far: who adds to one of these comes by here.
const _: fn(Access, Slots, Record, Key, ViewSentinel, Switch, SwitchOn, Scaled) =
    |access, slots, record, key, sentinel, switch, on, scaled| {
        let (Access::Once { getter: _ } | Access::Slots(_) | Access::Record(_)) = access;
        let Slots { item: _, items: _, length: _, count: _, keys: _ } = slots;
        let Record { getter: _, values: _ } = record;
        let Key { name: _, place: _, units: _, invalid: _, description: _ } = key;
        let (ViewSentinel::Field(_, _) | ViewSentinel::Words(_)) = sentinel;
        let Switch { name: _, on: _, span: _ } = switch;
        let (SwitchOn::Field(_, _) | SwitchOn::Bits { at: _, width: _ }) = on;
        let Scaled { factor: _, bias: _, divisor: _, units: _, exact: _ } = scaled;
    };
