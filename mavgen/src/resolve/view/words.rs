//! `words`: the fields whose bits a view is read from, least significant first.

use std::num::NonZeroU8;

use super::place::{self, Index};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Place, Word};
use crate::resolve::message_scope::{Found, MessageScope, parts};
use crate::source::Span;
use crate::syntax::Text;

/// How many bits a view can have: there is no larger integer.
const MOST_BITS: usize = 128;

/// The words of a view.
pub(super) struct Words {
    /// Least significant first.
    pub(super) list: Vec<Word>,
    /// Bits of all of them together.
    pub(super) width: u8,
    /// The slots, if each has its own elements.
    pub(super) shape: Option<Shape>,
    /// The attribute.
    pub(super) span: Span,
}

/// The slots of arrays that lie side by side.
#[derive(Clone, Copy)]
pub(super) struct Shape {
    /// How many.
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
pub(super) fn resolve(scope: &MessageScope<'_, '_>, text: &Text, diagnostics: &mut Diagnostics) -> Option<Words> {
    let parts = parts(text);
    if parts.is_empty() {
        diagnostics.push(Diagnostic::new(Code::Words, text.span, "a view of no words").help("name a field"));
        return None;
    }
    let read = parts.into_iter().map(|part| one(scope, part, diagnostics)).collect_vec();
    let read = read.into_iter().collect::<Option<Vec<Read<'_>>>>()?;
    check_once(&read, diagnostics)?;
    let shape = shape(&read, diagnostics)?;
    let width = width(scope, text, &read, diagnostics)?;
    Some(Words { list: read.iter().map(|read| read.word).collect_vec(), width, shape, span: text.span })
}

fn one<'s>(scope: &MessageScope<'s, '_>, text: Text, diagnostics: &mut Diagnostics) -> Option<Read<'s>> {
    let (found, index) = place::found(scope, &text, diagnostics)?;
    let ty = found.field.ty;
    if !ty.scalar.is_word() {
        let (message, spelled) = (scope.name(), &found.syntax.ty);
        let message = format!("`{message}.{}` is `{}`, which is no word", found.syntax.name.value, spelled.value);
        let problem = Diagnostic::new(Code::WordType, text.span, message).related(spelled.span, "the field");
        diagnostics.push(
            problem.help("words are unsigned integers, `uint8_t` to `uint64_t`, and the bits of `float` and `double`"),
        );
        return None;
    }
    let element = 8 * ty.scalar.size();
    let (word, bits) = match index {
        Index::All => (Word::Joined(found.index), 8 * ty.size()),
        Index::Slot => (Word::One(Place { field: found.index, element: true }), element),
        Index::None => (Word::One(Place { field: found.index, element: false }), element),
    };
    Some(Read { text, word, found, bits })
}

/// No word stands twice: a setter would contradict itself.
fn check_once(read: &[Read<'_>], diagnostics: &mut Diagnostics) -> Option<()> {
    let mut once = Some(());
    for (index, word) in read.iter().enumerate() {
        let before = read.iter().take(index).find(|before| before.found.index == word.found.index);
        if let Some(before) = before {
            let message = format!("`{}` is a word of the view already", word.text.value);
            let problem = Diagnostic::new(Code::Words, word.text.span, message);
            diagnostics.push(problem.related(before.text.span, "the first time").help("leave one of them out"));
            once = None;
        }
    }
    once
}

/// The slots, if the words are elements; that all of them are, and of arrays of one length.
fn shape(read: &[Read<'_>], diagnostics: &mut Diagnostics) -> Option<Option<Shape>> {
    let is_element = |read: &&Read<'_>| matches!(read.word, Word::One(Place { element: true, .. }));
    let Some(first) = read.iter().find(is_element) else { return Some(None) };
    if let Some(whole) = read.iter().find(|read| !is_element(read)) {
        let message = format!("`{}` is the same for every slot, and `{}` is not", whole.text.value, first.text.value);
        let problem = Diagnostic::new(Code::WordsMixed, whole.text.span, message);
        let problem = problem.related(first.text.span, "an element for each slot");
        diagnostics.push(problem.help("make all words elements (`x[i]`), or none"));
        return None;
    }
    let length = first.found.field.ty.array?;
    let other = read.iter().find(|read| read.found.field.ty.array != Some(length));
    if let Some(other) = other {
        diagnostics.push(place::length_differs(&other.text, other.found, length, first.found.syntax.ty.span));
        return None;
    }
    Some(Some(Shape { length, span: first.found.syntax.ty.span }))
}

fn width(scope: &MessageScope<'_, '_>, text: &Text, read: &[Read<'_>], diagnostics: &mut Diagnostics) -> Option<u8> {
    let bits: usize = read.iter().map(|read| read.bits).sum();
    if bits <= MOST_BITS {
        return u8::try_from(bits).ok();
    }
    let terms = read.iter().map(|read| read.bits.to_string()).collect_vec();
    let sum = if terms.len() > 1 { format!("{} = {bits}", terms.join(" + ")) } else { bits.to_string() };
    let message = format!("the words are {sum} bits wide; {MOST_BITS} are allowed");
    let mut problem = Diagnostic::new(Code::WordsTooWide, text.span, message);
    for read in read {
        let (name, ty) = (&read.found.syntax.name.value, &read.found.syntax.ty);
        problem = problem.related(ty.span, format!("`{}.{name}`", scope.name()));
    }
    diagnostics.push(problem.help("there is no larger integer: read the words in several views"));
    None
}
