//! Overlays: enums, refinements, notes, bindings and views for the messages of a file.

use std::fmt::Write;

use crate::Construct;
use crate::chance::Chance;
use crate::enums::{self, Enum};
use crate::messages::Message;
use crate::names::Scope;
use crate::view;
use crate::xml::{attribute, prose};

/// What additions to one message are made from, and the names that are taken.
pub(crate) struct Additions<'a> {
    pub(crate) enums: &'a [Enum],
    pub(crate) visible: &'a [usize],
    /// The types of the dialect.
    pub(crate) types: &'a mut Scope,
    /// The methods of the message.
    pub(crate) methods: Scope,
}

impl Additions<'_> {
    /// `if` and `is`; mostly nothing.
    pub(crate) fn condition(&self, chance: &mut Chance, message: &Message, construct: Construct) -> String {
        let asked: Vec<_> =
            message.fields.iter().filter(|field| field.array.is_none() && field.scalar.is_integer()).collect();
        let Some(field) = chance.pick(&asked).filter(|_| chance.one_in(4)) else { return String::new() };
        chance.say(construct);
        let entries = field.values.and_then(|at| self.enums.get(at)).map(|one| one.entries.as_slice());
        let entry = entries.and_then(|entries| chance.pick(entries)).filter(|(_, value)| *value <= field.scalar.most());
        let value = match entry {
            Some((name, _)) if !chance.one_in(3) => name.clone(),
            _ => chance.below(field.scalar.most().min(300) as usize).to_string(),
        };
        attribute("if", &field.name) + &attribute("is", &value)
    }
}

/// The overlay of a file: for its messages, with the enums that it sees.
pub(crate) fn make(
    chance: &mut Chance,
    (base, file): (&str, usize),
    (messages, enums): (&[&Message], &mut Vec<Enum>),
    (visible, types): (&mut Vec<usize>, &mut Scope),
) -> String {
    let mut text = format!("<mavlink-overlay version=\"1\" for=\"{base}\">\n<enums>\n");
    for _ in 0..chance.below(3) {
        chance.say(Construct::OverlayEnum);
        let name = types.upper(chance, Construct::OddEnumName);
        let (made, xml) = enums::make(chance, name, file);
        text += &xml;
        visible.push(enums.len());
        enums.push(made);
    }
    text += "</enums>\n";
    refine(chance, enums, visible, (file, &mut text));
    for message in messages {
        note(chance, message, &mut text);
        let mut methods = Scope::default();
        message.fields.iter().for_each(|field| {
            methods.take(&field.name);
            methods.take(&format!("set_{}", field.name));
        });
        let mut added = Additions { enums, visible, types, methods };
        let mut parts = bindings(chance, message, &mut added);
        let views = [0, 1, 1, 2][chance.below(4)];
        let views: Vec<String> = (0..views).filter_map(|_| view::make(chance, message, &mut added)).collect();
        if views.len() > 1 {
            chance.say(Construct::TwoViews);
        }
        parts += &views.concat();
        _ = writeln!(text, "<message{}>\n{parts}</message>", attribute("name", &message.name));
    }
    text + "</mavlink-overlay>\n"
}

/// Makes flags of an enum whose values allow that, or keeps one from being deprecated.
fn refine(chance: &mut Chance, enums: &mut [Enum], visible: &[usize], (file, text): (usize, &mut String)) {
    for at in visible {
        let Some(one) = enums.get_mut(*at).filter(|one| one.file != file && !one.refined && chance.one_in(5)) else {
            continue;
        };
        one.refined = true;
        chance.say(Construct::Refine);
        let named = attribute("enum", &one.name);
        if one.deprecated {
            one.deprecated = false;
            _ = writeln!(text, "<refine{named} deprecated=\"false\"/>");
        } else if !one.bitmask {
            one.bitmask = true;
            _ = writeln!(text, "<refine{named} bitmask=\"true\"/>");
        }
    }
}

fn note(chance: &mut Chance, message: &Message, text: &mut String) {
    let Some(field) = chance.pick(&message.fields).filter(|_| chance.maybe(3, Construct::Note)) else { return };
    let of_field = if chance.one_in(2) { attribute("field", &field.name) } else { String::new() };
    _ = writeln!(text, "<note{}{of_field}>Note. {}</note>", attribute("message", &message.name), prose(chance));
}

fn bindings(chance: &mut Chance, message: &Message, added: &mut Additions<'_>) -> String {
    let mut text = String::new();
    for field in &message.fields {
        if field.array.is_some() || field.values.is_some() || !field.scalar.is_integer() {
            continue;
        }
        let suits = |at: &&usize| added.enums.get(**at).is_some_and(|one| one.integer() == field.scalar);
        let suitable: Vec<usize> = added.visible.iter().filter(suits).copied().collect();
        let Some(carried) = chance.pick(&suitable).and_then(|at| added.enums.get(*at)) else { continue };
        if !chance.maybe(2, Construct::Bind) {
            continue;
        }
        if carried.bitmask || carried.integer().is_signed() {
            chance.say(Construct::BindFlags);
        }
        if carried.deprecated {
            chance.say(Construct::BindDeprecated);
        }
        let name = added.methods.lower(chance, Construct::OddGetterName);
        added.methods.take(&format!("set_{name}"));
        let named = attribute("name", &name) + &attribute("field", &field.name) + &attribute("enum", &carried.name);
        let condition = added.condition(chance, message, Construct::BindIf);
        _ = writeln!(text, "<bind{named}{condition}>{}</bind>", prose(chance));
    }
    text
}
