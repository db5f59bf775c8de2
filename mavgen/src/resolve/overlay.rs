//! Overlays: what they add to the model. They change nothing on the wire.

mod bind;
mod command;
mod head;
mod refine;

use std::collections::{HashMap, HashSet};

use super::enums::Enums;
use super::invalid::Entries;
use super::message::Draft;
use super::message_scope::{EnumUse, MessageScope};
use super::poisoned::Poisoned;
use super::suggest::suggest;
use super::view;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Binding, FileIndex, View};
use crate::read::Loaded;
use crate::source::{FileId, Span};
use crate::syntax::Text;
use crate::syntax::overlay::Additions;

pub(super) use command::Commands;
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
    for (index, overlay) in loaded.overlays.iter().enumerate() {
        let file = FileIndex(loaded.files.len() + index);
        for additions in &overlay.messages {
            let Some((position, draft)) = messages.find(&additions.name, drafts, enums.complete, diagnostics) else {
                continue;
            };
            let whole = !poisoned.near(additions.span);
            let scope = MessageScope { file, whole, draft, enums, entries };
            let Some(added) = all.get_mut(position) else { continue };
            add(&scope, additions, added, &mut enum_uses, diagnostics);
        }
    }
    (all, enum_uses)
}

fn add<'a>(
    scope: &MessageScope<'_, 'a>,
    additions: &'a Additions,
    added: &mut Added,
    enum_uses: &mut Vec<EnumUse<'a>>,
    diagnostics: &mut Diagnostics,
) {
    for element in &additions.bindings {
        added.bindings.extend(bind::resolve(scope, element, enum_uses, diagnostics));
    }
    for element in &additions.views {
        added.views.extend(view::resolve(scope, element, enum_uses, diagnostics));
    }
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
        let all = loaded.files.iter().flat_map(|file| &file.messages);
        Self {
            drafted: named.collect(),
            defined: all.map(|message| message.name.value.as_str()).collect(),
            added: HashMap::new(),
        }
    }

    /// The message that an overlay speaks of.
    fn find<'d>(
        &mut self,
        name: &'a Text,
        drafts: &'d [Draft<'a>],
        complete: bool,
        diagnostics: &mut Diagnostics,
    ) -> Option<(usize, &'d Draft<'a>)> {
        if let Some(first) = self.added.insert((&name.value, name.span.file), name.span) {
            let message = format!("message `{}` stands twice in the overlay", name.value);
            let problem = Diagnostic::new(Code::DuplicateMessageName, name.span, message);
            diagnostics.push(problem.related(first, "the first one").help("put all that is said of it in one place"));
        }
        if let Some(&position) = self.drafted.get(name.value.as_str()) {
            return drafts.get(position).map(|draft| (position, draft));
        }
        if complete && !self.defined.contains(name.value.as_str()) {
            let message = format!("message `{}` does not exist", name.value);
            let problem = Diagnostic::new(Code::OverlayMessage, name.span, message).label("no such message");
            // In the order of the definitions, so that of two equally near names it is always the same.
            let names = drafts.iter().map(|draft| draft.syntax.name.value.as_str());
            let problem = suggest(problem, &name.value, names, diagnostics);
            diagnostics.push(problem);
        }
        None
    }
}
