//! Start tags and their attributes.

use std::ops::Range;

use quick_xml::events::attributes::{AttrError, Attributes};

use super::characters::{self, expand, is_name, wrong_blank};
use super::fault::Fault;
use super::grammar::Element;
use super::schema;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::source::{FileId, Span, Spanned};
use crate::syntax::Text;

/// How many attributes a tag may have; the MAVLink grammar has 13 for a field.
const MAX_ATTRIBUTES: usize = 64;

/// A start tag.
pub(super) struct Tag<'t> {
    pub(super) name: &'t str,
    pub(super) span: Span,
    attributes: Vec<Attribute<'t>>,
    /// The element in the grammar, once it is known where the tag stands.
    pub(super) element: Option<&'static Element>,
    missing: Vec<&'static str>,
}

struct Attribute<'t> {
    name: &'t str,
    name_span: Span,
    value: Text,
}

impl Tag<'_> {
    /// The tag as that of an `element` of the grammar.
    pub(super) fn of(self, element: &'static Element) -> Self {
        Self { element: Some(element), ..self }
    }

    /// What pymavlink's schema refuses of the values of attributes.
    pub(super) fn refused_values(&self) -> impl Iterator<Item = Diagnostic> {
        self.attributes.iter().filter_map(|Attribute { name, value, .. }| {
            let known = self.element?.attribute(name).filter(|known| !known.ty.allows(&value.value))?;
            Some(schema::refused(&format!("`{name}` is"), known.ty, &value.value, value.span))
        })
    }

    /// Attributes of other namespaces, of which pymavlink's schema has none.
    pub(super) fn refused_names(&self) -> impl Iterator<Item = Diagnostic> {
        let foreign = self.attributes.iter().filter(|attribute| is_foreign(attribute.name));
        let foreign = foreign.filter(|attribute| !["xmlns:", "xsi:"].iter().any(|own| attribute.name.starts_with(own)));
        foreign.map(|attribute| {
            let message = format!("the attribute `{}`", attribute.name);
            schema::misplaced(&message, attribute.name_span, "its schema has no namespaces".to_owned())
        })
    }

    /// The value of an optional attribute.
    pub(super) fn take(&mut self, name: &'static str) -> Option<Text> {
        debug_assert!(self.element.is_some_and(|element| element.attribute(name).is_some()), "{name}");
        let at = self.attributes.iter().position(|attribute| attribute.name == name)?;
        Some(self.attributes.remove(at).value)
    }

    /// The value of a required attribute; without one, nothing, and the tag is not complete.
    pub(super) fn require(&mut self, name: &'static str) -> Text {
        self.take(name).unwrap_or_else(|| {
            self.missing.push(name);
            Text::new(String::new(), self.span)
        })
    }

    /// Reports what is missing and what the grammar, which may be that of a dialect, does not have. Returns whether every
    /// required attribute was there.
    pub(super) fn report(self, is_dialect: bool, diagnostics: &mut Diagnostics) -> bool {
        if !self.missing.is_empty() {
            let message = format!("`<{}>` lacks its `{}`", self.name, self.missing.join("` and `"));
            let label = format!("`{}=\"…\"` is required here", self.missing.join("=\"…\" "));
            let error = Diagnostic::new(Code::MissingAttribute, self.span, message);
            diagnostics.push(error.label(label));
        }
        let known = |name: &str| self.element.is_some_and(|element| element.attribute(name).is_some());
        let unknown = self.attributes.iter().filter(|attribute| !known(attribute.name));
        let unknown = unknown.filter(|attribute| !is_foreign(attribute.name));
        diagnostics.extend(unknown.map(|attribute| self.unknown(attribute, is_dialect)));
        self.missing.is_empty()
    }

    /// What is said of an attribute that the grammar does not have.
    fn unknown(&self, attribute: &Attribute<'_>, is_dialect: bool) -> Diagnostic {
        let Attribute { name, name_span, .. } = *attribute;
        let message = format!("`<{}>` has no attribute `{name}`", self.name);
        let all = self.element.map_or(&[][..], |element| element.attributes);
        let meant = nearest(name, all.iter().map(|known| known.name));
        let meant = meant.and_then(|meant| all.iter().find(|known| known.name == meant));
        let problem = match meant {
            Some(meant) if meant.essential => {
                Diagnostic::new(Code::Misspelt, name_span, message).label("would be lost")
            }
            _ => Diagnostic::new(Code::UnknownAttribute, name_span, message).label(if is_dialect {
                "ignored; pymavlink refuses it"
            } else {
                "ignored"
            }),
        };
        match meant {
            Some(meant) => problem.help(format!("did you mean `{}`?", meant.name)),
            None => problem,
        }
    }
}

