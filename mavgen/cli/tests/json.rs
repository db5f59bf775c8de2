//! Diagnostics as JSON, by definitions from the renderings of the library.
//!
//! `MAVGEN_BLESS=1 cargo test -p mavgen-cli --test json` records them anew; review them like code.

#![expect(clippy::unwrap_used, reason = "a failing test panics")]

use std::fs;
use std::path::Path;
use std::process::Command;

/// What `lint` says of a definition among the renderings, without its last line, which counts.
fn said(xml: &str, overlays: &[&str]) -> String {
    // In the folder of the library: no rendering names a folder of the machine.
    let mut command = Command::new(env!("CARGO_BIN_EXE_mavgen"));
    command.current_dir("..").args(["lint", "--message-format", "json"]).arg(format!("tests/ui/{xml}"));
    for overlay in overlays {
        command.arg("--overlay").arg(format!("tests/ui/{overlay}"));
    }
    let output = command.output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stderr).unwrap();
    let (said, count) = text.trim_end().rsplit_once('\n').unwrap();
    assert!(count.contains(r#""severity":"note""#), "{count}");
    format!("{said}\n")
}

#[test]
fn json_is_as_recorded() {
    let overlays = ["a", "b", "c"].map(|name| format!("overlay_base/{name}.overlay.xml"));
    for (name, xml, overlays) in [
        ("include_cycle", "include_cycle/main.xml", &[][..]),
        ("include_missing", "include_missing.xml", &[]),
        ("twenty_mistakes", "twenty_mistakes.xml", &[]),
        ("overlay_base", "overlay_base/main.xml", &overlays.each_ref().map(String::as_str)),
    ] {
        let (golden, actual) = (Path::new("tests/json").join(name).with_extension("json"), said(xml, overlays));
        if std::env::var_os("MAVGEN_BLESS").is_some() {
            fs::write(&golden, actual).unwrap();
        } else {
            assert_eq!(fs::read_to_string(&golden).unwrap(), actual, "{name}: MAVGEN_BLESS=1 records what is said now");
        }
    }
}
