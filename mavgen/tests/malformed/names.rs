//! Names that are none, are taken, or are not free elsewhere.

use super::{Mutation, m};

pub(crate) const MUTATIONS: &[Mutation] = &[
    m("M600", "a message with a dash", "name=\"PUMP_SET\"", "name=\"‸PUMP-SET\""),
    m("M600", "a message with a blank", "name=\"PUMP_SET\"", "name=\"‸PUMP SET\""),
    m("M600", "a message without a name", "name=\"PUMP_SET\"", "name=\"‸\""),
    m("M600", "a message that begins with a digit", "name=\"PUMP_SET\"", "name=\"‸2PUMPS\""),
    m("M600", "a message of underscores", "name=\"PUMP_SET\"", "name=\"‸__\""),
    m("M600", "a message of another alphabet", "name=\"PUMP_SET\"", "name=\"‸ПОМПА\""),
    m("M600", "a field with brackets", "name=\"label\"", "name=\"‸label[16]\""),
    m("M600", "a field with a point", "name=\"label\"", "name=\"‸label.text\""),
    m("M600", "a field with an accent", "name=\"label\"", "name=\"‸étiquette\""),
    m("M600", "a field with a zero-width space", "name=\"label\"", "name=\"‸lab\u{200b}el\""),
    m("M600", "an entry with a slash", "name=\"PUMP_STATE_FAST\"", "name=\"‸PUMP/FAST\""),
    m("M600", "an entry with a line end", "name=\"PUMP_STATE_FAST\"", "name=\"‸PUMP\nFAST\""),
    m("M600", "an entry with code", "name=\"PUMP_STATE_FAST\"", "name=\"‸A;fn main(){}\""),
    m("M600", "an enum with a colon", "name=\"MAV_CMD\"", "name=\"‸MAV:MAV_CMD\""),
    m("M601", "messages that differ in letter case", "name=\"PUMP_SET\"", "name=\"‸Pump_Status\""),
    m("M601", "messages that differ in underscores", "name=\"PUMP_SET\"", "name=\"‸PUMP__STATUS\""),
    m("M601", "fields that differ in letter case", "name=\"label\"", "name=\"‸Target_System\""),
    m("M601", "fields that differ in underscores", "name=\"label\"", "name=\"‸targetSystem\""),
    m("M601", "entries that differ in letter case", "name=\"PUMP_STATE_FAST\"", "name=\"‸PUMP_STATE_on\""),
    m("M604", "a message that C++ has", "name=\"PUMP_SET\"", "name=\"‸CLASS\""),
    m("M604", "a message that pymavlink means to forbid", "name=\"PUMP_SET\"", "name=\"‸RETURN\""),
    m("M604", "a field that Python has", "name=\"label\"", "name=\"‸from\""),
    m("M604", "a field that C has", "name=\"label\"", "name=\"‸struct\""),
    m("M604", "a field that JavaScript has", "name=\"label\"", "name=\"‸function\""),
    m("M604", "a field that hides an attribute", "name=\"label\"", "name=\"‸crc_extra\""),
    m("M604", "an entry that Python has", "name=\"PUMP_STATE_FAST\"", "name=\"‸None\""),
    m("M604", "an entry that ends the enum", "name=\"PUMP_STATE_FAST\"", "name=\"‸PUMP_STATE_ENUM_END\""),
];
