//! What a build script writes, and what it tells cargo.

use std::fs;
use std::path::Path;

use super::place::Builders;
use super::*;

impl Builder {
    /// What the one builder of a build script says.
    fn said(&self, out_dir: &Path) -> Vec<String> {
        self.cargo_directives(&Place::new(out_dir, &Builders::default(), true))
    }
}

const ACME: &str = r#"<mavlink>
  <include>base.xml</include>
  <messages>
    <message id="4711" name="SPRAYER">
      <description>What the sprayer does.</description>
      <field type="uint8_t" name="state" enum="SPRAY_STATE">Whether it sprays.</field>
    </message>
  </messages>
</mavlink>
"#;

const BASE: &str = r#"<mavlink>
  <enums>
    <enum name="SPRAY_STATE">
      <entry name="SPRAY_STATE_ON"/>
    </enum>
  </enums>
  <messages/>
</mavlink>
"#;

/// A folder with `acme.xml` and `base.xml`, and what a build script for it says.
fn build(acme: &str, base: &str) -> (tempfile::TempDir, Vec<String>) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("acme.xml"), acme).unwrap();
    fs::write(folder.path().join("base.xml"), base).unwrap();
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    fs::write(out.join("of-another-build-script"), "").unwrap();
    let said = Builder::new(folder.path().join("acme.xml")).said(&out);
    (folder, said)
}

fn starting<'a>(said: &'a [String], start: &str) -> Vec<&'a str> {
    said.iter().filter_map(|line| line.strip_prefix(start)).collect()
}

#[test]
fn every_file_is_watched() {
    let (folder, said) = build(ACME, BASE);
    let path = |name: &str| folder.path().join(name).display().to_string();
    let watched = starting(&said, "cargo::rerun-if-changed=");
    assert_eq!(watched, [path("acme.xml"), path("base.xml")]);
    let out = folder.path().join("out");
    let entry = fs::read_to_string(out.join("acme.rs")).unwrap();
    assert!(entry.contains("#[path = \"acme/mod.rs\"]\npub mod acme;"), "{entry}");
    assert!(out.join("acme/messages/sprayer.rs").exists() && out.join("of-another-build-script").exists());
}

#[test]
fn the_tree_can_lie_elsewhere() {
    let (folder, _) = build(ACME, BASE);
    let (out, tree) = (folder.path().join("out"), folder.path().join("src/generated"));
    Builder::new(folder.path().join("acme.xml")).out_dir(&tree).said(&out);
    let entry = fs::read_to_string(out.join("acme.rs")).unwrap();
    assert!(entry.contains(&format!("#[path = {:?}]\npub mod acme;", tree.join("mod.rs"))), "{entry}");
    assert!(tree.join("mod.rs").exists());
}

#[test]
fn a_mistake_is_an_error_with_its_place() {
    let (folder, said) = build(&ACME.replace("uint8_t", "uint9_t"), BASE);
    let errors = starting(&said, "cargo::error=");
    assert!(errors.iter().any(|line| line.contains("error[M304]")), "{said:?}");
    assert!(errors.iter().any(|line| line.contains("acme.xml:6:20")), "{said:?}");
    assert!(!said.iter().any(|line| line.contains("M404")), "a note is not for cargo: {said:?}");
    assert_eq!(starting(&said, "cargo::rerun-if-changed=").len(), 2);
    assert!(!folder.path().join("out/acme.rs").exists());
}

#[test]
fn a_missing_include_is_watched() {
    let (folder, said) = build(&ACME.replace("base.xml", "bass.xml"), BASE);
    let missing = folder.path().join("bass.xml").display().to_string();
    assert!(starting(&said, "cargo::rerun-if-changed=").contains(&missing.as_str()), "{said:?}");
    assert!(!starting(&said, "cargo::error=").is_empty());
}

#[test]
fn an_overlay_is_watched_and_warned_about() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("acme.xml"), BASE).unwrap();
    let refine = "<refine enum='SPRAY_STATE' bitmask='false'/>";
    fs::write(path("o.xml"), format!("<mavlink-overlay version='1' for='acme.xml'>{refine}</mavlink-overlay>"))
        .unwrap();
    let builder = Builder::new(path("acme.xml")).overlay(path("o.xml"));
    let said = builder.said(&path("out"));
    let watched = starting(&said, "cargo::rerun-if-changed=");
    assert_eq!(watched.last().copied(), Some(path("o.xml").to_str().unwrap()), "{said:?}");
    assert!(starting(&said, "cargo::warning=").iter().any(|line| line.contains("M708")), "{said:?}");
}

#[test]
fn a_name_can_be_given() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("my fork.xml"), BASE).unwrap();
    let builder = Builder::new(folder.path().join("my fork.xml"));
    let resolved = builder.clone().name("acme").resolve().unwrap();
    assert_eq!((resolved.dialect.name.as_str(), resolved.names.dialect.as_str()), ("acme", "Acme"));
    assert!(matches!(builder.name("---").resolve(), Err(Failure::Definitions(_))));
}

