//! That no two types, fields or constants become one in Rust.

use super::{EnumNames, MessageNames};
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::ir::{Access, Dialect, FileIndex, Name, Partial};
use crate::lower::namespace::{Claim, Namespace, Scope, What};
use crate::lower::{collision, spelling};
use crate::order;

/// Checks the types of a dialect, and gives what has which name.
pub(super) fn types<'a>(
    partial: &'a Partial,
    messages: &[MessageNames],
    enums: &[EnumNames],
    diagnostics: &mut Diagnostics,
) -> Namespace<'a> {
    let Partial { dialect, lost, lost_views } = partial;
    let claim = |what, name: &'a Name, file: FileIndex| Claim { age: dialect.age(file), ..Claim::of(what, name) };
    let mut claims: Vec<(String, Claim<'a>)> = Vec::new();
    for (message, names) in dialect.messages.iter().zip(messages) {
        claims.push((names.ty.clone(), claim(What::Message, &message.name, message.origin.file)));
        for (view, names) in message.views.iter().zip(&names.views) {
            claims.push((names.ty.clone(), claim(What::View, &view.name, view.origin.file)));
            if let (Access::Slots(slots), Some(names)) = (&view.access, &names.slots) {
                claims.push((names.ty.clone(), claim(What::View, &slots.item, view.origin.file)));
            }
        }
    }
    for (enum_, names) in dialect.enums.iter().zip(enums) {
        claims.push((names.ty.clone(), claim(What::Enum, &enum_.name, enum_.named_in)));
    }
    let lost = lost.iter().map(|lost| (&lost.name, lost.file, What::Message));
    let lost_views = lost_views.iter().map(|lost| (&lost.name, lost.file, What::View));
    claims.extend(
        lost.chain(lost_views).map(|(name, file, what)| (spelling::type_name(&name.text), claim(what, name, file))),
    );
    order::sort_by_key(&mut claims, |(_, claim)| (claim.what, claim.span.map(|span| span.start)));
    let mut types = Namespace::of(Scope::Types);
    collision::report(types.claim_by_age(claims), diagnostics);
    types
}

/// Names the type over all messages, which is called after a file or a folder, and that can be called anything.
pub(in crate::lower) fn dialect_type(
    name: &str,
    suffix: &str,
    types: &Namespace<'_>,
    diagnostics: &mut Diagnostics,
) -> String {
    let own = spelling::type_name(name);
    let own = if types.get(&own).is_some() { spelling::suffixed(&own, suffix) } else { own };
    match types.get(&own) {
        Some(first) => diagnostics.push(collision::of_dialect(name, &own, first)),
        None if Name::fault(&own).is_some() => diagnostics.push(collision::no_name(name)),
        None => {}
    }
    own
}

/// Checks the fields of all messages, also of those that could not be resolved.
pub(super) fn fields(partial: &Partial, messages: &[MessageNames], diagnostics: &mut Diagnostics) {
    for (message, names) in partial.dialect.messages.iter().zip(messages) {
        let claims = message.fields.iter().map(|field| Claim::of(What::Field, &field.name));
        collision::apart(Scope::Fields, claims, &names.fields, diagnostics);
    }
    for message in &partial.lost {
        let names = message.fields.iter().map(|name| spelling::field_name(&name.text)).collect_vec();
        let claims = message.fields.iter().map(|name| Claim::of(What::Field, name));
        collision::apart(Scope::Fields, claims, &names, diagnostics);
    }
}

/// Checks the constants of all enums.
pub(super) fn constants(dialect: &Dialect, enums: &[EnumNames], diagnostics: &mut Diagnostics) {
    for (enum_, names) in dialect.enums.iter().zip(enums) {
        let claims = enum_
            .entries
            .iter()
            .map(|entry| Claim { age: dialect.age(entry.origin.file), ..Claim::of(What::Entry, &entry.name) });
        collision::apart(Scope::Constants, claims, &names.constants, diagnostics);
    }
}