/// Whether an attribute belongs to another grammar, or to XML itself.
fn is_foreign(name: &str) -> bool {
    name == "xmlns" || name.contains(':')
}

/// The start tag of `name` at the bytes `range` of a text.
pub(super) fn read<'t>(
    (file, text): (FileId, &'t str),
    name: &'t str,
    range: Range<usize>,
    diagnostics: &mut Diagnostics,
) -> Result<Tag<'t>, Fault> {
    let inner = text.get(range.start + 1..range.end.saturating_sub(1)).unwrap_or_default();
    let inner = inner.strip_suffix('/').unwrap_or(inner);
    let source = Source { file, text, name, inner, start: range.start + 1 };
    let attributes = source.attributes(diagnostics)?;
    let span = Span::new(file, range);
    Ok(Tag { name, span, attributes, element: None, missing: Vec::new() })
}

/// Checks the XML declaration at the bytes `range`, which is a tag in all but its ends. Its encoding does not matter: the
/// text was decoded before.
pub(super) fn check_declaration((file, text): (FileId, &str), range: Range<usize>) -> Result<(), Fault> {
    let inner = text.get(range.start + 2..range.end.saturating_sub(2)).unwrap_or_default();
    let source = Source { file, text, name: "xml", inner, start: range.start + 2 };
    let attributes = source.attributes(&mut Diagnostics::default())?;
    let names = attributes.iter().map(|attribute| attribute.name).collect_vec();
    match names[..] {
        ["version"] | ["version", "encoding" | "standalone"] | ["version", "encoding", "standalone"] => Ok(()),
        _ => {
            let message = "an XML declaration has a `version` and then perhaps an `encoding`";
            Err(source.wrong(Code::NotWellFormed, range, message).into())
        }
    }
}

/// Why the tag at `start` runs to the end of the text: the first quote that was not meant to open a value, if the text
/// does not just end.
pub(super) fn runaway((file, text): (FileId, &str), start: usize) -> Option<Fault> {
    let inner = text.get(start + 1..)?;
    let name = inner.split(characters::BLANKS).next()?;
    let source = Source { file, text, name, inner, start: start + 1 };
    let fault = source.attributes(&mut Diagnostics::default()).err()?;
    (fault.code != Code::Unclosed).then_some(fault)
}

/// The text of a start tag.
struct Source<'t> {
    file: FileId,
    text: &'t str,
    name: &'t str,
    /// What stands between `<` and `>` or `/>`.
    inner: &'t str,
    /// Where `inner` starts in `text`.
    start: usize,
}

