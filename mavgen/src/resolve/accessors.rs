//! The methods of messages: accessors of fields, and what overlays add, must have different names.

use std::collections::HashMap;

use super::message::Draft;
use super::view;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Field, Message, Scalar, Values};
use crate::names::MESSAGE_METHODS;
use crate::read::Loaded;
use crate::source::Span;
use crate::syntax::overlay::Additions;

/// The methods of a message so far: what each belongs to, and where that is defined.
type Methods = HashMap<String, (String, Option<Span>)>;

/// Checks the methods of all messages.
pub(super) fn check(loaded: &Loaded, drafts: &[Draft<'_>], diagnostics: &mut Diagnostics) {
    let mut additions: HashMap<&str, Vec<&Additions>> = HashMap::new();
    for added in loaded.overlays.iter().flat_map(|overlay| &overlay.messages) {
        additions.entry(&added.name.value).or_default().push(added);
    }
    for draft in drafts {
        let mut methods = accessors(draft, diagnostics);
        let added = additions.get(draft.syntax.name.value.as_str()).map(Vec::as_slice).unwrap_or_default();
        check_added(&draft.message, added, &mut methods, diagnostics);
    }
}

/// Whether a field has a getter and a setter beside it.
fn has_accessors(field: &Field) -> bool {
    let text = field.ty.scalar == Scalar::Char && field.ty.array.is_some();
    matches!(field.values, Some(Values::Converted(_))) || field.invalid.is_some() && !text
}

/// The accessors of the fields. Of two fields whose accessors share a name, the first in the XML has them, which is said: a
/// definition that is valid elsewhere is not refused.
fn accessors(draft: &Draft<'_>, diagnostics: &mut Diagnostics) -> Methods {
    let mut methods = Methods::new();
    methods.extend(MESSAGE_METHODS.map(|name| (name.to_owned(), ("a method of every message".to_owned(), None))));
    for (field, syntax) in draft.fields().filter(|(field, _)| has_accessors(field)) {
        let names = [field.name.rust.clone(), format!("set_{}", field.name.rust)];
        if let Some((name, (_, first))) = names.iter().find_map(|name| methods.get_key_value(name)) {
            // A name that every message has is no mistake of the definition's.
            let Some(first) = *first else { continue };
            let message = format!("field `{}` has no getter and setter: `{name}` is there already", syntax.name.value);
            let problem = Diagnostic::new(Code::AccessorLost, syntax.name.span, message);
            diagnostics.push(problem.related(first, format!("this field has `{name}`")));
            continue;
        }
        let owner = (format!("a method of field `{}`", syntax.name.value), Some(syntax.name.span));
        methods.extend(names.map(|name| (name, owner.clone())));
    }
    methods
}

/// Checks what overlays add.
fn check_added(message: &Message, added: &[&Additions], methods: &mut Methods, diagnostics: &mut Diagnostics) {
    let mut claim = |names: Vec<String>, what: String, span: Span| {
        if let Some((name, (other, first))) = names.iter().find_map(|name| methods.get_key_value(name)) {
            let text = format!("`{name}` is a method of {what}, and {other} as well");
            let problem = Diagnostic::new(Code::NameCollision, span, text).help("rename one of them");
            diagnostics.push(match first {
                Some(first) => problem.related(*first, "the other one"),
                None => problem,
            });
            return;
        }
        methods.extend(names.into_iter().map(|name| (name, (format!("a method of {what}"), Some(span)))));
    };
    for element in added.iter().flat_map(|added| &added.bindings) {
        let rust = crate::names::field_name(&element.name.value);
        claim(vec![format!("set_{rust}"), rust], format!("binding `{}`", element.name.value), element.name.span);
    }
    for element in added.iter().flat_map(|added| &added.views) {
        let Some(view) = message.views.iter().find(|view| view.origin.span == element.span) else { continue };
        let place = element.item.as_ref().map_or(element.name.span, |item| item.span);
        claim(view::getters(view), format!("view `{}`", element.name.value), place);
    }
}
