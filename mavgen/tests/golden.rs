//! Small goldens of generated Rust: one folder of `golden` for each construct of a dialect and of an overlay.
//!
//! `main.xml` is the dialect, `*.overlay.xml` are its overlays and `*.root.xml` the dialects beside it; `generated` is what
//! mavgen writes. `commands.feature` names the cargo feature that commands need. A folder `msg` has uORB messages, and each folder in
//! `older` an older definition of them. The package `mavlink-conformance` compiles and runs it.
//!
//! `MAVGEN_BLESS=1 cargo test -p mavgen --test library golden::` writes the goldens anew, and `tests/regenerate.sh` those and
//! everything else that is committed and generated; review them like code.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::fs;
use std::path::{Path, PathBuf};

use mavgen::{Builder, Commands, GeneratedFile};

/// Relative to the crate, which is where cargo runs tests: no golden names a folder of the machine.
const FOLDER: &str = "tests/golden";

/// The files of a folder whose names end so, by name.
fn files(folder: &Path, end: &str) -> Vec<PathBuf> {
    let paths = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut found: Vec<PathBuf> = paths.filter(|path| path.to_string_lossy().ends_with(end)).collect();
    found.sort();
    found
}

fn builder(folder: &Path) -> Builder {
    #[cfg(feature = "uorb")]
    if is_uorb(folder) {
        return topics(folder);
    }
    let roots = files(folder, ".root.xml");
    let builder = roots.iter().fold(Builder::new(folder.join("main.xml")), Builder::root).commands(commands(folder));
    files(folder, ".overlay.xml").iter().fold(builder, Builder::overlay).out_dir(folder.join("generated"))
}

/// When commands have types: always, but with a feature that a file names.
fn commands(folder: &Path) -> Commands {
    let feature = fs::read_to_string(folder.join("commands.feature"));
    feature.map_or(Commands::Always, |name| Commands::Feature(name.trim_end().to_owned()))
}

/// Whether these are uORB messages.
fn is_uorb(folder: &Path) -> bool {
    folder.join("msg").exists()
}

#[cfg(feature = "uorb")]
fn topics(folder: &Path) -> Builder {
    let builder = Builder::new(folder.join("msg")).definition("main").out_dir(folder.join("generated"));
    let builder = files(folder, ".overlay.xml").iter().fold(builder, Builder::overlay);
    if !folder.join("older").exists() {
        return builder;
    }
    let older = files(&folder.join("older"), "").into_iter().rev();
    older.fold(builder, |builder, older| builder.older(older.file_name().unwrap().to_str().unwrap(), &older))
}

/// The committed messages of PX4 in the crate of the dialect.
#[cfg(feature = "uorb")]
fn committed() -> Builder {
    let messages = Path::new("../mavlink-autoquad/msg");
    let builder = Builder::new(messages.join("main")).name("px4_msgs").overlay(messages.join("esc.overlay.xml"));
    let older = ["v2026_02", "v1_14"];
    let builder = older.into_iter().fold(builder, |builder, name| builder.older(name, messages.join(name)));
    builder.out_dir("../mavlink-autoquad/src/generated_px4")
}

#[test]
fn what_is_generated_is_what_was_reviewed() {
    let bless = std::env::var_os("MAVGEN_BLESS").is_some();
    let mut stale = String::new();
    let folders = files(Path::new(FOLDER), "");
    assert!(folders.len() > 10, "{folders:?}");
    let folders = folders.iter().filter(|folder| cfg!(feature = "uorb") || !is_uorb(folder));
    let builders = folders.map(|folder| builder(folder));
    #[cfg(feature = "uorb")]
    let builders = builders.chain([committed()]);
    for builder in builders.map(|builder| builder.formatted(true)) {
        if bless {
            builder.generate().unwrap_or_else(|failure| panic!("{failure}"));
        }
        let differences = builder.check().unwrap_or_else(|failure| panic!("{failure}"));
        if !differences.is_empty() {
            stale += &format!("{differences}\n");
        }
    }
    assert!(stale.is_empty(), "{stale}\nMAVGEN_BLESS=1 writes them anew");
}

/// The dialects of the repository, with all that they have.
fn dialects() -> impl Iterator<Item = Builder> {
    let autoquad = Builder::new("../xml/autoquad.xml").overlay("../xml/overlay/autoquad.xml");
    let hostile = Builder::new("../tests/hostile/hostile.xml").overlay("../tests/hostile/hostile.overlay.xml");
    [autoquad, hostile, Builder::new("../tests/hostile/names.xml")].into_iter()
}

/// What a formatter makes of a file.
fn formatted(file: &GeneratedFile) -> String {
    let parsed = syn::parse_file(&file.text);
    assert!(parsed.is_ok(), "{}: {:?}\n{}", file.path, parsed.as_ref().err(), file.text);
    prettyplease::unparse(&parsed.unwrap())
}

#[test]
fn plain_lines_are_the_formatted_sources() {
    let folders = files(Path::new(FOLDER), "");
    let folders = folders.iter().filter(|folder| cfg!(feature = "uorb") || !is_uorb(folder));
    for builder in folders.map(|folder| builder(folder)).chain(dialects()) {
        let (plain, reviewed) = (builder.files().unwrap(), builder.formatted(true).files().unwrap());
        assert_eq!(plain.len(), reviewed.len());
        for (plain, reviewed) in plain.iter().zip(&reviewed) {
            assert_eq!(plain.path, reviewed.path);
            assert!(formatted(plain) == formatted(reviewed), "{}\n{}", plain.path, plain.text);
            let members = |text: &str| text.lines().filter(|line| line.starts_with("    pub ")).count();
            assert_eq!(members(&plain.text), members(&reviewed.text), "each on a line: {}\n{}", plain.path, plain.text);
        }
    }
}
