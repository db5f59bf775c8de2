//! XML as tokens with places.
//!
//! Everything that XML itself demands is checked here and in [`super::tag`]; nothing of MAVLink is known.

use std::ops::Range;

use quick_xml::events::Event;
use quick_xml::reader::Reader;

use super::characters::{self, is_name, wrong_blank};
use super::fault::{self, Fault, Reason};
use super::range::{first_line, trimmed};
use super::tag;
use crate::diag::{Code, Diagnostic};
use crate::source::{FileId, Span, Spanned};
use crate::syntax::Text;

/// How deep elements may nest; the MAVLink grammar needs six levels.
pub(crate) const MAX_DEPTH: usize = 64;

/// What comes next in a text.
pub(super) enum Token<'t> {
    /// A start tag: its name and the bytes from `<` to `>`. A self-closing tag is followed by its [`Token::Close`].
    Open(&'t str, Range<usize>),
    /// An end tag, and what stood in the element.
    Close(Content),
    /// The end of the text, with every element closed.
    End,
}

/// The character data directly inside an element.
#[derive(Default)]
pub(super) struct Content {
    /// All of it, joined, with references expanded; `None` if there is none.
    pub(super) text: Option<Text>,
    /// The first part that is not blank.
    pub(super) first: Option<Span>,
}

impl Content {
    fn push(&mut self, part: &str, span: Span) {
        if self.first.is_none() && !part.trim().is_empty() {
            self.first = Some(span);
        }
        match &mut self.text {
            Some(text) => {
                text.value.push_str(part);
                text.span.end = span.end;
            }
            None if part.is_empty() => {}
            None => self.text = Some(Spanned::new(part.to_owned(), span)),
        }
    }
}

/// An element that is not closed yet.
struct Open<'t> {
    name: &'t str,
    tag: Span,
    content: Content,
}

/// The tokens of a text.
pub(super) struct Xml<'t> {
    file: FileId,
    text: &'t str,
    reader: Reader<&'t [u8]>,
    open: Vec<Open<'t>>,
    root_seen: bool,
}

impl<'t> Xml<'t> {
    pub(super) fn new(file: FileId, text: &'t str) -> Self {
        let mut reader = Reader::from_str(text);
        let config = reader.config_mut();
        config.expand_empty_elements = true;
        // End tags are compared in `close`, which also knows where the element was opened.
        config.check_end_names = false;
        config.allow_unmatched_ends = true;
        Self { file, text, reader, open: Vec::new(), root_seen: false }
    }

