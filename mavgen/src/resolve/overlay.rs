//! Overlays: what they add to the model. They change nothing on the wire.

mod head;
mod refine;

use std::collections::HashMap;

use super::enums::Enums;
use super::invalid::Entries;
use super::lost::Poisoned;
use super::message::Draft;
use super::message_scope::MessageScope;
use super::origin::or_empty;
use super::uses::{EnumUse, UsePlace};
use super::{names, suggest, view};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Binding, View};
use crate::read::Loaded;
use crate::source::{FileId, Span};
use crate::syntax::Text;
use crate::syntax::overlay::Bind;

pub(super) use head::check as check_heads;
pub(super) use refine::apply as refine;

/// What an overlay adds to a message.
#[derive(Default)]
pub(super) struct Added {
    pub(super) views: Vec<View>,
    pub(super) bindings: Vec<Binding>,
}

/// Resolves the views and bindings of all overlays. Returns what they add to each of the drafts, and what carries which enum.
pub(super) fn resolve<'a>(
    loaded: &'a Loaded,
    drafts: &[Draft<'a>],
    (enums, entries): (&Enums<'a>, &Entries<'a>),
    poisoned: &Poisoned,
    diagnostics: &mut Diagnostics,
) -> (Vec<Added>, Vec<EnumUse<'a>>) {
    // Of each message that is defined the place of its draft, unless something is wrong with it.
    let mut places: HashMap<&str, Option<usize>> =
        loaded.messages().map(|message| (message.name.value.as_str(), None)).collect();
    places.extend(drafts.iter().enumerate().map(|(at, draft)| (draft.syntax.name.value.as_str(), Some(at))));
    let mut seen: HashMap<(&str, FileId), Span> = HashMap::new();
    let mut enum_uses = Vec::new();
    let mut all = drafts.iter().map(|_| Added::default()).collect_vec();
    for (file, overlay) in loaded.numbered_overlays() {
        for additions in &overlay.messages {
            let name = &additions.name;
            if let Some(first) = seen.insert((&name.value, name.span.file), name.span) {
                diagnostics.push(twice(name, first));
            }
            let place = places.get(name.value.as_str()).copied();
            let found = place.flatten().and_then(|at| Some((drafts.get(at)?, all.get_mut(at)?)));
            let Some((draft, Added { views, bindings })) = found else {
                if enums.complete && place.is_none() {
                    report_unknown(name, drafts, diagnostics);
                }
                continue;
            };
            let whole = !poisoned.near(additions.span);
            let enum_uses = &mut enum_uses;
            let mut scope = MessageScope { file, whole, draft, enums, entries, enum_uses, diagnostics };
            bindings.extend(additions.bindings.iter().filter_map(|element| bind(&mut scope, element)));
            views.extend(additions.views.iter().filter_map(|element| view::resolve(&mut scope, element)));
        }
    }
    (all, enum_uses)
}

/// `<bind>`: an enum on a field that the definitions give none.
fn bind<'a>(scope: &mut MessageScope<'_, 'a>, element: &'a Bind) -> Option<Binding> {
    names::check(&element.name, "a binding", scope.diagnostics);
    let condition = scope.condition(&element.condition);
    let enum_ = scope.enums.find(&element.enum_, scope.diagnostics);
    let found = scope.field(&element.field)?;
    let span = element.field.span;
    let Some(repr) = found.scalar_repr() else {
        return scope.refuse_type(
            Code::Bind,
            span,
            found,
            ("cannot carry an enum", "an enum can be bound to a scalar integer"),
        );
    };
    if let Some(own) = &found.syntax.enum_ {
        let message = format!("`{}.{}` carries enum `{}` already", scope.name(), element.field.value, own.value);
        let problem = Diagnostic::new(Code::Bind, span, message).related(own.span, "as the definitions say");
        return scope.refuse(problem.help("a field carries one enum; leave the binding out"));
    }
    let enum_ = enum_?;
    let place = (UsePlace::Field(repr), found.syntax.ty.span);
    scope.enum_uses.push(EnumUse { enum_, name: &element.enum_, place });
    Some(Binding {
        name: names::label(&element.name),
        field: found.index,
        enum_,
        condition,
        description: or_empty(&element.description),
    })
}

fn twice(name: &Text, first: Span) -> Diagnostic {
    let message = format!("message `{}` stands twice in the overlay", name.value);
    let problem = Diagnostic::new(Code::DuplicateMessageName, name.span, message);
    problem.related(first, "the first one").help("put all that is said of it in one place")
}

fn report_unknown(name: &Text, drafts: &[Draft<'_>], diagnostics: &mut Diagnostics) {
    let message = format!("message `{}` does not exist", name.value);
    let problem = Diagnostic::new(Code::OverlayMessage, name.span, message).label("no such message");
    let mut names = drafts.iter().map(|draft| draft.syntax.name.value.as_str());
    suggest::report(problem, &name.value, &mut names, diagnostics);
}
