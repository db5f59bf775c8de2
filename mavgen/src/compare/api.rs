//! The generated Rust: what no longer compiles, what is new, and what makes the compiler warn.

use std::collections::{BTreeMap, BTreeSet, HashMap};

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
    let mut matched = BTreeSet::new();
    for (name, shape) in &before.surface {
        match names.ty(name).and_then(|now| Some((now, after.surface.get(now)?))) {
            Some((now, other)) => {
                matched.insert(now);
                let types =
                    Types { old: (name, shape), new: (now, other), before: &before, after: &after, names: &names };
                changes.extend(types.changes());
            }
            None => changes.push(Change::new(Kind::ItemRemoved, true, name).at(before.place(name, &Name::Type), None)),
        }
    }
    for name in after.surface.keys().filter(|name| !matched.contains(name.as_str())) {
        changes.push(Change::new(Kind::ItemAdded, false, name).at(None, after.place(name, &Name::Type)));
    }
    Ok(changes)
}

/// One state.
struct Side {
    surface: Surface,
    /// Where types are defined, under an empty second name; and their fields and constants, under their own.
    places: HashMap<(String, String), Span>,
}

impl Side {
    fn of(state: &State) -> Result<Self, Failure> {
        let valid = state.dialect.validate().map_err(Failure::Model)?;
        let surface = surface(valid, &state.names)?;
        let mut places = HashMap::new();
        for (message, names) in state.messages() {
            places.insert((names.ty.clone(), String::new()), message.origin.span);
            let fields = names.fields.iter().zip(&message.fields);
            places.extend(fields.map(|(name, field)| ((names.ty.clone(), name.clone()), field.origin.span)));
            let views = names.views.iter().zip(&message.views);
            places.extend(views.map(|(names, view)| ((names.ty.clone(), String::new()), view.origin.span)));
        }
        for (enum_, names) in state.enums() {
            places.insert((names.ty.clone(), String::new()), enum_.origin.span);
            let entries = names.constants.iter().zip(&enum_.entries);
            places.extend(entries.map(|(name, entry)| ((names.ty.clone(), name.clone()), entry.origin.span)));
        }
        Ok(Self { surface, places })
    }

    /// Where a type, or a member of it, comes from; at least where the type does.
    fn place(&self, of: &str, name: &Name) -> Option<Span> {
        let place = |stem: &str| self.places.get(&(of.to_owned(), stem.to_owned())).copied();
        place(name.stem()).or_else(|| place(""))
    }
}

impl Name {
    /// The field, constant or method that it is about: `set_level` and `with_level` are about `level`.
    fn stem(&self) -> &str {
        match self {
            Self::Type => "",
            Self::Field(name) | Self::Constant(name) | Self::Trait(name) => name,
            Self::Method(name) => beside(name).map_or(name, |(_, stem)| stem),
        }
    }

    /// `Sprayer`, `Sprayer.level`, `SprayState::ON`, `Sprayer::level()`, `impl Targeted for Sprayer`
    fn of(&self, ty: &str) -> String {
        match self {
            Self::Type => ty.to_owned(),
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
        let ((ty, old), (now_ty, new)) = (self.old, self.new);
        let renamed: BTreeMap<Name, &Name> =
            old.members.keys().map(|name| (self.names.member(ty, name), name)).collect();
        let mut changes = Vec::new();
        for (now, name) in &renamed {
            match (old.members.get(name), new.members.get(now)) {
                (Some(before), Some(after)) => changes.extend(self.member((name, before), (now, after))),
                _ => {
                    let change = Change::new(Kind::ItemRemoved, true, name.of(ty));
                    changes.push((*name, change.at(self.before.place(ty, name), None)));
                }
            }
        }
        for name in new.members.keys().filter(|name| !renamed.contains_key(name)) {
            // A new field breaks every literal of the struct.
            let breaking = matches!(name, Name::Field(_)) && new.exhaustive;
            let change = Change::new(Kind::ItemAdded, breaking, name.of(now_ty));
            changes.push((name, change.at(None, self.after.place(now_ty, name))));
        }
        once(&changes)
    }

    /// The changes of the type, or of a member that is in both states.
    fn member<'n>(&self, (name, old): (&'n Name, &Member), (now, new): (&Name, &Member)) -> Vec<(&'n Name, Change)> {
        let item = name.of(self.old.0);
        let mut changes = Vec::new();
        let is_renamed = match name {
            Name::Type => self.old.0 != self.new.0,
            Name::Trait(_) => false,
            _ => name != now,
        };
        if is_renamed {
            changes.push(Change::new(Kind::ItemName, true, &item).with(None::<&str>, Some(now.of(self.new.0))));
        }
        if self.names.signature(&old.signature) != new.signature {
            let change = Change::new(Kind::ItemType, true, &item);
            changes.push(change.with(Some(&old.signature), Some(&new.signature)));
        } else if old.default != new.default && old.default.is_some() && new.default.is_some() {
            let change = Change::new(Kind::ItemDefault, false, &item);
            changes.push(change.with(old.default.as_ref(), new.default.as_ref()));
        }
        changes.extend(deprecation(&item, old.deprecated, new.deprecated));
        let (from, to) = (self.before.place(self.old.0, name), self.after.place(self.new.0, now));
        changes.into_iter().map(|change| (name, change.at(from, to))).collect()
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
fn once(changes: &[(&Name, Change)]) -> Vec<Change> {
    let rank = |name: &Name| match name {
        Name::Method(method) => BESIDE.iter().position(|prefix| method.starts_with(prefix)).map_or(1, |at| at + 2),
        _ => 0,
    };
    let key = |(name, change): &(&Name, Change)| (change.kind, name.stem().to_owned());
    let mut first = HashMap::new();
    for one in changes {
        let best = first.entry(key(one)).or_insert(usize::MAX);
        *best = rank(one.0).min(*best);
    }
    let shared = changes.iter().filter(|one| first.get(&key(one)) == Some(&rank(one.0)));
    shared.map(|(_, change)| change.clone()).collect()
}
