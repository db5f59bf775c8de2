//! Views: words, slots, keys, sentinels, values.

use std::fmt::Write;

use crate::Construct;
use crate::bits::Material;
use crate::chance::Chance;
use crate::layout;
use crate::messages::{Field, Kind, Message, sentinel};
use crate::names::Scope;
use crate::overlay::Additions;
use crate::switch::Selector;
use crate::xml::{attribute, optional, prose};

/// Bits of the widest view.
const MOST_BITS: u32 = 128;

/// A view of a message, if its fields allow one.
pub(crate) fn make(chance: &mut Chance, message: &Message, added: &mut Additions<'_>) -> Option<String> {
    if chance.one_in(4) {
        return record(chance, message, added);
    }
    let length = message.fields.iter().filter(|field| field.scalar.is_unsigned()).find_map(|field| field.array);
    match length.filter(|_| !chance.one_in(5)) {
        Some(length) => slots(chance, message, length, added),
        None => once(chance, message, added),
    }
}

fn is_word(field: &Field) -> bool {
    field.scalar.is_unsigned() || field.scalar.kind == Kind::Float
}

/// Some of the fields, as many as there is room for.
fn words<'m>(chance: &mut Chance, fields: impl Iterator<Item = &'m Field>, whole: bool) -> (Vec<&'m Field>, u32) {
    let (mut words, mut width) = (Vec::new(), 0);
    for field in fields {
        let bits = field.scalar.bits * u32::from(field.array.filter(|_| whole).unwrap_or(1));
        if bits + width > MOST_BITS || !words.is_empty() && chance.one_in(3) {
            continue;
        }
        width += bits;
        words.push(field);
    }
    if words.iter().any(|field| field.values.is_some()) {
        chance.say(Construct::EnumWord);
    }
    if words.iter().any(|field| field.scalar.kind == Kind::Float) {
        chance.say(Construct::FloatWord);
    }
    if width > 64 {
        chance.say(Construct::ViewWide);
    }
    (words, width)
}

fn once(chance: &mut Chance, message: &Message, added: &mut Additions<'_>) -> Option<String> {
    let skip = chance.below(message.fields.len());
    let fields = message.fields.iter().cycle().skip(skip).take(message.fields.len());
    let (words, width) = words(chance, fields.filter(|field| is_word(field)), true);
    if words.is_empty() {
        return None;
    }
    chance.say(if words.len() > 1 { Construct::ViewWords } else { Construct::ViewOnce });
    let spelled: Vec<String> =
        words.iter().map(|field| format!("{}{}", field.name, if field.array.is_some() { "[*]" } else { "" })).collect();
    if spelled.iter().any(|word| word.ends_with(']')) {
        chance.say(Construct::ViewJoined);
    }
    let name = added.types.upper(chance, Construct::OddViewName);
    let item = added.methods.lower(chance, Construct::OddGetterName);
    let head = attribute("name", &name) + &attribute("words", &spelled.join(" ")) + &attribute("item", &item);
    let condition = added.condition(chance, message, Construct::ViewIf);
    let body = body(chance, message, added, (&words, width, None));
    Some(format!("<view{head}{condition}{body}</view>\n"))
}

fn slots(chance: &mut Chance, message: &Message, length: u8, added: &mut Additions<'_>) -> Option<String> {
    let elements = message.fields.iter().filter(|field| field.array == Some(length) && is_word(field));
    let (words, width) = words(chance, elements, false);
    chance.say(Construct::ViewSlots);
    let spelled: Vec<String> = words.iter().map(|field| format!("{}[i]", field.name)).collect();
    let (name, item) = (added.types.upper(chance, Construct::OddViewName), item(chance, message, added));
    let items = added.methods.lower(chance, Construct::OddGetterName);
    let mut head = attribute("name", &name) + &attribute("words", &spelled.join(" "));
    head += &(attribute("item", &item) + &attribute("items", &items));
    if let Some(count) = count(chance, message) {
        head += &attribute("count", &count.name);
    }
    let condition = added.condition(chance, message, Construct::ViewIf);
    let mut keys = String::new();
    let mut scope = Scope::default();
    for _ in 0..chance.below(4) {
        keys += &key(chance, message, length, (&mut scope, added)).unwrap_or_default();
    }
    let body = body(chance, message, added, (&words, width, Some(length)));
    let at = body.find('>').map_or(0, |at| at + 1);
    Some(format!("<view{head}{condition}{}{keys}{}</view>\n", &body[..at], &body[at..]))
}

/// The name of a slot. Now and then one whose helper is called like the accessor of a field.
fn item(chance: &mut Chance, message: &Message, added: &mut Additions<'_>) -> String {
    let mut accessors = message.fields.iter().filter_map(|field| field.name.strip_prefix("store_"));
    if let Some(name) = accessors.next_back().filter(|name| added.types.take(name)) {
        chance.say(Construct::StoreCollision);
        return name.to_owned();
    }
    let name = added.types.upper(chance, Construct::OddViewName).to_lowercase();
    added.methods.take(&name);
    for helper in ["set", "push", "store"] {
        added.methods.take(&format!("{helper}_{name}"));
    }
    name
}

