//! The fields whose bits a view is read from, least significant first, and those that it reads beside them: `x` for a scalar,
//! `x[i]` for the element of a slot, `x[*]` for all of an array.

use std::num::NonZeroU8;

use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic};
use crate::ir::{MOST_BITS, Place, Word};
use crate::resolve::message_scope::{Found, MessageScope};
use crate::source::Span;
use crate::syntax::Text;

pub(super) struct Words {
    /// Least significant first.
    pub(super) list: Vec<Word>,
    /// Bits of all of them together.
    pub(super) width: u8,
    /// The slots, if each has its own elements.
    pub(super) shape: Option<Shape>,
    pub(super) span: Span,
}

/// The slots of arrays that lie side by side.
#[derive(Clone, Copy)]
pub(super) struct Shape {
    pub(super) length: NonZeroU8,
    /// Where the first of the arrays is defined.
    pub(super) span: Span,
}

/// A word, and what is known of its field.
struct Read<'s> {
    text: Text,
    word: Word,
    found: Found<'s>,
    bits: usize,
}

/// Resolves the words; `None` if any of them is not clear.
pub(super) fn resolve(scope: &mut MessageScope<'_, '_>, text: &Text) -> Option<Words> {
    let parts = parts(text);
    if parts.is_empty() {
        return scope.refuse(Diagnostic::new(Code::Words, text.span, "a view of no words").help("name a field"));
    }
    let read = parts.into_iter().map(|part| one(scope, part)).collect_vec();
    let read = read.into_iter().collect::<Option<Vec<Read<'_>>>>()?;
    check_once(scope, &read)?;
    let shape = shape(scope, &read)?;
    let width = width(scope, text, &read)?;
    Some(Words { list: read.iter().map(|read| read.word).collect_vec(), width, shape, span: text.span })
}

/// A scalar, or the element of a slot, for what is read beside the words: keys, sentinels, what a switch looks at.
pub(super) fn beside<'s>(scope: &mut MessageScope<'s, '_>, text: &Text, words: &Words) -> Option<(Place, Found<'s>)> {
    let (found, word) = found(scope, text)?;
    let problem = |message| Diagnostic::new(Code::Index, text.span, message);
    let problem = match (word, words.shape) {
        (Word::One(place), _) if !place.element => return Some((place, found)),
        (Word::One(place), Some(shape)) if found.field.ty.array == Some(shape.length) => return Some((place, found)),
        (Word::One(_), Some(shape)) => length_differs(text, found, shape),
        (Word::One(_), None) => {
            let message = format!("`{}` is the element of a slot, and the view has no slots", text.value);
            problem(message).related(words.span, "none of these has slots").help("name a scalar")
        }
        (Word::Joined(_), _) => {
            let problem = problem(format!("`{}` is not one value", text.value));
            problem.related(found.syntax.ty.span, "the field").help("only words can be joined")
        }
    };
    scope.refuse(problem)
}

/// The parts of a text between blanks, each with its own place.
///
/// A part of a text with character references has the place of the whole: references make it shorter than its source.
pub(super) fn parts(text: &Text) -> Vec<Text> {
    let exact = text.value.len() == text.span.range().len();
    let start = text.value.as_ptr() as usize;
    let part = |part: &str| {
        let at = (part.as_ptr() as usize).wrapping_sub(start) + text.span.range().start;
        let span = if exact { Span::new(text.span.file, at..at + part.len()) } else { text.span };
        Text::new(part.to_owned(), span)
    };
    text.value.split_whitespace().map(part).collect_vec()
}

/// The name and the index, if there is one; `Err` is what stands in the brackets and is none.
fn split(text: &str) -> Result<(&str, Option<&str>), &str> {
    match text.split_once('[') {
        None => Ok((text, None)),
        Some((name, index @ ("i]" | "*]"))) => Ok((name, Some(index))),
        Some((name, _)) => Err(text.get(name.len()..).unwrap_or_default()),
    }
}

/// The field that `text` names, with an index if and only if it is an array, and what it says of it.
fn found<'s>(scope: &mut MessageScope<'s, '_>, text: &Text) -> Option<(Found<'s>, Word)> {
    let problem = |message| Diagnostic::new(Code::Index, text.span, message);
    let (name, index) = match split(text.value.trim()) {
        Ok(split) => split,
        Err(index) => {
            let help = "`x[i]` is the element of a slot, `x[*]` all elements of an array";
            return scope.refuse(problem(format!("`{index}` is no index")).help(help));
        }
    };
    let found = scope.field(&Text::new(name.to_owned(), text.span))?;
    let field = found.index;
    let problem = match (index, found.field.ty.array) {
        (None, None) => return Some((found, Word::One(Place { field, element: false }))),
        (Some("*]"), Some(_)) => return Some((found, Word::Joined(field))),
        (Some(_), Some(_)) => return Some((found, Word::One(Place { field, element: true }))),
        (None, Some(_)) => problem(format!("`{name}` is an array"))
            .help(format!("write `{name}[i]` for the element of a slot, `{name}[*]` for all elements")),
        (Some(_), None) => {
            problem(format!("`{name}` is a scalar, which has no elements")).help(format!("write `{name}`"))
        }
    };
    scope.refuse(problem.related(found.syntax.ty.span, "the field"))
}

