//! Copies say what their originals say, and lose nothing that a person wrote.

mod descriptions;
mod edited;
mod folder;
mod part;
mod same_model;

use std::fs;
use std::path::{Path, PathBuf};

use super::{Prose, Vendored, vendor};
use crate::builder::Builder;

/// A folder with these files.
fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (path, text) in files {
        put(&folder.path().join(path), text);
    }
    folder
}

fn put(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// Copies of the dialect in `a.xml` of a folder.
fn copies(folder: &Path, prose: &Prose) -> Vendored {
    vendor(&Builder::new(folder.join("a.xml")), prose).unwrap_or_else(|failure| panic!("{failure}"))
}

/// The text of a copy.
fn text<'v>(vendored: &'v Vendored, name: &str) -> &'v str {
    &vendored.files.iter().find(|file| file.name == name).unwrap().text
}

/// What stands below the header of a copy.
fn below_header(text: &str) -> &str {
    let (_, header) = text.split_once("<!-- Vendored by mavgen ").unwrap();
    header.split_once(" -->\n").unwrap().1
}

/// Copies that are written into another folder; that folder's path.
fn written(vendored: &Vendored, folder: &Path) -> PathBuf {
    let out = folder.join("out");
    super::write(&out, vendored).unwrap();
    out
}
