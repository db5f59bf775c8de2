//! PX4's messages: layouts against a C compiler, bytes, lengths, hashes and formats against rosbags and an independent reading,
//! and what AutoQuad's telemetry becomes.

mod autoquad;
mod bytes;
mod structs;
mod vectors;

use std::path::{Path, PathBuf};

use mavgen::diag::Diagnostics;
use mavgen::source::Sources;
use mavgen::uorb::model::Package;

/// The definitions of `EscStatus`, newest first.
const DEFINITIONS: [&str; 3] = ["main", "v2026_02", "v1_14"];

fn folder(definition: &str) -> PathBuf {
    Path::new("../mavlink-autoquad/msg").join(definition)
}

/// All messages of a folder, in which nothing is wrong.
fn package(folder: &Path) -> Package {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let package = mavgen::uorb::load(folder, &[], |_| true, &mut sources, &mut diagnostics);
    assert!(!diagnostics.has_errors(), "{diagnostics:?}");
    package
}
