//! What neither the wire nor the types show: units, ranges, sentinels, stages of life, parameters of commands.

use super::order::moved;
use super::pairs::{EnumPair, MessagePair, Pairs};
use super::{Change, Kind, enums};
use crate::ir::{
    Command, Dialect, Entry, Field, FileIndex, Invalid, Lifecycle, Limits, Origin, Param, Scalar, Scope, Sentinel,
    Successor,
};

/// The changes of the facts of all items that are in both states.
pub(super) fn changes(old: &Dialect, new: &Dialect, pairs: &Pairs<'_>) -> Vec<Change> {
    let dialects = Dialects { old, new };
    let mut changes = Facts::new(&new.name, None);
    changes.compare("version", Some(old.version), Some(new.version));
    let messages = pairs.messages.both.iter().flat_map(|pair| message(&dialects, pair));
    let enums = pairs.enums.both.iter().flat_map(|pair| enum_(&dialects, pair));
    changes.list.into_iter().chain(messages).chain(enums).collect()
}

struct Dialects<'a> {
    old: &'a Dialect,
    new: &'a Dialect,
}

impl Dialects<'_> {
    fn files(&self, old: FileIndex, new: FileIndex) -> (Option<String>, Option<String>) {
        let name = |dialect: &Dialect, file| dialect.file(file).map(|file| file.name.clone());
        // The dialect's own file may be called differently.
        if old.0 == 0 && new.0 == 0 { (None, None) } else { (name(self.old, old), name(self.new, new)) }
    }
}

/// Collects what differs about one item.
struct Facts {
    item: String,
    origins: Option<(Origin, Origin)>,
    list: Vec<Change>,
}

impl Facts {
    fn new(item: impl Into<String>, origins: Option<(&Origin, &Origin)>) -> Self {
        let origins = origins.map(|(old, new)| (old.clone(), new.clone()));
        Self { item: item.into(), origins, list: Vec::new() }
    }

    fn compare(&mut self, fact: &'static str, old: Option<impl ToString>, new: Option<impl ToString>) {
        let (from, to) = (old.map(|old| old.to_string()), new.map(|new| new.to_string()));
        if from == to {
            return;
        }
        let places = self.origins.as_ref().map(|(old, new)| (old.span, new.span));
        let change = Change::new(Kind::Fact(fact), false, &self.item);
        let change = change.at(places.map(|(old, _)| old), places.map(|(_, new)| new));
        self.list.push(Change { from, to, ..change });
    }

    fn flag(&mut self, fact: &'static str, old: bool, new: bool) {
        self.compare(fact, Some(old), Some(new));
    }

    fn limits(&mut self, old: &Limits, new: &Limits) {
        self.compare("minValue", old.min, new.min);
        self.compare("maxValue", old.max, new.max);
        self.compare("increment", old.increment, new.increment);
    }

    /// The stage of life; of what is deprecated in both states, since when and by what. That something became deprecated is said
    /// of the Rust.
    fn lifecycle(&mut self) {
        let Some((old, new)) = self.origins.clone() else { return };
        let (old, new) = (old.lifecycle, new.lifecycle);
        if matches!(old, Some(Lifecycle::Deprecated(_))) == matches!(new, Some(Lifecycle::Deprecated(_))) {
            self.compare("lifecycle", old.as_ref().map(stage), new.as_ref().map(stage));
        } else {
            self.compare("lifecycle", old.as_ref().and_then(minor_stage), new.as_ref().and_then(minor_stage));
        }
    }
}

/// `superseded since 2015-08 by X`
fn stage(lifecycle: &Lifecycle) -> String {
    let by = |stage: &str, Successor { since, replaced_by, .. }: &Successor| {
        let since = since.as_ref().map_or_else(String::new, |since| format!(" since {since}"));
        let by = replaced_by.as_ref().map_or_else(String::new, |by| format!(" by {by}"));
        format!("{stage}{since}{by}")
    };
    match lifecycle {
        Lifecycle::Wip => "wip".to_owned(),
        Lifecycle::Superseded(successor) => by("superseded", successor),
        Lifecycle::Deprecated(successor) => by("deprecated", successor),
    }
}

/// A stage that Rust does not show.
fn minor_stage(lifecycle: &Lifecycle) -> Option<String> {
    (!matches!(lifecycle, Lifecycle::Deprecated(_))).then(|| stage(lifecycle))
}

fn message(dialects: &Dialects<'_>, pair: &MessagePair<'_>) -> Vec<Change> {
    let MessagePair { old, new, .. } = pair;
    let mut facts = Facts::new(format!("message {}", old.name.text), Some((&old.origin, &new.origin)));
    facts.lifecycle();
    let (from, to) = dialects.files(old.origin.file, new.origin.file);
    facts.compare("file", from, to);
    let mut changes = facts.list;
    for (before, after) in &pair.fields.both {
        changes.extend(field(&format!("field {}.{}", old.name.text, before.name.text), before, after));
    }
    changes.extend(order(pair));
    changes
}

