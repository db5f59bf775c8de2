//! The committed sources are what the generator writes, however it is called.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use mavgen::output::check;
use mavgen::{Builder, Commands, GeneratedFile};

const COMMAND: &str = "mavgen generate xml/autoquad.xml --overlay xml/overlay/autoquad.xml --commands feature=commands --out mavlink-autoquad/src/generated";

static GENERATED: LazyLock<Vec<GeneratedFile>> = LazyLock::new(|| generated("xml"));

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn committed() -> PathBuf {
    workspace().join("mavlink-autoquad/src/generated")
}

/// What the command generates from the definitions in a folder.
fn generated(folder: &str) -> Vec<GeneratedFile> {
    let folder = workspace().join(folder);
    let builder =
        Builder::new(folder.join("autoquad.xml")).name("autoquad").overlay(folder.join("overlay/autoquad.xml"));
    let builder = builder.commands(Commands::Feature("commands".into()));
    builder.formatted(true).files().unwrap_or_else(|failure| panic!("{failure}"))
}

#[test]
fn committed_sources_are_current() {
    let differences = check(&committed(), &GENERATED).unwrap();
    assert!(differences.is_empty(), "{differences:#?}\nto mend it: {COMMAND}");
}

/// The files in a folder and those below it, by path.
fn files(folder: &Path, prefix: &str) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let path = format!("{prefix}{}", entry.file_name().display());
        if entry.file_type().unwrap().is_dir() {
            found.extend(files(&entry.path(), &format!("{path}/")));
        } else {
            found.insert(path, fs::read_to_string(entry.path()).unwrap());
        }
    }
    found
}

/// Nothing lies in the folder that is not generated: the crate would carry it along.
#[test]
fn nothing_else_is_committed() {
    let found = files(&committed(), "");
    let expected = GENERATED.iter().map(|file| (file.path.clone(), file.text.clone())).collect();
    assert!(found == expected, "to mend it: {COMMAND}");
}

/// With the feature `generate` the build script reads the definitions beside the crate's own manifest, so that both ways to get
/// the crate are one. It writes the same code in plain lines, as the goldens of `mavgen` show; generating again changes nothing.
#[test]
fn the_build_script_reads_the_same_definitions() {
    assert!(generated("mavlink-autoquad/xml") == *GENERATED);
}
