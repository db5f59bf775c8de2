//! Any text as an overlay of a small dialect: refused with a place, or it becomes Rust that parses.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavgen::diag::{Diagnostics, Style, render};
use mavgen::read::{Loaded, read, read_overlay};
use mavgen::resolve::resolve;
use mavgen::source::Sources;
use mavgen::{Builder, Resolved};

/// Something for every construct to be about: scalars and arrays of every width, an enum, flags.
const DIALECT: &str = "<mavlink><enums>\
<enum name='E'><entry value='0' name='E_A'/><entry value='1' name='E_B'/></enum>\
<enum name='F' bitmask='true'><entry value='1' name='F_A'/><entry value='4' name='F_B'/></enum></enums><messages>\
<message id='1' name='M'><description>.</description><field type='uint32_t[4]' name='a'>.</field>\
<field type='uint32_t[4]' name='b'>.</field><field type='uint8_t[4]' name='c'>.</field><field type='uint8_t[2]' name='d'>.</field>\
<field type='uint8_t' name='n'>.</field><field type='uint8_t' name='p' enum='E'>.</field><field type='uint16_t' name='f'>.</field>\
<field type='uint64_t' name='l'>.</field><field type='float' name='x'>.</field></message></messages></mavlink>";

fuzz_target!(|text: &str| {
    let (mut sources, mut diagnostics, mut loaded) = (Sources::default(), Diagnostics::default(), Loaded::default());
    "a".clone_into(&mut loaded.name);
    let id = sources.add("a.xml", DIALECT);
    loaded.files.push(read(id, &sources, &mut diagnostics).into());
    loaded.includes.push(Vec::new());
    let id = sources.add("a.overlay.xml", text);
    loaded.overlays.push(read_overlay(id, &sources, &mut diagnostics));
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
