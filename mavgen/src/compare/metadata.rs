//! What neither the wire nor the types show: units, ranges, sentinels, stages of life, parameters of commands.

use super::order::moved;
use super::pairs::{EnumPair, MessagePair, Named as _, Pairs};
use super::{Change, Kind};
use crate::ir::{
    Command, Dialect, Entry, Enum, Field, FieldType, FileIndex, Invalid, Lifecycle, Limits, Message, Origin, Param,
    Scalar, Scope, Sentinel,
};
use crate::source::Span;

/// The changes of the facts of all items that are in both states.
pub(super) fn changes(old: &Dialect, new: &Dialect, pairs: &Pairs<'_>) -> Vec<Change> {
    let dialects = Dialects { old, new };
    let facts =
        |Dialect { version, name: _, files: _, enums: _, messages: _ }: &Dialect| vec![fact("version", Some(version))];
    let own = differences(&new.name, [None; 2], facts(old), facts(new));
    let messages = pairs.messages.both.iter().flat_map(|pair| dialects.message(pair));
    let enums = pairs.enums.both.iter().flat_map(|pair| dialects.enum_(pair));
    own.into_iter().chain(messages).chain(enums).collect()
}

/// The name of a fact, and what it is.
type Fact = (&'static str, Option<String>);

fn fact(name: &'static str, value: Option<impl ToString>) -> Fact {
    (name, value.map(|value| value.to_string()))
}

fn limits(Limits { min, max, increment }: &Limits) -> [Fact; 3] {
    [fact("minValue", *min), fact("maxValue", *max), fact("increment", *increment)]
}

/// What differs between the facts of an item, which both states list in one order.
fn differences(item: &str, [from, to]: [Option<Span>; 2], old: Vec<Fact>, new: Vec<Fact>) -> Vec<Change> {
    let facts = old.into_iter().zip(new).filter(|(old, new)| old != new);
    facts
        .map(|((name, old), (_, new))| Change::new(Kind::Fact(name), false, item).with(old, new).at(from, to))
        .collect()
}

/// The stage of life; of what is deprecated in both states, since when and by what. That something became deprecated is said
/// of the Rust.
fn lifecycle(of: &Origin, other: &Origin) -> Fact {
    // The file is compared where it is that of the definition; prose is free to change.
    let Origin { lifecycle, file: _, overlays: _, span: _, description: _ } = of;
    let is_deprecated = |stage: &Option<Lifecycle>| matches!(stage, Some(Lifecycle::Deprecated(_)));
    let shows = is_deprecated(lifecycle) == is_deprecated(&other.lifecycle) || !is_deprecated(lifecycle);
    fact("lifecycle", lifecycle.as_ref().filter(|_| shows))
}

fn field(
    Field {
        ty,
        units,
        invalid,
        limits,
        multiplier,
        default,
        print_format,
        display_bitmask,
        instance,
        // The wire or the types show these. A new fact of the model has to be compared here, or named as one of them.
        origin: _,
        name: _,
        offset: _,
        extension: _,
        values: _,
    }: &Field,
) -> Vec<Fact> {
    let version = |ty: &FieldType| matches!(ty.scalar, Scalar::Version(_)).then_some("uint8_t_mavlink_version");
    let [min, max, increment] = self::limits(limits);
    vec![
        fact("constant", version(ty)),
        fact("units", units.as_ref()),
        fact("invalid", invalid.as_ref().map(sentinel)),
        min,
        max,
        increment,
        fact("multiplier", multiplier.as_ref()),
        fact("default", default.as_ref()),
        fact("print_format", print_format.as_ref()),
        fact("display=\"bitmask\"", Some(display_bitmask)),
        fact("instance", Some(instance)),
    ]
}

/// A sentinel as the XML spells it: `[65535:]`
fn sentinel(Invalid { scope, sentinel }: &Invalid) -> String {
    let value = match sentinel {
        Sentinel::Integer(value) => value.to_string(),
        Sentinel::Float(value) => value.to_string(),
        Sentinel::NotANumber => "NaN".to_owned(),
    };
    match scope {
        Scope::Each => value,
        Scope::Whole => format!("[{value}:]"),
        Scope::First => format!("[{value},]"),
    }
}

/// Fields that stand elsewhere in the XML and not on the wire.
fn order(pair: &MessagePair<'_>) -> Vec<Change> {
    let mut by_offset: Vec<_> = pair.fields.both.iter().map(|(old, new)| (old.offset, new.offset)).collect();
    by_offset.sort_unstable();
    if !by_offset.is_sorted_by_key(|(_, new)| *new) {
        return Vec::new();
    }
    let rank = |field: &Field, message: &Message| message.fields.iter().position(|other| other.name == field.name);
    let fields = pair.fields.both.iter();
    let mut fields: Vec<_> = fields.map(|both| ((rank(both.0, pair.old), rank(both.1, pair.new)), *both)).collect();
    fields.sort_by_key(|((old, _), _)| *old);
    let change = moved(fields, |((_, new), _)| *new).map(|((from, to), (old, new))| {
        let item = format!("field {}.{}", pair.old.name.text, old.name.text);
        let change = Change::new(Kind::Fact("place in the XML"), false, item);
        change.with(from.map(|at| at + 1), to.map(|at| at + 1)).at(Some(old.span()), Some(new.span()))
    });
    change.collect()
}

struct Dialects<'a> {
    old: &'a Dialect,
    new: &'a Dialect,
}

