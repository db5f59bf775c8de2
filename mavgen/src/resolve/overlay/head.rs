//! The root element of an overlay: its version, and the file that it belongs to.

use std::borrow::Cow;

use super::super::lost::Poisoned;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::read::Loaded;
use crate::source::Sources;
use crate::syntax::{Overlay, Text};

/// The version of the grammar that is understood.
const VERSION: &str = "1";

/// Checks the root elements of all overlays. Returns what is left to resolve: an overlay for another dialect is not judged by this one.
pub(in crate::resolve) fn check<'l>(
    loaded: &'l Loaded,
    sources: &Sources,
    poisoned: &mut Poisoned,
    diagnostics: &mut Diagnostics,
) -> Cow<'l, Loaded> {
    let files = loaded.files.iter().filter_map(|file| sources.get(file.id));
    let names = files.map(|source| source.name()).collect_vec();
    let is_foreign = |overlay: &Overlay| overlay.base.as_ref().is_some_and(|base| !names.contains(&base.value));
    for overlay in &loaded.overlays {
        if let Some(version) = overlay.version.as_ref().filter(|version| version.value.trim() != VERSION) {
            let message = format!("overlays of version `{}` are not known", version.value);
            let problem = Diagnostic::new(Code::OverlayVersion, version.span, message);
            diagnostics.push(problem.help(format!("this mavgen reads version {VERSION}")));
        }
        if let Some(base) = overlay.base.as_ref().filter(|_| is_foreign(overlay)) {
            diagnostics.extend(foreign(base, &names).filter(|_| !loaded.has_include(&base.value)));
            if !overlay.enums.is_empty() {
                poisoned.add(overlay.id);
            }
        }
    }
    if !loaded.overlays.iter().any(|overlay| is_foreign(overlay)) {
        return Cow::Borrowed(loaded);
    }
    let mut own = loaded.clone();
    own.overlays.retain(|overlay| !is_foreign(overlay));
    Cow::Owned(own)
}

/// Says that no file of the dialect has that name; nothing if there is no dialect, which was said before.
fn foreign(base: &Text, names: &[String]) -> Option<Diagnostic> {
    let (top, count) = (names.first()?, names.len());
    let message = format!("the overlay is for `{}`, which is not part of the dialect", base.value);
    let problem = Diagnostic::new(Code::OverlayBase, base.span, message).label("no file of this name was read");
    Some(match nearest(&base.value, names.iter().map(String::as_str)) {
        Some(name) => problem.help(format!("did you mean `{name}`?")),
        None if count == 1 => problem.help(format!("the dialect is `{top}`")),
        None => problem.help(format!("the dialect is `{top}` and the {} files that it includes", count - 1)),
    })
}
