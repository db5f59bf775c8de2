//! Elements by the rules of a grammar: what is not in it is reported and skipped.

use super::characters::illegal;
use super::encoding;
use super::range::{first_line, trimmed};
use super::tag::{self, Tag};
use super::xml::{Content, Token, Xml};
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::source::{FileId, Span};
use crate::syntax::Text;

/// The text is no XML: it was said, and nothing more can be read.
#[derive(Debug)]
pub(super) struct Broken;

/// What may stand in an element.
pub(super) struct Grammar {
    children: &'static [&'static str],
    prose: bool,
}

impl Grammar {
    /// Elements, and blanks between them.
    pub(super) const fn parts(children: &'static [&'static str]) -> Self {
        Self { children, prose: false }
    }

    /// Text, and elements in it.
    pub(super) const fn prose(children: &'static [&'static str]) -> Self {
        Self { children, prose: true }
    }
}

/// The elements of one text.
pub(super) struct Elements<'t, 'd> {
    file: FileId,
    xml: Xml<'t>,
    diagnostics: &'d mut Diagnostics,
    /// What stood in the element that was closed last.
    closed: Content,
}

/// A token with its attributes read.
enum Step<'t> {
    Child(Tag<'t>),
    Close,
    End,
}

impl<'t, 'd> Elements<'t, 'd> {
    pub(super) fn new(file: FileId, text: &'t str, diagnostics: &'d mut Diagnostics) -> Self {
        Self { file, xml: Xml::new(file, text), diagnostics, closed: Content::default() }
    }