/// Says that an array has another length than the first array of the view.
fn length_differs(text: &Text, found: Found<'_>, Shape { length, span }: Shape) -> Diagnostic {
    let own = found.field.ty.array.map_or(0, NonZeroU8::get);
    let message = format!("`{}` has {own} elements, and the view has {length} slots", found.syntax.name.value);
    let problem = Diagnostic::new(Code::WordLengths, text.span, message);
    let problem = problem.related(found.syntax.ty.span, "the field").related(span, format!("{length} elements"));
    problem.help("arrays that are read side by side have one length")
}

fn one<'s>(scope: &mut MessageScope<'s, '_>, text: Text) -> Option<Read<'s>> {
    let (found, word) = found(scope, &text)?;
    let ty = found.field.ty;
    if !ty.scalar.is_word() {
        let help = "words are unsigned integers, `uint8_t` to `uint64_t`, and the bits of `float` and `double`";
        return scope.refuse_type(Code::WordType, text.span, found, ("is no word", help));
    }
    let bytes = if matches!(word, Word::Joined(_)) { ty.size() } else { ty.scalar.size() };
    Some(Read { text, word, found, bits: 8 * bytes })
}

/// No word stands twice: a setter would contradict itself.
fn check_once(scope: &mut MessageScope<'_, '_>, read: &[Read<'_>]) -> Option<()> {
    let mut once = Some(());
    for (index, word) in read.iter().enumerate() {
        if let Some(before) = read.iter().take(index).find(|before| before.found.index == word.found.index) {
            let message = format!("`{}` is a word of the view already", word.text.value);
            let problem = Diagnostic::new(Code::Words, word.text.span, message);
            scope.report(problem.related(before.text.span, "the first time").help("leave one of them out"));
            once = None;
        }
    }
    once
}

/// The slots, if the words are elements; that all of them are, and of arrays of one length.
fn shape(scope: &mut MessageScope<'_, '_>, read: &[Read<'_>]) -> Option<Option<Shape>> {
    let is_element = |read: &&Read<'_>| matches!(read.word, Word::One(Place { element: true, .. }));
    let Some(first) = read.iter().find(is_element) else { return Some(None) };
    if let Some(whole) = read.iter().find(|read| !is_element(read)) {
        let message = format!("`{}` is the same for every slot, and `{}` is not", whole.text.value, first.text.value);
        let problem = Diagnostic::new(Code::WordsMixed, whole.text.span, message);
        let problem = problem.related(first.text.span, "an element for each slot");
        return scope.refuse(problem.help("make all words elements (`x[i]`), or none"));
    }
    let shape = Shape { length: first.found.field.ty.array?, span: first.found.syntax.ty.span };
    if let Some(other) = read.iter().find(|read| read.found.field.ty.array != Some(shape.length)) {
        return scope.refuse(length_differs(&other.text, other.found, shape));
    }
    Some(Some(shape))
}

fn width(scope: &mut MessageScope<'_, '_>, text: &Text, read: &[Read<'_>]) -> Option<u8> {
    let bits: usize = read.iter().map(|read| read.bits).sum();
    if bits <= MOST_BITS {
        return u8::try_from(bits).ok();
    }
    let terms = read.iter().map(|read| read.bits.to_string()).collect_vec();
    let sum = if terms.len() > 1 { format!("{} = {bits}", terms.join(" + ")) } else { bits.to_string() };
    let message = format!("the words are {sum} bits wide; {MOST_BITS} are allowed");
    let mut problem = Diagnostic::new(Code::WordsTooWide, text.span, message);
    for Read { found, .. } in read {
        problem = problem.related(found.syntax.ty.span, format!("`{}.{}`", scope.name(), found.syntax.name.value));
    }
    scope.refuse(problem.help("there is no larger integer: read the words in several views"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Sources;

    #[test]
    fn indices() {
        for (text, expected) in [
            ("x", Ok(("x", None))),
            ("x[i]", Ok(("x", Some("i]")))),
            ("x[*]", Ok(("x", Some("*]")))),
            ("x[0]", Err("[0]")),
            ("x[i", Err("[i")),
            ("x[]", Err("[]")),
            ("x[i][i]", Err("[i][i]")),
        ] {
            assert_eq!(split(text), expected, "{text}");
        }
    }

    #[test]
    fn parts_have_their_places() {
        let file = Sources::default().add("a.xml", "");
        let spans = |length: usize| -> Vec<_> {
            let text = Text::new(" a  bc ".to_owned(), Span::new(file, 10..10 + length));
            parts(&text).into_iter().map(|part| (part.value, part.span.range())).collect()
        };
        assert_eq!(spans(7), [("a".to_owned(), 11..12), ("bc".to_owned(), 14..16)]);
        assert_eq!(spans(9), [("a".to_owned(), 10..19), ("bc".to_owned(), 10..19)]);
    }
}
