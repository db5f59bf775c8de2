//! Names: from the spelling of the XML to the spelling of Rust.
//!
//! Decides every identifier of the generated code, and only that; whether two of them collide is for [`super::namespace`] to see.

use heck::{ToShoutySnakeCase, ToSnakeCase, ToUpperCamelCase};

use crate::collect::CollectVec as _;
use crate::ir::{Label, param_words};

/// The word that no identifier can be, raw or not, and names of the prelude that the generated code itself needs.
const RESERVED_TYPES: [&str; 9] = ["Self", "Option", "Some", "None", "Result", "Ok", "Err", "Into", "Iterator"];

/// Methods that every message has, and names that readers and lints take for something else: no getter can be called so.
pub(crate) const MESSAGE_METHODS: &str =
    "clone clone_from cmp decode default eq info into len ne new payload to try_into write";

/// Methods that every view has, and names that readers and lints take for something else: no bits can be called so.
pub(crate) const VIEW_METHODS: &str =
    "bits from_bits clone clone_from cmp default eq fmt hash into len ne neg new not try_into";

/// The methods of operators with two sides: a method with such a name that takes an index looks like one.
pub(crate) const OPERATORS: [&str; 10] = ["add", "bitand", "bitor", "bitxor", "div", "mul", "rem", "shl", "shr", "sub"];

/// The field of a slot that holds the view.
pub(crate) const SLOT_VIEW: &str = "status";

/// The type name of a message, an enum or a dialect: `GPS_RAW_INT` becomes `GpsRawInt`, `my-dialect.v2` `MyDialectV2`.
///
/// A name that starts with a digit, or that would shadow what generated code or its readers rely on, takes an underscore.
pub(crate) fn type_name(xml: &str) -> String {
    let name = xml.to_upper_camel_case();
    if RESERVED_TYPES.contains(&name.as_str()) { name + "_" } else { not_a_digit(name) }
}

/// A type name that something else has, with what sets it apart.
///
/// `Option_` is spelled so only to differ from `Option`, which `OptionEnum` does anyway.
pub(crate) fn suffixed(name: &str, suffix: &str) -> String {
    name.trim_end_matches('_').to_owned() + suffix
}

/// The name of a field: `Index` becomes `index`, `baroAltMSL` becomes `baro_alt_msl`.
///
/// Keywords stay as they are, because they can be written raw (`r#type`), except the four that cannot.
pub(crate) fn field_name(xml: &str) -> String {
    member(xml.to_snake_case())
}

/// The name of a method or field that an overlay names: `age` in milliseconds becomes `age_ms`.
pub(crate) fn label(label: &Label) -> String {
    member(label.shown())
}

/// The name of a param of a command, after its label; `None` if that makes no name.
pub(crate) fn param_name(label: &str) -> Option<String> {
    param_words(label).map(member)
}

/// The name of a method beside the one of this name: `voltage_raw`; what sets `self_` apart from `self` is not needed there.
pub(crate) fn beside(name: &str, suffix: &str) -> String {
    format!("{}_{suffix}", name.trim_end_matches('_'))
}

fn member(name: String) -> String {
    if is_path_keyword(&name) { name + "_" } else { not_a_digit(name) }
}

/// The name of the file and module of a message or enum: `GPS_RAW_INT` becomes `gps_raw_int`.
///
/// The names of the modules around it take an underscore: one inside another of the same name confuses readers, and clippy.
pub(crate) fn item_module_name(xml: &str) -> String {
    let name = module_name(xml);
    if ["commands", "messages", "enums", "views"].contains(&name.as_str()) { name + "_" } else { name }
}

/// The name of the module of a dialect, and of its folder: `my-dialect` becomes `my_dialect`.
///
/// The names of the modules in it take an underscore: one inside another of the same name confuses readers, and clippy.
pub(crate) fn dialect_module_name(stem: &str) -> String {
    let name = item_module_name(stem);
    if name == "dialect" { name + "_" } else { name }
}

