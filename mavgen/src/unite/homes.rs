//! Where types are declared: beside the dialects, or in the module of one, where two have different things under one name.

use std::collections::HashMap;

use super::Class;
use super::messages::Joined;
use crate::ir::{Access, Enum, Home, MessageHome, View, ViewHome};
use crate::names::item_module_name;

/// Where the enums are declared.
pub(super) fn of_enums(enums: &[Class<Enum>]) -> Vec<Home> {
    let claims: Vec<_> = enums
        .iter()
        .map(|class| Claim {
            file: item_module_name(&class.item.name.text),
            types: vec![&class.item.name.rust],
            roots: &class.roots,
        })
        .collect();
    homes(&claims)
}

/// Where the messages and their views are declared.
pub(super) fn of_messages(messages: &[Class<Joined>]) -> Vec<MessageHome> {
    let claims: Vec<_> = messages
        .iter()
        .map(|class| {
            let name = &class.item.message.name;
            Claim { file: item_module_name(&name.text), types: vec![&name.rust], roots: &class.roots }
        })
        .collect();
    let views: Vec<(&View, &Vec<usize>)> =
        messages.iter().flat_map(|class| class.item.message.views.iter().zip(&class.item.views)).collect();
    let view_claims: Vec<_> = views.iter().map(|(view, roots)| Claim::of_view(view, roots)).collect();
    let mut view_homes =
        homes(&view_claims).into_iter().zip(views).map(|(home, (_, roots))| ViewHome { home, roots: roots.clone() });
    let each = homes(&claims).into_iter().zip(messages);
    each.map(|(home, class)| {
        let views = view_homes.by_ref().take(class.item.message.views.len()).collect();
        MessageHome { home, views }
    })
    .collect()
}

/// The names that a declaration takes in its folder.
struct Claim<'a> {
    file: String,
    types: Vec<&'a str>,
    /// The dialects that have it.
    roots: &'a [usize],
}

impl<'a> Claim<'a> {
    fn of_view(view: &'a View, roots: &'a [usize]) -> Self {
        let mut types = vec![view.name.rust.as_str()];
        if let Access::Slots(slots) = &view.access {
            types.push(&slots.item.rust);
        }
        Self { file: item_module_name(&view.name.text), types, roots }
    }
}

/// A declaration that shares a name with another goes to the first dialect that has it.
fn homes(claims: &[Claim<'_>]) -> Vec<Home> {
    let (mut files, mut types) = (HashMap::<&str, usize>::new(), HashMap::<&str, usize>::new());
    for claim in claims {
        *files.entry(&claim.file).or_default() += 1;
        claim.types.iter().for_each(|name| *types.entry(name).or_default() += 1);
    }
    let alone = |claim: &Claim<'_>| {
        files.get(claim.file.as_str()) == Some(&1) && claim.types.iter().all(|name| types.get(name) == Some(&1))
    };
    let home = |claim: &Claim<'_>| match claim.roots.first() {
        Some(&root) if !alone(claim) => Home::Root(root),
        _ => Home::Shared,
    };
    claims.iter().map(home).collect()
}
