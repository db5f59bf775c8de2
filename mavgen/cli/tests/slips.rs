//! A file with every slip that no byte, id or name depends on: each is a warning, and the model is pymavlink's.
//!
//! `tests/slips/slips.json` is what pymavlink makes of the file: `tests/oracle/model.py` writes it anew, and
//! `compare_dialects.py` compares both live.

#![expect(clippy::unwrap_used, reason = "a failing test panics")]

use std::process::{Command, Output};

use mavgen::diag::{Code, Severity};
use serde_json::Value;

fn mavgen(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mavgen")).current_dir("../../tests/slips").args(arguments).output().unwrap()
}

#[test]
fn the_model_is_pymavlinks() {
    let dumped = mavgen(&["dump", "--json", "slips.xml"]);
    assert_eq!(dumped.status.code(), Some(0), "{}", String::from_utf8_lossy(&dumped.stderr));
    let ours: Value = serde_json::from_slice(&dumped.stdout).unwrap();
    let theirs: Value = serde_json::from_str(include_str!("../../../tests/slips/slips.json")).unwrap();
    assert_covers("", &ours, &theirs);
}

/// Whether `ours` says all that `theirs` says; it may say more of each thing.
fn assert_covers(at: &str, ours: &Value, theirs: &Value) {
    match (ours, theirs) {
        (Value::Object(ours), Value::Object(theirs)) => {
            for (key, value) in theirs {
                assert_covers(&format!("{at}.{key}"), ours.get(key).unwrap_or(&Value::Null), value);
            }
        }
        (Value::Array(ours), Value::Array(theirs)) => {
            assert_eq!(ours.len(), theirs.len(), "{at}");
            for (index, (ours, theirs)) in ours.iter().zip(theirs).enumerate() {
                assert_covers(&format!("{at}[{index}]"), ours, theirs);
            }
        }
        _ => assert_eq!(ours, theirs, "{at}"),
    }
}

/// What is not in it: pymavlink reads the first two otherwise, and stops at the next two; the last three are
/// about Rust.
///
/// Where files disagree on a bitmask, the file that owns the enum decides, not the first; and no `float` carries an enum.
const NOT_HERE: [Code; 7] = [
    Code::BitmaskDiffers,
    Code::EnumOnField,
    Code::DeclaredEncoding,
    Code::SameFile,
    Code::AccessorLost,
    Code::CommandLost,
    Code::ParamLabel,
];

#[test]
fn every_warning_is_in_it() {
    let linted = mavgen(&["lint", "slips.xml"]);
    let said = String::from_utf8(linted.stderr).unwrap();
    assert!(linted.status.success() && !said.contains("error["), "{said}");
    let warnings = Code::ALL.iter().filter(|code| code.severity() == Severity::Warning && code.number() < 700);
    let missing: Vec<String> = warnings
        .filter(|code| !NOT_HERE.contains(code) && !said.contains(&format!("warning[{code}]")))
        .map(Code::to_string)
        .collect();
    assert!(missing.is_empty(), "{missing:?} are not told of slips.xml:\n{said}");
}
