//! The definitions in `xml` are what `mavgen vendor` makes of facts and of the descriptions in them.

use std::fs;
use std::path::{Path, PathBuf};

use mavgen::Builder;
use mavgen::compare::compare;
use mavgen::ir::Dialect;
use mavgen::vendor::{Prose, vendor, write};

/// The definitions of the project.
fn xml() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../xml")
}

fn resolved(xml: &Path) -> Dialect {
    Builder::new(xml).resolve().unwrap_or_else(|failure| panic!("{failure}")).dialect
}

/// A file without the line that says where it comes from.
fn below_header(text: &str) -> Vec<&str> {
    let (headers, rest): (Vec<&str>, Vec<&str>) =
        text.lines().partition(|line| line.starts_with("<!-- Vendored by mavgen "));
    assert_eq!(headers.len(), 1);
    rest
}

/// Facts from elsewhere, here a copy without prose, and the descriptions that are in the files: the files again, every byte.
#[test]
fn the_definitions_are_made_of_facts_and_their_descriptions() {
    let bare = tempfile::tempdir().unwrap();
    write(bare.path(), &vendor(&Builder::new(xml().join("autoquad.xml")), &Prose::Drop).unwrap()).unwrap();
    let again = vendor(&Builder::new(bare.path().join("autoquad.xml")), &Prose::From(xml())).unwrap();
    assert_eq!((again.files.len(), again.unplaced.len()), (4, 0));
    for copy in &again.files {
        let file = fs::read_to_string(xml().join(&copy.name)).unwrap();
        assert!(below_header(&copy.text) == below_header(&file), "{} is not as `mavgen vendor` writes it", copy.name);
    }
}

/// What `mavgen vendor` notices as an edit is not in the definitions: they can be made anew at any time.
#[test]
fn the_definitions_have_no_facts_of_their_own() {
    let (bare, copy) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    write(bare.path(), &vendor(&Builder::new(xml().join("autoquad.xml")), &Prose::Drop).unwrap()).unwrap();
    for name in ["autoquad.xml", "common.xml", "standard.xml", "minimal.xml"] {
        fs::copy(xml().join(name), copy.path().join(name)).unwrap();
    }
    let again = vendor(&Builder::new(bare.path().join("autoquad.xml")), &Prose::From(copy.path().into())).unwrap();
    let done = write(copy.path(), &again).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(done.written, 4, "they now say that they are from the facts");
    assert_eq!(write(copy.path(), &again).unwrap().kept, 4);
}

/// All that can be compared, and so all but the prose, is in the facts alone.
#[test]
fn the_facts_are_the_definitions() {
    for xml in [xml().join("autoquad.xml"), Path::new(env!("CARGO_MANIFEST_DIR")).join("hostile/hostile.xml")] {
        let folder = tempfile::tempdir().unwrap();
        write(folder.path(), &vendor(&Builder::new(&xml), &Prose::Drop).unwrap()).unwrap();
        let copy = folder.path().join(xml.file_name().unwrap());
        assert_eq!(compare(&resolved(&xml), &resolved(&copy), None).unwrap(), []);
    }
}