#[test]
fn only_some_messages_are_built() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("acme.xml"), ACME).unwrap();
    fs::write(
        path("base.xml"),
        BASE.replace(
            "<messages/>",
            "<messages><message id='1' name='BELL'><field type='char' name='a'>x</field></message></messages>",
        ),
    )
    .unwrap();
    let said = |names: &str| Builder::new(path("acme.xml")).messages(names.split(',')).said(folder.path());
    assert!(starting(&said("BELL"), "cargo::error=").is_empty());
    assert!(path("acme/messages/bell.rs").exists() && !path("acme/messages/sprayer.rs").exists());
    let wrong = ["no message of acme.xml is called `BEL` (did you mean `BELL`?)"];
    assert_eq!(starting(&said("BEL,SPRAYER"), "cargo::error="), wrong);
}

#[test]
fn denied_warnings_are_errors_and_those_of_included_files_are_not_printed() {
    let unknown = "<messages colour='red'/>";
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("base.xml"), BASE.replace("<messages/>", unknown)).unwrap();
    let said = |acme: &str, deny: bool| {
        fs::write(path("acme.xml"), acme).unwrap();
        Builder::new(path("acme.xml")).deny_warnings(deny).said(folder.path())
    };
    let fine = said(ACME, true);
    assert!(starting(&fine, "cargo::error=").is_empty() && starting(&fine, "cargo::warning=").is_empty(), "{fine:?}");
    let own = ACME.replace("<messages>", "<messages colour='red'>");
    assert!(starting(&said(&own, false), "cargo::warning=")[0].starts_with("warning[M102]"));
    let denied = said(&own, true);
    assert!(starting(&denied, "cargo::error=")[0].starts_with("warning[M102]"), "{denied:?}");
    assert_eq!(starting(&denied, "cargo::rerun-if-changed=").len(), 2);
}

#[test]
fn several_dialects_are_one_module() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::write(path("acme.xml"), ACME).unwrap();
    fs::write(path("base.xml"), BASE).unwrap();
    fs::write(path("fork.xml"), "<mavlink><include>base.xml</include></mavlink>").unwrap();
    let builder = Builder::new(path("acme.xml")).root(path("fork.xml"));
    let said = builder.said(&path("out"));
    let watched = [path("acme.xml"), path("base.xml"), path("fork.xml")];
    let watched = watched.map(|path: PathBuf| path.display().to_string());
    assert_eq!(starting(&said, "cargo::rerun-if-changed="), watched, "what both include is named once");
    let entry = fs::read_to_string(path("out/dialects.rs")).unwrap();
    assert!(entry.contains("/// The dialects `acme`, `fork`, each in its module"), "{entry}");
    assert!(entry.contains("#[path = \"dialects/mod.rs\"]\npub mod dialects;"), "{entry}");
    assert!(path("out/dialects/acme/dialect.rs").exists());
    builder.clone().name("fleet").said(&path("out"));
    assert!(path("out/fleet.rs").exists() && path("out/fleet/fork.rs").exists());
    let said = builder.name("---").said(&path("out"));
    assert_eq!(starting(&said, "cargo::error=").len(), 1, "{said:?}");
}

#[test]
fn two_builders_do_not_write_over_each_other() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    fs::create_dir(path("v2")).unwrap();
    for name in ["acme.xml", "v2/Acme.xml", "fork.xml"] {
        fs::write(path(name), BASE).unwrap();
    }
    let (builders, out) = (Builders::default(), path("out"));
    let errors = |builder: &Builder| -> Vec<String> {
        let said = builder.cargo_directives(&Place::new(&out, &builders, true));
        assert_eq!(starting(&said, "cargo::rerun-if-changed=").len(), 1, "{said:?}");
        starting(&said, "cargo::error=").into_iter().map(str::to_owned).collect()
    };
    let (acme, other) = (Builder::new(path("acme.xml")), Builder::new(path("v2/Acme.xml")));
    assert!(errors(&acme).is_empty());
    let [said] = &*errors(&other) else { panic!() };
    assert!(said.contains("v2/Acme.xml` make one module, `acme`: name one of them"), "{said}");
    assert_eq!(errors(&acme).len(), 1, "its own files are no better");
    assert!(errors(&other.name("acme2").out_dir(path("src/acme2"))).is_empty());

    let fork = Builder::new(path("fork.xml"));
    for taken in ["src/acme2", "src/acme2/../acme2/fork", "src", "out/acme"] {
        let [said] = &*errors(&fork.clone().out_dir(path(taken))) else { panic!("{taken}") };
        assert!(said.contains("give each its own Builder::out_dir"), "{said}");
    }
    assert!(errors(&fork.out_dir(path("src/fork"))).is_empty());
    for file in ["out/acme/mod.rs", "src/acme2/mod.rs", "src/fork/mod.rs"] {
        assert!(path(file).exists(), "{file}");
    }
}

#[test]
fn a_script_that_went_elsewhere_watches_whole_paths() {
    let (here, there) = (Builders::default(), Builders::default());
    let (here, there) = (Place::new(Path::new("out"), &here, true), Place::new(Path::new("out"), &there, false));
    assert_eq!(here.for_cargo(Path::new("xml/acme.xml")), Path::new("xml/acme.xml"));
    assert_eq!(there.for_cargo(Path::new("xml/acme.xml")), absolute("xml/acme.xml").unwrap());
}
