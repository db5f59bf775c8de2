//! Elements by the rules of a grammar: what is not in it is reported and skipped.

use super::characters::illegal;
use super::encoding;
use super::fault::not_well_formed;
use super::grammar::{Child, Element, TextKind, Times};
use super::schema;
use super::tag;
use super::xml::{Content, Token, Xml};
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::source::{Part, Span};
use crate::syntax::{self, Tag, Text};

/// The text is no XML: it was said, and nothing more can be read.
#[derive(Debug)]
pub(super) struct Broken;

/// The elements of one text.
pub(super) struct Elements<'t, 'd> {
    xml: Xml<'t>,
    diagnostics: &'d mut Diagnostics,
    /// What stood in the element that was closed last.
    closed: Content,
    /// Whether pymavlink reads the file, so that what it refuses is worth a word.
    is_dialect: bool,
    /// The elements that are open, from the root.
    open: Vec<Open>,
}

/// An element of the grammar that is open.
struct Open {
    element: &'static Element,
    /// Its start tag.
    tag: Span,
    /// The first one of each kind of child that has stood in it.
    seen: Vec<(&'static Child, Span)>,
}

impl Open {
    fn first(&self, name: &str) -> Option<Span> {
        self.seen.iter().find(|(child, _)| child.element.name == name).map(|(_, first)| *first)
    }
}

/// A token with its attributes read.
enum Step<'t> {
    Child(Tag<'t>),
    Close,
    End,
}

impl<'t, 'd> Elements<'t, 'd> {
    pub(super) fn new(source: Part<'t>, is_dialect: bool, diagnostics: &'d mut Diagnostics) -> Self {
        Self { xml: Xml::new(source), diagnostics, closed: Content::default(), is_dialect, open: Vec::new() }
    }

