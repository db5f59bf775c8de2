//! Start tags: from their text to their attributes, and what is said of these.

use quick_xml::events::attributes::{AttrError, Attributes};

use super::characters::{self, expand, is_name, wrong_blank};
use super::fault::{Fault, not_well_formed};
use super::grammar::Element;
use super::schema;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::source::{Part, Span, Spanned};
use crate::syntax::{Tag, Type, Written};

/// How many attributes a tag may have; the MAVLink grammar has 13 for a field.
const MAX_ATTRIBUTES: usize = 64;

/// Reads the start tag of `name`.
pub(super) fn read<'t>(name: &'t str, tag: Part<'t>, diagnostics: &mut Diagnostics) -> Result<Tag<'t>, Fault> {
    let inner = tag.get(1..tag.text.len().saturating_sub(1));
    let inner = inner.with(inner.text.strip_suffix('/').unwrap_or(inner.text));
    let attributes = Source { name, inner, rest: tag.after(1) }.attributes(diagnostics)?;
    Ok(Tag { name, span: tag.span(), attributes, missing: Vec::new() })
}

/// Checks the XML declaration, which is a tag in all but its ends. Its encoding does not matter: the text was decoded before.
pub(super) fn check_declaration(declaration: Part<'_>) -> Result<(), Fault> {
    let inner = declaration.get(2..declaration.text.len().saturating_sub(2));
    let source = Source { name: "xml", inner, rest: declaration.after(2) };
    let attributes = source.attributes(&mut Diagnostics::default())?;
    let names = attributes.iter().map(|attribute| attribute.name).collect_vec();
    match names[..] {
        ["version"] | ["version", "encoding" | "standalone"] | ["version", "encoding", "standalone"] => Ok(()),
        _ => {
            let message = "an XML declaration has a `version` and then perhaps an `encoding`";
            Err(not_well_formed(declaration.span(), message).into())
        }
    }
}

/// Why the tag that the text begins with runs to its end: the first quote that was not meant to open a value, if the text does
/// not just end.
pub(super) fn runaway(text: Part<'_>) -> Option<Fault> {
    let inner = text.after(1);
    let name = inner.text.split(characters::BLANKS).next()?;
    let fault = Source { name, inner, rest: inner }.attributes(&mut Diagnostics::default()).err()?;
    (fault.code != Code::Unclosed).then_some(fault)
}

/// The text of a start tag.
struct Source<'t> {
    name: &'t str,
    /// What stands between `<` and `>` or `/>`.
    inner: Part<'t>,
    /// The same, and what follows it.
    rest: Part<'t>,
}

impl<'t> Source<'t> {
    fn attributes(&self, diagnostics: &mut Diagnostics) -> Result<Vec<Written<'t>>, Fault> {
        let mut attributes: Vec<Written<'t>> = Vec::new();
        let mut iterator = Attributes::new(self.inner.text, self.name.len());
        let mut end = self.name.len();
        for next in iterator.with_checks(false) {
            self.check_start(self.rest.after(end))?;
            let attribute = match next {
                Ok(found) => attribute(self.inner.with(found.key.0), self.inner.with(&found.value))?,
                Err(error) => return Err(self.fault(&error, end)),
            };
            end = attribute.value.span.range().end + 1 - self.inner.start;
            match attributes.iter().find(|before| before.name == attribute.name) {
                Some(first) => diagnostics.push(self.duplicate(first, &attribute)),
                None => attributes.push(attribute),
            }
            if attributes.len() > MAX_ATTRIBUTES {
                let message = format!("`<{}>` has more than {MAX_ATTRIBUTES} attributes", self.name);
                return Err(Diagnostic::new(Code::TooLarge, self.rest.span_of(0..end), message).into());
            }
        }
        Ok(attributes)
    }

    /// Checks what stands after an attribute, or after the name.
    fn check_start(&self, rest: Part<'t>) -> Result<(), Fault> {
        let next = rest.trimmed();
        if next.text.starts_with('<') {
            let diagnostic =
                not_well_formed(next.span_of(0..1), format!("the tag `<{}` is not closed by `>`", self.name));
            let name = self.inner.span_of(0..self.name.len());
            let opened = Span { start: name.start.saturating_sub(1), ..name };
            let diagnostic = diagnostic.related(opened, "the tag starts here");
            return Err(diagnostic.label("`>` is expected before this").into());
        }
        if next.start == rest.start {
            let next = next.text.chars().next().map_or(0, char::len_utf8);
            let diagnostic = not_well_formed(rest.span_of(0..next), "no blank between two attributes");
            return Err(diagnostic.help("is there a quote too many, or one missing, before this?").into());
        }
        Ok(())
    }

    /// What quick-xml does not take for an attribute, after this many bytes.
    fn fault(&self, error: &AttrError, end: usize) -> Fault {
        let word = first_word(self.rest.after(end));
        let name = word.text;
        let (code, place, message) = match *error {
            AttrError::UnquotedValue(at) => {
                let value = first_word(self.rest.after(at));
                (Code::NotWellFormed, value.span(), format!("the value of `{name}` is not in quotes"))
            }
            AttrError::ExpectedQuote(..) => {
                (Code::Unclosed, word.span(), format!("the value of `{name}` is not closed by its quote"))
            }
            _ if name.is_empty() => return not_well_formed(word.span_of(0..1), "an attribute without a name").into(),
            _ => (Code::NotWellFormed, word.span(), format!("`{name}` has no value")),
        };
        Diagnostic::new(code, place, message).help(format!("write `{name}=\"…\"`")).into()
    }

    fn duplicate(&self, first: &Written<'_>, second: &Written<'_>) -> Diagnostic {
        let message = format!("`{}` stands twice in `<{}>`", second.name, self.name);
        Diagnostic::new(Code::DuplicateAttribute, second.name_span, message)
            .label("again here")
            .related(first.name_span, "first here")
    }
}