/// The name of the module of one of several dialects, in the tree of this name; that of the tree takes an underscore.
pub(crate) fn root_module_name(stem: &str, tree: &str) -> String {
    let name = dialect_module_name(stem);
    if name == dialect_module_name(tree) { name + "_" } else { name }
}

/// A name as that of a module and its file.
///
/// Keywords and the names that Windows keeps for devices take an underscore.
fn module_name(xml: &str) -> String {
    let name = xml.to_snake_case();
    if is_keyword(&name) || is_device(&name) { name + "_" } else { not_a_digit(name) }
}

/// The names of an enum's constants: its entries' names without what they share.
///
/// Where every entry of the file that owns the enum starts with the enum's name, that is taken away; else the `_` segments
/// that all of them share, if there are at least two entries. An entry of another file that lacks the prefix keeps its full
/// name, so that adding entries renames nothing. Where a digit or nothing would be left, one more segment stays.
pub(crate) fn constant_names(enum_name: &str, owner_entries: &[&str], entries: &[&str]) -> Vec<String> {
    let prefix = prefix_of(enum_name, owner_entries);
    entries.iter().map(|entry| constant_name(&prefix, entry)).collect_vec()
}

/// What all of `entries` start with, underscore included; may be empty.
fn prefix_of(enum_name: &str, entries: &[&str]) -> String {
    let own = format!("{enum_name}_");
    if entries.iter().all(|entry| entry.starts_with(&own)) {
        return own;
    }
    let Some((first, rest)) = entries.split_first().filter(|(_, rest)| !rest.is_empty()) else {
        return String::new();
    };
    let ends = first.match_indices('_').map(|(at, _)| &first[..=at]);
    ends.take_while(|prefix| rest.iter().all(|entry| entry.starts_with(prefix))).last().unwrap_or_default().to_owned()
}

/// One constant: `entry` without `prefix`.
fn constant_name(prefix: &str, entry: &str) -> String {
    let Some(short) = entry.strip_prefix(prefix) else { return constant(entry) };
    let begins_well = |name: &str| name.starts_with(|first: char| first.is_ascii_alphabetic());
    if begins_well(short) {
        return constant(short);
    }
    let kept = prefix.trim_end_matches('_').rsplit('_').next().unwrap_or_default();
    let longer = format!("{kept}_{short}");
    if begins_well(&longer) { constant(&longer) } else { constant(entry) }
}

/// SCREAMING_CASE; what is spelled so already stays as it is.
pub(crate) fn constant(name: &str) -> String {
    if name.bytes().any(|byte| byte.is_ascii_lowercase()) { name.to_shouty_snake_case() } else { name.to_owned() }
}

fn not_a_digit(name: String) -> String {
    if name.starts_with(|first: char| first.is_ascii_digit()) { format!("_{name}") } else { name }
}

/// Whether `name` has to be written as a raw identifier, `r#name`.
pub(crate) fn is_keyword(name: &str) -> bool {
    is_path_keyword(name) || KEYWORDS.contains(&name)
}

/// The keywords that cannot be raw identifiers.
pub(crate) fn is_path_keyword(name: &str) -> bool {
    matches!(name, "self" | "super" | "crate" | "_")
}

/// Strict and reserved keywords of the 2024 edition, in lower case (Rust reference, "Keywords").
const KEYWORDS: [&str; 48] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn", "else", "enum",
    "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move",
    "mut", "override", "priv", "pub", "ref", "return", "static", "struct", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// File names that Windows does not allow, whatever the extension.
