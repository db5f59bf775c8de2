//! Overlays: what they add to the model. They change nothing on the wire.

mod bind;
mod head;
mod refine;

use std::collections::{HashMap, HashSet};

use super::enums::Enums;
use super::invalid::Entries;
use super::message::Draft;
use super::message_scope::MessageScope;
use super::poisoned::Poisoned;
use super::uses::EnumUse;
use super::{suggest, view};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Binding, View};
use crate::read::Loaded;
use crate::source::{FileId, Span};
use crate::syntax::Text;

pub(super) use head::check as check_heads;
pub(super) use refine::apply as refine;

/// What an overlay adds to a message.
#[derive(Default)]
pub(super) struct Added {
    /// `<view>`.
    pub(super) views: Vec<View>,
    /// `<bind>`.
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
    let mut messages = Messages::of(loaded, drafts);
    let mut enum_uses = Vec::new();
    let mut all = drafts.iter().map(|_| Added::default()).collect_vec();
    for (file, overlay) in loaded.numbered_overlays() {
        for additions in &overlay.messages {
            let position = messages.find(&additions.name, drafts, enums.complete, diagnostics);
            let found = position.and_then(|at| Some((drafts.get(at)?, all.get_mut(at)?)));
            let Some((draft, Added { views, bindings })) = found else { continue };
            let whole = !poisoned.near(additions.span);
            let enum_uses = &mut enum_uses;
            let mut scope = MessageScope { file, whole, draft, enums, entries, enum_uses, diagnostics };
            bindings.extend(additions.bindings.iter().filter_map(|element| bind::resolve(&mut scope, element)));
            views.extend(additions.views.iter().filter_map(|element| view::resolve(&mut scope, element)));
        }
    }
    (all, enum_uses)
}

/// The messages by name.
struct Messages<'a> {
    /// Places in the drafts.
    drafted: HashMap<&'a str, usize>,
    /// All that are defined, even if something is wrong with them.
    defined: HashSet<&'a str>,
    /// Where overlays have added to a message already.
    added: HashMap<(&'a str, FileId), Span>,
}

impl<'a> Messages<'a> {
    fn of(loaded: &'a Loaded, drafts: &[Draft<'a>]) -> Self {
        let named = drafts.iter().enumerate().map(|(index, draft)| (draft.syntax.name.value.as_str(), index));
        let defined = loaded.messages().map(|message| message.name.value.as_str()).collect();
        Self { drafted: named.collect(), defined, added: HashMap::new() }
    }

    /// The message that an overlay speaks of, by its place in the drafts.
    fn find(
        &mut self,
        name: &'a Text,
        drafts: &[Draft<'_>],
        complete: bool,
        diagnostics: &mut Diagnostics,
    ) -> Option<usize> {
        if let Some(first) = self.added.insert((&name.value, name.span.file), name.span) {
            let message = format!("message `{}` stands twice in the overlay", name.value);
            let problem = Diagnostic::new(Code::DuplicateMessageName, name.span, message);
            diagnostics.push(problem.related(first, "the first one").help("put all that is said of it in one place"));
        }
        let position = self.drafted.get(name.value.as_str()).copied();
        if position.is_none() && complete && !self.defined.contains(name.value.as_str()) {
            let message = format!("message `{}` does not exist", name.value);
            let problem = Diagnostic::new(Code::OverlayMessage, name.span, message).label("no such message");
            // In the order of the definitions, so that of two equally near names it is always the same.
            let mut names = drafts.iter().map(|draft| draft.syntax.name.value.as_str());
            suggest::report(problem, &name.value, &mut names, diagnostics);
        }
        position
    }
}
