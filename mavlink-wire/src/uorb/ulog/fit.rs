//! What a log lacks of a topic, and what it has that the topic does not.

use core::fmt::{self, Write};
use core::marker::PhantomData;

use super::Records;
use super::format::{self, FormatField, Formats};
use crate::uorb::{Element, Field, Topic};

/// How the fields of a log fit those of a topic. Displays each that does not, between semicolons; nothing if all do.
pub struct Fit<'a, T> {
    records: Records<'a>,
    format: &'a str,
    topic: PhantomData<T>,
}

impl<'a, T: Topic> Fit<'a, T> {
    pub(super) fn new(records: Records<'a>, format: &'a str) -> Self {
        Self { records, format, topic: PhantomData }
    }

    /// Whether the log has every field of the topic in its own type, and no other.
    #[must_use]
    pub fn is_exact(&self) -> bool {
        struct Nothing;
        impl Write for Nothing {
            fn write_str(&mut self, _: &str) -> fmt::Result {
                Err(fmt::Error)
            }
        }
        write!(Nothing, "{self}").is_ok()
    }
}

impl<T: Topic> fmt::Debug for Fit<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Fit({self})")
    }
}

impl<T: Topic> fmt::Display for Fit<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let find = |name: &str| format::find(&self.records, name);
        let mut report = Report { to: f, begun: false, formats: Formats::new(&find) };
        match report.formats.find(self.format) {
            Some(text) => report.compare(T::NAME, T::FIELDS, text, None),
            None => report.say(None, self.format, false, &"not in this log"),
        }
    }
}

/// The fields that a field is nested in.
struct Path<'p> {
    outer: Option<&'p Self>,
    name: &'p str,
    array: bool,
}

impl fmt::Display for Path<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(outer) = self.outer {
            write!(f, "{outer}.")?;
        }
        write!(f, "{}{}", self.name, if self.array { "[]" } else { "" })
    }
}

struct Report<'r, 'f, 'a, W> {
    to: &'r mut W,
    begun: bool,
    formats: Formats<'f, 'a>,
}

impl<W: Write> Report<'_, '_, '_, W> {
    fn say(&mut self, outer: Option<&Path<'_>>, name: &str, array: bool, what: &dyn fmt::Display) -> fmt::Result {
        let separator = if core::mem::replace(&mut self.begun, true) { "; " } else { "" };
        write!(self.to, "{separator}{}: {what}", Path { outer, name, array })
    }

    fn compare(&mut self, message: &str, topic: &[Field], text: &str, outer: Option<&Path<'_>>) -> fmt::Result {
        for field in topic {
            match format::fields(text).flatten().find(|found| field.is_called(found.name)) {
                Some(found) => self.compare_field(field, &found, outer)?,
                None => self.say(outer, field.name, false, &"not in this log")?,
            }
        }
        for found in format::fields(text) {
            let Some(found) = found else { return self.say(outer, message, false, &"a format that cannot be read") };
            if !found.is_padding() && !topic.iter().any(|field| field.is_called(found.name)) {
                self.say(outer, found.name, false, &format_args!("not in {message}"))?;
            }
        }
        Ok(())
    }

    fn compare_field(&mut self, field: &Field, found: &FormatField<'_>, outer: Option<&Path<'_>>) -> fmt::Result {
        if found.len > field.len {
            return self.say(
                outer,
                field.name,
                true,
                &format_args!("{} elements, of which {} fit", found.len, field.len),
            );
        }
        match (field.element, found.kind()) {
            (Element::Scalar(kind), Some(narrower)) if narrower.widens_to(kind) => Ok(()),
            (Element::Message { name, fields }, None) => match self.formats.find(found.element) {
                Some(text) => {
                    self.compare(name, fields, text, Some(&Path { outer, name: field.name, array: field.array }))
                }
                None => {
                    self.say(outer, field.name, field.array, &format_args!("the log does not define {}", found.element))
                }
            },
            (element, _) => {
                let ours = match element {
                    Element::Scalar(kind) => kind.name(),
                    Element::Message { name, .. } => name,
                };
                self.say(outer, field.name, field.array, &format_args!("{} does not fit into {ours}", found.element))
            }
        }
    }
}
