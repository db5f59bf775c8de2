//! One message as a table: a row for each frame, a column for each value that it can hold.
//!
//! A column is named by the way to its value in JSON, `voltages[0]` or `escs[1].status.rpm`, with the unit behind it in
//! parentheses. What the sender does not know, and what a frame does not have, is empty; a secret key is one column, that
//! says `secret`.

use std::collections::HashMap;

use csv::WriterBuilder;
use mavgen::decode::{Contents, Entry, Node};
use mavgen::ir::{Access, Meaning, Message, Scalar, View};

use super::received::Received;

/// The columns in front of those of the message.
const FRAME: [&str; 4] = ["time", "system", "component", "sequence"];

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
}

impl Columns {
    pub(super) fn of(message: &Message) -> Self {
        let mut columns = Self::default();
        for field in &message.fields {
            let units = if field.values.is_some() { None } else { field.units.as_deref() };
            let secret = message.secret().is_some_and(|secret| secret.offset == field.offset);
            let one = secret || field.ty.scalar == Scalar::Char;
            let length = if one { None } else { field.ty.array.map(|length| length.get()) };
            columns.push(Part::Field, &field.name.text, length, units);
        }
        for binding in &message.bindings {
            columns.push(Part::View, &binding.name.shown(), None, None);
        }
        for view in &message.views {
            columns.view(view);
        }
        columns
    }

    fn view(&mut self, view: &View) {
        match &view.access {
            Access::Once { getter } => self.members(view, &getter.shown()),
            Access::Slots(slots) => {
                for index in 0..slots.length.get() {
                    let slot = format!("{}[{index}]", slots.items);
                    for key in &slots.keys {
                        self.push(Part::View, &format!("{slot}.{}", key.name), None, key.units.as_deref());
                    }
                    self.members(view, &format!("{slot}.status"));
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
            self.push(Part::View, &format!("{prefix}.{}", member.name), count, units);
        }
    }

    /// A column, or one for each of several alike.
    fn push(&mut self, part: Part, name: &str, count: Option<u8>, units: Option<&str>) {
        let names = match count {
            None => vec![name.to_owned()],
            Some(count) => (0..count).map(|index| format!("{name}[{index}]")).collect(),
        };
        self.columns
            .extend(names.into_iter().map(|name| Column { path: (part, name), units: units.map(str::to_owned) }));
    }

    /// The first row.
    pub(super) fn head(&self) -> String {
        let names = self.columns.iter().map(|Column { path: (_, name), units }| match units {
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
        let (frame, time) = (&received.frame, received.time.map(|time| time.to_string()).unwrap_or_default());
        let head =
            [time, frame.system_id().to_string(), frame.component_id().to_string(), frame.sequence().to_string()];
        row(head.into_iter().chain(self.columns.iter().map(|column| cells.remove(&column.path).unwrap_or_default())))
    }
}

/// Puts each value below a node where its column will look for it.
fn fill(cells: &mut HashMap<Path, String>, part: Part, path: String, node: &Node) {
    let text = match node {
        Node::Unknown => return,
        Node::List(nodes) => {
            let nodes = nodes.iter().enumerate();
            return nodes.for_each(|(index, node)| fill(cells, part, format!("{path}[{index}]"), node));
        }
        Node::Record(entries) => {
            return entries
                .iter()
                .for_each(|Entry { name, node, .. }| fill(cells, part, format!("{path}.{name}"), node));
        }
        Node::Secret => "secret".to_owned(),
        Node::Unsigned(value) => value.to_string(),
        Node::Signed(value) => value.to_string(),
        Node::Float(value) => format!("{value:?}"),
        Node::Double(value) => format!("{value:?}"),
        Node::Scaled(ratio) => ratio.to_f64().to_string(),
        Node::Flag(flag) => flag.to_string(),
        Node::Name(name) => name.clone(),
        Node::Text(bytes) => String::from_utf8_lossy(bytes).into_owned(),
    };
    cells.insert((part, path), text);
}

/// A line, with quotes where a cell needs them.
fn row(cells: impl Iterator<Item = String>) -> String {
    let mut writer = WriterBuilder::new().from_writer(Vec::new());
    // Writing into memory cannot fail.
    let _ = writer.write_record(cells.map(String::into_bytes));
    let line = writer.into_inner().unwrap_or_default();
    String::from_utf8_lossy(&line).into_owned()
}
