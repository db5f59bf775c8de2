//! The generated Rust: what no longer compiles, what is new, and what makes the compiler warn.

use std::collections::{BTreeMap, HashMap};

use super::pairs::Pairs;
use super::renamed::Renamed;
use super::state::State;
use super::surface::{BESIDE, Member, Name, Shape, Surface, beside, surface};
use super::{Change, Kind};
use crate::builder::Failure;
use crate::source::Span;

/// The changes of all types.
pub(super) fn changes(old: &State, new: &State, pairs: &Pairs<'_>) -> Result<Vec<Change>, Failure> {
    let names = Renamed::of(pairs, old, new);
    let (before, after) = (Side::of(old)?, Side::of(new)?);
    let mut changes = Vec::new();
    let mut matched: BTreeMap<&str, &str> = BTreeMap::new();
    for (name, shape) in &before.surface {
        match names.ty(name).and_then(|now| Some((now, after.surface.get(now)?))) {
            Some((now, other)) => {
                matched.insert(now, name);
                let types =
                    Types { old: (name, shape), new: (now, other), before: &before, after: &after, names: &names };
                changes.extend(types.changes());
            }
            None => changes.push(Change::new(Kind::ItemRemoved, true, name).at(before.place(name, None), None)),
        }
    }
    for name in after.surface.keys().filter(|name| !matched.contains_key(name.as_str())) {
        changes.push(Change::new(Kind::ItemAdded, false, name).at(None, after.place(name, None)));
    }
    Ok(changes)
}

/// One state.
struct Side {
    surface: Surface,
    /// Where types are defined and, by their own name, fields and constants.
    places: HashMap<(String, Option<String>), Span>,
}

impl Side {
    fn of(state: &State) -> Result<Self, Failure> {
        let valid = state.dialect.validate().map_err(Failure::Model)?;
        let surface = surface(valid, &state.names).map_err(|internal| Failure::Internal(internal.to_string()))?;
        let mut places = HashMap::new();
        for (message, names) in state.messages() {
            places.insert((names.ty.clone(), None), message.origin.span);
            let fields = names.fields.iter().zip(&message.fields);
            places.extend(fields.map(|(name, field)| ((names.ty.clone(), Some(name.clone())), field.origin.span)));
            let views = names.views.iter().zip(&message.views);
            places.extend(views.map(|(names, view)| ((names.ty.clone(), None), view.origin.span)));
        }
        for (enum_, names) in state.enums() {
            places.insert((names.ty.clone(), None), enum_.origin.span);
            let entries = names.constants.iter().zip(&enum_.entries);
            places.extend(entries.map(|(name, entry)| ((names.ty.clone(), Some(name.clone())), entry.origin.span)));
        }
        Ok(Self { surface, places })
    }

    /// Where a type, or a member of it, comes from; at least where the type does.
    fn place(&self, of: &str, member: Option<&Name>) -> Option<Span> {
        let own = member.map(Name::stem).map(|stem| (of.to_owned(), Some(stem.to_owned())));
        let own = own.and_then(|key| self.places.get(&key));
        own.or_else(|| self.places.get(&(of.to_owned(), None))).copied()
    }
}

impl Name {
    /// The field, constant or method that it is about: `set_level` and `with_level` are about `level`.
    fn stem(&self) -> &str {
        match self {
            Self::Field(name) | Self::Constant(name) | Self::Trait(name) => name,
            Self::Method(name) => beside(name).map_or(name, |(_, stem)| stem),
        }
    }

    /// `Sprayer.level`, `SprayState::ON`, `Sprayer::level()`, `impl Targeted for Sprayer`
    fn of(&self, ty: &str) -> String {
        match self {
            Self::Field(name) => format!("{ty}.{name}"),
            Self::Constant(name) => format!("{ty}::{name}"),
            Self::Method(name) => format!("{ty}::{name}()"),
            Self::Trait(name) => format!("impl {name} for {ty}"),
        }
    }
}

/// A type that is in both states.
struct Types<'a> {
    old: (&'a str, &'a Shape),
    new: (&'a str, &'a Shape),
    before: &'a Side,
    after: &'a Side,
    names: &'a Renamed<'a>,
}