fn field(item: &str, old: &Field, new: &Field) -> Vec<Change> {
    let mut facts = Facts::new(item, Some((&old.origin, &new.origin)));
    let version = |field: &Field| matches!(field.ty.scalar, Scalar::Version(_)).then_some("uint8_t_mavlink_version");
    facts.compare("constant", version(old), version(new));
    facts.compare("units", old.units.as_ref(), new.units.as_ref());
    facts.compare("invalid", old.invalid.as_ref().map(sentinel), new.invalid.as_ref().map(sentinel));
    facts.limits(&old.limits, &new.limits);
    facts.compare("multiplier", old.multiplier.as_ref(), new.multiplier.as_ref());
    facts.compare("default", old.default.as_ref(), new.default.as_ref());
    facts.compare("print_format", old.print_format.as_ref(), new.print_format.as_ref());
    facts.flag("display=\"bitmask\"", old.display_bitmask, new.display_bitmask);
    facts.flag("instance", old.instance, new.instance);
    facts.list
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
    let on_the_wire = |(old, new): &(&Field, &Field)| (old.offset, new.offset);
    let offsets: Vec<_> = pair.fields.both.iter().map(on_the_wire).collect();
    let rank =
        |field: &Field, fields: &[Field]| fields.iter().position(|other| other.name == field.name).unwrap_or_default();
    let mut fields: Vec<_> = pair
        .fields
        .both
        .iter()
        .map(|(old, new)| (rank(old, &pair.old.fields), rank(new, &pair.new.fields), *old, *new))
        .collect();
    fields.sort_by_key(|(old, ..)| *old);
    let mut by_offset = offsets;
    by_offset.sort_unstable();
    if !by_offset.is_sorted_by_key(|(_, new)| *new) {
        return Vec::new();
    }
    let positions: Vec<usize> = fields.iter().map(|(_, new, ..)| *new).collect();
    let moved = moved(&positions).into_iter().filter_map(|at| fields.get(at));
    let change = moved.map(|(from, to, old, new)| {
        let item = format!("field {}.{}", pair.old.name.text, old.name.text);
        let change = Change::new(Kind::Fact("place in the XML"), false, item);
        change.from((from + 1).to_string()).to((to + 1).to_string()).at(Some(old.origin.span), Some(new.origin.span))
    });
    change.collect()
}

fn enum_(dialects: &Dialects<'_>, pair: &EnumPair<'_>) -> Vec<Change> {
    let EnumPair { old, new, entries } = pair;
    let mut facts = Facts::new(format!("enum {}", old.name.text), Some((&old.origin, &new.origin)));
    facts.lifecycle();
    let (from, to) = dialects.files(old.defined_in, new.defined_in);
    facts.compare("file", from, to);
    let mut changes = facts.list;
    for (before, after) in &entries.both {
        changes.extend(entry(dialects, &format!("entry {}", enums::path(old, before)), before, after));
    }
    changes
}

fn entry(dialects: &Dialects<'_>, item: &str, old: &Entry, new: &Entry) -> Vec<Change> {
    let mut facts = Facts::new(item, Some((&old.origin, &new.origin)));
    facts.lifecycle();
    let numbering = |entry: &Entry| if entry.auto { "automatic" } else { "written" };
    facts.compare("value", Some(numbering(old)), Some(numbering(new)));
    let none = Command::default();
    let (before, after) = (old.command.as_ref().unwrap_or(&none), new.command.as_ref().unwrap_or(&none));
    facts.flag("hasLocation", before.has_location, after.has_location);
    facts.flag("isDestination", before.is_destination, after.is_destination);
    facts.flag("missionOnly", before.mission_only, after.mission_only);
    let mut changes = facts.list;
    for index in 1..=7 {
        let find = |command: &'_ Command| command.params.iter().position(|param| param.index == index);
        let (old, new) =
            (find(before).and_then(|at| before.params.get(at)), find(after).and_then(|at| after.params.get(at)));
        changes.extend(param(dialects, &format!("{item} param {index}"), old, new));
    }
    changes
}

fn param(dialects: &Dialects<'_>, item: &str, old: Option<&Param>, new: Option<&Param>) -> Vec<Change> {
    let (Some(before), Some(after)) = (old, new) else {
        let mut facts = Facts::new(item, None);
        facts.compare("param", old.map(|_| "listed"), new.map(|_| "listed"));
        let span = |param: Option<&Param>| param.map(|param| param.origin.span);
        return facts.list.into_iter().map(|change| change.at(span(old), span(new))).collect();
    };
    let mut facts = Facts::new(item, Some((&before.origin, &after.origin)));
    facts.compare("label", before.label.as_ref(), after.label.as_ref());
    facts.compare("units", before.units.as_ref(), after.units.as_ref());
    let name = |dialect: &Dialect, param: &Param| Some(dialect.enum_by_id(param.enum_?)?.name.text.clone());
    facts.compare("enum", name(dialects.old, before), name(dialects.new, after));
    facts.limits(&before.limits, &after.limits);
    facts.compare("default", before.default, after.default);
    facts.flag("reserved", before.reserved, after.reserved);
    facts.list
}