impl<'t> Source<'t> {
    fn attributes(&self, diagnostics: &mut Diagnostics) -> Result<Vec<Attribute<'t>>, Fault> {
        let mut attributes: Vec<Attribute<'t>> = Vec::new();
        let mut iterator = Attributes::new(self.inner, self.name.len());
        let mut end = self.start + self.name.len();
        for next in iterator.with_checks(false) {
            self.check_start(end)?;
            let attribute = match next {
                Ok(found) => self.attribute(found.key.0, &found.value)?,
                Err(error) => return Err(self.fault(&error, end)),
            };
            end = attribute.value.span.range().end + 1;
            match attributes.iter().find(|before| before.name == attribute.name) {
                Some(first) => diagnostics.push(self.duplicate(first, &attribute)),
                None => attributes.push(attribute),
            }
            if attributes.len() > MAX_ATTRIBUTES {
                let message = format!("`<{}>` has more than {MAX_ATTRIBUTES} attributes", self.name);
                return Err(self.wrong(Code::TooLarge, self.start..end, message).into());
            }
        }
        Ok(attributes)
    }

    /// Checks what stands after the attribute or name that ended at `end`.
    fn check_start(&self, end: usize) -> Result<(), Fault> {
        let rest = self.text.get(end..).unwrap_or_default();
        let start = end + (rest.len() - rest.trim_start().len());
        if rest.trim_start().starts_with('<') {
            let message = format!("the tag `<{}` is not closed by `>`", self.name);
            let diagnostic = self.wrong(Code::NotWellFormed, start..start + 1, message);
            let opened = Span::new(self.file, self.start - 1..self.start + self.name.len());
            let diagnostic = diagnostic.related(opened, "the tag starts here");
            return Err(diagnostic.label("`>` is expected before this").into());
        }
        if start == end {
            let message = "no blank between two attributes";
            let next = rest.chars().next().map_or(0, char::len_utf8);
            let diagnostic = self.wrong(Code::NotWellFormed, start..start + next, message);
            return Err(diagnostic.help("is there a quote too many, or one missing, before this?").into());
        }
        Ok(())
    }

    fn attribute(&self, name: &'t str, raw: &str) -> Result<Attribute<'t>, Fault> {
        let at = self.offset_of(name);
        let name_range = at..at + name.len();
        if !is_name(name) {
            let message = format!("`{name}` is not a name of an attribute");
            let diagnostic = self.wrong(Code::NotWellFormed, name_range, message);
            return Err(match wrong_blank(name) {
                Some(help) => diagnostic.help(help),
                None => diagnostic,
            }
            .into());
        }
        let start = self.offset_of(raw);
        if let Some(bracket) = raw.find('<') {
            let at = start + bracket;
            let message = format!("`<` stands in the value of `{name}`");
            let diagnostic = self.wrong(Code::NotWellFormed, at..at + 1, message);
            let span = Span::new(self.file, name_range);
            let help = "write `&lt;`, or close the quote before";
            return Err(diagnostic.related(span, "the value starts here").help(help).into());
        }
        let value = Spanned::new(self.value(raw, start)?, Span::new(self.file, start..start + raw.len()));
        Ok(Attribute { name, name_span: Span::new(self.file, name_range), value })
    }

    /// An attribute value as XML normalises it: references expanded, and every other blank a space.
    fn value(&self, raw: &str, start: usize) -> Result<String, Fault> {
        if !raw.contains(['&', '\t', '\r', '\n']) {
            return Ok(raw.to_owned());
        }
        let mut value = String::with_capacity(raw.len());
        let mut rest = raw;
        while let Some((before, from)) = rest.find('&').and_then(|at| rest.split_at_checked(at)) {
            let at = start + (raw.len() - from.len());
            let end = from.find(';').map_or(1, |end| end + 1);
            let (reference, after) = from.split_at_checked(end).unwrap_or((from, ""));
            value.push_str(&spaces(before));
            value.push_str(&expand(reference, Span::new(self.file, at..at + end))?);
            rest = after;
        }
        value.push_str(&spaces(rest));
        Ok(value)
    }

    /// Where a part of the tag stands in the text. Parts borrow from the text, so this is the distance of two addresses.
    fn offset_of(&self, part: &str) -> usize {
        self.start + (part.as_ptr() as usize).wrapping_sub(self.inner.as_ptr() as usize)
    }

    /// What quick-xml does not take for an attribute, after the byte `end`.
    fn fault(&self, error: &AttrError, end: usize) -> Fault {
        let word = self.word(end);
        let name = self.text.get(word.clone()).unwrap_or_default();
        let (code, range, message) = match *error {
            AttrError::UnquotedValue(at) => {
                let message = format!("the value of `{name}` is not in quotes");
                (Code::NotWellFormed, self.word(self.start + at), message)
            }
            AttrError::ExpectedQuote(..) => {
                (Code::Unclosed, word, format!("the value of `{name}` is not closed by its quote"))
            }
            _ if name.is_empty() => {
                let range = word.start..word.start + 1;
                return self.wrong(Code::NotWellFormed, range, "an attribute without a name").into();
            }
            _ => (Code::NotWellFormed, word, format!("`{name}` has no value")),
        };
        self.wrong(code, range, message).help(format!("write `{name}=\"…\"`")).into()
    }

    /// The first word after the byte `end`.
    fn word(&self, end: usize) -> Range<usize> {
        let rest = self.text.get(end..).unwrap_or_default();
        let start = end + (rest.len() - rest.trim_start().len());
        let word = rest.trim_start().split(['=', ' ', '\t', '\r', '\n', '>']).next();
        start..start + word.map_or(0, str::len)
    }

    fn duplicate(&self, first: &Attribute<'_>, second: &Attribute<'_>) -> Diagnostic {
        let message = format!("`{}` stands twice in `<{}>`", second.name, self.name);
        Diagnostic::new(Code::DuplicateAttribute, second.name_span, message)
            .label("again here")
            .related(first.name_span, "first here")
    }

    fn wrong(&self, code: Code, range: Range<usize>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(code, Span::new(self.file, range), message)
    }
}

/// Line ends and tabs as spaces, a CRLF as one.
fn spaces(text: &str) -> String {
    text.replace("\r\n", " ").replace(['\r', '\n', '\t'], " ")
}
