//! What the targets for definitions have in common; what those for protocols have is in [`services`].

pub mod services;

use std::path::{Path, PathBuf};
use std::{env, fs, process};

use mavgen::diag::{Diagnostics, Style, render};
use mavgen::read::{Loaded, read, read_overlay};
use mavgen::source::Sources;
use mavgen::uorb;
use mavgen::uorb::model::{Element, Message, Package};
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
        loaded.overlays.push(read_overlay(id, &sources, &mut diagnostics).into());
    }
    let outcome = Resolved::of(loaded, sources, diagnostics);
    let (diagnostics, sources) = match &outcome {
        Ok(resolved) => (&resolved.diagnostics, &resolved.sources),
        Err(problems) => (&problems.diagnostics, &problems.sources),
    };
    assert_eq!(outcome.is_err(), diagnostics.has_errors());
    draw(diagnostics, sources);
    let Ok(resolved) = &outcome else { return };
    for file in Builder::new("a.xml").emit(resolved).unwrap_or_default() {
        assert!(syn::parse_file(&file.text).is_ok(), "{}", file.text);
    }
}

fn draw(diagnostics: &Diagnostics, sources: &Sources) {
    for problem in diagnostics.iter().take(DRAWN) {
        assert!(problem.span.is_some());
        render(problem, sources, Style::Plain);
    }
}

/// Reads and resolves a `.msg` file, and what begins with `<uorb-overlay` as an overlay for its folder `msg`. It may nest `Nested`.
///
/// # Panics
///
/// If a problem has no place, if what is fine is not there, or if its fields are not where they can be. And if nothing can be
/// written to the folder for temporary files.
pub fn resolve_message(text: &str) {
    let (message, overlay) = text.split_at(text.find("<uorb-overlay").unwrap_or(text.len()));
    let folder = scratch();
    let overlays = [folder.join("a.overlay.xml")];
    for (path, text) in [(folder.join("A.msg"), message), (overlays[0].clone(), overlay)] {
        assert!(fs::write(path, text).is_ok());
    }
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let overlays = if overlay.is_empty() { &[][..] } else { &overlays };
    let overlays = uorb::overlays(overlays, &[&folder], &mut sources, &mut diagnostics);
    let package = uorb::load(&folder.join("A.msg"), &overlays, |_| true, &mut sources, &mut diagnostics);
    draw(&diagnostics, &sources);
    let found = package.messages.iter().find(|message| message.name == "A");
    assert!(found.is_some() || diagnostics.has_errors());
    package.messages.iter().for_each(|message| check(message, &package));
}

/// A folder `msg` with the message `Nested`, for this process.
fn scratch() -> PathBuf {
    let folder = env::temp_dir().join(format!("mavgen-fuzz-{}", process::id())).join("msg");
    if !Path::new(&folder).is_dir() {
        assert!(fs::create_dir_all(&folder).is_ok());
        assert!(fs::write(folder.join("Nested.msg"), "uint64 timestamp\nint16[3] x\nuint8 y\n").is_ok());
    }
    folder
}

/// Fields lie one behind the other in both layouts, and inside.
fn check(message: &Message, package: &Package) {
    let length = |element: Element, of: fn(&Message) -> u32| match element {
        Element::Scalar(scalar) => scalar.size(),
        Element::Message(index) => package.message(index).map_or(0, of),
    };
    let mut fields: Vec<_> = message.fields.iter().collect();
    let mut end = 0;
    for field in &fields {
        assert!(field.cdr_offset >= end);
        // Of nested messages only the first scalar is aligned as it stands here.
        end = field.cdr_offset + length(field.element, |_| 1);
    }
    assert!(end <= message.cdr_len);
    fields.sort_by_key(|field| field.struct_offset);
    end = 0;
    for field in fields {
        assert!(field.struct_offset >= end);
        end = field.struct_offset + field.elements() * length(field.element, |message| message.struct_len);
    }
    assert!(end <= message.struct_len && message.struct_len - end == message.struct_padding);
    let enums = message.fields.iter().filter_map(|field| package.enum_(field.enum_?));
    assert!(enums.flat_map(|one| &one.entries).all(|entry| !entry.label.is_empty()));
    assert!(uorb::log_format(message, package).ends_with(';'));
}