    /// The start tag of the root element.
    pub(super) fn root(&mut self, element: &'static Element) -> Result<Tag<'t>, Broken> {
        let (name, source) = (element.name, self.xml.source);
        if let Some((range, character)) = illegal(source.text) {
            let message = format!("the character U+{:04X} is not allowed in XML", u32::from(character));
            return Err(self.broken(not_well_formed(source.span_of(range), message)));
        }
        self.diagnostics.extend(encoding::check(source));
        match self.step()? {
            Step::Child(tag) if tag.name == name => {
                self.enter(element, &tag);
                Ok(tag)
            }
            Step::Child(tag) => {
                let message = format!("the root element is `<{}>`", tag.name);
                let label = format!("`<{name}>` is expected");
                Err(self.broken(Diagnostic::new(Code::WrongRoot, tag.span, message).label(label)))
            }
            Step::Close | Step::End => {
                let message = format!("the file has no `<{name}>` element");
                Err(self.broken(Diagnostic::new(Code::WrongRoot, source.span_of(0..0), message)))
            }
        }
    }

    /// Checks that nothing but comments follows the root element.
    pub(super) fn end(&mut self) -> Result<(), Broken> {
        self.step().map(|_| ())
    }

    /// Reads an element that has others, each by `child`; `None` if a required attribute is missing.
    pub(super) fn element<E: syntax::Element>(
        &mut self,
        mut tag: Tag<'t>,
        mut child: impl FnMut(&mut E, &mut Self, Tag<'t>) -> Result<(), Broken>,
    ) -> Result<Option<E>, Broken> {
        let mut element = E::of(&mut tag);
        let is_complete = self.close_tag(tag);
        while let Some(tag) = self.next_child()? {
            child(&mut element, self, tag)?;
        }
        Ok(is_complete.then_some(element))
    }

    /// Reads an element that has only text, which `text` puts into it; `None` if a required attribute is missing.
    pub(super) fn leaf<E: syntax::Element>(
        &mut self,
        mut tag: Tag<'t>,
        text: impl FnOnce(&mut E, Option<Text>),
    ) -> Result<Option<E>, Broken> {
        let mut element = E::of(&mut tag);
        let is_complete = self.close_tag(tag);
        text(&mut element, self.text()?);
        Ok(is_complete.then_some(element))
    }

    /// The next element in the one that is open, if the grammar has it; `None` once that is closed.
    ///
    /// The caller reads the child to its end.
    pub(super) fn next_child(&mut self) -> Result<Option<Tag<'t>>, Broken> {
        loop {
            match self.step()? {
                Step::Child(tag) => match self.open.last().and_then(|around| around.element.child(tag.name)) {
                    Some(child) => {
                        self.check_place(&tag, child);
                        self.enter(child.element, &tag);
                        return Ok(Some(tag));
                    }
                    None => {
                        self.unknown(&tag);
                        self.skip()?;
                    }
                },
                Step::Close | Step::End => {
                    self.leave();
                    return Ok(None);
                }
            }
        }
    }

    fn enter(&mut self, element: &'static Element, tag: &Tag<'t>) {
        if self.is_dialect {
            self.diagnostics.extend(tag.attributes.iter().filter_map(|written| tag::refused(element, written)));
        }
        self.open.push(Open { element, tag: tag.span, seen: Vec::new() });
    }

    /// Checks what stood in the element that was closed.
    fn leave(&mut self) {
        if let Some(left) = self.open.pop() {
            self.check_text(&left);
            self.check_complete(&left);
        }
    }

    /// Reads to the end of an element that has only text, and elements that do not matter.
    pub(super) fn text(&mut self) -> Result<Option<Text>, Broken> {
        let kind = self.open.last().map(|open| open.element.text);
        while self.next_child()?.is_some() {
            self.pass_over()?;
        }
        Ok(if kind == Some(TextKind::Prose) { self.closed.text.take() } else { self.trimmed_content() })
    }

    /// The text that stood in the element that was closed last, without blanks at both ends; blanks alone are no text.
    pub(super) fn trimmed_content(&mut self) -> Option<Text> {
        let text = self.closed.text.take()?;
        let value = text.value.trim();
        let place = self.xml.source.get(text.span.range()).trimmed();
        (!value.is_empty()).then(|| Text::new(value.to_owned(), place.span()))
    }

    /// Reads to the end of the child that came last, whatever is in it.
    pub(super) fn pass_over(&mut self) -> Result<(), Broken> {
        self.open.pop();
        self.skip()
    }

    /// Reads to the end of the element whose start tag came last.
    fn skip(&mut self) -> Result<(), Broken> {
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

    /// Reports the child that came last if one of these names, of which an element has at most one, came before.
    pub(super) fn check_repeated(&mut self, tag: &Tag<'t>, names: &[&str]) {
        let [.., around, child] = &self.open[..] else { return };
        let Some(first) = names.iter().filter_map(|name| around.first(name)).min().filter(|first| *first != tag.span)
        else {
            return;
        };
        let code = if child.element.essential { Code::DuplicateElement } else { Code::RepeatedElement };
        let problem = Diagnostic::new(code, tag.span, format!("a second `<{}>`", tag.name)).label("again here");
        self.diagnostics.push(problem.related(first, "first here"));
    }

    fn step(&mut self) -> Result<Step<'t>, Broken> {
        match self.xml.next() {
            Ok(Token::Open(name, part)) => {
                tag::read(name, part, self.diagnostics).map(Step::Child).map_err(|fault| self.broken(*fault))
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

    /// The first line of what stands at a place.
    fn first_line(&self, place: Span) -> Span {
        self.xml.source.get(place.range()).first_line().span()
    }

    /// Reports the attributes that nobody took, those that are missing, and those that pymavlink's schema refuses; whether none
    /// is missing.
    pub(super) fn close_tag(&mut self, tag: Tag<'t>) -> bool {
        let Some(Open { element, .. }) = self.open.last() else { return false };
        tag::report(&tag, element, self.is_dialect, self.diagnostics);
        tag.missing.is_empty()
    }

    /// Notes a child, and says where pymavlink's schema wants another order.
    fn check_place(&mut self, tag: &Tag<'t>, child: &'static Child) {
        let Some(around) = self.open.last_mut() else { return };
        let is_again = around.first(tag.name).is_some();
        // Of several in the highest place, the first.
        let furthest = around.seen.iter().rev().max_by_key(|(seen, _)| seen.place).map(|(seen, _)| *seen);
        if !is_again {
            around.seen.push((child, tag.span));
        }
        let (name, element) = (tag.name, around.element.name);
        let (message, help) = match furthest.filter(|furthest| furthest.place > child.place) {
            Some(Child { element: Element { name: first, .. }, .. }) => {
                (format!("`<{name}>` stands after `<{first}>`"), format!("move it before the first `<{first}>`"))
            }
            None if is_again && child.times != Times::Any => {
                (format!("`<{name}>` stands twice in `<{element}>`"), "join the two".to_owned())
            }
            None => return,
        };
        self.misplaced(&message, tag.span, help);
    }

    /// Says what pymavlink's schema misses in an element.
    fn check_complete(&mut self, left: &Open) {
        let mut required = left.element.children.iter().filter(|child| child.times == Times::Once);
        let Some(missing) = required.find(|child| left.first(child.element.name).is_none()) else { return };
        let (name, missing) = (left.element.name, missing.element.name);
        let help = format!("add `<{missing}>…</{missing}>`, or an empty `<{missing}/>`");
        self.misplaced(&format!("`<{name}>` has no `<{missing}>`"), left.tag, help);
    }

    fn misplaced(&mut self, message: &str, element: Span, help: String) {
        if self.is_dialect {
            self.diagnostics.push(schema::misplaced(message, self.first_line(element), help));
        }
    }

    /// Reports text that pymavlink's schema refuses in the element that was closed, and any text if it is no place for text.
    fn check_text(&mut self, left: &Open) {
        let (name, source) = (left.element.name, self.xml.source);
        match (left.element.text, self.closed.first) {
            (TextKind::None, Some(first)) => {
                let place = source.get(first.range()).trimmed().first_line().span();
                let label = if self.is_dialect { "ignored; pymavlink refuses it" } else { "ignored" };
                let problem = Diagnostic::new(Code::StrayText, place, format!("text in `<{name}>`"));
                self.diagnostics.push(problem.label(label));
            }
            (TextKind::Trimmed(ty), _) if self.is_dialect => {
                let text = self.closed.text.as_ref();
                let place = text.map_or(left.tag, |text| source.get(text.span.range()).trimmed().span());
                let text = text.map_or("", |text| text.value.as_str());
                self.diagnostics.extend(schema::refused(&format!("`<{name}>` is"), ty, text, place));
            }
            _ => {}
        }
    }

    /// Reports an element that the grammar does not have. One that is nearly another of which the wire, or a name, depends
    /// would be lost from there in silence.
    fn unknown(&mut self, tag: &Tag<'t>) {
        let Some(Open { element, .. }) = self.open.last() else { return };
        let meant = nearest(tag.name, element.children.iter().map(|child| child.element.name));
        let meant = meant.and_then(|name| element.child(name)).map(|child| child.element);
        let (code, label) = match meant {
            Some(meant) if meant.essential => (Code::Misspelt, "all that is in it would be lost"),
            _ if self.is_dialect => (Code::UnknownElement, "ignored, with all that is in it; pymavlink refuses it"),
            _ => (Code::UnknownElement, "ignored, with all that is in it"),
        };
        let message = format!("`<{}>` has no element `<{}>`", element.name, tag.name);
        let problem = Diagnostic::new(code, self.first_line(tag.span), message).label(label);
        self.diagnostics.push(match meant {
            Some(meant) => problem.help(format!("did you mean `<{}>`?", meant.name)),
            None if element.name == "extensions" => {
                problem.help("write `<extensions/>`, and the extension fields after it")
            }
            None => problem,
        });
    }
}
