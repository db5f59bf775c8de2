//! A crate that generates its dialect is built again when, and only when, a file changes that the dialect is made of.
//!
//! Builds a crate of its own, so it is not among the tests that everybody runs: `cargo test --test rebuild -- --ignored`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const ACME: &str = "<mavlink><include>base.xml</include><messages>\
                    <message id='1' name='TANK'><field type='uint16_t' name='level'>Level.</field></message>\
                    </messages></mavlink>";
const BASE: &str = "<mavlink><messages>\
                    <message id='2' name='PUMP'><field type='uint8_t' name='speed'>Speed.</field></message>\
                    </messages></mavlink>";
const OVERLAY: &str =
    "<mavlink-overlay version='1' for='acme.xml'><note message='TANK'>Noted.</note></mavlink-overlay>";
const BUILD: &str = "fn main() { mavgen::Builder::new(\"acme.xml\").overlay(\"acme.overlay.xml\").build_script(); }\n";
const LIB: &str = "//! A dialect.\n#![deny(warnings, missing_docs)]\nmavlink_wire::include_dialect!(\"acme\");\n";

/// A crate with a dialect, in a folder that is its own.
struct Crate {
    folder: tempfile::TempDir,
}

/// What a build came to.
struct Build {
    succeeded: bool,
    said: String,
}

impl Crate {
    /// With the build script in this file.
    fn new(script: &str, build: &str) -> Self {
        let made = Self { folder: tempfile::tempdir().unwrap() };
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let path = |name: &str| workspace.join(name).display().to_string();
        let manifest = format!(
            "[package]\nname = \"rebuilt\"\nversion = \"0.0.0\"\nedition = \"2024\"\nbuild = {script:?}\n[workspace]\n\
             [dependencies]\nmavlink-wire = {{ path = {:?} }}\n[build-dependencies]\nmavgen = {{ path = {:?} }}\n",
            path("mavlink-wire"),
            path("mavgen"),
        );
        for file in ["src/lib.rs", script] {
            fs::create_dir_all(made.path(file).parent().unwrap()).unwrap();
        }
        fs::copy(workspace.join("Cargo.lock"), made.path("Cargo.lock")).unwrap();
        let files = [("Cargo.toml", &*manifest), (script, build), ("src/lib.rs", LIB)];
        let definitions = [("acme.xml", ACME), ("base.xml", BASE), ("acme.overlay.xml", OVERLAY)];
        files.iter().chain(&definitions).for_each(|(name, text)| made.write(name, text));
        made
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    fn build(&self) -> Build {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["check", "--offline", "-v", "--color", "never"]).current_dir(self.folder.path());
        // The dependencies are compiled once for all of these crates, which do not build at the same time: cargo locks the folder.
        cargo.env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).join("rebuild"));
        let output = cargo.output().unwrap();
        Build { succeeded: output.status.success(), said: String::from_utf8(output.stderr).unwrap() }
    }

    /// Builds, and demands that it works; whether anything was done.
    fn rebuilds(&self) -> bool {
        let Build { succeeded, said } = self.build();
        assert!(succeeded, "{said}");
        let fresh = said.contains("Fresh rebuilt v0.0.0");
        assert_ne!(fresh, said.contains("rustc --crate-name rebuilt "), "{said}");
        !fresh
    }
}

#[test]
#[ignore = "builds a crate with cargo"]
fn what_a_dialect_is_made_of_is_what_it_is_built_again_for() {
    let made = Crate::new("build.rs", BUILD);
    assert!(made.rebuilds());
    assert!(!made.rebuilds(), "nothing was touched");

    made.write("base.xml", &BASE.replace("PUMP", "VALVE"));
    made.write("src/lib.rs", &format!("{LIB}\n/// New in the included file.\npub type New = acme::Valve;\n"));
    assert!(made.rebuilds(), "an included file was changed");
    assert!(!made.rebuilds());

    made.write("acme.overlay.xml", &OVERLAY.replace("Noted", "Noted again"));
    assert!(made.rebuilds(), "an overlay was changed");
    made.write("notes.txt", "nothing to do with it");
    assert!(!made.rebuilds(), "nothing that it is made of was touched");

    // A file that is missing is waited for.
    made.write("acme.xml", &ACME.replace("base.xml", "later.xml"));
    let broken = made.build();
    assert!(!broken.succeeded && broken.said.contains("error[M200]: the included file `later.xml`"), "{}", broken.said);
    fs::rename(made.path("base.xml"), made.path("later.xml")).unwrap();
    assert!(made.rebuilds(), "the missing file is there");
    assert!(!made.rebuilds());
}

#[test]
#[ignore = "builds a crate with cargo"]
fn a_build_script_can_be_anywhere() {
    let made = Crate::new("build/main.rs", BUILD);
    assert!(made.rebuilds());
    assert!(!made.rebuilds(), "nothing was touched");
    made.write("build/main.rs", &BUILD.replace(".build_script", ".deprecated(false).build_script"));
    assert!(made.rebuilds(), "the script was changed");
    assert!(!made.rebuilds());

    // What is watched is relative to the package, where the script no longer is.
    let gone = BUILD.replace("{ ", "{ std::env::set_current_dir(\"src\").unwrap(); ").replace("(\"acme", "(\"../acme");
    made.write("build/main.rs", &gone);
    assert!(made.rebuilds());
    assert!(!made.rebuilds());
    made.write("base.xml", &BASE.replace("PUMP", "VALVE"));
    assert!(made.rebuilds(), "an included file was changed");
}

#[test]
#[ignore = "builds a crate with cargo"]
fn two_builders_of_one_name_are_an_error() {
    let other = "mavgen::Builder::new(\"base.xml\").name(\"acme\").build_script(); }";
    let made = Crate::new("build.rs", &BUILD.replace('}', other));
    let Build { succeeded, said } = made.build();
    assert!(!succeeded && said.contains("make one module, `acme`"), "{said}");
}
