//! Names that other generators cannot take, although Rust can.

use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::read::Loaded;
use crate::syntax::Text;

/// The words that pymavlink's validation means to refuse as the name of anything, in any letter case.
///
/// Five of them (`abstract`, `enum`, `export`, `return` and `short`) pass it by a slip in its pattern.
const REFUSED: [&str; 4] = [
    "abstract await boolean break byte case catch char class const continue debugger default delete do double",
    "else enum export extends final finally float for function goto if implements import in instanceof int interface",
    "let long native new package private protected public return short static super switch synchronized",
    "this throw transient try typeof var void volatile while with yield",
];

/// Keywords of C and Python beyond those, as they are spelled: fields and constants have their names as written.
const KEYWORDS: [&str; 2] = [
    "auto extern inline register restrict signed sizeof struct typedef union unsigned",
    "False None True and as assert async def del elif except from global is lambda nonlocal not or pass raise",
];

/// Attributes of pymavlink's message classes, which a field of the same name hides.
const HIDDEN: [&str; 1] = ["self crc_extra unpacker"];

/// Reports the names in all files.
pub(super) fn check(loaded: &Loaded, diagnostics: &mut Diagnostics) {
    for element in loaded.files.iter().flat_map(|file| &file.enums) {
        check_name(&element.name, reason(&element.name.value), diagnostics);
        let end = format!("{}_ENUM_END", element.name.value);
        for entry in &element.entries {
            let name = &entry.name.value;
            let is_end = (*name == end).then_some("pymavlink adds an entry of this name to the enum");
            check_name(&entry.name, is_end.or_else(|| member_reason(name)), diagnostics);
        }
    }
    for message in loaded.messages() {
        check_name(&message.name, reason(&message.name.value), diagnostics);
        for field in &message.fields {
            let hides = has(&HIDDEN, &field.name.value).then_some("hides an attribute of pymavlink's message class");
            check_name(&field.name, hides.or_else(|| member_reason(&field.name.value)), diagnostics);
        }
    }
}

/// Why a name of anything is reserved.
fn reason(name: &str) -> Option<&'static str> {
    has(&REFUSED, &name.to_ascii_lowercase()).then_some("a word that pymavlink's validation forbids")
}

/// Why a name of a field or an entry is reserved.
fn member_reason(name: &str) -> Option<&'static str> {
    reason(name).or_else(|| has(&KEYWORDS, name).then_some("a keyword of C or Python"))
}

fn has(words: &[&str], name: &str) -> bool {
    words.iter().flat_map(|words| words.split(' ')).any(|word| word == name)
}

fn check_name(name: &Text, reason: Option<&str>, diagnostics: &mut Diagnostics) {
    let Some(reason) = reason else { return };
    let message = format!("other generators do not take the name `{}`", name.value);
    let problem = Diagnostic::new(Code::ReservedName, name.span, message).label(reason);
    diagnostics.push(problem.help("Rust takes it; for C and Python, give it another name"));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reserved() {
        for name in ["break", "CLASS", "Return", "enum", "abstract", "short", "yield"] {
            assert!(reason(name).is_some(), "{name}");
        }
        for name in ["type", "BREAKER", "from", "id", "name", "DEBUG"] {
            assert!(reason(name).is_none(), "{name}");
        }
        for name in ["from", "None", "struct", "in", "auto"] {
            assert!(member_reason(name).is_some(), "{name}");
        }
        for name in ["type", "NONE", "AUTO", "data"] {
            assert!(member_reason(name).is_none(), "{name}");
        }
    }
}
