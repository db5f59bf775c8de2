//! Whatever mavgen accepts of uORB messages compiles without a warning, and each definition gives back the bytes that it read.

use std::fmt::Write;
use std::fs;
use std::ops::Range;

use mavgen::{Builder, Failure, GeneratedFile};
use random_dialects::{Topics, topics};

use crate::package::{HEAD, Package, blame};
use crate::{SEEDS, seeds};

/// The seeds of every run.
const FEWER: Range<u64> = 1..61;

/// Packages of one crate.
const TOGETHER: usize = 100;

/// What is generated of a seed; nothing if mavgen refuses it.
fn generated(case: &Topics) -> Option<Vec<GeneratedFile>> {
    let folder = tempfile::tempdir().unwrap();
    for (path, text) in &case.files {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    let overlay = folder.path().join("overlay.xml");
    fs::write(&overlay, &case.overlay).unwrap();
    let (newest, older) = case.definitions.split_first().unwrap();
    let builder = Builder::new(folder.path().join(newest)).overlay(overlay).name(format!("seed_{}", case.seed));
    let builder = older.iter().fold(builder, |builder, name| builder.older(name, folder.path().join(name)));
    match builder.files() {
        Ok(files) => Some(files),
        Err(Failure::Definitions(_)) => None,
        Err(failure) => panic!("seed {}: {failure}", case.seed),
    }
}

/// The topics that a file declares.
fn types(file: &GeneratedFile) -> impl Iterator<Item = &str> {
    let is_message = file.path.starts_with("messages/");
    let lines = file.text.lines().filter(move |_| is_message);
    lines.filter_map(|line| line.strip_prefix("pub struct ")?.strip_suffix(" {"))
}

#[test]
fn topics_compile_and_give_back_what_they_read() {
    // Each has up to four messages of up to three definitions: fewer say as much as so many dialects.
    let seeds = seeds();
    let seeds = if seeds == SEEDS { FEWER } else { seeds };
    let accepted: Vec<(u64, Vec<GeneratedFile>)> =
        seeds.clone().filter_map(|seed| Some((seed, generated(&topics(seed))?))).collect();
    println!("seeds {seeds:?}: {} of {} accepted", accepted.len(), seeds.clone().count());
    assert!(accepted.len() * 2 > seeds.count(), "a generator of what is refused proves nothing");
    for together in accepted.chunks(TOGETHER) {
        compile_and_run(together, "");
    }
}

/// `vectors` are what others say of values, as `make_px4.py` writes it.
fn compile_and_run(accepted: &[(u64, Vec<GeneratedFile>)], vectors: &str) -> String {
    let crate_ = Package::new("topics");
    let (mut root, mut checks) = (HEAD.to_owned(), String::new());
    for (seed, files) in accepted {
        for file in files {
            crate_.write(&format!("src/seed_{seed}/{}", file.path), &file.text);
            for ty in types(file) {
                writeln!(checks, "    check::<topics::seed_{seed}::{ty}>(&vectors);").unwrap();
            }
        }
        writeln!(root, "/// Seed {seed}.\n#[rustfmt::skip]\npub mod seed_{seed};").unwrap();
    }
    crate_.write("src/lib.rs", &root);
    crate_.write("src/main.rs", &include_str!("topics_program.rs").replace("// CHECKS", &checks));
    if let Err(said) = crate_.cargo(&["clippy", "--quiet", "--lib"], "") {
        panic!("{:#?}\n{said}", blame(&said).keys());
    }
    crate_.cargo(&["run", "--quiet"], vectors).unwrap_or_else(|said| panic!("{said}"))
}

/// All of PX4's own, which lie beside the project where they do: `PX4_MESSAGES` and `PX4_VECTORS` name the folder, and what
/// `make_px4.py --all` writes of it.
#[test]
#[ignore = "needs PX4's messages"]
fn all_messages_of_px4() {
    let files = Builder::new(std::env::var("PX4_MESSAGES").unwrap()).name("px4").files().unwrap();
    let messages = files.iter().flat_map(types).count();
    assert!(messages > 200, "{messages}");
    let vectors = fs::read_to_string(std::env::var("PX4_VECTORS").unwrap()).unwrap();
    let said = compile_and_run(&[(0, files)], &vectors);
    let values = vectors.lines().filter(|line| line.starts_with("value ")).count();
    assert!(values > 600 && said.ends_with(&format!("{values} values\n")), "{values} values; {said}");
}
