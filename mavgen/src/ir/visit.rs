//! Every mention of an enum in the model, in one place: whatever gains one is visited here, and the compiler asks for it.

use super::{
    Access, Binding, Command, Condition, Entry, Enum, EnumId, Field, Key, Meaning, Member, Message, Param, Record,
    Scaled, Slots, Switch, SwitchOn, Values, View, ViewSentinel,
};

/// The visits of messages and of enums, to look at ids or to change them.
macro_rules! visits {
    ($message:ident $enum:ident $binding:ident $view:ident $access:ident $condition:ident $($mut:ident)?) => {
        /// Visits every enum that a message names.
        pub(crate) fn $message(message: & $($mut)? Message, visit: &mut dyn FnMut(& $($mut)? EnumId)) {
            let Message { fields, views, bindings, id: _, name: _, crc_extra: _, len_v1: _, len_v2: _, origin: _ } = message;
            for field in fields {
                let Field {
                    values, name: _, ty: _, offset: _, extension: _, units: _, invalid: _, limits: _, multiplier: _, default: _,
                    print_format: _, display_bitmask: _, instance: _, origin: _,
                } = field;
                if let Some(Values::Typed(id) | Values::Converted(id)) = values {
                    visit(id);
                }
            }
            for view in views {
                $view(view, visit);
            }
            for binding in bindings {
                $binding(binding, visit);
            }
        }

        fn $binding(binding: & $($mut)? Binding, visit: &mut dyn FnMut(& $($mut)? EnumId)) {
            let Binding { enum_, condition, name: _, field: _, description: _ } = binding;
            visit(enum_);
            $condition(condition, visit);
        }

        fn $view(view: & $($mut)? View, visit: &mut dyn FnMut(& $($mut)? EnumId)) {
            let View { access, condition, invalid, switch, members, name: _, words: _, width: _, origin: _ } = view;
            $access(access);
            $condition(condition, visit);
            for sentinel in invalid {
                match sentinel {
                    ViewSentinel::Field(_, _) | ViewSentinel::Words(_) => {}
                }
            }
            if let Some(Switch { on, name: _, span: _ }) = switch {
                match on {
                    SwitchOn::Field(_, _) | SwitchOn::Bits { at: _, width: _ } => {}
                }
            }
            for Member { meaning, name: _, at: _, width: _, signed: _, repeat: _, presence: _, description: _ } in members {
                match meaning {
                    Meaning::Values(id) => visit(id),
                    Meaning::Scaled(Scaled { factor: _, bias: _, divisor: _, units: _, exact: _ }) => {}
                    Meaning::Flag | Meaning::Number { units: _ } => {}
                }
            }
        }

        /// What a message gives a view by names no enum so far.
        fn $access(access: & $($mut)? Access) {
            match access {
                Access::Once { getter: _ } => {}
                Access::Slots(Slots { keys, item: _, items: _, length: _, count: _ }) => {
                    for Key { name: _, place: _, units: _, invalid: _, description: _ } in keys {}
                }
                Access::Record(Record { getter: _, values }) => {
                    for Key { name: _, place: _, units: _, invalid: _, description: _ } in values {}
                }
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
                for param in params {
                    let Param {
                        enum_, index: _, label: _, units: _, limits: _, default: _, reserved: _, origin: _,
                    } = param;
                    if let Some(id) = enum_ {
                        visit(id);
                    }
                }
            }
        }
    };
}

visits!(enums_of_message enums_of_enum of_binding of_view of_access of_condition);
visits!(enums_of_message_mut enums_of_enum_mut of_binding_mut of_view_mut of_access_mut of_condition_mut mut);
