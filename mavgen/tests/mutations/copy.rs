//! Copies of mutated dialects: what is generated of one is what is generated of its source.

use std::path::Path;

use mavgen::Builder;
use mavgen::vendor::{Prose, vendor, write};
use proptest::prelude::*;

/// The sources of a dialect, or of one message of it, but for the digest of the XML; without documentation if so asked.
fn generated(xml: &Path, message: Option<&str>, documented: bool) -> Option<Vec<(String, String)>> {
    let builder = builder(xml, message);
    let files = builder.emit(&builder.resolve().ok()?).ok()?;
    let is_compared =
        |line: &&str| !line.contains("; sources ") && (documented || !line.trim_start().starts_with("//"));
    let text = |text: &str| text.lines().filter(is_compared).collect::<Vec<_>>().join("\n");
    Some(files.iter().map(|file| (file.path.clone(), text(&file.text))).collect())
}

fn builder(xml: &Path, message: Option<&str>) -> Builder {
    message.into_iter().fold(Builder::new(xml), |builder, name| builder.messages([name]))
}

/// Copies a dialect whole and one message of it, with and without descriptions, and generates from the copies.
pub(crate) fn holds(dialect: &str, pick: usize) -> Result<(), TestCaseError> {
    let folder = tempfile::tempdir()?;
    let xml = folder.path().join("autoquad.xml");
    std::fs::write(&xml, dialect)?;
    let Ok(resolved) = Builder::new(&xml).resolve() else { return Ok(()) };
    let messages = &resolved.dialect.messages;
    let picked = messages.get(pick % messages.len().max(1)).map(|message| message.name.text.as_str());
    for (at, (message, prose)) in
        [(None, Prose::Keep), (None, Prose::Drop), (picked, Prose::Keep), (picked, Prose::Drop)].into_iter().enumerate()
    {
        let out = folder.path().join(at.to_string());
        let copies = vendor(&builder(&xml, message), &prose);
        prop_assert!(copies.is_ok(), "{:?}: {}", prose, copies.unwrap_err());
        write(&out, &copies.unwrap()).unwrap();
        let documented = prose == Prose::Keep;
        let (source, copy) =
            (generated(&xml, message, documented), generated(&out.join("autoquad.xml"), message, documented));
        prop_assert!(source.is_some());
        prop_assert_eq!(source, copy, "{:?} {:?}", message, prose);
    }
    Ok(())
}
