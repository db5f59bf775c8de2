//! What the comments of `.msg` files say, and what only the generator knows.

use super::{Named, Topics};
use crate::collect::CollectVec as _;
use crate::docs::line;
use crate::internal::Internal;
use crate::lower::docs;
use crate::rust::{Cell, Definition, Docs, Paragraph, Part};
use crate::uorb::model::{Constant, Element};
use crate::uorb::union::{Enum, Field};

/// The topics that carry a message: "topic `esc_status`", "topics `a`, `b`".
pub(super) fn named_topics(topics: &[String]) -> String {
    let names: Vec<String> = topics.iter().map(|topic| format!("`{topic}`")).collect();
    format!("{} {}", if topics.len() == 1 { "topic" } else { "topics" }, names.join(", "))
}

impl<'d> Topics<'d> {
    /// What the file says, what carries it, and where the fields lie.
    pub(super) fn topic_docs(self, message: Named<'d>, definitions: &[Definition<'d>]) -> Result<Docs<'d>, Internal> {
        let version = message.model.version.map(|version| format!(", version {version}")).unwrap_or_default();
        let queue = message.model.queue.map(|queue| format!("; PX4 keeps {queue} of an instance")).unwrap_or_default();
        let facts = format!("`{}`{version}: {}{queue}.", message.model.name, named_topics(&message.model.topics));
        let head = match definitions {
            [_] => "The bytes of a CDR body and of a record in a log:".to_owned(),
            _ => "The bytes of a CDR body by definition, and of a record in a log of the newest:".to_owned(),
        };
        Ok(Docs(vec![
            Paragraph::prose(message.model.text.as_str()),
            Paragraph::line(facts),
            Paragraph::line(head),
            self.layout(message, definitions)?,
        ]))
    }

    /// Where the definitions have the fields.
    fn layout(self, message: Named<'d>, definitions: &[Definition<'d>]) -> Result<Paragraph<'d>, Internal> {
        let fields = &message.model.fields;
        let has_units = fields.iter().any(|field| field.docs.units.is_some());
        let mut head: Vec<&'d str> = match definitions {
            [_] => vec!["CDR"],
            _ => definitions.iter().map(|one| one.name).collect(),
        };
        head.extend(["record", "field", "type"]);
        head.extend(has_units.then_some("units"));
        let record = self.record(message)?;
        let parts = || definitions.iter().map(|one| &one.cdr).chain([&record]);
        let rows = fields.iter().enumerate().map(|(at, field)| {
            let slot = self.slot(message, at)?;
            let place = |part: &Part<'_>| {
                let found = part.fields.iter().find(|one| one.slot.ident == slot.ident);
                Cell::Plain(found.map(|one| one.at.to_string()).unwrap_or_default())
            };
            let mut row: Vec<Cell<'d>> = parts().map(place).collect();
            row.extend([format!("`{}`", field.name), format!("`{}`", self.written(field)?)].map(Cell::Plain));
            let units = || Cell::Plain(field.docs.units.as_deref().map(line).unwrap_or_default());
            row.extend(has_units.then(units));
            Ok(row)
        });
        Ok(Paragraph::Table(head, rows.collect::<Result<_, Internal>>()?))
    }

    /// The type as `.msg` files write it: `uint16[4]`.
    fn written(self, field: &Field) -> Result<String, Internal> {
        let element = match field.element {
            Element::Scalar(scalar) => scalar.name(),
            Element::Message(nested) => &self.message(nested)?.model.name,
        };
        let array = field.array.map(|len| format!("[{len}]")).unwrap_or_default();
        Ok(format!("{element}{array}"))
    }

    /// The comment; then units, range, sentinel, frame, enum, and until when there was such a field.
    pub(super) fn field_docs(self, field: &'d Field) -> Result<Docs<'d>, Internal> {
        let mut sentences = docs::sentence(&facts(field)).into_iter().collect_vec();
        if let (Some(one), None) = (field.enum_, self.union.typed(field)) {
            sentences.push(format!("Its numbers are those of `{}`.", self.enum_type(one)?.ident));
        }
        if let Some(until) = field.until.and_then(|at| self.union.definitions.get(at)) {
            sentences.push(format!("Until `{}`.", until.name));
        }
        let text = comment(&field.docs.lines);
        if text.trim().is_empty() && sentences.is_empty() {
            sentences.push(format!("`{}`, a `{}`.", field.name, self.written(field)?));
        }
        Ok(Docs(vec![Paragraph::said(text, sentences)]))
    }
}

fn facts(field: &Field) -> Vec<String> {
    let units = field.docs.units.as_deref().map(|units| format!("in {}", line(units)));
    let end = |end: &str| Some(line(end)).filter(|end| !end.is_empty());
    let range = field.docs.range.as_ref().and_then(|(low, high)| docs::range(end(low), end(high)));
    let unknown = field.invalid.map(|invalid| docs::not_known(invalid, field.array.is_some()));
    let frame = field.docs.frame.as_deref().map(|frame| format!("in the frame {}", line(frame)));
    [units, range, unknown, frame].into_iter().flatten().collect_vec()
}

/// The lines of a comment, with a full stop at the end.
fn comment(lines: &[String]) -> String {
    let mut text = lines.join("\n").trim_end().to_owned();
    if text.ends_with(|last: char| last.is_alphanumeric() || ")]%".contains(last)) {
        text.push('.');
    }
    text
}

pub(super) fn of_constant<'d>(constant: &Constant) -> Docs<'d> {
    let text = comment(&constant.docs.lines);
    let named = if text.trim().is_empty() { vec![format!("`{}`.", constant.name)] } else { Vec::new() };
    Docs(vec![Paragraph::said(text, named)])
}

pub(super) fn of_enum<'d>(one: &Enum) -> Docs<'d> {
    let (name, kind) = (&one.message, if one.flags { "Flags in a" } else { "Numbers of type" });
    Docs::line(format!("{kind} `{}`: constants of `{name}`.", one.repr.name()))
}

pub(super) fn of_definition<'d>(name: &str, cdr_len: u32, record_len: u32) -> Docs<'d> {
    Docs::line(format!("Definition `{name}`: {cdr_len} bytes as CDR, {record_len} in a log."))
}

pub(super) fn of_same<'d>(name: &str, newer: &str) -> Docs<'d> {
    Docs::line(format!("Definition `{name}`, which is that of `{newer}`."))
}
