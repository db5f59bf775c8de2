//! Messages of several definitions do not nest each other in a circle.

use super::{Field, Message};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::uorb::model::Element;

/// How far the search has come with a message.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Seen {
    Not,
    Begun,
    Done,
}

/// Reports what nests itself: no definition does so alone, but one may nest what nests it in another.
pub(super) fn check(messages: &[Message], diagnostics: &mut Diagnostics) {
    let mut seen = vec![Seen::Not; messages.len()];
    for at in 0..messages.len() {
        visit(at, messages, &mut seen, diagnostics);
    }
}

fn visit(at: usize, messages: &[Message], seen: &mut [Seen], diagnostics: &mut Diagnostics) {
    let (Some(message), Some(state)) = (messages.get(at), seen.get_mut(at)) else { return };
    if *state != Seen::Not {
        return;
    }
    *state = Seen::Begun;
    for field in &message.fields {
        let Element::Message(nested) = field.element else { continue };
        match seen.get(nested.0) {
            Some(Seen::Begun) => diagnostics.push(circle(message, field)),
            _ => visit(nested.0, messages, seen, diagnostics),
        }
    }
    seen.get_mut(at).into_iter().for_each(|state| *state = Seen::Done);
}

fn circle(message: &Message, field: &Field) -> Diagnostic {
    let text = format!("with what other definitions have, `{}` nests itself by `{}`", message.name, field.name);
    Diagnostic::new(Code::UorbUnion, field.span, text).help("leave one of the definitions out")
}
