//! XML as tokens with places.
//!
//! Everything that XML itself demands is checked here and in [`super::tag`]; nothing of MAVLink is known.

use quick_xml::Error;
use quick_xml::errors::{IllFormedError, SyntaxError};
use quick_xml::events::Event;
use quick_xml::reader::Reader;

use super::characters::{self, is_name, wrong_blank};
use super::fault::{Fault, not_well_formed};
use super::tag;
use crate::diag::{Code, Diagnostic};
use crate::source::{Part, Span, Spanned};
use crate::syntax::Text;

/// How deep elements may nest; the MAVLink grammar needs six levels.
pub(crate) const MAX_DEPTH: usize = 64;

/// What comes next in a text.
pub(super) enum Token<'t> {
    /// A start tag from `<` to `>`, and its name. A self-closing tag is followed by its [`Token::Close`].
    Open(&'t str, Part<'t>),
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
    pub(super) source: Part<'t>,
    reader: Reader<&'t [u8]>,
    open: Vec<Open<'t>>,
    root_seen: bool,
}

impl<'t> Xml<'t> {
    pub(super) fn new(source: Part<'t>) -> Self {
        let mut reader = Reader::from_str(source.text);
        let config = reader.config_mut();
        config.expand_empty_elements = true;
        // End tags are compared in `close`, which also knows where the element was opened.
        config.check_end_names = false;
        config.allow_unmatched_ends = true;
        Self { source, reader, open: Vec::new(), root_seen: false }
    }

