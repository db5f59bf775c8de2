//! `<note>`: a paragraph for the documentation of a message, a field, an enum or an entry.

use super::super::losses::Losses;
use super::super::suggest::suggest;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Dialect, Origin};
use crate::read::Loaded;
use crate::source::Span;
use crate::syntax::Text;
use crate::syntax::overlay::Note;

/// What a note is about: the names of a whole and, if it is about one, of its part.
enum Subject<'n> {
    Message(&'n Text, Option<&'n Text>),
    Enum(&'n Text, Option<&'n Text>),
}

/// Adds the notes of all overlays to the descriptions.
pub(in crate::resolve) fn apply(
    loaded: &Loaded,
    dialect: &mut Dialect,
    losses: &Losses,
    diagnostics: &mut Diagnostics,
) {
    for note in loaded.overlays.iter().flat_map(|overlay| &overlay.notes) {
        let Some(subject) = subject(note, diagnostics) else { continue };
        let Some(text) = &note.text else {
            let problem = Diagnostic::new(Code::Note, note.span, "a note without a text");
            diagnostics.push(problem.help("the text stands between `<note …>` and `</note>`"));
            continue;
        };
        if let Some(origin) = origin(&subject, dialect) {
            origin.append(&text.value);
        } else if !losses.any() && !is_broken(&subject, loaded, dialect) {
            let problem = unknown(&subject, dialect, diagnostics);
            diagnostics.push(problem);
        }
    }
}

/// Whether a message is defined and not in the model, because something is wrong with it.
fn is_broken(subject: &Subject<'_>, loaded: &Loaded, dialect: &Dialect) -> bool {
    let Subject::Message(name, _) = subject else { return false };
    let mut defined = loaded.files.iter().flat_map(|file| &file.messages);
    let in_model = dialect.messages.iter().any(|message| message.name.text == name.value);
    !in_model && defined.any(|message| message.name.value == name.value)
}

/// What the attributes say.
fn subject<'n>(note: &'n Note, diagnostics: &mut Diagnostics) -> Option<Subject<'n>> {
    read(note)
        .map_err(|wrong| {
            let problem = Diagnostic::new(Code::Note, note.span, wrong);
            diagnostics
                .push(problem.help("write `message=`, with or without `field=`, or `enum=`, with or without `entry=`"));
        })
        .ok()
}

fn read(note: &Note) -> Result<Subject<'_>, &'static str> {
    let Note { message, field, values, entry, .. } = note;
    match (message, field, values, entry) {
        (Some(message), field, None, None) => Ok(Subject::Message(message, field.as_ref())),
        (None, None, Some(values), entry) => Ok(Subject::Enum(values, entry.as_ref())),
        (None, None, None, None) => Err("a note does not say what it is about"),
        (None, Some(_), _, _) => Err("a note about a field does not say of which message"),
        (_, _, None, Some(_)) => Err("a note about an entry does not say of which enum"),
        (Some(_), _, Some(_), _) => Err("a note is about a message and an enum"),
    }
}

/// What a note is about, in the model.
pub(super) fn origin_of<'d>(note: &Note, dialect: &'d mut Dialect) -> Option<&'d mut Origin> {
    origin(&read(note).ok()?, dialect)
}

fn origin<'d>(subject: &Subject<'_>, dialect: &'d mut Dialect) -> Option<&'d mut Origin> {
    match subject {
        Subject::Message(name, part) => {
            let message = dialect.messages.iter_mut().find(|message| message.name.text == name.value)?;
            let Some(part) = part else { return Some(&mut message.origin) };
            let mut fields = message.fields.iter_mut();
            fields.find(|field| field.name.text == part.value).map(|field| &mut field.origin)
        }
        Subject::Enum(name, part) => {
            let values = dialect.enums.iter_mut().find(|values| values.name.text == name.value)?;
            let Some(part) = part else { return Some(&mut values.origin) };
            let mut entries = values.entries.iter_mut();
            entries.find(|entry| entry.name.text == part.value).map(|entry| &mut entry.origin)
        }
    }
}

/// Says which of the names does not exist.
fn unknown(subject: &Subject<'_>, dialect: &Dialect, before: &Diagnostics) -> Diagnostic {
    let (whole, part, [code, part_code], [what, part_what]) = match subject {
        Subject::Message(whole, part) => {
            (whole, part, [Code::OverlayMessage, Code::OverlayField], ["message", "field"])
        }
        Subject::Enum(whole, part) => (whole, part, [Code::OverlayEnum, Code::OverlayEntry], ["enum", "entry"]),
    };
    let (wholes, place, parts) = names(subject, dialect);
    match (place, part) {
        (Some(place), Some(part)) => {
            let message = format!("{what} `{}` has no {part_what} `{}`", whole.value, part.value);
            let problem = Diagnostic::new(part_code, part.span, message).label(format!("no such {part_what}"));
            let problem = problem.related(place, format!("the {what}"));
            suggest(problem, &part.value, parts, before)
        }
        _ => {
            let message = format!("{what} `{}` does not exist", whole.value);
            let problem = Diagnostic::new(code, whole.span, message).label(format!("no such {what}"));
            suggest(problem, &whole.value, wholes, before)
        }
    }
}

/// The names that a whole could have; the place of the whole, if it exists, and the names that its part could have.
fn names<'d>(subject: &Subject<'_>, dialect: &'d Dialect) -> (Vec<&'d str>, Option<Span>, Vec<&'d str>) {
    match subject {
        Subject::Message(name, _) => {
            let all = dialect.messages.iter().map(|message| message.name.text.as_str()).collect();
            let found = dialect.messages.iter().find(|message| message.name.text == name.value);
            let parts = found.into_iter().flat_map(|message| &message.fields).map(|field| field.name.text.as_str());
            (all, found.map(|message| message.origin.span), parts.collect())
        }
        Subject::Enum(name, _) => {
            let all = dialect.enums.iter().map(|values| values.name.text.as_str()).collect();
            let found = dialect.enums.iter().find(|values| values.name.text == name.value);
            let parts = found.into_iter().flat_map(|values| &values.entries).map(|entry| entry.name.text.as_str());
            (all, found.map(|values| values.origin.span), parts.collect())
        }
    }
}