fn is_device(name: &str) -> bool {
    let numbered =
        |port: &str| name.strip_prefix(port).is_some_and(|n| n.len() == 1 && n.as_bytes() >= b"1".as_slice());
    matches!(name, "con" | "prn" | "aux" | "nul") || numbered("com") || numbered("lpt")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_and_fields() {
        for (xml, rust) in [
            ("GPS_RAW_INT", "GpsRawInt"),
            ("V2_EXTENSION", "V2Extension"),
            ("DATA16", "Data16"),
            ("DEBUG", "Debug"),
            ("OPTION", "Option_"),
            ("SELF", "Self_"),
            ("ITERATOR", "Iterator_"),
        ] {
            assert_eq!(type_name(xml), rust);
        }
        for (xml, rust) in [
            ("Index", "index"),
            ("baroAltMSL", "baro_alt_msl"),
            ("type", "type"),
            ("self", "self_"),
            ("Vcc", "vcc"),
            ("z1_LocalUpdraftSpeed", "z1_local_updraft_speed"),
            ("hRef_t", "h_ref_t"),
        ] {
            assert_eq!(field_name(xml), rust);
        }
        assert_eq!(type_name("my-dialect.v2"), "MyDialectV2");
    }

    #[test]
    fn files() {
        for (xml, rust) in [
            ("GPS_RAW_INT", "gps_raw_int"),
            ("MOD", "mod_"),
            ("TYPE", "type_"),
            ("AUX", "aux_"),
            ("COM1", "com1_"),
            ("COMMAND_INT", "command_int"),
            ("ENUMS", "enums_"),
        ] {
            assert_eq!(item_module_name(xml), rust);
        }
    }

    #[test]
    fn no_module_stands_in_one_of_its_own_name() {
        for (stem, rust) in [("my-dialect.v2", "my_dialect_v2"), ("Messages", "messages_"), ("dialect", "dialect_")] {
            assert_eq!(dialect_module_name(stem), rust);
        }
        assert_eq!(item_module_name("DIALECT"), "dialect", "that of a message is not beside that of the dialect");
        let in_tree = |stem| root_module_name(stem, "dialects");
        assert_eq!(["Dialects", "dialect", "wire"].map(in_tree), ["dialects_", "dialect_", "wire"]);
        assert_eq!(root_module_name("dialects", "acme"), "dialects");
    }

    /// Every row: enum, entries of its own file, entry, constant.
    #[test]
    fn constants() {
        let own = |name: &str, entries: &[&str]| constant_names(name, entries, entries);
        assert_eq!(own("MAV_STATE", &["MAV_STATE_UNINIT", "MAV_STATE_BOOT"]), ["UNINIT", "BOOT"]);
        assert_eq!(own("GPS_FIX_TYPE", &["GPS_FIX_TYPE_NO_GPS", "GPS_FIX_TYPE_3D_FIX"]), ["NO_GPS", "TYPE_3D_FIX"]);
        assert_eq!(
            own("RESOLUTION", &["RESOLUTION_480p", "RESOLUTION_2_7k_17_9"]),
            ["RESOLUTION_480P", "RESOLUTION_2_7K_17_9"]
        );
        assert_eq!(own("AUTOQUAD_NAV_STATUS", &["AQ_NAV_STATUS_INIT", "AQ_NAV_STATUS_NO_RC"]), ["INIT", "NO_RC"]);
        assert_eq!(own("DEFS_VERSION", &["AQ_DEFS_VERSION_1"]), ["AQ_DEFS_VERSION_1"]);
        assert_eq!(own("E", &["E_", "E_A"]), ["E_", "A"]);
        assert_eq!(own("RALLY_FLAGS", &["FAVORABLE_WIND", "LAND_IMMEDIATELY"]), ["FAVORABLE_WIND", "LAND_IMMEDIATELY"]);
        let sensors = ["MAV_SYS_STATUS_SENSOR_3D_GYRO", "MAV_SYS_STATUS_AHRS"];
        assert_eq!(own("MAV_SYS_STATUS_SENSOR", &sensors), ["SENSOR_3D_GYRO", "AHRS"]);
    }

    #[test]
    fn an_entry_of_another_file_renames_nothing() {
        let own = ["MAV_CMD_NAV_WAYPOINT", "MAV_CMD_NAV_LAND"];
        let merged = ["MAV_CMD_NAV_WAYPOINT", "MAV_CMD_NAV_LAND", "MAV_CMD_AQ_TELEMETRY", "ACME_CMD_SPRAY"];
        let names = constant_names("MAV_CMD", &own, &merged);
        assert_eq!(names, ["NAV_WAYPOINT", "NAV_LAND", "AQ_TELEMETRY", "ACME_CMD_SPRAY"]);
    }
}