    pub(super) fn text(&self) -> &'t str {
        self.text
    }

    pub(super) fn span(&self, range: Range<usize>) -> Span {
        Span::new(self.file, range)
    }

    /// The next token.
    pub(super) fn next(&mut self) -> Result<Token<'t>, Fault> {
        loop {
            let start = self.position();
            let event = self.reader.read_event();
            let range = start..self.position();
            match event.map_err(|error| self.fault(&error))? {
                Event::Start(tag) | Event::Empty(tag) => {
                    return self.open(tag.name().as_ref().len(), range);
                }
                Event::End(tag) => return self.close(tag.name().as_ref(), range),
                Event::Eof => return self.end(),
                other => self.passive(&other, range)?,
            }
        }
    }

    /// An event that neither opens nor closes an element.
    fn passive(&mut self, event: &Event<'_>, range: Range<usize>) -> Result<(), Fault> {
        match event {
            Event::Text(text) => self.character_data(&text.xml10_content(), range),
            Event::CData(_) if self.open.is_empty() => Err(self.outside(range)),
            Event::CData(data) => self.append(&data.xml10_content(), range),
            Event::GeneralRef(_) if self.open.is_empty() => Err(self.outside(range)),
            Event::GeneralRef(_) => {
                let reference = self.text.get(range.clone()).unwrap_or_default();
                let expanded = characters::expand(reference, self.span(range.clone()))?;
                self.append(&expanded, range)
            }
            Event::Comment(comment) => self.comment(comment, range),
            Event::Decl(_) if range.start > 0 => {
                let message = "an XML declaration stands only at the very start of a file";
                Err(self.not_well_formed(range, message).into())
            }
            Event::Decl(_) => tag::check_declaration((self.file, self.text), range),
            Event::PI(instruction) if !is_name(instruction.target()) => {
                let message = "a processing instruction without a name";
                Err(self.not_well_formed(first_line(self.text, range), message).into())
            }
            Event::DocType(_) => Err(self.refused(range)),
            _ => Ok(()),
        }
    }

    fn position(&self) -> usize {
        usize::try_from(self.reader.buffer_position()).unwrap_or(usize::MAX)
    }

    fn open(&mut self, name: usize, range: Range<usize>) -> Result<Token<'t>, Fault> {
        let name_range = range.start + 1..range.start + 1 + name;
        let name = self.text.get(name_range.clone()).unwrap_or_default();
        let tag = self.span(range.clone());
        if self.open.len() >= MAX_DEPTH {
            let message = format!("elements are nested more than {MAX_DEPTH} deep");
            return Err(Box::new(Diagnostic::new(Code::TooLarge, tag, message)));
        }
        if self.open.is_empty() && self.root_seen {
            let message = format!("a second root element `<{name}>`");
            return Err(self.not_well_formed(range, message).into());
        }
        if !is_name(name) {
            let message = match name {
                "" => "`<` starts no tag".to_owned(),
                _ => format!("`{name}` is not a name of an element"),
            };
            let name_range = range.start..name_range.end;
            let help = if name.starts_with("<<<<<<") {
                "a merge left this marker: choose one of the versions that it separates".to_owned()
            } else {
                wrong_blank(name).unwrap_or_else(|| "write `&lt;` for a plain `<`".to_owned())
            };
            return Err(self.not_well_formed(name_range, message).help(help).into());
        }
        self.root_seen = true;
        self.open.push(Open { name, tag, content: Content::default() });
        Ok(Token::Open(name, range))
    }

    fn close(&mut self, name: &str, range: Range<usize>) -> Result<Token<'t>, Fault> {
        match self.open.pop() {
            Some(open) if open.name == name => Ok(Token::Close(open.content)),
            Some(open) => Err(self.mismatch(&open, name, range)),
            None => {
                let message = format!("`</{name}>` closes nothing");
                Err(self.not_well_formed(range, message).into())
            }
        }
    }

    fn mismatch(&self, open: &Open<'t>, found: &str, range: Range<usize>) -> Fault {
        let parent = self.open.iter().any(|parent| parent.name == found);
        let code = if parent { Code::Unclosed } else { Code::NotWellFormed };
        let message = format!("`</{}>` is expected, `</{found}>` is found", open.name);
        let diagnostic = Diagnostic::new(code, self.span(range), message)
            .label(format!("`</{}>` is expected before this", open.name));
        Box::new(diagnostic.related(open.tag, format!("`<{}>` is opened here", open.name)))
    }

    fn end(&self) -> Result<Token<'t>, Fault> {
        let Some(open) = self.open.last() else { return Ok(Token::End) };
        let end = self.text.trim_end().len();
        let message = format!("the file ends before `</{}>`", open.name);
        let diagnostic = Diagnostic::new(Code::Unclosed, self.span(end..end), message)
            .label("the file ends here")
            .related(open.tag, format!("`<{}>` is opened here", open.name));
        Err(Box::new(diagnostic.help("is the file complete?")))
    }

    fn character_data(&mut self, part: &str, range: Range<usize>) -> Result<(), Fault> {
        let raw = self.text.get(range.clone()).unwrap_or_default();
        if let Some(at) = raw.find("]]>") {
            let at = range.start + at;
            let message = "`]]>` stands outside of a CDATA section";
            return Err(self.not_well_formed(at..at + 3, message).help("write `]]&gt;`").into());
        }
        if self.open.is_empty() && !raw.trim_matches(characters::BLANKS).is_empty() {
            return Err(self.outside(range));
        }
        self.append(part, range)
    }

    fn append(&mut self, part: &str, range: Range<usize>) -> Result<(), Fault> {
        let span = self.span(range);
        if let Some(open) = self.open.last_mut() {
            open.content.push(part, span);
        }
        Ok(())
    }

    fn comment(&self, comment: &str, range: Range<usize>) -> Result<(), Fault> {
        let dashes = comment.find("--").or_else(|| comment.ends_with('-').then(|| comment.len() - 1));
        dashes.map_or(Ok(()), |at| {
            let at = range.start + "<!--".len() + at;
            Err(self.not_well_formed(at..at + 2, "`--` stands inside a comment").into())
        })
    }

    fn outside(&self, range: Range<usize>) -> Fault {
        let range = trimmed(self.text, range);
        let wording = if self.root_seen { "after" } else { "before" };
        let message = format!("text {wording} the root element");
        self.not_well_formed(first_line(self.text, range), message).into()
    }

    fn refused(&self, range: Range<usize>) -> Fault {
        let place = self.span(first_line(self.text, range));
        let message = "a document type declaration is refused";
        let help = "remove it: nothing is validated by it, expanded or fetched";
        Box::new(Diagnostic::new(Code::DocumentType, place, message).help(help))
    }

    /// What quick-xml itself found.
    fn fault(&self, error: &quick_xml::Error) -> Fault {
        let at = usize::try_from(self.reader.error_position()).unwrap_or(usize::MAX);
        let at = at.min(self.text.len());
        let line = first_line(self.text, at..self.text.len());
        match fault::describe(error) {
            Reason::DocumentType => self.refused(line),
            Reason::Reference => {
                let message = "`&` starts a reference that no `;` closes";
                let help = "write `&amp;` for a plain `&`";
                self.not_well_formed(at..at + 1, message).help(help).into()
            }
            Reason::Quote(quote) => tag::runaway((self.file, self.text), at)
                .unwrap_or_else(|| self.unclosed(line, "an attribute value", quote)),
            Reason::Unclosed { what, end } => self.unclosed(line, what, end),
            Reason::Other(message) => self.not_well_formed(line, message).into(),
        }
    }

    fn unclosed(&self, place: Range<usize>, what: &str, end: &str) -> Fault {
        let message = format!("the file ends before {what} is closed by `{end}`");
        let diagnostic = Diagnostic::new(Code::Unclosed, self.span(place), message);
        diagnostic.label("starts here").help("is the file complete?").into()
    }

    fn not_well_formed(&self, range: Range<usize>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(Code::NotWellFormed, self.span(range), message)
    }
}
