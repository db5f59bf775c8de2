//! Drawing of diagnostics: source line, caret, labels, help.

use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet, normalize_untrusted_str};

use super::{Diagnostic, Severity};
use crate::collect::CollectVec as _;
use crate::source::{FileId, SourceFile, Sources, Span};

/// The width at which long source lines are cut, whatever the terminal: output must not depend on where it is made.
const WIDTH: usize = 120;

/// How many characters of a message are shown.
const LONGEST: usize = 400;

/// How a diagnostic is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Plain text.
    Plain,
    /// With terminal colours.
    Coloured,
}

/// Draws one diagnostic: several lines, without a line end at the end.
pub fn render(diagnostic: &Diagnostic, sources: &Sources, style: Style) -> String {
    let level = match diagnostic.severity() {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let title = level.primary_title(line(&diagnostic.message)).id(diagnostic.code.to_string());
    let help = diagnostic.help.as_deref().map(|help| Level::HELP.message(line(help)));
    let group = Group::with_title(title).elements(snippets(diagnostic, sources)).elements(help);
    let renderer = match style {
        Style::Plain => Renderer::plain(),
        Style::Coloured => Renderer::styled(),
    };
    renderer.term_width(WIDTH).render(&[group])
}

/// One diagnostic in one line: `path:line:column: error[M304]: message`, or without a place `error[M001]: message`.
pub fn one_line(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let said = format!("{}[{}]: {}", diagnostic.severity(), diagnostic.code, line(&diagnostic.message));
    let place = diagnostic.span.and_then(|span| Some((sources.get(span.file)?, span.start)));
    place.map_or(said.clone(), |(file, start)| {
        let at = file.position(start);
        format!("{}:{}:{}: {said}", file.path().display(), at.line, at.column)
    })
}

/// One line of bounded length, without control characters: texts quote names, and those are what a file makes them.
fn line(text: &str) -> String {
    let cut = text.char_indices().nth(LONGEST).map_or(text, |(at, _)| text.get(..at).unwrap_or(text));
    let more = if cut.len() < text.len() { "…" } else { "" };
    normalize_untrusted_str(&format!("{}{more}", cut.replace(['\r', '\n'], " ")))
}

/// A place, what is said of it, and how loudly.
type Mark<'d> = (Span, &'d str, AnnotationKind);

/// One snippet per file: the file of the primary place first, the others in the order in which they are spoken of.
fn snippets<'s>(diagnostic: &'s Diagnostic, sources: &'s Sources) -> Vec<Snippet<'s, Annotation<'s>>> {
    let primary = diagnostic.span.map(|span| (span, &*diagnostic.label, AnnotationKind::Primary));
    let related = diagnostic.related.iter().map(|r| (r.span, &*r.label, AnnotationKind::Context));
    let mut files: Vec<(FileId, Vec<Mark<'s>>)> = Vec::new();
    for mark in primary.into_iter().chain(related) {
        match files.iter_mut().find(|(file, _)| *file == mark.0.file) {
            Some((_, marks)) => marks.push(mark),
            None => files.push((mark.0.file, vec![mark])),
        }
    }
    files.iter().filter_map(|(file, marks)| Some(snippet(sources.get(*file)?, marks))).collect_vec()
}

/// The lines of one file from the first mark to the last.
fn snippet<'s>(file: &'s SourceFile, marks: &[Mark<'s>]) -> Snippet<'s, Annotation<'s>> {
    let text = file.text();
    let spans = || marks.iter().map(|(span, ..)| inside(text, *span));
    let first = spans().map(|span| span.start).min().unwrap_or_default();
    let last = spans().map(|span| span.end).max().unwrap_or_default();
    let start = text.get(..first).and_then(|before| before.rfind('\n')).map_or(0, |at| at + 1);
    let end = text.get(last..).and_then(|after| after.find('\n')).map_or(text.len(), |at| last + at);
    // A carriage return before the line end is part of it.
    let end = if end > last && text.get(..end).is_some_and(|t| t.ends_with('\r')) { end - 1 } else { end };
    let number = file.position(u32::try_from(start).unwrap_or(u32::MAX)).line;
    Snippet::source(text.get(start..end).unwrap_or_default())
        .path(file.path().to_string_lossy())
        .line_start(number)
        .annotations(marks.iter().zip(spans()).map(|((_, label, kind), span)| {
            let label = (!label.is_empty()).then(|| line(label));
            kind.span(span.start - start..span.end - start).label(label)
        }))
}

/// The bytes of a span, cut to the text and to whole characters.
fn inside(text: &str, span: Span) -> std::ops::Range<usize> {
    let floor = |mut at: usize| {
        at = at.min(text.len());
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    let start = floor(span.range().start);
    start..floor(span.range().end).max(start)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Code;

    /// A diagnostic at the bytes `range` of a text.
    fn at(text: &str, range: std::ops::Range<usize>) -> (Diagnostic, Sources) {
        let mut sources = Sources::default();
        let span = Span::new(sources.add("xml/a.xml", text), range);
        (Diagnostic::new(Code::UnknownType, span, "what"), sources)
    }

    #[test]
    fn one_line_names_the_place() {
        let (diagnostic, sources) = at("ab\n°cd", 5..6);
        assert_eq!(one_line(&diagnostic, &sources), "xml/a.xml:2:2: error[M304]: what");
        let diagnostic = Diagnostic::without_place(Code::Unreadable, "`a.xml`\ncannot\u{1b} be read");
        assert_eq!(one_line(&diagnostic, &sources), "error[M001]: `a.xml` cannot␛ be read");
    }

    #[test]
    fn a_message_is_no_longer_than_a_reader_reads() {
        let (_, sources) = at("", 0..0);
        let diagnostic = Diagnostic::without_place(Code::Unreadable, "é".repeat(1000));
        assert_eq!(one_line(&diagnostic, &sources).chars().filter(|&c| c == 'é').count(), LONGEST);
        assert!(render(&diagnostic, &sources, Style::Plain).ends_with('…'));
    }

    #[test]
    fn a_span_beyond_the_text_is_drawn_at_its_end() {
        for (text, range) in [("", 3..9), ("ab", 1..9), ("é", 1..1), ("a\r\nb", 1..2)] {
            let (diagnostic, sources) = at(text, range);
            let drawn = render(&diagnostic, &sources, Style::Plain);
            assert!(drawn.starts_with("error[M304]: what\n --> xml/a.xml:1:"), "{drawn}");
        }
    }

    #[test]
    fn colours_change_nothing_else() {
        let (diagnostic, sources) = at("<field type=\"u8\"/>", 13..15);
        let diagnostic = diagnostic.label("here").help("do");
        let coloured = render(&diagnostic, &sources, Style::Coloured);
        let mut plain = String::new();
        for (index, part) in coloured.split('\u{1b}').enumerate() {
            plain.push_str(if index == 0 { part } else { part.split_once('m').unwrap().1 });
        }
        assert_ne!(coloured, plain);
        assert_eq!(plain, render(&diagnostic, &sources, Style::Plain));
    }
}
