//! Two hundred mistakes and more: each is a small change to a good definition or overlay, and is told with its code, at its
//! place, and alone.
//!
//! A `‸` in what is put in marks where the diagnostic has to point; it is taken out before the text is read. Without one only
//! the code counts.

#![expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may panic")]

mod enums;
mod grammar;
mod messages;
mod names;
mod numbers;
mod overlays;
mod xml;

use mavgen::Resolved;
use mavgen::diag::Diagnostics;
use mavgen::read::{Loaded, read, read_overlay};
use mavgen::source::Sources;

const BASE: &str = include_str!("malformed/base.xml");
const OVERLAY: &str = include_str!("malformed/base.overlay.xml");

/// Marks the place of the diagnostic.
const MARK: char = '‸';

/// A change and what has to be said of it.
struct Mutation {
    code: &'static str,
    what: &'static str,
    find: &'static str,
    put: &'static str,
}

const fn m(code: &'static str, what: &'static str, find: &'static str, put: &'static str) -> Mutation {
    Mutation { code, what, find, put }
}

/// The problems of a definition with an overlay, as `M304 7:20`.
fn problems(definition: &str, overlay: Option<&str>) -> Vec<String> {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let file = read(sources.add("base.xml", definition), &sources, &mut diagnostics);
    let mut loaded =
        Loaded { name: "base".to_owned(), files: vec![file.into()], includes: vec![Vec::new()], ..Loaded::default() };
    if let Some(text) = overlay {
        let overlay = read_overlay(sources.add("base.overlay.xml", text), &sources, &mut diagnostics);
        loaded.overlays.push(overlay.into());
    }
    let (sources, diagnostics) = match Resolved::of(loaded, sources, diagnostics) {
        Ok(Resolved { sources, diagnostics, .. }) => (sources, diagnostics),
        Err(problems) => (problems.sources, problems.diagnostics),
    };
    let place = |span: mavgen::source::Span| sources.get(span.file).unwrap().position(span.start);
    let placed = diagnostics.iter().map(|problem| (problem.code, place(problem.span.unwrap())));
    placed.map(|(code, at)| format!("{code} {}:{}", at.line, at.column)).collect()
}

/// The text with the change, and where it has to be told.
fn mutated(base: &str, mutation: &Mutation) -> (String, Option<(usize, usize)>) {
    assert_eq!(base.matches(mutation.find).count(), 1, "{}: `{}` is not there once", mutation.what, mutation.find);
    let marked = base.replace(mutation.find, mutation.put);
    let place = marked.split_once(MARK).map(|(before, _)| {
        let line = before.rsplit('\n').next().unwrap();
        (before.matches('\n').count() + 1, line.chars().count() + 1)
    });
    (marked.replace(MARK, ""), place)
}

/// Runs a table of mutations; `of` makes the problems of a mutated text.
fn run(base: &str, mutations: &[Mutation], of: impl Fn(&str) -> Vec<String>) -> usize {
    assert_eq!(of(base), [""; 0], "before any change");
    let mut wrong = Vec::new();
    for mutation in mutations {
        let (text, place) = mutated(base, mutation);
        let found = of(&text);
        let as_said = match place {
            Some((line, column)) => found == [format!("{} {line}:{column}", mutation.code)],
            None => found.len() == 1 && found[0].starts_with(mutation.code),
        };
        if !as_said {
            let place = place.map(|(line, column)| format!(" {line}:{column}")).unwrap_or_default();
            wrong.push(format!("{}: {}{place} is expected, {found:?} is told", mutation.what, mutation.code));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    mutations.len()
}

#[test]
fn mistakes_in_definitions_are_told_where_they_are() {
    let tables = [
        xml::MUTATIONS,
        grammar::MUTATIONS,
        numbers::MUTATIONS,
        messages::MUTATIONS,
        enums::MUTATIONS,
        names::MUTATIONS,
    ];
    let all: usize = tables.iter().map(|table| run(BASE, table, |text| problems(text, None))).sum();
    assert!(all >= 200, "only {all}");
}

#[test]
fn mistakes_in_overlays_are_told_where_they_are() {
    let all = run(OVERLAY, overlays::MUTATIONS, |text| problems(BASE, Some(text)));
    assert!(all >= 50, "only {all}");
}
