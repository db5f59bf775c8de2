//! One message as a table: a row for each frame, a column for each value that it can hold.
//!
//! A column is named by the way to its value in JSON, `voltages[0]` or `escs[1].status.rpm`, with the unit behind it in
//! parentheses. What the sender does not know, and what a frame does not have, is empty; a secret key is one column, that
//! says `secret`.

use std::collections::HashMap;

use csv::WriterBuilder;
use mavgen::decode::{Contents, Entry, Node, parameter_readings};
use mavgen::ir::{Access, Meaning, Message, Scalar, View};

use super::choice::Choice;
use super::received::Received;
use super::text::plain;

/// The columns in front of those of the message.
const FRAME: [&str; 5] = ["time", "unix_time (s)", "system_id", "component_id", "sequence"];

/// Whether a column is of a field, or of what overlays see in the fields; and the way to its value.
type Path = (Part, String);

/// Names of fields and names of views may be the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Part {
    Field,
    View,
}

/// The columns of a message.
#[derive(Default)]
pub(super) struct Columns {
    columns: Vec<Column>,
}

struct Column {
    path: Path,
    units: Option<String>,
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
            columns.push(Part::Field, ("", &field.name.text), length, units);
        }
        for binding in &message.bindings {
            columns.push(Part::View, ("", &binding.name.shown()), None, None);
        }
        for view in &message.views {
            columns.view(view);
        }
        for reading in parameter_readings(message) {
            columns.push(Part::View, ("parameter.", reading), None, None);
        }
        columns
    }

    fn view(&mut self, view: &View) {
        match &view.access {
            Access::Once { getter } => self.members(view, &format!("{}.", getter.shown())),
            Access::Record(record) => {
                let prefix = format!("{}.", record.getter.shown());
                for value in &record.values {
                    self.push(Part::View, (&prefix, &value.name.to_string()), None, value.units.as_deref());
                }
            }
            Access::Slots(slots) => {
                for index in 0..slots.length.get() {
                    let slot = format!("{}[{index}].", slots.items);
                    for key in &slots.keys {
                        self.push(Part::View, (&slot, &key.name.to_string()), None, key.units.as_deref());
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
            self.push(Part::View, (prefix, &member.name.to_string()), count, units);
        }
    }

    /// A column, or one for each of several alike.
    fn push(&mut self, part: Part, (prefix, name): (&str, &str), count: Option<u8>, units: Option<&str>) {
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

    /// The first row.
    pub(super) fn head(&self) -> String {
        let names = self.columns.iter().map(|Column { path: (_, name), units, .. }| match units {
            Some(units) => format!("{name} ({units})"),
            None => name.clone(),
        });
        row(FRAME.map(str::to_owned).into_iter().chain(names))
    }

    /// The row of a frame.
    pub(super) fn row(&self, received: &Received<'_>, contents: &Contents) -> String {
        let mut cells = HashMap::new();
        for (part, entries) in [(Part::Field, &contents.fields), (Part::View, &contents.views)] {
            for Entry { name, node, .. } in entries {
                fill(&mut cells, part, name.clone(), node);
            }
        }
        let Received { frame, time } = received;
        let unix_time = time.map(|time| time.unix()).unwrap_or_default();
        let time = time.map(|time| time.to_string()).unwrap_or_default();
        let sender = [frame.system_id().to_string(), frame.component_id().to_string(), frame.sequence().to_string()];
        let head = [time, unix_time].into_iter().chain(sender);
        row(head.chain(self.columns.iter().map(|column| cells.remove(&column.path).unwrap_or_default())))
    }
}

/// Whether a file begins as these tables do.
pub(super) fn is_head(line: &str) -> bool {
    let head = row(FRAME.map(str::to_owned).into_iter());
    line.strip_prefix(head.trim_end()).is_some_and(|rest| rest.is_empty() || rest.starts_with([',', '\r', '\n']))
}

/// Puts each value below a node where its column will look for it.
fn fill(cells: &mut HashMap<Path, String>, part: Part, path: String, node: &Node) {
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
            cells.insert((part, path), plain(value));
        }
    }
}

/// A line, with quotes where a cell needs them.
fn row(cells: impl Iterator<Item = String>) -> String {
    let mut writer = WriterBuilder::new().from_writer(Vec::new());
    // Writing into memory cannot fail.
    let _ = writer.write_record(cells.map(String::into_bytes));
    let line = writer.into_inner().unwrap_or_default();
    String::from_utf8_lossy(&line).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_known_by_their_head() {
        let head = row(FRAME.map(str::to_owned).into_iter());
        for line in [&head, "time,unix_time (s),system_id,component_id,sequence,roll\n", head.trim_end()] {
            assert!(is_head(line), "{line}");
        }
        for line in ["", "time,roll", "time,unix_time (s),system_id,component_id,sequences"] {
            assert!(!is_head(line), "{line}");
        }
    }
}