fn attribute<'t>(name: Part<'t>, raw: Part<'_>) -> Result<Written<'t>, Fault> {
    let (name, name_span) = (name.text, name.span());
    if !is_name(name) {
        let diagnostic = not_well_formed(name_span, format!("`{name}` is not a name of an attribute"));
        return Err(Diagnostic { help: wrong_blank(name), ..diagnostic }.into());
    }
    if let Some(at) = raw.text.find('<') {
        let diagnostic = not_well_formed(raw.span_of(at..at + 1), format!("`<` stands in the value of `{name}`"));
        let help = "write `&lt;`, or close the quote before";
        return Err(diagnostic.related(name_span, "the value starts here").help(help).into());
    }
    Ok(Written { name, name_span, value: Spanned::new(value(raw)?, raw.span()) })
}

/// An attribute value as XML normalises it: references expanded, and every other blank a space.
fn value(raw: Part<'_>) -> Result<String, Fault> {
    if !raw.text.contains(['&', '\t', '\r', '\n']) {
        return Ok(raw.text.to_owned());
    }
    let mut value = String::with_capacity(raw.text.len());
    let mut rest = raw.text;
    while let Some((before, from)) = rest.find('&').and_then(|at| rest.split_at_checked(at)) {
        let end = from.find(';').map_or(1, |end| end + 1);
        let (reference, after) = from.split_at_checked(end).unwrap_or((from, ""));
        value.push_str(&spaces(before));
        value.push_str(&expand(raw.with(reference))?);
        rest = after;
    }
    value.push_str(&spaces(rest));
    Ok(value)
}

/// The first word of a text, which may be an attribute's name.
fn first_word(text: Part<'_>) -> Part<'_> {
    let text = text.with(text.text.trim_start());
    text.with(text.text.split(['=', ' ', '\t', '\r', '\n', '>']).next().unwrap_or(text.text))
}

/// Line ends and tabs as spaces, a CRLF as one.
fn spaces(text: &str) -> String {
    text.replace("\r\n", " ").replace(['\r', '\n', '\t'], " ")
}

/// Reports the attributes of a tag that nobody took, those that are missing, and those that pymavlink's schema does not have.
pub(super) fn report(tag: &Tag<'_>, element: &Element, is_dialect: bool, diagnostics: &mut Diagnostics) {
    if is_dialect {
        diagnostics.extend(tag.attributes.iter().filter_map(foreign));
    }
    if !tag.missing.is_empty() {
        let message = format!("`<{}>` lacks its `{}`", tag.name, tag.missing.join("` and `"));
        let label = format!("`{}=\"…\"` is required here", tag.missing.join("=\"…\" "));
        diagnostics.push(Diagnostic::new(Code::MissingAttribute, tag.span, message).label(label));
    }
    let is_known = |name: &str| is_foreign(name) || element.attribute(name).is_some();
    let unread = tag.attributes.iter().filter(|attribute| !is_known(attribute.name));
    diagnostics.extend(unread.map(|attribute| unknown(element, attribute, is_dialect)));
}

/// Whether an attribute belongs to another grammar, or to XML itself.
fn is_foreign(name: &str) -> bool {
    name == "xmlns" || name.contains(':')
}

/// An attribute of another namespace, of which pymavlink's schema has none.
fn foreign(attribute: &Written<'_>) -> Option<Diagnostic> {
    let name = attribute.name;
    let is_known = !is_foreign(name) || name.starts_with("xmlns:") || name.starts_with("xsi:");
    let help = "its schema has no namespaces".to_owned();
    (!is_known).then(|| schema::misplaced(&format!("the attribute `{name}`"), attribute.name_span, help))
}

/// What pymavlink's schema refuses of the value of an attribute.
pub(super) fn refused(element: &Element, Written { name, value, .. }: &Written<'_>) -> Option<Diagnostic> {
    schema::refused(&format!("`{name}` is"), element.attribute(name)?.ty, &value.value, value.span)
}

/// What is said of an attribute that the grammar does not have.
fn unknown(element: &Element, attribute: &Written<'_>, is_dialect: bool) -> Diagnostic {
    let meant = nearest(attribute.name, element.attributes.iter().map(|known| known.name));
    // Only the value of an entry: lost, it changes the wire.
    let is_essential = meant.and_then(|name| element.attribute(name)).is_some_and(|known| known.ty == Type::Number);
    let (code, label) = match is_essential {
        true => (Code::Misspelt, "would be lost"),
        false if is_dialect => (Code::UnknownAttribute, "ignored; pymavlink refuses it"),
        false => (Code::UnknownAttribute, "ignored"),
    };
    let message = format!("`<{}>` has no attribute `{}`", element.name, attribute.name);
    Diagnostic::new(code, attribute.name_span, message).label(label).meant(meant)
}
