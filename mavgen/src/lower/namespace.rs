//! Names that have to differ from each other: one [`Namespace`] for every scope, which finds each collision and says none.
//! [`super::collision`] does that.
//!
//! Other names follow from these: variants of the dialect are its message types, flat exports are all types. Files are
//! named after types; where two of several dialects would share one, each goes to its own dialect ([`super::link`]). Two bits
//! of one name in one case are a fact of the overlay, which `resolve` reports.

use std::collections::HashMap;

use super::spelling;
use crate::collect::CollectVec as _;
use crate::ir::Name;
use crate::order;
use crate::source::Span;

/// What has to differ. A collision is M601 where nothing else is said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scope {
    /// Messages, enums (suffix `Enum`), views, slots, the dialect (suffix `Dialect`).
    Types,
    /// The fields of a message.
    Fields,
    /// The entries of an enum.
    Constants,
    /// The typed commands of a dialect: M605.
    Commands,
    /// The params of a command: M606.
    Params,
    /// Of a message: accessors of fields (M603), bindings, how it gives its views.
    Methods,
    /// The getter of the switch of a view, and all methods of members.
    ViewMethods,
    /// The view in a slot, and the keys.
    SlotFields,
    /// The values of a view.
    RecordFields,
    /// The dialects of a tree: M802.
    Modules,
}

/// What has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum What {
    /// Nothing of the definitions: this is what has it.
    Reserved(&'static str),
    Message,
    Enum,
    /// A view, or the slot that it is in.
    View,
    Field,
    Entry,
    Param,
    /// A field with a getter and a setter beside it.
    Accessors,
    /// An enum that an overlay binds to a field.
    Binding,
    /// The field that the switch of a view looks at.
    Switch,
    /// Bits of a view.
    Member,
    /// A field that is copied into a slot.
    Key,
    /// A field that is a value of a view.
    Value,
    /// A dialect in a tree of several.
    Root,
}

/// Something that would like to have a name.
#[derive(Clone, Copy, Debug)]
pub(super) struct Claim<'a> {
    pub(super) what: What,
    /// How it is spelled where it was written.
    pub(super) text: &'a str,
    /// Where that is.
    pub(super) span: Option<Span>,
    /// The age of its file: [`crate::ir::Dialect::age`].
    pub(super) age: usize,
}

impl<'a> Claim<'a> {
    /// That of something which is spelled so here; the age of its file does not matter.
    pub(super) fn at(what: What, text: &'a str, span: Span) -> Self {
        Self { what, text, span: Some(span), age: 0 }
    }

    /// That of something which has this name.
    pub(super) fn of(what: What, name: &'a Name) -> Self {
        Self::at(what, &name.text, name.span)
    }

    /// That of what is not in the definitions.
    pub(super) fn reserved(what: &'static str) -> Self {
        Self { what: What::Reserved(what), text: "", span: None, age: 0 }
    }
}

/// A name that two things would like to have.
#[derive(Clone, Debug)]
pub(super) struct Collision<'a> {
    pub(super) scope: Scope,
    /// The name.
    pub(super) name: String,
    /// What has it.
    pub(super) first: Claim<'a>,
    /// What came later.
    pub(super) second: Claim<'a>,
}

/// The names of a scope, and what has each.
pub(super) struct Namespace<'a> {
    scope: Scope,
    taken: HashMap<String, Claim<'a>>,
}

impl<'a> Namespace<'a> {
    /// A scope in which nothing has a name but what is in every one of its kind.
    pub(super) fn of(scope: Scope) -> Self {
        let mut namespace = Self { scope, taken: HashMap::new() };
        match scope {
            Scope::Methods => namespace.reserve("a method of every message", spelling::MESSAGE_METHODS),
            Scope::ViewMethods => namespace.reserve("a method of every view", spelling::VIEW_METHODS),
            Scope::SlotFields => {
                namespace.reserve("the field of every slot that holds the view", spelling::SLOT_VIEW);
            }
            _ => {}
        }
        namespace
    }

    /// Takes names, with spaces between them, that nothing of the definitions can have here.
    pub(super) fn reserve(&mut self, what: &'static str, names: &str) {
        self.taken.extend(names.split(' ').map(|name| (name.to_owned(), Claim::reserved(what))));
    }

    /// What has a name.
    pub(super) fn get(&self, name: &str) -> Option<&Claim<'a>> {
        self.taken.get(name)
    }

    /// Takes a name; if something has it, the collision.
    #[must_use]
    pub(super) fn claim(&mut self, name: String, second: Claim<'a>) -> Option<Collision<'a>> {
        if let Some(&first) = self.taken.get(&name) {
            return Some(Collision { scope: self.scope, name, first, second });
        }
        self.taken.insert(name, second);
        None
    }

    /// Takes all of these names, or none: then the collision of one that something else has.
    #[must_use]
    pub(super) fn claim_all(&mut self, names: &[String], second: Claim<'a>) -> Option<Collision<'a>> {
        if let Some((name, &first)) = names.iter().find_map(|name| self.taken.get_key_value(name)) {
            return Some(Collision { scope: self.scope, name: name.clone(), first, second });
        }
        self.taken.extend(names.iter().map(|name| (name.clone(), second)));
        None
    }

    /// Takes those of these names that are free; the collision is that of the first that is not.
    #[must_use]
    pub(super) fn claim_each(&mut self, names: &[String], by: Claim<'a>) -> Option<Collision<'a>> {
        names.iter().fold(None, |found, name| {
            let collision = self.claim(name.clone(), by);
            found.or(collision)
        })
    }

    /// Takes names, those of older files first; of one file in the order in which they come.
    #[must_use]
    pub(super) fn claim_by_age(&mut self, mut claims: Vec<(String, Claim<'a>)>) -> Vec<Collision<'a>> {
        order::sort_by_key(&mut claims, |(_, claim)| claim.age);
        claims.into_iter().filter_map(|(name, claim)| self.claim(name, claim)).collect_vec()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn by(what: What, text: &str, age: usize) -> Claim<'_> {
        Claim { what, text, span: None, age }
    }

    fn names(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn all_or_none() {
        let mut methods = Namespace::of(Scope::Methods);
        assert!(methods.claim_all(&names(&["x", "set_x"]), by(What::Accessors, "x", 0)).is_none());
        let lost = methods.claim_all(&names(&["set_set_x", "set_x"]), by(What::Accessors, "set_x", 0)).unwrap();
        assert_eq!((lost.name.as_str(), lost.first.text), ("set_x", "x"));
        assert!(methods.get("set_set_x").is_none());
        assert!(matches!(methods.get("info"), Some(Claim { what: What::Reserved(_), .. })));
    }

    #[test]
    fn each_that_is_free() {
        let mut view = Namespace::of(Scope::ViewMethods);
        let collision = view.claim_each(&names(&["bits", "a", "a"]), by(What::Member, "bits", 0)).unwrap();
        assert_eq!(collision.name, "bits");
        assert_eq!(view.get("a").map(|claim| claim.text), Some("bits"));
    }

    #[test]
    fn the_younger_one_collides() {
        let claims = [("X", "young", 1), ("X", "old", 0), ("Y", "young", 1), ("Y", "younger", 1)];
        let claims = claims.map(|(name, text, age)| (name.to_owned(), by(What::Message, text, age))).to_vec();
        let found = Namespace::of(Scope::Types).claim_by_age(claims);
        let found: Vec<_> = found.iter().map(|collision| (collision.first.text, collision.second.text)).collect();
        assert_eq!(found, [("old", "young"), ("young", "younger")]);
    }
}
