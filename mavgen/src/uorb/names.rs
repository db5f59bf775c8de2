//! No two things of a message have one name.

use std::collections::HashMap;

use super::syntax::MsgFile;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::order;
use crate::source::Span;

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
    let mut names = fields.chain(constants).collect_vec();
    order::sort_by_key(&mut names, |name| name.span);
    let mut seen: HashMap<&str, Span> = HashMap::new();
    for name in names {
        if let Some(first) = seen.get(&*name.value) {
            let message = format!("`{}` stands here twice", name.value);
            let problem = Diagnostic::new(Code::UorbDuplicate, name.span, message);
            diagnostics.push(problem.related(*first, "the first one"));
        } else {
            seen.insert(&name.value, name.span);
        }
    }
}