impl Dialects<'_> {
    fn message(&self, pair: &MessagePair<'_>) -> Vec<Change> {
        let MessagePair { old, new, fields } = pair;
        let facts = |dialect, one: &Message, other: &Message| {
            let Message {
                name: _,
                origin,
                id: _,
                crc_extra: _,
                len_v1: _,
                len_v2: _,
                fields: _,
                views: _,
                bindings: _,
            } = one;
            vec![lifecycle(origin, &other.origin), file(dialect, origin.file, other.origin.file)]
        };
        let item = format!("message {}", old.name.text);
        let spans = [old, new].map(|message| Some(message.span()));
        let mut changes = differences(&item, spans, facts(self.old, old, new), facts(self.new, new, old));
        for (before, after) in &fields.both {
            let item = format!("field {}.{}", old.name.text, before.name.text);
            let spans = [before, after].map(|field| Some(field.span()));
            changes.extend(differences(&item, spans, field(before), field(after)));
        }
        changes.extend(order(pair));
        changes
    }

    fn enum_(&self, EnumPair { old, new, entries }: &EnumPair<'_>) -> Vec<Change> {
        let facts = |dialect, one: &Enum, other: &Enum| {
            let Enum { name: _, defined_in, origin, bitmask: _, repr: _, entries: _, named_in: _ } = one;
            vec![lifecycle(origin, &other.origin), file(dialect, *defined_in, other.defined_in)]
        };
        let item = format!("enum {}", old.name.text);
        let spans = [old, new].map(|enum_| Some(enum_.span()));
        let mut changes = differences(&item, spans, facts(self.old, old, new), facts(self.new, new, old));
        for (before, after) in &entries.both {
            changes.extend(self.entry(&format!("entry {}.{}", old.name.text, before.name.text), before, after));
        }
        changes
    }

    fn entry(&self, item: &str, old: &Entry, new: &Entry) -> Vec<Change> {
        let none = Command::default();
        let facts = |one: &Entry, other: &Entry| {
            let Entry { auto, command, origin, name: _, value: _ } = one;
            let Command { params: _, has_location, is_destination, mission_only } = command.as_ref().unwrap_or(&none);
            vec![
                lifecycle(origin, &other.origin),
                fact("value", Some(if *auto { "automatic" } else { "written" })),
                fact("hasLocation", Some(has_location)),
                fact("isDestination", Some(is_destination)),
                fact("missionOnly", Some(mission_only)),
            ]
        };
        let spans = [old, new].map(|entry| Some(entry.span()));
        let mut changes = differences(item, spans, facts(old, new), facts(new, old));
        for index in 1..=7 {
            let [old, new] = [old, new].map(|entry| {
                entry.command.iter().flat_map(|command| &command.params).find(|param| param.index == index)
            });
            changes.extend(self.param(&format!("{item} param {index}"), old, new));
        }
        changes
    }

    fn param(&self, item: &str, old: Option<&Param>, new: Option<&Param>) -> Vec<Change> {
        let listed = |param: Option<&Param>| vec![fact("param", param.map(|_| "listed"))];
        let facts = |dialect: &Dialect, param: &Param| {
            let Param { label, units, enum_, limits, default, reserved, origin: _, index: _ } = param;
            let [min, max, increment] = self::limits(limits);
            vec![
                fact("label", label.as_ref()),
                fact("units", units.as_ref()),
                fact("enum", enum_.and_then(|id| dialect.enum_by_id(id)).map(|enum_| &enum_.name.text)),
                min,
                max,
                increment,
                fact("default", *default),
                fact("reserved", Some(reserved)),
            ]
        };
        let spans = [old, new].map(|param| param.map(|param| param.origin.span));
        match (old, new) {
            (Some(before), Some(after)) => differences(item, spans, facts(self.old, before), facts(self.new, after)),
            _ => differences(item, spans, listed(old), listed(new)),
        }
    }
}

/// The file of an item; nothing if it is the dialect's own in both states, which may be called differently.
fn file(dialect: &Dialect, of: FileIndex, other: FileIndex) -> Fact {
    let file = dialect.file(of).filter(|_| of.0 != 0 || other.0 != 0);
    fact("file", file.map(|file| &file.name))
}
