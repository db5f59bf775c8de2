//! Overlays: what they add to the model. They change nothing on the wire.

mod bind;
mod carrier;
mod condition;
mod credit;
mod head;
mod list;
mod note;
mod refine;
mod scene;

use std::collections::{HashMap, HashSet};

use super::invalid::Entries;
use super::losses::Losses;
use super::merge::Enums;
use super::message::Draft;
use super::suggest::suggest;
use super::view;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Binding, FileIndex, View};
use crate::read::Loaded;
use crate::source::{FileId, Span};
use crate::syntax::Text;
use crate::syntax::overlay::Additions;

pub(super) use carrier::{Carrier, CarrierPlace, check as check_carriers};
pub(super) use condition::resolve as condition;
pub(super) use credit::credit;
pub(super) use head::check as check_heads;
pub(super) use list::parts;
pub(super) use note::apply as note;
pub(super) use refine::apply as refine;
pub(super) use scene::{Found, Scene};

/// What an overlay adds to a message.
#[derive(Default)]
struct Added {
    views: Vec<View>,
    bindings: Vec<Binding>,
}

/// Resolves the views and bindings of all overlays into the messages that they belong to. Returns who carries which enum.
pub(super) fn resolve<'a>(
    loaded: &'a Loaded,
    drafts: &mut [Draft<'a>],
    enums: &Enums<'a>,
    losses: &Losses,
    diagnostics: &mut Diagnostics,
) -> Vec<Carrier<'a>> {
    let entries = Entries::of(enums);
    let mut messages = Messages::of(loaded, drafts);
    let mut carriers = Vec::new();
    let mut all = Vec::new();
    for (index, overlay) in loaded.overlays.iter().enumerate() {
        let file = FileIndex(loaded.files.len() + index);
        for additions in &overlay.messages {
            let Some((position, draft)) = messages.find(&additions.name, drafts, enums.complete, diagnostics) else {
                continue;
            };
            let whole = !losses.near(additions.span);
            let scene = Scene { file, whole, draft, enums, entries: &entries };
            all.push((position, add(&scene, additions, &mut carriers, diagnostics)));
        }
    }
    for (position, added) in all {
        if let Some(draft) = drafts.get_mut(position) {
            draft.message.views.extend(added.views);
            draft.message.bindings.extend(added.bindings);
        }
    }
    carriers
}

fn add<'a>(
    scene: &Scene<'_, 'a>,
    additions: &'a Additions,
    carriers: &mut Vec<Carrier<'a>>,
    diagnostics: &mut Diagnostics,
) -> Added {
    let mut added = Added::default();
    for element in &additions.bindings {
        added.bindings.extend(bind::resolve(scene, element, carriers, diagnostics));
    }
    for element in &additions.views {
        added.views.extend(view::resolve(scene, element, carriers, diagnostics));
    }
    added
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
