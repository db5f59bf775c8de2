//! Overlays: which of them speak of a folder, and what they say of its messages.

use std::collections::HashMap;
use std::path::{Component, Path, PathBuf};

use super::folder::Folder;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::read::{self, absolute};
use crate::source::{Sources, Span};
use crate::syntax::Text;
use crate::syntax::uorb_overlay::{Message, Overlay};

/// The version of the grammar that is understood.
const VERSION: &str = "1";

/// Reads the overlays of uORB messages that are read from `folders`. What is wrong with their text goes to `diagnostics`, and
/// if one is for none of the folders. What they say is judged when the messages are [loaded](super::load).
pub fn overlays(
    paths: &[PathBuf],
    folders: &[&Path],
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> Vec<Overlay> {
    let mut all = Vec::new();
    for path in paths {
        let Some(id) = read::open(path, read::bytes_of(path), sources, diagnostics) else { continue };
        let overlay = read::read_uorb_overlay(id, sources, diagnostics);
        if let Some(version) = overlay.version.as_ref().filter(|version| version.value.trim() != VERSION) {
            let message = format!("overlays of version `{}` are not known", version.value);
            let problem = Diagnostic::new(Code::OverlayVersion, version.span, message);
            diagnostics.push(problem.help(format!("this mavgen reads version {VERSION}")));
        }
        diagnostics.extend(overlay.base.as_ref().and_then(|base| foreign(base, folders)));
        all.push(overlay);
    }
    all
}

/// Says that an overlay is for none of the folders.
fn foreign(base: &Text, folders: &[&Path]) -> Option<Diagnostic> {
    let folders = folders.iter().copied().map(Folder::path_of).collect_vec();
    if folders.iter().any(|folder| is_for(&base.value, folder)) {
        return None;
    }
    let message = format!("the overlay is for `{}`, and no messages are read from there", base.value);
    let problem = Diagnostic::new(Code::UorbOverlayFolder, base.span, message).label("no such folder is read");
    let last = folders.first().and_then(|folder| absolute(folder).file_name()?.to_str().map(str::to_owned));
    Some(match last {
        Some(last) => problem.help(format!("`for` is how the path of the folder ends: `for=\"{last}\"`")),
        None => problem,
    })
}

/// Whether the path of a folder ends so. Links are followed only if that is needed.
pub(super) fn is_for(base: &str, folder: &Path) -> bool {
    let wanted = Path::new(base.trim());
    let named = wanted.components().next().is_some_and(|first| matches!(first, Component::Normal(_)));
    named && (absolute(folder).ends_with(wanted) || folder.canonicalize().is_ok_and(|path| path.ends_with(wanted)))
}

/// What overlays say of the messages of a folder.
pub(super) struct Said<'o> {
    messages: HashMap<&'o str, &'o Message>,
}

impl<'o> Said<'o> {
    /// Of the overlays that are for this folder.
    pub(super) fn of(overlays: &'o [Overlay], folder: &Folder, diagnostics: &mut Diagnostics) -> Self {
        let mut messages: HashMap<&str, &Message> = HashMap::new();
        let own = overlays
            .iter()
            .filter(|overlay| overlay.base.as_ref().is_some_and(|base| is_for(&base.value, folder.path())));
        for message in own.flat_map(|overlay| &overlay.messages) {
            let name = &message.name;
            match messages.get(&*name.value) {
                Some(first) => diagnostics.push(twice(name, first.name.span)),
                None if !folder.has(&name.value) => diagnostics.push(missing(name, folder)),
                None => drop(messages.insert(&name.value, message)),
            }
        }
        Self { messages }
    }

    /// Of a message.
    pub(super) fn message(&self, name: &str) -> Option<&'o Message> {
        self.messages.get(name).copied()
    }
}

fn twice(name: &Text, first: Span) -> Diagnostic {
    let message = format!("overlays speak of message `{}` twice", name.value);
    let problem = Diagnostic::new(Code::DuplicateMessageName, name.span, message).related(first, "the first time");
    problem.help("put all that is said of it in one place")
}

fn missing(name: &Text, folder: &Folder) -> Diagnostic {
    let problem = Diagnostic::new(Code::OverlayMessage, name.span, format!("message `{}` does not exist", name.value));
    problem.label(format!("there is no file `{}.msg`", name.value)).meant(nearest(&name.value, folder.names()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_overlay_is_for_what_the_path_ends_with() {
        for (base, folder, expected) in [
            ("msg", "px4/msg", true),
            ("px4/msg", "px4/msg", true),
            ("px4/msg", "./px4/old/../msg", true),
            (" msg ", "msg", true),
            ("sg", "msg", false),
            ("px4/msg", "msg", false),
            ("", "msg", false),
            (".", "msg", false),
            ("/", "msg", false),
            ("../msg", "msg", false),
        ] {
            assert_eq!(is_for(base, Path::new(folder)), expected, "{base} {folder}");
        }
    }
}
