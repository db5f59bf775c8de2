//! No two things of a message have one name.

use std::collections::BTreeMap;

use super::syntax::MsgFile;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::source::Spanned;

/// Whether a text can be the name of a message.
pub(super) fn is_message(name: &str) -> bool {
    name.starts_with(|first: char| first.is_ascii_uppercase()) && name.chars().all(|one| one.is_ascii_alphanumeric())
}

/// Whether a text can be the name of a field.
pub(super) fn is_field(name: &str) -> bool {
    let is_letter = |letter: char| letter.is_ascii_lowercase();
    name.starts_with(is_letter) && name.chars().all(|one| is_letter(one) || one.is_ascii_digit() || one == '_')
}

pub(super) fn check(file: &MsgFile, diagnostics: &mut Diagnostics) {
    let fields = file.fields.iter().map(|field| &field.name);
    let constants = file.constants.iter().map(|constant| &constant.name);
    let mut names: Vec<&Spanned<String>> = fields.chain(constants).collect();
    names.sort_by_key(|name| name.span);
    let mut seen = BTreeMap::new();
    for name in names {
        match seen.get(&name.value) {
            Some(first) => diagnostics.push(
                Diagnostic::new(Code::UorbDuplicate, name.span, format!("`{}` stands here twice", name.value))
                    .related(*first, "the first one"),
            ),
            None => {
                seen.insert(&name.value, name.span);
            }
        }
    }
}