fn count<'m>(chance: &mut Chance, message: &'m Message) -> Option<&'m Field> {
    let scalars: Vec<&Field> =
        message.fields.iter().filter(|field| field.array.is_none() && field.scalar.is_unsigned()).collect();
    let field = chance.pick(&scalars).copied().filter(|_| !chance.one_in(4))?;
    chance.say(if field.values.is_some() { Construct::EnumCount } else { Construct::Count });
    Some(field)
}

/// `x`, or `x[i]` of an array that has an element for each slot.
fn beside(field: &Field, length: Option<u8>) -> Option<String> {
    match field.array {
        None => Some(field.name.clone()),
        Some(own) if Some(own) == length => Some(format!("{}[i]", field.name)),
        Some(_) => None,
    }
}

fn key(
    chance: &mut Chance,
    message: &Message,
    length: u8,
    (scope, added): (&mut Scope, &Additions<'_>),
) -> Option<String> {
    let field = chance.pick(&message.fields)?;
    copied(chance, ("key", field), Some(length), (scope, added))
}

/// A view of some of the scalars.
fn record(chance: &mut Chance, message: &Message, added: &mut Additions<'_>) -> Option<String> {
    let condition = added.condition(chance, message, Construct::ValuesIf);
    let asked = |field: &&Field| condition.contains(&attribute("if", &field.name));
    let scalars = message.fields.iter().filter(|field| field.array.is_none() && !asked(field));
    let chosen: Vec<&Field> = scalars.filter(|_| !chance.one_in(3)).collect();
    let mut scope = Scope::default();
    let values = chosen.iter().filter_map(|field| copied(chance, ("value", field), None, (&mut scope, added)));
    let values: String = values.collect();
    if values.is_empty() {
        return None;
    }
    chance.say(Construct::Values);
    let item = added.methods.lower(chance, Construct::OddGetterName);
    for helper in ["set", "with"] {
        added.methods.take(&format!("{helper}_{item}"));
    }
    let head = attribute("name", &added.types.upper(chance, Construct::OddViewName)) + &attribute("item", &item);
    Some(format!("<view{head}{condition}>\n<description>{}</description>\n{values}</view>\n", prose(chance)))
}

/// A key or a value.
fn copied(
    chance: &mut Chance,
    (element, field): (&str, &Field),
    length: Option<u8>,
    (scope, added): (&mut Scope, &Additions<'_>),
) -> Option<String> {
    let word = beside(field, length)?;
    chance.say(match field.scalar.kind {
        Kind::Float => Construct::KeyFloat,
        _ if field.values.is_some() => Construct::EnumKey,
        _ => Construct::Key,
    });
    let name = attribute("name", &scope.lower(chance, Construct::OddGetterName));
    let plain = field.values.is_none() && field.scalar.kind != Kind::Char;
    let units = if plain && chance.maybe(3, Construct::KeyUnits) { Some("ms") } else { None };
    let carried = field.values.and_then(|at| added.enums.get(at));
    let invalid =
        if field.scalar.is_integer() && chance.one_in(3) { sentinel(chance, field.scalar, carried) } else { None };
    if invalid.is_some() {
        chance.say(Construct::KeyInvalid);
    }
    let more = optional("units", units) + &optional("invalid", invalid.as_deref());
    Some(format!("<{element}{name}{}{more}>{}</{element}>\n", attribute("field", &word), prose(chance)))
}

/// What stands in a view, from the end of its start tag on.
fn body(
    chance: &mut Chance,
    message: &Message,
    added: &Additions<'_>,
    (words, width, length): (&[&Field], u32, Option<u8>),
) -> String {
    let partial = chance.maybe(5, Construct::Partial);
    let mut text = String::from(if partial { " partial=\"true\">" } else { ">" });
    _ = writeln!(text, "<description>{}</description>", prose(chance));
    if chance.maybe(5, Construct::ViewInvalidWords) {
        let value = if width < 64 && chance.one_in(2) { (1_u64 << width) - 1 } else { 0 };
        _ = writeln!(text, "<invalid value=\"{value}\"/>");
    }
    if chance.one_in(3) {
        text += &invalid(chance, message, length, added).unwrap_or_default();
    }
    let material = Material { enums: added.enums, visible: added.visible, partial };
    let outside = |field: &&Field| !words.iter().any(|word| word.name == field.name);
    let unsigned = message.fields.iter().filter(outside).filter(|field| field.scalar.is_unsigned());
    let selectors: Vec<Selector> = unsigned
        .filter_map(|field| {
            let (most, values) = (field.scalar.most(), field.values);
            Some(Selector { name: field.name.clone(), word: beside(field, length)?, on_bits: false, most, values })
        })
        .collect();
    text + &layout::make(chance, &material, width, &selectors)
}

fn invalid(chance: &mut Chance, message: &Message, length: Option<u8>, added: &Additions<'_>) -> Option<String> {
    let field = chance.pick(&message.fields).filter(|field| field.scalar.is_integer())?;
    let word = beside(field, length)?;
    let carried = field.values.and_then(|at| added.enums.get(at));
    let value = sentinel(chance, field.scalar, carried)?;
    chance.say(if carried.is_some() { Construct::ViewInvalidEnum } else { Construct::ViewInvalid });
    Some(format!("<invalid{}{}/>\n", attribute("field", &word), attribute("value", &value)))
}
