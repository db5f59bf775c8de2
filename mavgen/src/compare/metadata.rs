//! What neither the wire nor the types show: units, ranges, sentinels, stages of life, parameters of commands.

use super::order::moved;
use super::pairs::{EnumPair, MessagePair, Pairs};
use super::{Change, Kind, enums};
use crate::ir::{
    Command, Dialect, Entry, Enum, EnumId, Field, FieldType, FileIndex, Invalid, Lifecycle, Limits, Message, Origin,
    Param, Scalar, Scope, Sentinel,
};

/// The changes of the facts of all items that are in both states.
pub(super) fn changes(old: &Dialect, new: &Dialect, pairs: &Pairs<'_>) -> Vec<Change> {
    let dialects = Dialects { old, new };
    let Dialect { version, name: _, files: _, enums: _, messages: _ } = old;
    let mut changes = Facts::new(&new.name, None);
    changes.compare("version", Some(version), Some(&new.version));
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
        let Limits { min, max, increment } = *old;
        self.compare("minValue", min, new.min);
        self.compare("maxValue", max, new.max);
        self.compare("increment", increment, new.increment);
    }

    /// The stage of life; of what is deprecated in both states, since when and by what. That something became deprecated is said
    /// of the Rust.
    fn lifecycle(&mut self) {
        let Some((old, new)) = self.origins.clone() else { return };
        // The file is compared where it is that of the definition; prose is free to change.
        let Origin { lifecycle: old, file: _, overlays: _, span: _, description: _ } = old;
        let new = new.lifecycle;
        if matches!(old, Some(Lifecycle::Deprecated(_))) == matches!(new, Some(Lifecycle::Deprecated(_))) {
            self.compare("lifecycle", old.as_ref(), new.as_ref());
        } else {
            self.compare("lifecycle", old.as_ref().and_then(minor_stage), new.as_ref().and_then(minor_stage));
        }
    }
}

/// A stage that Rust does not show.
fn minor_stage(lifecycle: &Lifecycle) -> Option<&Lifecycle> {
    Some(lifecycle).filter(|lifecycle| !matches!(lifecycle, Lifecycle::Deprecated(_)))
}

fn message(dialects: &Dialects<'_>, pair: &MessagePair<'_>) -> Vec<Change> {
    let MessagePair { old, new, fields } = pair;
    let Message { name, origin, id: _, crc_extra: _, len_v1: _, len_v2: _, fields: _, views: _, bindings: _ } = old;
    let mut facts = Facts::new(format!("message {}", name.text), Some((origin, &new.origin)));
    facts.lifecycle();
    let (from, to) = dialects.files(origin.file, new.origin.file);
    facts.compare("file", from, to);
    let mut changes = facts.list;
    for (before, after) in &fields.both {
        changes.extend(field(&format!("field {}.{}", name.text, before.name.text), before, after));
    }
    changes.extend(order(pair));
    changes
}

fn field(item: &str, old: &Field, new: &Field) -> Vec<Change> {
    // A new fact of the model has to be compared here, or named as one that the wire or the types show.
    let Field {
        ty,
        units,
        invalid,
        limits,
        multiplier,
        default,
        print_format,
        display_bitmask,
        instance,
        origin,
        name: _,
        offset: _,
        extension: _,
        values: _,
    } = old;
    let mut facts = Facts::new(item, Some((origin, &new.origin)));
    let version = |ty: FieldType| matches!(ty.scalar, Scalar::Version(_)).then_some("uint8_t_mavlink_version");
    facts.compare("constant", version(*ty), version(new.ty));
    facts.compare("units", units.as_ref(), new.units.as_ref());
    facts.compare("invalid", invalid.as_ref().map(sentinel), new.invalid.as_ref().map(sentinel));
    facts.limits(limits, &new.limits);
    facts.compare("multiplier", multiplier.as_ref(), new.multiplier.as_ref());
    facts.compare("default", default.as_ref(), new.default.as_ref());
    facts.compare("print_format", print_format.as_ref(), new.print_format.as_ref());
    facts.flag("display=\"bitmask\"", *display_bitmask, new.display_bitmask);
    facts.flag("instance", *instance, new.instance);
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
    let Enum { name, defined_in, origin, bitmask: _, repr: _, entries: _, named_in: _ } = old;
    let mut facts = Facts::new(format!("enum {}", name.text), Some((origin, &new.origin)));
    facts.lifecycle();
    let (from, to) = dialects.files(*defined_in, new.defined_in);
    facts.compare("file", from, to);
    let mut changes = facts.list;
    for (before, after) in &entries.both {
        changes.extend(entry(dialects, &format!("entry {}", enums::path(old, before)), before, after));
    }
    changes
}

fn entry(dialects: &Dialects<'_>, item: &str, old: &Entry, new: &Entry) -> Vec<Change> {
    let Entry { auto, command, origin, name: _, value: _ } = old;
    let mut facts = Facts::new(item, Some((origin, &new.origin)));
    facts.lifecycle();
    let numbering = |auto| if auto { "automatic" } else { "written" };
    facts.compare("value", Some(numbering(*auto)), Some(numbering(new.auto)));
    let none = Command::default();
    let (before, after) = (command.as_ref().unwrap_or(&none), new.command.as_ref().unwrap_or(&none));
    let Command { params, has_location, is_destination, mission_only } = before;
    facts.flag("hasLocation", *has_location, after.has_location);
    facts.flag("isDestination", *is_destination, after.is_destination);
    facts.flag("missionOnly", *mission_only, after.mission_only);
    let mut changes = facts.list;
    for index in 1..=7 {
        let [old, new] = [params, &after.params].map(|params| params.iter().find(|param| param.index == index));
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
    let Param { label, units, enum_, limits, default, reserved, origin, index: _ } = before;
    let mut facts = Facts::new(item, Some((origin, &after.origin)));
    facts.compare("label", label.as_ref(), after.label.as_ref());
    facts.compare("units", units.as_ref(), after.units.as_ref());
    let name = |dialect: &Dialect, id: Option<EnumId>| Some(dialect.enum_by_id(id?)?.name.text.clone());
    facts.compare("enum", name(dialects.old, *enum_), name(dialects.new, after.enum_));
    facts.limits(limits, &after.limits);
    facts.compare("default", *default, after.default);
    facts.flag("reserved", *reserved, after.reserved);
    facts.list
}
