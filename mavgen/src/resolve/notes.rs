//! What overlays say of the items of the definitions: the paragraphs of their notes, and who says something at all.

use std::collections::HashMap;

use super::enums::Enums;
use super::message::Draft;
use super::poisoned::Poisoned;
use super::suggest::suggest;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{FileIndex, Origin};
use crate::read::Loaded;
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::{Note, Overlay};

/// What a note is about: a whole and, if it is about one, its part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Subject<T> {
    /// A message, or a field of it.
    Message(T, Option<T>),
    /// An enum, or an entry of it.
    Enum(T, Option<T>),
}

impl<'n> Subject<&'n Text> {
    fn names(self) -> Subject<&'n str> {
        let name = |text: &'n Text| text.value.as_str();
        match self {
            Self::Message(whole, part) => Subject::Message(name(whole), part.map(name)),
            Self::Enum(whole, part) => Subject::Enum(name(whole), part.map(name)),
        }
    }
}

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
    /// Reads the notes of all overlays. One about what does not exist is reported.
    pub(super) fn of(
        loaded: &'a Loaded,
        drafts: &[Draft<'_>],
        enums: &Enums<'_>,
        poisoned: &Poisoned,
        diagnostics: &mut Diagnostics,
    ) -> Self {
        let mut notes = Self::default();
        for (index, overlay) in loaded.overlays.iter().enumerate() {
            let file = FileIndex(loaded.files.len() + index);
            notes.credit(file, overlay);
            for note in &overlay.notes {
                let Some(subject) = subject(note, diagnostics) else { continue };
                let Some(text) = &note.text else {
                    let problem = Diagnostic::new(Code::Note, note.span, "a note without a text");
                    diagnostics.push(problem.help("the text stands between `<note …>` and `</note>`"));
                    continue;
                };
                let known = Known { drafts, enums };
                if known.has(subject) {
                    notes.by(file, subject.names()).paragraphs.push(&text.value);
                } else if !poisoned.any() && !known.is_broken(subject, loaded) {
                    let problem = known.missing(subject, diagnostics);
                    diagnostics.push(problem);
                }
            }
        }
        notes
    }

    /// Notes what an overlay adds to beside its notes.
    fn credit(&mut self, file: FileIndex, overlay: &'a Overlay) {
        for additions in &overlay.messages {
            self.by(file, Subject::Message(&additions.name.value, None));
        }
        for refinement in &overlay.refinements {
            self.by(file, Subject::Enum(&refinement.enum_.value, None));
        }
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
        (Some(message), field, None, None) => return Some(Subject::Message(message, field.as_ref())),
        (None, None, Some(enum_), entry) => return Some(Subject::Enum(enum_, entry.as_ref())),
        (None, None, None, None) => "a note does not say what it is about",
        (None, Some(_), _, _) => "a note about a field does not say of which message",
        (_, _, None, Some(_)) => "a note about an entry does not say of which enum",
        (Some(_), _, Some(_), _) => "a note is about a message and an enum",
    };
    let problem = Diagnostic::new(Code::Note, note.span, wrong);
    diagnostics.push(problem.help("write `message=`, with or without `field=`, or `enum=`, with or without `entry=`"));
    None
}

/// What a note can be about.
struct Known<'k, 'a> {
    drafts: &'k [Draft<'a>],
    enums: &'k Enums<'a>,
}

impl<'a> Known<'_, 'a> {
    fn has(&self, subject: Subject<&Text>) -> bool {
        let (Subject::Message(whole, part) | Subject::Enum(whole, part)) = subject;
        match (self.whole(subject, whole), part) {
            (None, _) => false,
            (Some(_), None) => true,
            (Some((_, parts)), Some(part)) => parts.contains(&part.value.as_str()),
        }
    }

    /// The place of a whole, if it exists, and the names of its parts.
    fn whole(&self, subject: Subject<&Text>, name: &Text) -> Option<(Span, Vec<&'a str>)> {
        match subject {
            Subject::Message(..) => {
                let message = self.drafts.iter().find(|draft| draft.syntax.name.value == name.value)?.syntax;
                Some((message.span, message.fields.iter().map(|field| field.name.value.as_str()).collect_vec()))
            }
            Subject::Enum(..) => {
                let merged = self.enums.list.get(self.enums.id(&name.value)?.0)?;
                let entries = merged.entries.iter().map(|entry| entry.syntax.name.value.as_str());
                Some((merged.span, entries.collect_vec()))
            }
        }
    }

    /// Whether a message is defined and no draft, because something is wrong with it.
    fn is_broken(&self, subject: Subject<&Text>, loaded: &Loaded) -> bool {
        let Subject::Message(name, _) = subject else { return false };
        let mut defined = loaded.files.iter().flat_map(|file| &file.messages);
        self.whole(subject, name).is_none() && defined.any(|message| message.name.value == name.value)
    }

    /// Says which of the names does not exist.
    fn missing(&self, subject: Subject<&Text>, before: &Diagnostics) -> Diagnostic {
        let (whole, part, [code, part_code], [what, part_what]) = match subject {
            Subject::Message(whole, part) => {
                (whole, part, [Code::OverlayMessage, Code::OverlayField], ["message", "field"])
            }
            Subject::Enum(whole, part) => (whole, part, [Code::OverlayEnum, Code::OverlayEntry], ["enum", "entry"]),
        };
        match (self.whole(subject, whole), part) {
            (Some((place, parts)), Some(part)) => {
                let message = format!("{what} `{}` has no {part_what} `{}`", whole.value, part.value);
                let problem = Diagnostic::new(part_code, part.span, message).label(format!("no such {part_what}"));
                suggest(problem.related(place, format!("the {what}")), &part.value, parts, before)
            }
            _ => {
                let message = format!("{what} `{}` does not exist", whole.value);
                let problem = Diagnostic::new(code, whole.span, message).label(format!("no such {what}"));
                suggest(problem, &whole.value, self.wholes(subject), before)
            }
        }
    }

    /// The names that a whole could have.
    fn wholes(&self, subject: Subject<&Text>) -> Vec<&'a str> {
        match subject {
            Subject::Message(..) => self.drafts.iter().map(|draft| draft.syntax.name.value.as_str()).collect_vec(),
            Subject::Enum(..) => self.enums.names().collect_vec(),
        }
    }
}
