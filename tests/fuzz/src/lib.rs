//! What the targets for definitions have in common.

use mavgen::diag::{Diagnostics, Style, render};
use mavgen::read::{Loaded, read, read_overlay};
use mavgen::source::Sources;
use mavgen::{Builder, Resolved};

/// Problems that are drawn: a hundred thousand of one kind say no more.
const DRAWN: usize = 20;

/// Reads, resolves and generates.
///
/// # Panics
///
/// If a problem has no place, if what has errors is accepted or the reverse, or if generated text is not Rust.
pub fn compile(dialect: &str, overlay: Option<&str>) {
    let (mut sources, mut diagnostics, mut loaded) = (Sources::default(), Diagnostics::default(), Loaded::default());
    "a".clone_into(&mut loaded.name);
    let id = sources.add("a.xml", dialect);
    loaded.files.push(read(id, &sources, &mut diagnostics).into());
    loaded.includes.push(Vec::new());
    if let Some(overlay) = overlay {
        let id = sources.add("a.overlay.xml", overlay);
        loaded.overlays.push(read_overlay(id, &sources, &mut diagnostics));
    }
    let outcome = Resolved::of(loaded, sources, diagnostics);
    let (diagnostics, sources) = match &outcome {
        Ok(resolved) => (&resolved.diagnostics, &resolved.sources),
        Err(problems) => (&problems.diagnostics, &problems.sources),
    };
    assert_eq!(outcome.is_err(), diagnostics.has_errors());
    for problem in diagnostics.iter().take(DRAWN) {
        assert!(problem.span.is_some());
        render(problem, sources, Style::Plain);
    }
    let Ok(resolved) = &outcome else { return };
    for file in Builder::new("a.xml").emit(resolved).unwrap_or_default() {
        assert!(syn::parse_file(&file.text).is_ok(), "{}", file.text);
    }
}
