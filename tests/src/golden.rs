//! The goldens of mavgen, `mavgen/tests/golden`: one module for each construct.
//!
//! They stand in this library, not in a test, so that `cargo doc` sees them as well.

#![deny(warnings, missing_docs, clippy::all)]

macro_rules! goldens {
    ($($name:ident: $path:literal, $what:literal;)*) => {$(
        #[doc = $what]
        #[rustfmt::skip]
        #[path = $path]
        pub mod $name;
    )*};
}

goldens! {
    bind: "../../mavgen/tests/golden/bind/generated/mod.rs", "Enums on plain integers, on a condition.";
    command_feature: "../../mavgen/tests/golden/command_feature/generated/mod.rs", "Commands that need a feature, of two dialects.";
    definitions: "../../mavgen/tests/golden/definitions/generated/mod.rs", "uORB messages of several definitions.";
    deprecated: "../../mavgen/tests/golden/deprecated/generated/mod.rs", "What is deprecated, and what only names it.";
    fields: "../../mavgen/tests/golden/fields/generated/mod.rs", "Fields of all types.";
    flags: "../../mavgen/tests/golden/flags/generated/mod.rs", "Values that are combined bit by bit.";
    invalid: "../../mavgen/tests/golden/invalid/generated/mod.rs", "Values that mean \"not known\".";
    mav_cmd: "../../mavgen/tests/golden/commands/generated/mod.rs", "Commands with params, and as types.";
    names: "../../mavgen/tests/golden/names/generated/mod.rs", "Names that Rust has already.";
    open_enums: "../../mavgen/tests/golden/open_enums/generated/mod.rs", "Enums, and fields of other widths.";
    roots: "../../mavgen/tests/golden/roots/generated/mod.rs", "Two dialects.";
    targets: "../../mavgen/tests/golden/targets/generated/mod.rs", "A message to somebody.";
    topics: "../../mavgen/tests/golden/topics/generated/mod.rs", "uORB messages.";
    view_bits: "../../mavgen/tests/golden/view_bits/generated/mod.rs", "Views over words: flags, enums, numbers, several alike.";
    view_floats: "../../mavgen/tests/golden/view_floats/generated/mod.rs", "Views over the bits of floats.";
    view_scaled: "../../mavgen/tests/golden/view_scaled/generated/mod.rs", "Bits that stand for another number.";
    view_slots: "../../mavgen/tests/golden/view_slots/generated/mod.rs", "A view for each element of arrays.";
    view_switch: "../../mavgen/tests/golden/view_switch/generated/mod.rs", "Layouts that depend on something.";
    view_values: "../../mavgen/tests/golden/view_values/generated/mod.rs", "Values in fields, on a condition.";
}