    /// The next token.
    pub(super) fn next(&mut self) -> Result<Token<'t>, Fault> {
        loop {
            let start = self.position();
            let event = self.reader.read_event();
            let part = self.source.get(start..self.position());
            match event.map_err(|error| self.fault(&error))? {
                Event::Start(tag) | Event::Empty(tag) => return self.open(tag.name().as_ref().len(), part),
                Event::End(tag) => return self.close(tag.name().as_ref(), part),
                Event::Eof => return self.end(),
                other => self.passive(&other, part)?,
            }
        }
    }

    /// An event that neither opens nor closes an element.
    fn passive(&mut self, event: &Event<'_>, part: Part<'t>) -> Result<(), Fault> {
        match event {
            Event::Text(text) => self.character_data(&text.xml10_content(), part),
            Event::CData(_) | Event::GeneralRef(_) if self.open.is_empty() => Err(self.outside(part)),
            Event::CData(data) => self.append(&data.xml10_content(), part),
            Event::GeneralRef(_) => self.append(&characters::expand(part)?, part),
            Event::Comment(comment) => check_comment(comment, part),
            Event::Decl(_) if part.start > 0 => {
                Err(not_well_formed(part.span(), "an XML declaration stands only at the very start of a file").into())
            }
            Event::Decl(_) => tag::check_declaration(part),
            Event::PI(instruction) if !is_name(instruction.target()) => {
                Err(not_well_formed(part.first_line().span(), "a processing instruction without a name").into())
            }
            Event::DocType(_) => Err(refused(part)),
            _ => Ok(()),
        }
    }

    fn position(&self) -> usize {
        usize::try_from(self.reader.buffer_position()).unwrap_or(usize::MAX)
    }

    fn open(&mut self, name: usize, part: Part<'t>) -> Result<Token<'t>, Fault> {
        let tag = part.span();
        let name = part.get(1..1 + name).text;
        if self.open.len() >= MAX_DEPTH {
            let message = format!("elements are nested more than {MAX_DEPTH} deep");
            return Err(Diagnostic::new(Code::TooLarge, tag, message).into());
        }
        if self.open.is_empty() && self.root_seen {
            return Err(not_well_formed(tag, format!("a second root element `<{name}>`")).into());
        }
        if !is_name(name) {
            let message = match name {
                "" => "`<` starts no tag".to_owned(),
                _ => format!("`{name}` is not a name of an element"),
            };
            let help = if name.starts_with("<<<<<<") {
                "a merge left this marker: choose one of the versions that it separates".to_owned()
            } else {
                wrong_blank(name).unwrap_or_else(|| "write `&lt;` for a plain `<`".to_owned())
            };
            return Err(not_well_formed(part.span_of(0..1 + name.len()), message).help(help).into());
        }
        self.root_seen = true;
        self.open.push(Open { name, tag, content: Content::default() });
        Ok(Token::Open(name, part))
    }

    fn close(&mut self, name: &str, part: Part<'t>) -> Result<Token<'t>, Fault> {
        match self.open.pop() {
            Some(open) if open.name == name => Ok(Token::Close(open.content)),
            Some(open) => Err(self.mismatch(&open, name, part)),
            None => Err(not_well_formed(part.span(), format!("`</{name}>` closes nothing")).into()),
        }
    }

    fn mismatch(&self, open: &Open<'t>, found: &str, part: Part<'t>) -> Fault {
        let parent = self.open.iter().any(|parent| parent.name == found);
        let code = if parent { Code::Unclosed } else { Code::NotWellFormed };
        let message = format!("`</{}>` is expected, `</{found}>` is found", open.name);
        let diagnostic =
            Diagnostic::new(code, part.span(), message).label(format!("`</{}>` is expected before this", open.name));
        diagnostic.related(open.tag, format!("`<{}>` is opened here", open.name)).into()
    }

    fn end(&self) -> Result<Token<'t>, Fault> {
        let Some(open) = self.open.last() else { return Ok(Token::End) };
        let end = self.source.text.trim_end().len();
        let message = format!("the file ends before `</{}>`", open.name);
        let diagnostic = Diagnostic::new(Code::Unclosed, self.source.span_of(end..end), message)
            .label("the file ends here")
            .related(open.tag, format!("`<{}>` is opened here", open.name));
        Err(diagnostic.help("is the file complete?").into())
    }

    fn character_data(&mut self, text: &str, part: Part<'t>) -> Result<(), Fault> {
        if let Some(at) = part.text.find("]]>") {
            let message = "`]]>` stands outside of a CDATA section";
            return Err(not_well_formed(part.span_of(at..at + 3), message).help("write `]]&gt;`").into());
        }
        if self.open.is_empty() && !part.text.trim_matches(characters::BLANKS).is_empty() {
            return Err(self.outside(part));
        }
        self.append(text, part)
    }

    fn append(&mut self, text: &str, part: Part<'t>) -> Result<(), Fault> {
        if let Some(open) = self.open.last_mut() {
            open.content.push(text, part.span());
        }
        Ok(())
    }

    fn outside(&self, part: Part<'t>) -> Fault {
        let wording = if self.root_seen { "after" } else { "before" };
        not_well_formed(part.trimmed().first_line().span(), format!("text {wording} the root element")).into()
    }

    /// What quick-xml itself found.
    fn fault(&self, error: &Error) -> Fault {
        let at = usize::try_from(self.reader.error_position()).unwrap_or(usize::MAX);
        let rest = self.source.after(at.min(self.source.text.len()));
        let unclosed = |what: &str, end: &str| {
            let message = format!("the file ends before {what} is closed by `{end}`");
            let diagnostic = Diagnostic::new(Code::Unclosed, rest.first_line().span(), message);
            diagnostic.label("starts here").help("is the file complete?").into()
        };
        let value = |quote| tag::runaway(rest).unwrap_or_else(|| unclosed("an attribute value", quote));
        let other = |message: String| not_well_formed(rest.first_line().span(), message).into();
        match error {
            Error::Syntax(SyntaxError::InvalidBangMarkup) => {
                other("`<!` starts neither a comment nor a CDATA section".to_owned())
            }
            Error::Syntax(SyntaxError::UnclosedDoctype) | Error::IllFormed(IllFormedError::MissingDoctypeName) => {
                refused(rest)
            }
            Error::Syntax(SyntaxError::UnclosedPI) => unclosed("a processing instruction", "?>"),
            Error::Syntax(SyntaxError::UnclosedXmlDecl) => unclosed("the XML declaration", "?>"),
            Error::Syntax(SyntaxError::UnclosedComment) => unclosed("a comment", "-->"),
            Error::Syntax(SyntaxError::UnclosedCData) => unclosed("a CDATA section", "]]>"),
            Error::Syntax(SyntaxError::UnclosedTag) => unclosed("a tag", ">"),
            Error::Syntax(SyntaxError::UnclosedSingleQuotedAttributeValue) => value("'"),
            Error::Syntax(SyntaxError::UnclosedDoubleQuotedAttributeValue) => value("\""),
            Error::IllFormed(IllFormedError::UnclosedReference) => {
                let diagnostic = not_well_formed(rest.span_of(0..1), "`&` starts a reference that no `;` closes");
                diagnostic.help("write `&amp;` for a plain `&`").into()
            }
            other_error => other(other_error.to_string()),
        }
    }
}

fn check_comment(comment: &str, part: Part<'_>) -> Result<(), Fault> {
    let dashes = comment.find("--").or_else(|| comment.ends_with('-').then(|| comment.len() - 1));
    dashes.map_or(Ok(()), |at| {
        let at = "<!--".len() + at;
        Err(not_well_formed(part.span_of(at..at + 2), "`--` stands inside a comment").into())
    })
}

/// A document type declaration.
fn refused(declaration: Part<'_>) -> Fault {
    let message = "a document type declaration is refused";
    let diagnostic = Diagnostic::new(Code::DocumentType, declaration.first_line().span(), message);
    diagnostic.help("remove it: nothing is validated by it, expanded or fetched").into()
}
