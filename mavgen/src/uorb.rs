//! PX4's uORB messages: `.msg` files to what their bytes are, as CDR and in logs.
//!
//! A front end beside that of MAVLink: text is [`read`] to spanned [`syntax`], and [`load`] resolves what was asked for, and what
//! that nests, to a [`Package`](model::Package). The grammar is the one that PX4's own files use; what its generator refuses or
//! takes by accident is an error.

mod comment;
mod enums;
mod folder;
mod hash;
mod invalid;
mod layout;
mod line;
pub mod model;
mod names;
mod overlay;
pub(crate) mod placed;
mod read;
mod refine;
mod resolve;
mod scalar;
pub mod syntax;
#[cfg(test)]
mod tests;
pub mod union;

use std::path::Path;

pub use overlay::overlays;
pub use read::read;
pub use scalar::Scalar;

use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::select::Selection;
use crate::source::Sources;
use crate::syntax::uorb_overlay::Overlay;
use folder::Folder;
use overlay::Said;
use resolve::Resolver;

/// Reads the messages that `wanted` says of a folder of `.msg` files, and what they nest; other files are not opened. If `path`
/// is a file, it is the only one that may be wanted, and what it nests stands beside it. As in PX4's own tree, messages may also
/// stand in a folder `versioned` in the folder.
///
/// [Overlays](overlays) that are for the folder say what the files cannot; others are left out.
///
/// What is wrong goes to `diagnostics`; a message with a mistake is left out, and so is what nests it.
pub fn load(
    path: &Path,
    overlays: &[Overlay],
    wanted: impl Fn(&str) -> bool,
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> model::Package {
    let folder = match Folder::of(path) {
        Ok(folder) => folder,
        Err(problem) => {
            diagnostics.push(problem);
            return model::Package::default();
        }
    };
    let names = folder.meant(path).filter(|name| wanted(name)).map(str::to_owned).collect_vec();
    let said = Said::of(overlays, &folder, diagnostics);
    let mut resolver = Resolver::new(folder, said, sources, diagnostics);
    resolver.load(&names);
    for name in &names {
        resolver.message(name);
    }
    let package = resolver.finish();
    diagnostics.arrange();
    package
}

/// The messages of a folder of `.msg` files, or of the one file, that are meant by `names`: names as `EscStatus`, and patterns in
/// which `*` stands for any characters. Without names, all. Nothing is opened.
///
/// # Errors
///
/// With a sentence: a name is empty or means no message, or the folder cannot be read.
pub fn selected(path: &Path, names: &[String]) -> Result<Vec<String>, String> {
    let folder = Folder::of(path).map_err(|problem| problem.message)?;
    let all = || folder.meant(path);
    if names.is_empty() {
        return Ok(all().map(str::to_owned).collect_vec());
    }
    let selection = Selection::new(names.iter().map(String::as_str))?;
    selection.check_names(all, &path.display().to_string())?;
    Ok(all().filter(|name| selection.has(name)).map(str::to_owned).collect_vec())
}

/// The fields of a message as PX4's logs define them: `uint64_t timestamp;uint8_t[2] _padding0;`.
pub fn log_format(message: &model::Message, package: &model::Package) -> String {
    layout::log_format(message, &package.messages, true)
}

/// The same as a topic of its own has it: without the padding at its end, which a record lacks.
pub(crate) fn record_format(message: &model::Message, package: &model::Package) -> String {
    layout::log_format(message, &package.messages, false)
}

/// The topic that a message is named after: `EscStatus` is `esc_status`. PX4's rule: an underscore before each capital.
pub fn topic_name(message: &str) -> String {
    let mut name = String::new();
    for letter in message.chars() {
        if letter.is_ascii_uppercase() && !name.is_empty() {
            name.push('_');
        }
        name.push(letter.to_ascii_lowercase());
    }
    name
}
