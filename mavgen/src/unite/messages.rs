//! Messages of several dialects: those of one definition are one type, with what the overlays of all dialects add to it.

use std::collections::{HashMap, HashSet};

use super::enums::{Enums, join};
use super::{Class, definition};
use crate::ir::{Binding, Condition, EnumId, Meaning, Message, Values, View};
use crate::resolve::view_methods;

/// The messages so far.
#[derive(Default)]
pub(super) struct Messages {
    pub(super) list: Vec<Class<Joined>>,
    by_name: HashMap<String, Vec<usize>>,
}

/// A message, and for each of its views the dialects that have it.
pub(super) struct Joined {
    pub(super) message: Message,
    pub(super) views: Vec<Vec<usize>>,
}

impl Messages {
    /// Takes in the messages of a dialect, whose enums are now `ids`, and returns for each its place.
    pub(super) fn take(&mut self, root: usize, messages: Vec<Message>, ids: &[EnumId], enums: &Enums) -> Vec<usize> {
        messages.into_iter().map(|message| self.take_one(root, message, ids, enums)).collect()
    }

    fn take_one(&mut self, root: usize, mut message: Message, ids: &[EnumId], enums: &Enums) -> usize {
        each_enum(&mut message, |id| *id = ids.get(id.0).copied().unwrap_or(*id));
        let places = self.by_name.entry(message.name.rust.clone()).or_default();
        for &place in places.iter() {
            let Some(class) = self.list.get_mut(place) else { continue };
            let known = &class.item.message;
            if definition::same(known, &message) && additions_agree(known, &message, enums) {
                class.item.add(root, message);
                class.roots.push(root);
                return place;
            }
        }
        let place = self.list.len();
        places.push(place);
        let views = message.views.iter().map(|_| vec![root]).collect();
        self.list.push(Class { item: Joined { message, views }, roots: vec![root] });
        place
    }
}

impl Joined {
    /// Takes in what another dialect says of the same message.
    fn add(&mut self, root: usize, other: Message) {
        for (field, other) in self.message.fields.iter_mut().zip(other.fields) {
            join(&mut field.origin, other.origin);
        }
        join(&mut self.message.origin, other.origin);
        for view in other.views {
            match self.message.views.iter().position(|known| same_view(known, &view)) {
                Some(at) => self.views.get_mut(at).into_iter().for_each(|roots| roots.push(root)),
                None => {
                    self.message.views.push(view);
                    self.views.push(vec![root]);
                }
            }
        }
        for binding in other.bindings {
            if !self.message.bindings.iter().any(|known| same_binding(known, &binding)) {
                self.message.bindings.push(binding);
            }
        }
    }
}

/// Whether the views and bindings of two messages of one definition can stand on one type: no two methods of one name, and
/// no two enums of one name in the bindings.
fn additions_agree(a: &Message, b: &Message, enums: &Enums) -> bool {
    let mut methods: HashSet<String> = a.views.iter().flat_map(view_methods).collect();
    methods.extend(a.bindings.iter().flat_map(binding_methods));
    let new_views = b.views.iter().filter(|view| !a.views.iter().any(|known| same_view(known, view)));
    let new_bindings = b.bindings.iter().filter(|one| !a.bindings.iter().any(|known| same_binding(known, one)));
    let mut added = new_views.flat_map(view_methods).chain(new_bindings.flat_map(binding_methods));
    let mut named: HashMap<&str, EnumId> = HashMap::new();
    let mut ids = imported(a).chain(imported(b));
    ids.all(|id| *named.entry(enums.rust_name(id)).or_insert(id) == id) && !added.any(|name| methods.contains(&name))
}

/// The enums that the file of a message names.
fn imported(message: &Message) -> impl Iterator<Item = EnumId> {
    let fields = message.fields.iter().filter_map(|field| Some(field.values?.id()));
    fields.chain(message.bindings.iter().map(|binding| binding.values))
}

fn binding_methods(binding: &Binding) -> [String; 2] {
    [binding.name.rust(), format!("set_{}", binding.name.rust())]
}

/// Whether two bindings say the same.
fn same_binding(a: &Binding, b: &Binding) -> bool {
    (&a.name, a.field, a.values, a.condition) == (&b.name, b.field, b.values, b.condition)
}

/// Whether two views of one message are the same element of an overlay, with the same enums.
fn same_view(a: &View, b: &View) -> bool {
    let enums =
        |view: &View| -> Vec<EnumId> { view.members.iter().filter_map(|member| values(&member.meaning)).collect() };
    a.origin.span == b.origin.span && a.condition == b.condition && enums(a) == enums(b)
}

fn values(meaning: &Meaning) -> Option<EnumId> {
    match meaning {
        Meaning::Values(id) => Some(*id),
        _ => None,
    }
}

/// Changes every mention of an enum.
fn each_enum(message: &mut Message, change: impl Fn(&mut EnumId)) {
    let in_condition = |condition: &mut Option<Condition>| {
        condition.iter_mut().filter_map(|condition| condition.values.as_mut()).for_each(&change);
    };
    for values in message.fields.iter_mut().filter_map(|field| field.values.as_mut()) {
        match values {
            Values::Typed(id) | Values::Converted(id) => change(id),
        }
    }
    for binding in &mut message.bindings {
        change(&mut binding.values);
        in_condition(&mut binding.condition);
    }
    for view in &mut message.views {
        in_condition(&mut view.condition);
        for member in &mut view.members {
            if let Meaning::Values(id) = &mut member.meaning {
                change(id);
            }
        }
    }
}
