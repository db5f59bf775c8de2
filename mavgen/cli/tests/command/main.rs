//! The command: exit status, what it says, what it writes, and what it leaves alone.

#![expect(clippy::unwrap_used, reason = "in what the tests share, too, a failure is a failed test")]

mod bad_input;
mod check;
mod diff;
mod dump;
mod generate;
mod help;
mod lint;
mod messages;
mod roots;
mod speech;
mod uorb;
mod vendor;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const ACME: &str = r#"<mavlink>
  <version>3</version>
  <enums>
    <enum name="SPRAY_STATE">
      <entry value="0" name="SPRAY_STATE_OFF"/>
      <entry value="1" name="SPRAY_STATE_ON"/>
    </enum>
  </enums>
  <messages>
    <message id="4711" name="SPRAYER">
      <description>What the sprayer does.</description>
      <field type="uint8_t" name="state" enum="SPRAY_STATE">Whether it sprays.</field>
      <field type="uint16_t" name="level" units="cm" invalid="UINT16_MAX">What is left in the tank.</field>
    </message>
  </messages>
</mavlink>
"#;

/// A folder with `acme.xml` in it.
fn folder(xml: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("acme.xml"), xml).unwrap();
    folder
}

fn mavgen(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mavgen")).current_dir(folder).args(arguments).output().unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// Every file below a folder with its bytes, by path.
fn tree(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let (mut tree, mut open) = (Vec::new(), vec![folder.to_owned()]);
    while let Some(below) = open.pop() {
        for path in fs::read_dir(below).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() {
                open.push(path);
            } else {
                tree.push((path.strip_prefix(folder).unwrap().to_owned(), fs::read(path).unwrap()));
            }
        }
    }
    tree.sort();
    tree
}
