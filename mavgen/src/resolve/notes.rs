//! What overlays say of the items of the definitions: the paragraphs of their notes, and who says something at all.

use std::collections::HashMap;

use super::enums::Enums;
use super::lost::Poisoned;
use super::message::Draft;
use super::suggest;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FileIndex, Origin};
use crate::read::Loaded;
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::Note;

/// What a note is about.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Whole {
    /// A message, or a field of it.
    Message,
    /// An enum, or an entry of it.
    Enum,
}

/// What a note is about: a message or an enum, its name and, if the note is about one field or entry of it, the name of that.
type Subject<T> = (Whole, T, Option<T>);

/// What overlays say, by what it is about.
#[derive(Default)]
pub(super) struct Notes<'a> {
    said: HashMap<Subject<&'a str>, Said<'a>>,
}

/// What overlays say of one item.
#[derive(Default)]
struct Said<'a> {
    /// Those that add to it.
    overlays: Vec<FileIndex>,
    /// For its documentation.
    paragraphs: Vec<&'a str>,
}

impl<'a> Notes<'a> {
    /// Reads the notes of all overlays, and what else they add to. A note about what does not exist is reported.
    pub(super) fn of(
        loaded: &'a Loaded,
        drafts: &[Draft<'_>],
        enums: &Enums<'_>,
        poisoned: &Poisoned,
        diagnostics: &mut Diagnostics,
    ) -> Self {
        let mut notes = Self::default();
        for (file, overlay) in loaded.numbered_overlays() {
            for additions in &overlay.messages {
                notes.by(file, (Whole::Message, &additions.name.value, None));
            }
            for refinement in &overlay.refinements {
                notes.by(file, (Whole::Enum, &refinement.enum_.value, None));
            }
            for note in &overlay.notes {
                let Some(subject) = subject(note, diagnostics) else { continue };
                let Some(text) = &note.text else {
                    let problem = Diagnostic::new(Code::Note, note.span, "a note without a text");
                    diagnostics.push(problem.help("the text stands between `<note …>` and `</note>`"));
                    continue;
                };
                let (what, whole, part) = subject;
                let parts = parts(what, &whole.value, drafts, enums);
                // A message that is defined is no draft if something is wrong with it.
                let is_broken = || {
                    let mut messages = loaded.messages();
                    what == Whole::Message && messages.any(|message| message.name.value == whole.value)
                };
                let has = |part: &Text| parts.as_ref().is_some_and(|(_, names)| names.contains(&part.value.as_str()));
                if parts.is_some() && part.is_none_or(has) {
                    let subject = (what, whole.value.as_str(), part.map(|part| part.value.as_str()));
                    notes.by(file, subject).paragraphs.push(&text.value);
                } else if !poisoned.any() && (parts.is_some() || !is_broken()) {
                    report_missing(subject, parts, (drafts, enums), diagnostics);
                }
            }
        }
        notes
    }

    /// What is said of an item, now also by the overlay `file`.
    fn by(&mut self, file: FileIndex, subject: Subject<&'a str>) -> &mut Said<'a> {
        let said = self.said.entry(subject).or_default();
        if !said.overlays.contains(&file) {
            said.overlays.push(file);
        }
        said
    }

    /// Adds what is said of an item to its origin.
    pub(super) fn add_to(&self, origin: &mut Origin, subject: Subject<&str>) {
        let Some(said) = self.said.get(&subject) else { return };
        origin.overlays.extend(&said.overlays);
        said.paragraphs.iter().for_each(|paragraph| origin.append(paragraph));
    }
}

/// What the attributes say.
fn subject<'n>(note: &'n Note, diagnostics: &mut Diagnostics) -> Option<Subject<&'n Text>> {
    let Note { message, field, enum_, entry, .. } = note;
    let wrong = match (message, field, enum_, entry) {
        (Some(message), field, None, None) => return Some((Whole::Message, message, field.as_ref())),
        (None, None, Some(enum_), entry) => return Some((Whole::Enum, enum_, entry.as_ref())),
        (None, None, None, None) => "a note does not say what it is about",
        (None, Some(_), _, _) => "a note about a field does not say of which message",
        (_, _, None, Some(_)) => "a note about an entry does not say of which enum",
        (Some(_), _, Some(_), _) => "a note is about a message and an enum",
    };
    let problem = Diagnostic::new(Code::Note, note.span, wrong);
    diagnostics.refuse(problem.help("write `message=`, with or without `field=`, or `enum=`, with or without `entry=`"))
}

/// The place of a whole, if it exists, and the names of its parts.
fn parts<'a>(what: Whole, name: &str, drafts: &[Draft<'a>], enums: &Enums<'a>) -> Option<(Span, Vec<&'a str>)> {
    match what {
        Whole::Message => {
            let message = drafts.iter().find(|draft| draft.syntax.name.value == name)?.syntax;
            Some((message.span, message.fields.iter().map(|field| field.name.value.as_str()).collect_vec()))
        }
        Whole::Enum => {
            let merged = enums.get(enums.id(name)?)?;
            Some((merged.span, merged.entry_names().collect_vec()))
        }
    }
}

/// Says which of the names does not exist.
fn report_missing(
    (what, whole, part): Subject<&Text>,
    parts: Option<(Span, Vec<&str>)>,
    (drafts, enums): (&[Draft<'_>], &Enums<'_>),
    diagnostics: &mut Diagnostics,
) {
    let (what, code, part_what, part_code, wholes) = match what {
        Whole::Message => {
            let names = drafts.iter().map(|draft| draft.syntax.name.value.as_str()).collect_vec();
            ("message", Code::OverlayMessage, "field", Code::OverlayField, names)
        }
        Whole::Enum => ("enum", Code::OverlayEnum, "entry", Code::OverlayEntry, enums.names().collect_vec()),
    };
    if let (Some((place, parts)), Some(part)) = (parts, part) {
        let message = format!("{what} `{}` has no {part_what} `{}`", whole.value, part.value);
        let problem = Diagnostic::new(part_code, part.span, message).label(format!("no such {part_what}"));
        let problem = problem.related(place, format!("the {what}"));
        suggest::report(problem, &part.value, &mut parts.into_iter(), diagnostics);
    } else {
        let message = format!("{what} `{}` does not exist", whole.value);
        let problem = Diagnostic::new(code, whole.span, message).label(format!("no such {what}"));
        suggest::report(problem, &whole.value, &mut wholes.into_iter(), diagnostics);
    }
}
