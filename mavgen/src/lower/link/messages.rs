//! Messages of several dialects: those of one definition are one type, with what the overlays of all dialects add to it.

use std::collections::{HashMap, HashSet};

use super::Class;
use super::enums::{Enums, follow, join};
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::{Binding, EnumId, Field, Meaning, Message, View, enums_of_message_mut};
use crate::lower::names::MessageNames;
use crate::lower::names::methods::{binding_methods, view_methods};

#[derive(Default)]
pub(super) struct Messages {
    pub(super) list: Vec<Class<Joined, MessageNames>>,
    by_name: HashMap<String, Vec<usize>>,
}

/// A message, and for each of its views the dialects that have it.
pub(super) struct Joined {
    pub(super) message: Message,
    pub(super) views: Vec<Vec<usize>>,
}

impl Messages {
    /// Takes in the messages of a dialect, whose enums are now `ids`, and returns for each its place.
    pub(super) fn take(
        &mut self,
        root: usize,
        messages: impl Iterator<Item = (Message, MessageNames)>,
        ids: &[EnumId],
        enums: &Enums,
    ) -> Result<Vec<usize>, Internal> {
        let mut take = |(mut message, names): (Message, MessageNames)| {
            follow(ids, |each| enums_of_message_mut(&mut message, each))?;
            Ok(self.take_one(root, message, names, enums))
        };
        messages.map(&mut take).try_collect_vec()
    }

    fn take_one(&mut self, root: usize, message: Message, names: MessageNames, enums: &Enums) -> usize {
        let places = self.by_name.entry(names.ty.clone()).or_default();
        for &place in places.iter() {
            let Some(class) = self.list.get_mut(place) else { continue };
            let known = &class.item.message;
            if is_same(known, &message) && additions_agree((known, &class.names), (&message, &names), enums) {
                class.add(root, message, names);
                return place;
            }
        }
        let place = self.list.len();
        places.push(place);
        let views = message.views.iter().map(|_| vec![root]).collect_vec();
        self.list.push(Class { item: Joined { message, views }, names, roots: vec![root] });
        place
    }
}

impl Class<Joined, MessageNames> {
    /// Takes in what another dialect says of the same message.
    fn add(&mut self, root: usize, other: Message, names: MessageNames) {
        let Joined { message, views } = &mut self.item;
        for (field, other) in message.fields.iter_mut().zip(other.fields) {
            join(&mut field.origin, other.origin);
        }
        join(&mut message.origin, other.origin);
        for (view, own) in other.views.into_iter().zip(names.views) {
            match message.views.iter().position(|known| same_view(known, &view)) {
                Some(at) => views.get_mut(at).into_iter().for_each(|roots| roots.push(root)),
                None => {
                    message.views.push(view);
                    self.names.views.push(own);
                    views.push(vec![root]);
                }
            }
        }
        for (binding, own) in other.bindings.into_iter().zip(names.bindings) {
            if !message.bindings.iter().any(|known| same_binding(known, &binding)) {
                message.bindings.push(binding);
                self.names.bindings.push(own);
            }
        }
        self.roots.push(root);
    }
}

/// Whether the views and bindings of two messages of one definition can stand on one type: no two methods of one name, and
/// no two enums of one name in the bindings.
fn additions_agree(
    (a, a_names): (&Message, &MessageNames),
    (b, b_names): (&Message, &MessageNames),
    enums: &Enums,
) -> bool {
    let (mut methods, mut added) = (HashSet::new(), Vec::new());
    a.views.iter().zip(&a_names.views).for_each(|(view, names)| methods.extend(view_methods(view, names)));
    a_names.bindings.iter().for_each(|name| methods.extend(binding_methods(name)));
    for (view, names) in b.views.iter().zip(&b_names.views) {
        if !a.views.iter().any(|known| same_view(known, view)) {
            added.extend(view_methods(view, names));
        }
    }
    for (binding, name) in b.bindings.iter().zip(&b_names.bindings) {
        if !a.bindings.iter().any(|known| same_binding(known, binding)) {
            added.extend(binding_methods(name));
        }
    }
    let mut named: HashMap<&str, EnumId> = HashMap::new();
    let mut ids = imported(a).chain(imported(b)).filter_map(|id| Some((id, enums.ty(id)?)));
    ids.all(|(id, ty)| *named.entry(ty).or_insert(id) == id) && !added.iter().any(|name| methods.contains(name))
}

/// The enums that the file of a message names.
fn imported(message: &Message) -> impl Iterator<Item = EnumId> {
    let fields = message.fields.iter().filter_map(|field| Some(field.values?.id()));
    fields.chain(message.bindings.iter().map(|binding| binding.enum_))
}

/// Whether two bindings say the same.
fn same_binding(a: &Binding, b: &Binding) -> bool {
    (&a.name, a.field, a.enum_, a.condition) == (&b.name, b.field, b.enum_, b.condition)
}

/// Whether two views of one message are the same element of an overlay, with the same enums.
fn same_view(a: &View, b: &View) -> bool {
    let enums = |view: &View| -> Vec<EnumId> {
        view.members.iter().filter_map(|member| enum_of(&member.meaning)).collect_vec()
    };
    a.origin.span == b.origin.span && a.condition == b.condition && enums(a) == enums(b)
}

fn enum_of(meaning: &Meaning) -> Option<EnumId> {
    match meaning {
        Meaning::Values(id) => Some(*id),
        _ => None,
    }
}

/// Whether two messages are defined alike. Their enums are those of the union already.
fn is_same(a: &Message, b: &Message) -> bool {
    // Lengths and the checksum follow from the fields; what overlays add is joined.
    let Message { id, name, fields, crc_extra: _, len_v1: _, len_v2: _, views: _, bindings: _, origin: _ } = a;
    (*id, name, fields.len()) == (b.id, &b.name, b.fields.len())
        && fields.iter().zip(&b.fields).all(|(a, b)| same_field(a, b))
}

fn same_field(a: &Field, b: &Field) -> bool {
    let Field {
        name,
        ty,
        offset,
        extension,
        values,
        instance,
        invalid,
        units,
        multiplier,
        limits,
        default,
        print_format,
        display_bitmask,
        origin,
    } = a;
    let wire = (*ty, *offset, *extension, *values, *instance) == (b.ty, b.offset, b.extension, b.values, b.instance);
    // What elements say beyond the wire; one element says the same as itself.
    let meaning = || {
        (units, multiplier, limits) == (&b.units, &b.multiplier, &b.limits)
            && (default, print_format, *display_bitmask) == (&b.default, &b.print_format, b.display_bitmask)
    };
    wire && (name, invalid) == (&b.name, &b.invalid) && (origin.span == b.origin.span || meaning())
}
