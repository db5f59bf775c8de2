//! Elements by the rules of a grammar: what is not in it is reported and skipped.

use super::characters::illegal;
use super::encoding;
use super::grammar::{self, Child, Element, TextKind, Times};
use super::range::{first_line, trimmed};
use super::schema;
use super::tag::{self, Tag};
use super::xml::{Content, Token, Xml};
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::source::{FileId, Span};
use crate::syntax::Text;

/// The text is no XML: it was said, and nothing more can be read.
#[derive(Debug)]
pub(super) struct Broken;

/// The elements of one text.
pub(super) struct Elements<'t, 'd> {
    file: FileId,
    xml: Xml<'t>,
    diagnostics: &'d mut Diagnostics,
    /// What stood in the element that was closed last.
    closed: Content,
    /// Whether pymavlink reads the file, so that what it refuses is worth a word.
    is_dialect: bool,
    /// For each element that is open, from the root: what has stood in it so far.
    inside: Vec<Progress>,
    /// That of the element that was closed last.
    left: Option<Progress>,
}

/// What has stood in an element so far.
struct Progress {
    /// The start tag of the element.
    tag: Span,
    /// The child of the highest place: none of a lower one may follow.
    furthest: Option<&'static Child>,
    /// The children that were there.
    seen: Vec<&'static str>,
}

/// A token with its attributes read.
enum Step<'t> {
    Child(Tag<'t>),
    Close,
    End,
}

impl<'t, 'd> Elements<'t, 'd> {
    pub(super) fn new(file: FileId, text: &'t str, diagnostics: &'d mut Diagnostics) -> Self {
        let (closed, inside) = (Content::default(), Vec::new());
        Self { file, xml: Xml::new(file, text), diagnostics, closed, is_dialect: false, inside, left: None }
    }

