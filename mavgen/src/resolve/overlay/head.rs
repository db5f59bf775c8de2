//! The root element of an overlay: its version, and the file that it belongs to.

use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::read::Loaded;
use crate::source::Sources;
use crate::syntax::Text;

/// The version of the grammar that is understood.
const VERSION: &str = "1";

/// Checks the root elements of all overlays.
pub(in crate::resolve) fn check(loaded: &Loaded, sources: &Sources, diagnostics: &mut Diagnostics) {
    let files = loaded.files.iter().filter_map(|file| sources.get(file.id));
    let names: Vec<String> = files.map(|source| source.name()).collect();
    for overlay in &loaded.overlays {
        if let Some(version) = overlay.version.as_ref().filter(|version| version.value.trim() != VERSION) {
            let message = format!("overlays of version `{}` are not known", version.value);
            let problem = Diagnostic::new(Code::OverlayVersion, version.span, message);
            diagnostics.push(problem.help(format!("this mavgen reads version {VERSION}")));
        }
        if let Some(base) = overlay.base.as_ref().filter(|base| !names.contains(&base.value)) {
            diagnostics.extend(foreign(base, &names));
        }
    }
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
