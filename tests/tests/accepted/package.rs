//! A crate with a dialect in each module, and what clippy says of it.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::failure::Failure;
use crate::sample::Sample;

/// What every dialect has to pass.
pub(crate) const HEAD: &str = "//! Dialects.\n#![no_std]\n#![forbid(unsafe_code)]\n#![deny(warnings, missing_docs, unreachable_pub, \
                    clippy::all)]\n";

/// A folder for crates that are not part of the workspace; it stays, and so does what was compiled there.
pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("accepted")
}

/// The crate.
pub(crate) struct Package {
    folder: PathBuf,
}

impl Package {
    /// An empty crate of that name, in the place of what was there.
    pub(crate) fn new(name: &str) -> Self {
        let made = Self { folder: folder().join(name) };
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        let manifest = format!(
            "[package]\nname = {name:?}\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n\
             [dependencies]\nmavlink-wire = {{ path = {:?}, features = [\"uorb\"] }}\n",
            workspace.join("mavlink-wire"),
        );
        _ = fs::remove_dir_all(&made.folder);
        made.write("Cargo.toml", &manifest);
        fs::copy(workspace.join("Cargo.lock"), made.folder.join("Cargo.lock")).unwrap();
        made
    }

    /// Those of the samples that do not compile, alone or beside others.
    pub(crate) fn failures(samples: &[&Sample]) -> Vec<Failure> {
        let mut left: Vec<&Sample> = samples.to_vec();
        let mut failures = Vec::new();
        while !left.is_empty() {
            let blamed = Self::tried(&left);
            if blamed.is_empty() {
                break;
            }
            left.retain(|sample| !blamed.contains_key(&sample.case.seed));
            let of = |seed: u64| samples.iter().find(|sample| sample.case.seed == seed).unwrap();
            failures.extend(blamed.into_iter().map(|(seed, said)| Failure::new(of(seed), said)));
        }
        failures
    }

    /// What is said of each sample that something is said of.
    ///
    /// # Panics
    ///
    /// If the crate does not compile and no sample is at fault.
    pub(crate) fn tried(samples: &[&Sample]) -> BTreeMap<u64, Vec<String>> {
        let made = Self::new("accepted");
        let mut root = HEAD.to_owned();
        for sample in samples {
            made.add(sample, &mut root);
        }
        made.write("src/lib.rs", &root);
        let said = made.cargo(&["clippy", "--quiet"], "");
        let blamed = blame(said.as_ref().err().map_or("", String::as_str));
        assert!(said.is_ok() || !blamed.is_empty(), "{}", said.unwrap_err());
        blamed
    }

    /// Adds a dialect as a module of the root.
    pub(crate) fn add(&self, sample: &Sample, root: &mut String) {
        let seed = sample.case.seed;
        for file in sample.accepted().into_iter().flat_map(|accepted| &accepted.files) {
            self.write(&format!("src/seed_{seed}/{}", file.path), &file.text);
        }
        writeln!(root, "/// Seed {seed}.\n#[rustfmt::skip]\npub mod seed_{seed};").unwrap();
    }

    pub(crate) fn write(&self, path: &str, text: &str) {
        let path = self.folder.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    /// Runs cargo in it: what it prints, or what it says is wrong.
    pub(crate) fn cargo(&self, arguments: &[&str], input: &str) -> Result<String, String> {
        self.write("input", input);
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(arguments).args(["--offline", "--color", "never"]).current_dir(&self.folder);
        cargo.env("CARGO_TARGET_DIR", folder().join("target")).env("CARGO_INCREMENTAL", "0").env_remove("RUSTFLAGS");
        cargo.stdin(File::open(self.folder.join("input")).unwrap());
        let output = cargo.output().unwrap();
        let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
        if output.status.success() { Ok(text(&output.stdout)) } else { Err(text(&output.stderr)) }
    }
}

/// Takes apart what rustc says, by the seeds in whose files it lies.
pub(crate) fn blame(said: &str) -> BTreeMap<u64, Vec<String>> {
    let mut blamed: BTreeMap<u64, Vec<String>> = BTreeMap::new();
    for one in said.split("\n\n") {
        let place = one.split("src/seed_").nth(1).and_then(|rest| rest.split('/').next()).map(str::parse);
        if let Some(Ok(seed)) = place {
            blamed.entry(seed).or_default().push(one.trim().to_owned());
        }
    }
    blamed
}