    /// The start tag of the root element.
    pub(super) fn root(&mut self, element: &'static Element) -> Result<Tag<'t>, Broken> {
        let name = element.name;
        if let Some((range, character)) = illegal(self.xml.text()) {
            let code = u32::from(character);
            let message = format!("the character U+{code:04X} is not allowed in XML");
            let fault = Diagnostic::new(Code::NotWellFormed, self.xml.span(range), message);
            return Err(self.broken(fault));
        }
        self.diagnostics.extend(encoding::check(self.file, self.xml.text()));
        match self.step()? {
            Step::Child(tag) if tag.name == name => {
                self.is_dialect = std::ptr::eq(element, &grammar::MAVLINK);
                Ok(self.known(tag, element))
            }
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
        if self.is_dialect {
            self.diagnostics.extend(tag.refused_names());
        }
        tag.report(self.is_dialect, self.diagnostics)
    }

    /// The next element in the one that is open, an `element`, if the grammar has it; `None` once that is closed.
    ///
    /// The caller reads the child to its end.
    pub(super) fn next_child(&mut self, element: &'static Element) -> Result<Option<Tag<'t>>, Broken> {
        loop {
            match self.step()? {
                Step::Child(tag) => match element.child(tag.name) {
                    Some(child) => {
                        self.check_place(&tag, element, child);
                        return Ok(Some(self.known(tag, child.element)));
                    }
                    None => {
                        self.unknown(&tag, element);
                        self.skip()?;
                    }
                },
                Step::Close | Step::End => {
                    self.stray(element);
                    self.check_complete(element);
                    return Ok(None);
                }
            }
        }
    }

    /// The tag as that of an `element` of the grammar. Says what pymavlink's schema refuses of its attributes.
    fn known(&mut self, tag: Tag<'t>, element: &'static Element) -> Tag<'t> {
        let tag = tag.of(element);
        if self.is_dialect {
            self.diagnostics.extend(tag.refused_values());
        }
        tag
    }

    /// Reads to the end of an `element` that has only text, and elements that do not matter.
    pub(super) fn text(&mut self, element: &'static Element) -> Result<Option<Text>, Broken> {
        while self.next_child(element)?.is_some() {
            self.skip()?;
        }
        let text = self.closed.text.take();
        if let TextKind::Fact(ty) = element.text {
            let (said, tag) = (text.as_ref(), self.left.as_ref().map(|left| left.tag));
            let place = said.map(|text| self.xml.span(trimmed(self.xml.text(), text.span.range()))).or(tag);
            let said = said.map_or("", |text| text.value.as_str());
            if let Some(place) = place.filter(|_| self.is_dialect && !ty.allows(said)) {
                self.diagnostics.push(schema::refused(&format!("`<{}>` is", element.name), ty, said, place));
            }
        }
        Ok(text)
    }

    /// Like [`Self::text`], without blanks at both ends; blanks alone are no text.
    pub(super) fn trimmed_text(&mut self, element: &'static Element) -> Result<Option<Text>, Broken> {
        self.closed.text = self.text(element)?;
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
        let essential = tag.element.is_some_and(|element| element.essential);
        let code = if essential { Code::DuplicateElement } else { Code::RepeatedElement };
        let problem = Diagnostic::new(code, tag.span, format!("a second `<{}>`", tag.name)).label("again here");
        self.diagnostics.push(problem.related(first, "first here"));
    }

    fn step(&mut self) -> Result<Step<'t>, Broken> {
        match self.xml.next() {
            Ok(Token::Open(name, range)) => {
                let source = (self.file, self.xml.text());
                let tag = tag::read(source, name, range, self.diagnostics).map_err(|fault| self.broken(*fault))?;
                self.inside.push(Progress { tag: tag.span, furthest: None, seen: Vec::new() });
                Ok(Step::Child(tag))
            }
            Ok(Token::Close(content)) => {
                self.closed = content;
                self.left = self.inside.pop();
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

    /// Says where pymavlink's schema wants another order. What is about to be read stands on top of what is open.
    fn check_place(&mut self, tag: &Tag<'t>, element: &Element, child: &'static Child) {
        let Some(around) = self.inside.iter_mut().nth_back(1).filter(|_| self.is_dialect) else { return };
        let first = around.furthest.filter(|first| first.place > child.place);
        let again = child.times != Times::Any && around.seen.contains(&tag.name);
        around.seen.push(child.element.name);
        if around.furthest.is_none_or(|first| first.place < child.place) {
            around.furthest = Some(child);
        }
        let (name, place) = (tag.name, self.xml.span(first_line(self.xml.text(), tag.span.range())));
        let problem = if let Some(first) = first {
            let first = first.element.name;
            schema::misplaced(
                &format!("`<{name}>` stands after `<{first}>`"),
                place,
                format!("move it before the first `<{first}>`"),
            )
        } else if again {
            schema::misplaced(
                &format!("`<{name}>` stands twice in `<{}>`", element.name),
                place,
                "join the two".to_owned(),
            )
        } else {
            return;
        };
        self.diagnostics.push(problem);
    }

    /// Says what pymavlink's schema misses in the element that was closed last.
    fn check_complete(&mut self, element: &Element) {
        let Some(left) = self.left.as_ref().filter(|_| self.is_dialect) else { return };
        let mut required = element.children.iter().filter(|child| child.times == Times::Once);
        let Some(missing) = required.find(|child| !left.seen.contains(&child.element.name)) else { return };
        let missing = missing.element.name;
        let place = self.xml.span(first_line(self.xml.text(), left.tag.range()));
        let help = format!("add `<{missing}>…</{missing}>`, or an empty `<{missing}/>`");
        self.diagnostics.push(schema::misplaced(&format!("`<{}>` has no `<{missing}>`", element.name), place, help));
    }

    /// Reports an element that the grammar does not have. One that is nearly another of which the wire, or a name, depends
    /// would be lost from there in silence.
    fn unknown(&mut self, tag: &Tag<'t>, element: &Element) {
        let message = format!("`<{}>` has no element `<{}>`", element.name, tag.name);
        let place = self.xml.span(first_line(self.xml.text(), tag.span.range()));
        let meant = nearest(tag.name, element.children.iter().map(|child| child.element.name));
        let meant = meant.and_then(|name| element.child(name)).map(|child| child.element);
        let code = match meant {
            Some(meant) if meant.essential => Code::Misspelt,
            _ => Code::UnknownElement,
        };
        let problem = Diagnostic::new(code, place, message);
        let problem = match code {
            Code::Misspelt => problem.label("all that is in it would be lost"),
            _ if self.is_dialect => problem.label("ignored, with all that is in it; pymavlink refuses it"),
            _ => problem.label("ignored, with all that is in it"),
        };
        self.diagnostics.push(match meant {
            Some(meant) => problem.help(format!("did you mean `<{}>`?", meant.name)),
            None if element.name == "extensions" => {
                problem.help("write `<extensions/>`, and the extension fields after it")
            }
            None => problem,
        });
    }

    /// Reports text in the element that was closed last, if it is no place for text.
    fn stray(&mut self, element: &Element) {
        let Some(first) = self.closed.first.filter(|_| element.text == TextKind::None) else { return };
        let text = self.xml.text();
        let place = self.xml.span(first_line(text, trimmed(text, first.range())));
        let message = format!("text in `<{}>`", element.name);
        let label = if self.is_dialect { "ignored; pymavlink refuses it" } else { "ignored" };
        self.diagnostics.push(Diagnostic::new(Code::StrayText, place, message).label(label));
    }
}
