//! The columns of a message: one for each value that it can hold.
//!
//! A column is named by the way to its value in JSON, `voltages[0]` or `escs[1].status.rpm`.

use std::collections::HashMap;

use mavgen::decode::{Contents, Entry, Node, parameter_readings};
use mavgen::ir::{Access, Field, Key, Meaning, Member, Message, Scalar, View};

use super::choice::Choice;

/// Whether a column is of a field, or of what overlays see in the fields; and the way to its value.
pub(super) type Path = (Part, String);

/// Names of fields and names of views may be the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Part {
    Field,
    View,
}

/// What the values of a column are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A whole number of so many bits.
    Integer {
        bits: i8,
        signed: bool,
    },
    Float,
    Double,
    Flag,
    /// Names of enums and flags, text.
    Text,
}

/// The columns of a message.
#[derive(Default)]
pub(super) struct Columns {
    pub(super) columns: Vec<Column>,
}

pub(super) struct Column {
    pub(super) path: Path,
    pub(super) units: Option<String>,
    #[cfg_attr(not(feature = "parquet"), expect(dead_code, reason = "text has no types"))]
    pub(super) kind: Kind,
    /// The path without indices.
    name: String,
}

impl Columns {
    pub(super) fn of(message: &Message) -> Self {
        let mut columns = Self::default();
        for field in &message.fields {
            let units = if field.values.is_some() { None } else { field.units.as_deref() };
            let secret = message.secret().is_some_and(|secret| secret.offset == field.offset);
            let one = secret || field.ty.scalar == Scalar::Char;
            let length = if one { None } else { field.ty.array.map(|length| length.get()) };
            let kind = if one { Kind::Text } else { Kind::of_field(field) };
            columns.push(Part::Field, ("", &field.name.text), length, (units, kind));
        }
        for binding in &message.bindings {
            columns.push(Part::View, ("", &binding.name.shown()), None, (None, Kind::Text));
        }
        for view in &message.views {
            columns.view(view, message);
        }
        for reading in parameter_readings(message) {
            columns.push(Part::View, ("parameter.", reading), None, (None, Kind::Double));
        }
        columns
    }

    fn view(&mut self, view: &View, message: &Message) {
        match &view.access {
            Access::Once { getter } => self.members(view, &format!("{}.", getter.shown())),
            Access::Record(record) => {
                let prefix = format!("{}.", record.getter.shown());
                for value in &record.values {
                    let kind = Kind::of_key(value, message);
                    self.push(Part::View, (&prefix, &value.name.to_string()), None, (value.units.as_deref(), kind));
                }
            }
            Access::Slots(slots) => {
                for index in 0..slots.length.get() {
                    let slot = format!("{}[{index}].", slots.items);
                    for key in &slots.keys {
                        let kind = Kind::of_key(key, message);
                        self.push(Part::View, (&slot, &key.name.to_string()), None, (key.units.as_deref(), kind));
                    }
                    self.members(view, &format!("{slot}status."));
                }
            }
        }
    }

    fn members(&mut self, view: &View, prefix: &str) {
        for member in &view.members {
            let units = match &member.meaning {
                Meaning::Number { units } => units.as_deref(),
                Meaning::Scaled(scaled) => scaled.units.as_deref(),
                Meaning::Flag | Meaning::Values(_) => None,
            };
            let count = member.repeat.map(|repeat| repeat.count);
            self.push(Part::View, (prefix, &member.name.to_string()), count, (units, Kind::of_member(member)));
        }
    }

    /// A column, or one for each of several alike.
    fn push(
        &mut self,
        part: Part,
        (prefix, name): (&str, &str),
        count: Option<u8>,
        (units, kind): (Option<&str>, Kind),
    ) {
        let paths = match count {
            None => vec![format!("{prefix}{name}")],
            Some(count) => (0..count).map(|index| format!("{prefix}{name}[{index}]")).collect(),
        };
        let slots = prefix.find('[').zip(prefix.find(']').and_then(|end| prefix.get(end + 1..)));
        let prefix =
            slots.map_or(prefix.to_owned(), |(start, rest)| prefix.get(..start).unwrap_or_default().to_owned() + rest);
        self.columns.extend(paths.into_iter().map(|path| Column {
            path: (part, path),
            units: units.map(str::to_owned),
            kind,
            name: format!("{prefix}{name}"),
        }));
    }

    /// The paths of fields, and those of what overlays see in them, without indices.
    pub(super) fn names(&self) -> (Vec<String>, Vec<String>) {
        let of = |part: Part| {
            self.columns.iter().filter(move |column| column.path.0 == part).map(|column| column.name.clone()).collect()
        };
        (of(Part::Field), of(Part::View))
    }

    /// Those that are printed.
    pub(super) fn chosen(mut self, choice: &Choice) -> Self {
        self.columns.retain(|column| choice.keeps(&column.name, column.path.0 == Part::View));
        self
    }

    pub(super) fn is_empty(&self) -> bool {
        self.columns.is_empty()
    }
}

/// The values of a message by the ways to them. What the sender does not know, and what the message does not have, is not there.
pub(super) fn cells(contents: &Contents) -> HashMap<Path, &Node> {
    let mut cells = HashMap::new();
    for (part, entries) in [(Part::Field, &contents.fields), (Part::View, &contents.views)] {
        for Entry { name, node, .. } in entries {
            fill(&mut cells, part, name.clone(), node);
        }
    }
    cells
}

/// Puts each value below a node where its column will look for it.
fn fill<'n>(cells: &mut HashMap<Path, &'n Node>, part: Part, path: String, node: &'n Node) {
    match node {
        Node::Unknown => {}
        Node::List(nodes) => {
            let nodes = nodes.iter().enumerate();
            nodes.for_each(|(index, node)| fill(cells, part, format!("{path}[{index}]"), node));
        }
        Node::Record(entries) => {
            entries.iter().for_each(|Entry { name, node, .. }| fill(cells, part, format!("{path}.{name}"), node));
        }
        value => {
            cells.insert((part, path), value);
        }
    }
}

impl Kind {
    fn of_field(field: &Field) -> Self {
        if field.values.is_some() {
            return Self::Text;
        }
        let integer = |bits, signed| Self::Integer { bits, signed };
        match field.ty.scalar {
            Scalar::Char => Self::Text,
            Scalar::U8 | Scalar::Version(_) => integer(8, false),
            Scalar::I8 => integer(8, true),
            Scalar::U16 => integer(16, false),
            Scalar::I16 => integer(16, true),
            Scalar::U32 => integer(32, false),
            Scalar::I32 => integer(32, true),
            Scalar::U64 => integer(64, false),
            Scalar::I64 => integer(64, true),
            Scalar::F32 => Self::Float,
            Scalar::F64 => Self::Double,
        }
    }

    fn of_key(key: &Key, message: &Message) -> Self {
        message.fields.get(key.place.field.0).map_or(Self::Text, Self::of_field)
    }

    fn of_member(member: &Member) -> Self {
        match member.meaning {
            Meaning::Flag => Self::Flag,
            Meaning::Values(_) => Self::Text,
            Meaning::Scaled(_) => Self::Double,
            Meaning::Number { .. } => match member.width {
                // No table has wider integers.
                65.. => Self::Text,
                width => Self::Integer { bits: width.next_power_of_two().max(8) as i8, signed: member.signed },
            },
        }
    }
}
