//! Any text as a dialect: refused with a place, or it becomes Rust that parses.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavgen::diag::{Diagnostics, Style, render};
use mavgen::read::{Loaded, read};
use mavgen::resolve::resolve;
use mavgen::source::Sources;
use mavgen::{Builder, Resolved};

fuzz_target!(|text: &str| {
    let (mut sources, mut diagnostics, mut loaded) = (Sources::default(), Diagnostics::default(), Loaded::default());
    "a".clone_into(&mut loaded.name);
    let id = sources.add("a.xml", text);
    loaded.files.push(read(id, &sources, &mut diagnostics).into());
    loaded.includes.push(Vec::new());
    let dialect = resolve(&loaded, &sources, &mut diagnostics);
    assert_eq!(dialect.is_none(), diagnostics.has_errors());
    for problem in diagnostics.iter().take(20) {
        assert!(problem.span.is_some());
        render(problem, &sources, Style::Plain);
    }
    let Some(dialect) = dialect else { return };
    let resolved = Resolved { dialect, others: Vec::new(), union: None, diagnostics, sources, watched: Vec::new() };
    for file in Builder::new("a.xml").emit(&resolved).unwrap_or_default() {
        assert!(syn::parse_file(&file.text).is_ok(), "{}", file.text);
    }
});
