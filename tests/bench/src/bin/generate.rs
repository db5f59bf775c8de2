//! Generating `common.xml` beside mavlink-bindgen with rustfmt: `cargo run --release --bin generate`.
//!
//! A build script runs the generator unoptimised. The ratio for that takes two runs, which `generate.sh` makes.

use std::error::Error;
use std::fs;
use std::path::Path;

use mavlink_bench::rounds::{Contender, compare};
use mavlink_bindgen::XmlDefinitions;

const XML: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../xml/common.xml");

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::temp_dir().join(format!("mavlink-bench-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    let files = mavgen::Builder::new(XML).files()?;
    report("mavgen", files.iter().map(|file| file.text.as_str()));
    peer(&folder, true);
    let theirs = fs::read_to_string(folder.join("common.rs"))?;
    report("mavlink-bindgen, rustfmt", [theirs.as_str()]);
    compare(
        "generate common.xml",
        vec![
            Contender::new("mavgen", || ours(false)),
            Contender::new("mavgen, formatted", || ours(true)),
            Contender::new("mavlink-bindgen, no fmt", || peer(&folder, false)),
            Contender::new("mavlink-bindgen, rustfmt", || peer(&folder, true)),
        ],
    );
    fs::remove_dir_all(&folder)?;
    Ok(())
}

fn report<'a>(name: &str, texts: impl IntoIterator<Item = &'a str>) {
    let (mut files, mut lines, mut bytes) = (0, 0, 0);
    for text in texts {
        (files, lines, bytes) = (files + 1, lines + text.lines().count(), bytes + text.len());
    }
    println!("{name}: {files} files, {lines} lines, {bytes} bytes");
}

/// In memory, as in a build script or as the command.
fn ours(formatted: bool) -> usize {
    usize::from(mavgen::Builder::new(XML).formatted(formatted).files().is_ok())
}

/// Into a folder, as the library has it; formatted by rustfmt as its own build script does.
fn peer(folder: &Path, formatted: bool) -> usize {
    let Ok(bindings) = mavlink_bindgen::generate(XmlDefinitions::Files(vec![XML]), folder) else { return 0 };
    if formatted {
        mavlink_bindgen::format_generated_code(&bindings);
    }
    1
}
