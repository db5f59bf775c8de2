//! Where types are declared: beside the dialects, or in the module of one, where two have different things under one name.

use std::collections::HashMap;

use super::Class;
use super::messages::Joined;
use crate::collect::CollectVec as _;
use crate::ir::Enum;
use crate::lower::names::{EnumNames, MessageNames, SlotNames};

/// Where a type is declared. Every dialect that has it exports it, wherever that is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Placement {
    /// Beside the dialects: no dialect has anything else under its name.
    Shared,
    /// In the module of this dialect, by its place in [`super::Union::roots`]: the first of those that have the type.
    Root(usize),
}

/// Where a message and its views are declared.
#[derive(Clone, Debug)]
pub(crate) struct MessagePlacement {
    /// Of the message.
    pub(crate) placement: Placement,
    /// Of its views, in their order.
    pub(crate) views: Vec<ViewPlacement>,
}

/// Where a view is declared, and who knows it.
#[derive(Clone, Debug)]
pub(crate) struct ViewPlacement {
    /// Of the view.
    pub(crate) placement: Placement,
    /// The dialects whose overlays have it, by their places in [`super::Union::roots`].
    pub(crate) roots: Vec<usize>,
}

/// Where the enums are declared.
pub(super) fn of_enums(enums: &[Class<Enum, EnumNames>]) -> Vec<Placement> {
    let claims = enums.iter().map(|Class { names, roots, .. }| Claim::of(&names.module, &names.ty, None, roots));
    placements(&claims.collect_vec())
}

/// Where the messages and their views are declared.
pub(super) fn of_messages(messages: &[Class<Joined, MessageNames>]) -> Vec<MessagePlacement> {
    let claims = messages.iter().map(|Class { names, roots, .. }| Claim::of(&names.module, &names.ty, None, roots));
    let views = messages.iter().flat_map(|class| class.names.views.iter().zip(&class.item.views)).collect_vec();
    let view_claims =
        views.iter().map(|(names, roots)| Claim::of(&names.module, &names.ty, names.slots.as_ref(), roots));
    let view_placements = placements(&view_claims.collect_vec()).into_iter().zip(&views);
    let mut view_placements =
        view_placements.map(|(placement, (_, roots))| ViewPlacement { placement, roots: roots.to_vec() });
    let each = placements(&claims.collect_vec()).into_iter().zip(messages).map(|(placement, class)| {
        let views = view_placements.by_ref().take(class.item.message.views.len()).collect_vec();
        MessagePlacement { placement, views }
    });
    each.collect_vec()
}

/// The names that a declaration takes in its folder.
struct Claim<'a> {
    file: &'a str,
    types: Vec<&'a str>,
    /// The dialects that have it.
    roots: &'a [usize],
}

impl<'a> Claim<'a> {
    fn of(file: &'a str, ty: &'a str, slots: Option<&'a SlotNames>, roots: &'a [usize]) -> Self {
        let types = [ty].into_iter().chain(slots.map(|slots| slots.ty.as_str()));
        Self { file, types: types.collect_vec(), roots }
    }
}

/// A declaration that shares a name with another goes to the first dialect that has it.
fn placements(claims: &[Claim<'_>]) -> Vec<Placement> {
    let (mut files, mut types) = (HashMap::<&str, usize>::new(), HashMap::<&str, usize>::new());
    for claim in claims {
        *files.entry(claim.file).or_default() += 1;
        claim.types.iter().for_each(|name| *types.entry(name).or_default() += 1);
    }
    let alone = |claim: &Claim<'_>| {
        files.get(claim.file) == Some(&1) && claim.types.iter().all(|name| types.get(name) == Some(&1))
    };
    let placement = |claim: &Claim<'_>| match claim.roots.first() {
        Some(&root) if !alone(claim) => Placement::Root(root),
        _ => Placement::Shared,
    };
    claims.iter().map(placement).collect_vec()
}