impl Types<'_> {
    fn changes(&self) -> Vec<Change> {
        let ((name, old), (now, new)) = (self.old, self.new);
        let mut changes = Vec::new();
        let mut push = |change: Change| changes.push(self.placed(change, None, None));
        if name != now {
            push(Change::new(Kind::ItemName, true, name).with(None::<&str>, Some(now)));
        }
        if old.signature != new.signature {
            push(Change::new(Kind::ItemType, true, name).with(Some(&old.signature), Some(&new.signature)));
        }
        deprecation(name, old.deprecated, new.deprecated).into_iter().for_each(push);
        changes.extend(self.members());
        changes
    }

    fn placed(&self, change: Change, old: Option<&Name>, new: Option<&Name>) -> Change {
        change.at(self.before.place(self.old.0, old), self.after.place(self.new.0, new))
    }

    fn members(&self) -> Vec<Change> {
        let ((ty, old), (_, new)) = (self.old, self.new);
        let renamed: BTreeMap<Name, &Name> =
            old.members.keys().map(|name| (self.names.member(ty, name), name)).collect();
        let mut changes = Vec::new();
        for (now, name) in &renamed {
            let (Some(before), after) = (old.members.get(name), new.members.get(now)) else { continue };
            match after {
                Some(after) => changes.extend(self.member((name, before), (now, after))),
                None => changes.push((Kind::ItemRemoved, *name, self.removed(name))),
            }
        }
        let added = new.members.keys().filter(|name| !renamed.contains_key(name));
        changes.extend(added.map(|name| (Kind::ItemAdded, name, self.added(name))));
        once(changes)
    }

    fn removed(&self, name: &Name) -> Change {
        let change = Change::new(Kind::ItemRemoved, true, name.of(self.old.0));
        Change { new: None, ..self.placed(change, Some(name), None) }
    }

    /// A new field breaks every literal of the struct.
    fn added(&self, name: &Name) -> Change {
        let breaking = matches!(name, Name::Field(_)) && self.new.1.exhaustive;
        let change = Change::new(Kind::ItemAdded, breaking, name.of(self.new.0));
        Change { old: None, ..self.placed(change, None, Some(name)) }
    }

    /// The changes of a member that is in both states.
    fn member<'n>(
        &self,
        (name, old): (&'n Name, &Member),
        (now, new): (&Name, &Member),
    ) -> Vec<(Kind, &'n Name, Change)> {
        let item = name.of(self.old.0);
        let mut changes = Vec::new();
        if name != now && !matches!(name, Name::Trait(_)) {
            changes.push(Change::new(Kind::ItemName, true, &item).with(None::<&str>, Some(now.of(self.new.0))));
        }
        let signature = self.names.signature(&old.signature);
        if signature != new.signature {
            changes.push(Change::new(Kind::ItemType, true, &item).with(Some(&old.signature), Some(&new.signature)));
        } else if old.default != new.default && old.default.is_some() && new.default.is_some() {
            let change = Change::new(Kind::ItemDefault, false, &item);
            changes.push(change.with(old.default.as_ref(), new.default.as_ref()));
        }
        changes.extend(deprecation(&item, old.deprecated, new.deprecated));
        changes.into_iter().map(|change| (change.kind, name, self.placed(change, Some(name), Some(now)))).collect()
    }
}

/// That the compiler warns of an item, or no longer does. Code that does not forbid warnings goes on to compile.
fn deprecation(item: &str, old: bool, new: bool) -> Option<Change> {
    match (old, new) {
        (false, true) => Some(Change::new(Kind::ItemDeprecated, false, item)),
        (true, false) => Some(Change::new(Kind::ItemUndeprecated, false, item)),
        _ => None,
    }
}

/// One change where a field, its getter and its setter share one: that of the first of them.
fn once(changes: Vec<(Kind, &Name, Change)>) -> Vec<Change> {
    let rank = |name: &Name| match name {
        Name::Method(method) => {
            let prefix = BESIDE.iter().position(|prefix| method.starts_with(prefix));
            prefix.map_or(1, |at| at + 2)
        }
        _ => 0,
    };
    let mut first: HashMap<(Kind, &str), usize> = HashMap::new();
    for (kind, name, _) in &changes {
        let best = first.entry((*kind, name.stem())).or_insert(usize::MAX);
        *best = rank(name).min(*best);
    }
    let is_first = |kind: Kind, name: &Name| first.get(&(kind, name.stem())) == Some(&rank(name));
    changes.iter().filter(|(kind, name, _)| is_first(*kind, name)).map(|(_, _, change)| change.clone()).collect()
}
