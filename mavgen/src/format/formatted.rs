//! The layout of a formatter: lines are broken at a width.
//!
//! rustfmt would break some lines elsewhere (it fills 100 columns, prettyplease 89), and orders modules otherwise. A program
//! cannot count on it: it may not be installed, it takes ten times as long, and its layout changes with the toolchain, where
//! the same definitions have to give the same bytes.

use crate::internal::Internal;

/// The text of a file that has this text in plain lines.
///
/// # Errors
/// If that is no Rust, which is a mistake of the emitters.
pub(super) fn formatted(lines: &str) -> Result<String, Internal> {
    let file = syn::parse_file(lines).map_err(|error| Internal::new(format!("generated code is no Rust: {error}")))?;
    Ok(prettyplease::unparse(&file))
}
