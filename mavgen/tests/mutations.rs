//! Real dialects, mutated: whatever comes of it is refused with a place, or becomes Rust that parses. Never a panic.
//!
//! A case is an excerpt of the definitions in this repository (whole files of 200 messages would cost a second each) with a few
//! tags or attributes deleted, doubled, swapped or spoilt. `PROPTEST_CASES=100000 cargo test --release -p mavgen --test mutations`
//! tries more of them.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

#[cfg(feature = "vendor")]
mod copy;
mod edit;
mod excerpt;

use std::sync::LazyLock;

use mavgen::diag::{Diagnostics, Severity, Style, one_line, render};
use mavgen::read::{Loaded, read, read_overlay};
use mavgen::source::Sources;
use mavgen::{Builder, Resolved};
use proptest::prelude::*;

use edit::Edit;
use excerpt::Definitions;

static DEFINITIONS: LazyLock<Definitions> = LazyLock::new(|| {
    Definitions::of(
        &["autoquad", "common", "standard", "minimal"]
            .map(|name| std::fs::read_to_string(format!("../xml/{name}.xml")).unwrap()),
    )
});

static OVERLAY: LazyLock<String> = LazyLock::new(|| std::fs::read_to_string("../xml/overlay/autoquad.xml").unwrap());

/// A dialect that the overlay suits.
static CARRIERS: LazyLock<String> = LazyLock::new(|| DEFINITIONS.carriers());

/// What became of a case.
#[derive(Debug, PartialEq, Eq)]
enum Fate {
    /// With the first error.
    Refused(String),
    Generated,
}

/// Reads, resolves and generates; fails if a problem has no place, or generated text does not parse.
fn fate(dialect: &str, overlay: Option<&str>) -> Result<Fate, TestCaseError> {
    let (mut sources, mut diagnostics, mut loaded) = (Sources::default(), Diagnostics::default(), Loaded::default());
    "autoquad".clone_into(&mut loaded.name);
    let id = sources.add("autoquad.xml", dialect);
    loaded.files.push(read(id, &sources, &mut diagnostics).into());
    loaded.includes.push(Vec::new());
    if let Some(overlay) = overlay {
        let id = sources.add("autoquad.overlay.xml", overlay);
        loaded.overlays.push(read_overlay(id, &sources, &mut diagnostics).into());
    }
    let outcome = Resolved::of(loaded, sources, diagnostics);
    let (diagnostics, sources) = match &outcome {
        Ok(resolved) => (&resolved.diagnostics, &resolved.sources),
        Err(problems) => (&problems.diagnostics, &problems.sources),
    };
    prop_assert_eq!(outcome.is_err(), diagnostics.has_errors());
    for problem in diagnostics.iter() {
        prop_assert!(problem.span.is_some(), "{}", one_line(problem, sources));
        prop_assert!(render(problem, sources, Style::Plain).contains("--> autoquad."));
    }
    let Ok(resolved) = &outcome else {
        let mut errors = diagnostics.iter().filter(|problem| problem.severity() == Severity::Error);
        return Ok(Fate::Refused(errors.next().map(|error| one_line(error, sources)).unwrap()));
    };
    for file in Builder::new("autoquad.xml").emit(resolved).unwrap() {
        let parsed = syn::parse_file(&file.text);
        prop_assert!(parsed.is_ok(), "{}: {:?}\n{}", file.path, parsed.err(), file.text);
    }
    Ok(Fate::Generated)
}

#[test]
fn the_definitions_themselves_are_accepted() {
    let definitions = &*DEFINITIONS;
    assert!(definitions.messages() > 200 && definitions.enums() > 100);
    for first in (0..definitions.messages()).step_by(7) {
        assert_eq!(fate(&definitions.excerpt(&[first, first + 1]), None).unwrap(), Fate::Generated);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(1500), ..ProptestConfig::default() })]

    #[test]
    fn a_mutated_dialect_is_refused_or_becomes_rust(
        picks in prop::collection::vec(0..1000_usize, 1..4),
        edits in prop::collection::vec(edit::any(), 1..4),
    ) {
        let text = edits.iter().fold(DEFINITIONS.excerpt(&picks), |text, edit: &Edit| edit.apply(&text));
        fate(&text, None)?;
    }
}

#[cfg(feature = "vendor")]
proptest! {
    #[test]
    fn a_copy_of_a_mutated_dialect_generates_the_same(
        picks in prop::collection::vec(0..1000_usize, 1..4),
        edits in prop::collection::vec(edit::any(), 1..4),
        pick: usize,
    ) {
        let text = edits.iter().fold(DEFINITIONS.excerpt(&picks), |text, edit: &Edit| edit.apply(&text));
        copy::holds(&text, pick)?;
    }
}

proptest! {
    #[test]
    fn a_mutated_overlay_is_refused_or_becomes_rust(edits in prop::collection::vec(edit::any(), 1..3)) {
        let text = edits.iter().fold(OVERLAY.clone(), |text, edit: &Edit| edit.apply(&text));
        fate(&CARRIERS, Some(&text))?;
    }
}

#[test]
fn the_overlay_itself_is_accepted() {
    assert_eq!(fate(&CARRIERS, Some(&OVERLAY)).unwrap(), Fate::Generated);
}
