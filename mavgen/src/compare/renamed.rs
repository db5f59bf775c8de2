//! What generated types and their members are called in the new state.

use std::collections::HashMap;

use super::pairs::Pairs;
use super::state::{State, of_same};
use super::surface::{Name, beside};

/// What generated items are called now.
pub(super) struct Renamed<'a> {
    types: HashMap<&'a str, &'a str>,
    /// By old type: fields and constants.
    members: HashMap<(&'a str, &'a str), &'a str>,
}

impl<'a> Renamed<'a> {
    pub(super) fn of(pairs: &Pairs<'_>, old: &'a State, new: &'a State) -> Self {
        let mut names = Self { types: HashMap::new(), members: HashMap::new() };
        for pair in pairs.messages.both.iter().filter(|pair| pair.is_one_message()) {
            let before = of_same(&old.dialect.messages, &old.names.messages, pair.old);
            let after = of_same(&new.dialect.messages, &new.names.messages, pair.new);
            let Some((before, after)) = before.zip(after) else { continue };
            let fields = pair.fields.both.iter().filter_map(|(old, new)| {
                of_same(&pair.old.fields, &before.fields, old).zip(of_same(&pair.new.fields, &after.fields, new))
            });
            names.add(&before.ty, &after.ty, fields);
        }
        for pair in &pairs.enums.both {
            let before = of_same(&old.dialect.enums, &old.names.enums, pair.old);
            let after = of_same(&new.dialect.enums, &new.names.enums, pair.new);
            let Some((before, after)) = before.zip(after) else { continue };
            let entries = pair.entries.both.iter().filter_map(|(old, new)| {
                let now = of_same(&pair.new.entries, &after.constants, new);
                of_same(&pair.old.entries, &before.constants, old).zip(now)
            });
            names.add(&before.ty, &after.ty, entries);
        }
        names
    }

    fn add(&mut self, before: &'a str, after: &'a str, members: impl Iterator<Item = (&'a String, &'a String)>) {
        self.types.insert(before, after);
        self.members.extend(members.map(|(old, new)| ((before, old.as_str()), new.as_str())));
    }

    /// What an old type is called now; nothing if another type has taken its name.
    pub(super) fn ty<'n>(&self, name: &'n str) -> Option<&'n str>
    where
        'a: 'n,
    {
        match self.types.get(name) {
            Some(now) => Some(now),
            None => (!self.types.values().any(|now| *now == name)).then_some(name),
        }
    }

    /// What a member of an old type is called now.
    pub(super) fn member(&self, of: &str, name: &Name) -> Name {
        let now = |name: &str| self.members.get(&(of, name)).map(|now| (*now).to_owned());
        match name {
            Name::Type => Name::Type,
            Name::Field(field) => Name::Field(now(field).unwrap_or_else(|| field.clone())),
            Name::Constant(constant) => Name::Constant(now(constant).unwrap_or_else(|| constant.clone())),
            Name::Method(method) => {
                let other = || beside(method).and_then(|(prefix, stem)| Some(format!("{prefix}{}", now(stem)?)));
                Name::Method(now(method).or_else(other).unwrap_or_else(|| method.clone()))
            }
            Name::Trait(of) => Name::Trait(self.signature(of)),
        }
    }

    /// A signature with types called as they are now.
    pub(super) fn signature(&self, signature: &str) -> String {
        let mut text = String::new();
        let mut rest = signature;
        while let Some((gap, word, after)) = next_word(rest) {
            text.push_str(gap);
            text.push_str(self.types.get(word).copied().unwrap_or(word));
            rest = after;
        }
        text + rest
    }
}

/// What stands before the first word, the word, and what stands behind it.
fn next_word(text: &str) -> Option<(&str, &str, &str)> {
    let is_word = |character: char| character.is_alphanumeric() || character == '_';
    let (gap, rest) = text.split_at_checked(text.find(is_word)?)?;
    let (word, after) = rest.split_at_checked(rest.find(|character| !is_word(character)).unwrap_or(rest.len()))?;
    Some((gap, word, after))
}