    /// The start tag of the root element.
    pub(super) fn root(&mut self, name: &str) -> Result<Tag<'t>, Broken> {
        if let Some((range, character)) = illegal(self.xml.text()) {
            let code = u32::from(character);
            let message = format!("the character U+{code:04X} is not allowed in XML");
            let fault = Diagnostic::new(Code::NotWellFormed, self.xml.span(range), message);
            return Err(self.broken(fault));
        }
        self.diagnostics.extend(encoding::check(self.file, self.xml.text()));
        match self.step()? {
            Step::Child(tag) if tag.name == name => Ok(tag),
            Step::Child(tag) => {
                let message = format!("the root element is `<{}>`", tag.name);
                let label = format!("`<{name}>` is expected");
                let fault = Diagnostic::new(Code::WrongRoot, tag.span, message).label(label);
                Err(self.broken(fault))
            }
            Step::Close | Step::End => {
                let message = format!("the file has no `<{name}>` element");
                let fault = Diagnostic::new(Code::WrongRoot, self.xml.span(0..0), message);
                Err(self.broken(fault))
            }
        }
    }

    /// Checks that nothing but comments follows the root element.
    pub(super) fn end(&mut self) -> Result<(), Broken> {
        self.step().map(|_| ())
    }

    /// Reports the attributes that were not asked for and those that are missing; whether none is missing.
    pub(super) fn close_tag(&mut self, tag: Tag<'t>) -> bool {
        tag.report(self.diagnostics)
    }

    /// The next element in the one that is open, if it is one that `grammar` has; `None` once it is closed.
    ///
    /// The caller reads the element to its end.
    pub(super) fn next_child(&mut self, grammar: &Grammar) -> Result<Option<Tag<'t>>, Broken> {
        loop {
            let parent = self.xml.inside().unwrap_or_default();
            match self.step()? {
                Step::Child(tag) if grammar.children.contains(&tag.name) => return Ok(Some(tag)),
                Step::Child(tag) => {
                    self.unknown(&tag, parent, grammar);
                    self.skip()?;
                }
                Step::Close | Step::End => {
                    self.stray(parent, grammar);
                    return Ok(None);
                }
            }
        }
    }

    /// Reads to the end of an element that has only text, and elements that do not matter.
    pub(super) fn text(&mut self, grammar: &Grammar) -> Result<Option<Text>, Broken> {
        while self.next_child(grammar)?.is_some() {
            self.skip()?;
        }
        Ok(self.closed.text.take())
    }

    /// Like [`Self::text`], without blanks at both ends; blanks alone are no text.
    pub(super) fn trimmed_text(&mut self) -> Result<Option<Text>, Broken> {
        while self.next_child(&Grammar::prose(&[]))?.is_some() {
            self.skip()?;
        }
        Ok(self.trimmed_content())
    }

    /// The text that stood in the element that was closed last, without blanks at both ends; blanks alone are no text.
    pub(super) fn trimmed_content(&mut self) -> Option<Text> {
        let text = self.closed.text.take().filter(|text| !text.value.trim().is_empty())?;
        let range = trimmed(self.xml.text(), text.span.range());
        Some(Text::new(text.value.trim().to_owned(), self.xml.span(range)))
    }

    /// Reads to the end of the element that is open.
    pub(super) fn skip(&mut self) -> Result<(), Broken> {
        let mut depth = 1_usize;
        while depth > 0 {
            match self.step()? {
                Step::Child(_) => depth += 1,
                Step::Close => depth -= 1,
                Step::End => return Ok(()),
            }
        }
        Ok(())
    }

    /// Reports a fault of the grammar that the caller found. The text is read on.
    pub(super) fn refuse(&mut self, problem: Diagnostic) {
        self.diagnostics.push(problem);
    }

    /// Reports an element that may stand once and stood at `first` already.
    pub(super) fn repeated(&mut self, tag: &Tag<'t>, first: Span) {
        let message = format!("a second `<{}>`", tag.name);
        let error = Diagnostic::new(Code::DuplicateElement, tag.span, message).label("again here");
        self.diagnostics.push(error.related(first, "first here"));
    }

    fn step(&mut self) -> Result<Step<'t>, Broken> {
        match self.xml.next() {
            Ok(Token::Open(name, range)) => {
                let source = (self.file, self.xml.text());
                let tag = tag::read(source, name, range, self.diagnostics);
                tag.map(Step::Child).map_err(|fault| self.broken(*fault))
            }
            Ok(Token::Close(content)) => {
                self.closed = content;
                Ok(Step::Close)
            }
            Ok(Token::End) => Ok(Step::End),
            Err(fault) => Err(self.broken(*fault)),
        }
    }

    /// Reports what ends the reading. Elements that seemed to be in a wrong place are no mistakes if one before them was not
    /// closed.
    fn broken(&mut self, fault: Diagnostic) -> Broken {
        if let (Code::Unclosed, Some(opened)) = (fault.code, fault.related.first()) {
            let (file, start) = (opened.span.file, opened.span.start);
            self.diagnostics.withdraw(|problem| {
                matches!(problem.code, Code::UnknownElement | Code::StrayText)
                    && problem.span.is_some_and(|span| span.file == file && span.start > start)
            });
        }
        self.diagnostics.push(fault);
        Broken
    }

    fn unknown(&mut self, tag: &Tag<'t>, parent: &str, grammar: &Grammar) {
        let message = format!("`<{parent}>` has no element `<{}>`", tag.name);
        let place = self.xml.span(first_line(self.xml.text(), tag.span.range()));
        let warning = Diagnostic::new(Code::UnknownElement, place, message);
        let warning = warning.label("ignored, with all that is in it");
        self.diagnostics.push(match nearest(tag.name, grammar.children.iter().copied()) {
            Some(known) => warning.help(format!("did you mean `<{known}>`?")),
            None if parent == "extensions" => warning.help("write `<extensions/>`, and the extension fields after it"),
            None => warning,
        });
    }

    /// Reports text in the element that was closed last, if it is no place for text.
    fn stray(&mut self, parent: &str, grammar: &Grammar) {
        let Some(first) = self.closed.first.filter(|_| !grammar.prose) else { return };
        let text = self.xml.text();
        let place = self.xml.span(first_line(text, trimmed(text, first.range())));
        let message = format!("text in `<{parent}>`");
        self.diagnostics.push(Diagnostic::new(Code::StrayText, place, message).label("ignored"));
    }
}
