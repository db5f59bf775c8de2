//! Frames of AutoQuad's dialect as JSON, as recorded in `decoded.jsonl`.
//!
//! `mavlink-conformance` reads the same lines with serde, as generated types: what this command writes of a message is what they
//! read. `MAVGEN_BLESS=1 cargo test -p mavgen-cli --test decode recorded` records it anew; review it like code.

use std::fs;

use crate::bench::{decode, stderr};

const DEFINITIONS: [&str; 3] = ["xml/autoquad.xml", "--overlay", "xml/overlay/autoquad.xml"];
const FRAMES: &str = "mavgen/cli/tests/decode/frames.hex";
const GOLDEN: &str = "tests/decode/decoded.jsonl";

#[test]
fn json_is_as_recorded() {
    let output = decode("../..".as_ref(), &[&DEFINITIONS[..], &[FRAMES, "--format", "json"]].concat(), b"");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let actual = String::from_utf8(output.stdout).unwrap();
    if std::env::var_os("MAVGEN_BLESS").is_some() {
        fs::write(GOLDEN, &actual).unwrap();
    }
    let expected = fs::read_to_string(GOLDEN).unwrap();
    for (actual, expected) in actual.lines().zip(expected.lines()) {
        assert_eq!(actual, expected, "MAVGEN_BLESS=1 records what is said now");
    }
    assert_eq!(actual.lines().count(), expected.lines().count());
}
