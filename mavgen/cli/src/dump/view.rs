//! What overlays add to a message: views of packed bits and of values, and enums bound to fields.

use std::ops::RangeInclusive;

use mavgen::ir::{
    Access, Binding, Condition, Dialect, EnumId, FieldIndex, Key, Meaning, Member, Message, Place, Presence, Slots,
    Switch, SwitchOn, View, ViewSentinel, Word,
};
use serde_json::{Value, json};

/// A message's views and bindings: what the two formats share.
pub(super) struct Overlaid<'d> {
    pub(super) dialect: &'d Dialect,
    pub(super) message: &'d Message,
}

impl Overlaid<'_> {
    /// As JSON; fields are spelled as in overlays, `escid[i]`.
    pub(super) fn views_json(&self) -> Vec<Value> {
        self.message.views.iter().map(|view| self.view_json(view)).collect()
    }

    fn view_json(&self, view: &View) -> Value {
        let (getter, slots, values) = match &view.access {
            Access::Once { getter } => (Some(getter.shown()), None, None),
            Access::Slots(slots) => (None, Some(self.slots_json(slots)), None),
            Access::Record(record) => (Some(record.getter.shown()), None, Some(self.keys_json(&record.values))),
        };
        let words: Vec<String> = view.words.iter().map(|word| self.word(*word)).collect();
        let invalid: Vec<Value> = view.invalid.iter().map(|blank| self.blank_json(blank)).collect();
        let members: Vec<Value> = view.members.iter().map(|member| self.member_json(member)).collect();
        json!({
            "name": view.name.text,
            "words": words,
            "width": view.width,
            "getter": getter,
            "slots": slots,
            "values": values,
            "condition": view.condition.as_ref().map(|condition| self.condition_json(condition)),
            "invalid": invalid,
            "switch": view.switch.as_ref().map(|switch| self.switch_json(switch)),
            "members": members,
        })
    }

    fn slots_json(&self, slots: &Slots) -> Value {
        let count = slots.count.map(|count| self.field(count));
        json!({
            "item": slots.item.text, "items": slots.items.shown(), "length": slots.length, "count": count,
            "keys": self.keys_json(&slots.keys),
        })
    }

    fn keys_json(&self, keys: &[Key]) -> Vec<Value> {
        keys.iter().map(|key| self.key_json(key)).collect()
    }

    fn key_json(&self, key: &Key) -> Value {
        let invalid = key.invalid.map(number);
        json!({ "name": key.name.shown(), "field": self.place(key.place), "units": key.units, "invalid": invalid })
    }

    fn condition_json(&self, condition: &Condition) -> Value {
        json!({ "field": self.field(condition.field), "value": condition.value })
    }

    fn blank_json(&self, blank: &ViewSentinel) -> Value {
        match *blank {
            ViewSentinel::Field(place, value) => json!({ "field": self.place(place), "value": number(value) }),
            ViewSentinel::Words(value) => json!({ "field": null, "value": number(value) }),
        }
    }

    fn switch_json(&self, switch: &Switch) -> Value {
        match switch.on {
            SwitchOn::Field(place, _) => {
                json!({ "name": switch.name.shown(), "field": self.place(place), "at": null, "width": null })
            }
            SwitchOn::Bits { at, width } => {
                json!({ "name": switch.name.shown(), "field": null, "at": at, "width": width })
            }
        }
    }

    fn member_json(&self, member: &Member) -> Value {
        let (enum_, units, scaled) = match &member.meaning {
            Meaning::Flag => (None, None, None),
            Meaning::Values(id) => (self.enum_name(*id), None, None),
            Meaning::Number { units } => (None, units.as_deref(), None),
            Meaning::Scaled(scaled) => (None, scaled.units.as_deref(), Some(scaled)),
        };
        let exact = scaled.and_then(|scaled| scaled.exact.as_ref());
        json!({
            "name": member.name.shown(),
            "at": member.at,
            "width": member.width,
            "signed": member.signed,
            "flag": member.meaning == Meaning::Flag,
            "enum": enum_,
            "units": units,
            "scale": scaled.map(|scaled| {
                json!({ "factor": scaled.factor, "bias": scaled.bias, "divisor": scaled.divisor })
            }),
            "exact": exact.map(|exact| {
                json!({ "units": exact.units, "factor": exact.factor, "bias": exact.bias })
            }),
            "repeat": member.repeat.map(|repeat| json!({ "count": repeat.count, "stride": repeat.stride })),
            "when": when(member).map(|ranges| ranges.iter().map(|range| [*range.start(), *range.end()]).collect::<Vec<_>>()),
        })
    }

    pub(super) fn bindings_json(&self) -> Vec<Value> {
        let binding = |binding: &Binding| {
            json!({
                "name": binding.name.shown(),
                "field": self.field(binding.field),
                "enum": self.enum_name(binding.enum_),
                "condition": binding.condition.as_ref().map(|condition| self.condition_json(condition)),
            })
        };
        self.message.bindings.iter().map(binding).collect()
    }

    /// As lines for a person, without what indents them under their message.
    pub(super) fn lines(&self) -> Vec<String> {
        let mut lines: Vec<String> = self.message.bindings.iter().map(|binding| self.binding_line(binding)).collect();
        for view in &self.message.views {
            self.view_lines(&mut lines, view);
        }
        lines
    }

    fn binding_line(&self, binding: &Binding) -> String {
        let Binding { name, field, enum_, condition, .. } = binding;
        let enum_ = self.enum_name(*enum_).unwrap_or_default();
        format!("binding {name}: {} as {enum_}{}", self.field(*field), self.condition(condition.as_ref()))
    }

    fn view_lines(&self, lines: &mut Vec<String>, view: &View) {
        let words: Vec<String> = view.words.iter().map(|word| self.word(*word)).collect();
        let access = match &view.access {
            Access::Once { getter } => getter.shown(),
            Access::Slots(slots) => {
                let count = slots.count.map(|count| format!(", {} of them", self.field(count))).unwrap_or_default();
                format!("{}[{}]{count}", slots.items, slots.length)
            }
            Access::Record(record) => {
                let (name, condition) = (&view.name.text, self.condition(view.condition.as_ref()));
                lines.push(format!("view {name}: values, as {}{condition}", record.getter));
                lines.extend(record.values.iter().map(|value| self.key_line("value", value)));
                return;
            }
        };
        let (name, width, condition) = (&view.name.text, view.width, self.condition(view.condition.as_ref()));
        lines.push(format!("view {name}: {width} bits of {}, as {access}{condition}", words.join(" ")));
        if let Access::Slots(slots) = &view.access {
            lines.extend(slots.keys.iter().map(|key| self.key_line("key", key)));
        }
        lines.extend(view.invalid.iter().map(|blank| match blank {
            ViewSentinel::Field(place, value) => format!("  unknown if {} is {value}", self.place(*place)),
            ViewSentinel::Words(value) => format!("  unknown if the bits are {value:#x}"),
        }));
        lines.extend(view.members.iter().map(|member| self.member_line(view, member)));
    }

    fn key_line(&self, what: &str, key: &Key) -> String {
        let units = key.units.as_ref().map(|units| format!(" {units}")).unwrap_or_default();
        let invalid = key.invalid.map(|value| format!(", unknown if {value}")).unwrap_or_default();
        format!("  {what} {}: {}{units}{invalid}", key.name, self.place(key.place))
    }

    fn member_line(&self, view: &View, member: &Member) -> String {
        let bits = match member.width {
            1 => member.at.to_string(),
            width => format!("{}..={}", member.at, member.at + (width - 1)),
        };
        let repeat =
            member.repeat.map(|repeat| format!("[{}] every {}", repeat.count, repeat.stride)).unwrap_or_default();
        let with_units =
            |text: String, units: Option<&String>| units.map_or(text.clone(), |units| format!("{text} {units}"));
        let meaning = match &member.meaning {
            Meaning::Flag => "yes or no".to_owned(),
            Meaning::Values(id) => self.enum_name(*id).unwrap_or_default().to_owned(),
            Meaning::Number { units } => with_units("raw".to_owned(), units.as_ref()),
            Meaning::Scaled(scaled) => with_units(scaled.to_string(), scaled.units.as_ref()),
        };
        let signed = if member.signed { " signed" } else { "" };
        let when = when(member).zip(view.switch.as_ref()).map(|(ranges, switch)| {
            let ranges: Vec<String> = ranges.iter().map(range).collect();
            format!(", if {} is {}", switch.name, ranges.join(" "))
        });
        format!("  {bits:>8} {}{repeat}: {meaning}{signed}{}", member.name, when.unwrap_or_default())
    }

    fn condition(&self, condition: Option<&Condition>) -> String {
        let Some(condition) = condition else { return String::new() };
        let enum_ = condition.enum_.and_then(|id| self.dialect.enum_by_id(id));
        let entry = enum_.and_then(|enum_| enum_.entries.iter().find(|entry| entry.value == condition.value));
        let value = entry.map_or_else(|| condition.value.to_string(), |entry| entry.name.text.clone());
        format!(", if {} is {value}", self.field(condition.field))
    }

    fn enum_name(&self, id: EnumId) -> Option<&str> {
        self.dialect.enum_by_id(id).map(|enum_| enum_.name.text.as_str())
    }

    fn field(&self, index: FieldIndex) -> &str {
        self.message.fields.get(index.0).map_or("", |field| field.name.text.as_str())
    }

    fn place(&self, place: Place) -> String {
        let name = self.field(place.field);
        if place.element { format!("{name}[i]") } else { name.to_owned() }
    }

    fn word(&self, word: Word) -> String {
        match word {
            Word::One(place) => self.place(place),
            Word::Joined(field) => format!("{}[*]", self.field(field)),
        }
    }
}

fn when(member: &Member) -> Option<&[RangeInclusive<u64>]> {
    match &member.presence {
        Presence::Always => None,
        Presence::When(ranges) => Some(ranges),
    }
}

/// `3..=9`, `30`
fn range(range: &RangeInclusive<u64>) -> String {
    match (range.start(), range.end()) {
        (start, end) if start == end => start.to_string(),
        (start, end) => format!("{start}..={end}"),
    }
}

/// A number, or a text where it is over 64 bits.
fn number<N: Copy + ToString + TryInto<u64> + TryInto<i64>>(value: N) -> Value {
    if let Ok(value) = TryInto::<u64>::try_into(value) {
        return value.into();
    }
    TryInto::<i64>::try_into(value).map_or_else(|_| value.to_string().into(), Value::from)
}
