//! Names: ordinary ones, and those that generated code has to survive.

use std::collections::BTreeSet;

use crate::Construct;
use crate::chance::Chance;

const WORDS: [&str; 32] = [
    "TANK", "PUMP", "LEVEL", "STATE", "ESC", "FLOW", "BOOM", "NOZZLE", "WIND", "RANGE", "RADIO", "CELL", "PACK", "GPS",
    "YAW", "SPEED", "MODE", "HOME", "FENCE", "TIME", "LIGHT", "WINCH", "CABLE", "SERVO", "TRIM", "LIMIT", "FAULT",
    "TEMP", "ANGLE", "RATE", "COUNTS", "LOAD",
];

/// Names of types that the generated code, its derives or its readers rely on.
const TYPES: [&str; 52] = [
    "ITERATOR",
    "OPTION",
    "SELF",
    "STRING",
    "DEFAULT",
    "DEBUG",
    "CLONE",
    "COPY",
    "FROM",
    "INTO",
    "WIRE",
    "MESSAGE",
    "ENCODE",
    "DIALECT",
    "TABLE",
    "CHARS",
    "STR",
    "U8",
    "F32",
    "BOOL",
    "VEC",
    "PARTIAL_EQ",
    "RESULT",
    "OK",
    "ERR",
    "SOME",
    "NONE",
    "TRY_FROM",
    "DISPLAY",
    "FORMATTER",
    "SIZED",
    "SEND",
    "DROP",
    "FN",
    "AS_REF",
    "FROM_STR",
    "VIEW_ERROR",
    "MAIN",
    "TYPE",
    "MOD",
    "MESSAGES",
    "ENUMS",
    "VIEWS",
    "AUX",
    "ORD",
    "EQ",
    "HASH",
    "TARGETED",
    "MESSAGE_INFO",
    "FIELD_INFO",
    "INTO_ITERATOR",
    "CON",
];

/// Names of fields and getters: keywords, methods of messages, views and slots, locals of templates.
const GETTERS: [&str; 55] = [
    "type",
    "self",
    "super",
    "crate",
    "fn",
    "match",
    "move",
    "loop",
    "gen",
    "try",
    "async",
    "dyn",
    "from",
    "index",
    "value",
    "raw",
    "p",
    "n",
    "i",
    "f",
    "next",
    "add",
    "sub",
    "mul",
    "div",
    "rem",
    "shl",
    "shr",
    "bitand",
    "bitor",
    "into_iter",
    "from_str",
    "from_iter",
    "as_ref",
    "as_mut",
    "borrow",
    "deref",
    "drop",
    "index_mut",
    "partial_cmp",
    "message",
    "wire",
    "info_static",
    "ID",
    "INFO",
    "DEFAULT",
    "is_empty",
    "contains",
    "read",
    "store",
    "encode",
    "slot",
    "view",
    "words",
    "count",
];

/// Names that every message, view or slot has already: mostly refused.
const REFUSED: [&str; 22] = [
    "bits",
    "from_bits",
    "clone",
    "cmp",
    "default",
    "hash",
    "neg",
    "new",
    "not",
    "decode",
    "info",
    "payload",
    "to",
    "write",
    "status",
    "eq",
    "fmt",
    "into",
    "len",
    "ne",
    "try_into",
    "clone_from",
];

/// The last word of an entry's name.
const ENTRIES: [&str; 30] = [
    "SELF", "0", "3D", "2G", "NONE", "ALL", "EMPTY", "BITS", "MAX", "MIN", "INFO", "PARAMS", "ID", "DEFAULT", "type",
    "fooBar", "FROM", "NEW", "A_B", "_", "CRATE", "TRUE", "OK", "ENUM_END", "UNKNOWN", "Self", "NAMES", "TABLE",
    "ENTRIES", "FIELDS",
];

/// Two names that differ in case and underscores alone are one in Rust.
fn key(name: &str) -> String {
    name.chars().filter(|letter| *letter != '_').flat_map(char::to_lowercase).collect()
}

/// Names of one scope.
#[derive(Clone, Default)]
pub(crate) struct Scope(BTreeSet<String>);

impl Scope {
    pub(crate) fn take(&mut self, name: &str) -> bool {
        self.0.insert(key(name))
    }

    /// A name in capitals.
    pub(crate) fn upper(&mut self, chance: &mut Chance, odd: Construct) -> String {
        self.free(
            chance,
            |chance| {
                if chance.maybe(8, odd) { chance.word(&TYPES).to_owned() } else { two_words(chance) }
            },
        )
    }

    /// A name of a field or a getter.
    pub(crate) fn lower(&mut self, chance: &mut Chance, odd: Construct) -> String {
        self.free(chance, |chance| {
            if chance.maybe(7, odd) {
                let refused = chance.one_in(25);
                return chance.word(if refused { &REFUSED } else { &GETTERS }).to_owned();
            }
            let name = two_words(chance);
            match chance.below(12) {
                0 => format!("set_{}", name.to_lowercase()),
                1 => name.split('_').enumerate().map(camel).collect(),
                2 => format!("{}_raw", name.to_lowercase()),
                3 => format!("store_{}", name.to_lowercase()),
                _ => name.to_lowercase(),
            }
        })
    }

    fn free(&mut self, chance: &mut Chance, make: impl Fn(&mut Chance) -> String) -> String {
        for _ in 0..20 {
            let name = make(chance);
            if self.take(&name) {
                return name;
            }
        }
        let name = format!("{}_{}", two_words(chance), self.0.len());
        self.take(&name);
        name
    }
}

/// The name of an entry.
pub(crate) fn entry(chance: &mut Chance, of: &str, nth: usize) -> String {
    let short = if chance.maybe(9, Construct::OddEntryName) {
        chance.word(&ENTRIES).to_owned()
    } else {
        format!("{}{nth}", chance.word(&WORDS))
    };
    if chance.one_in(15) { format!("X_{short}") } else { format!("{of}_{short}") }
}

fn two_words(chance: &mut Chance) -> String {
    let first = chance.word(&WORDS);
    match chance.below(3) {
        0 => first.to_owned(),
        1 => format!("{first}{}", chance.below(10)),
        _ => format!("{first}_{}", chance.word(&WORDS)),
    }
}

/// `fooBar`.
fn camel((nth, word): (usize, &str)) -> String {
    let (first, rest) = word.split_at(1);
    if nth == 0 { word.to_lowercase() } else { format!("{first}{}", rest.to_lowercase()) }
}
