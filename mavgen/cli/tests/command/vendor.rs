//! `vendor`: exit status, and what it says.

use std::fs;
use std::path::Path;
use std::process::Output;

use crate::{mavgen, stderr, tree};

const ACME: &str = "<mavlink>
  <include>parts/base.xml</include>
  <messages>
    <message id=\"4711\" name=\"SPRAYER\">
      <description>What the sprayer does.</description>
      <field type=\"uint8_t\" name=\"state\" enum=\"SPRAY_STATE\">Whether it sprays.</field>
      <field type=\"uint16_t\" name=\"level\">What is left.</field>
    </message>
  </messages>
</mavlink>
";

const BASE: &str = "<mavlink>
  <enums>
    <enum name=\"SPRAY_STATE\">
      <entry value=\"0\" name=\"SPRAY_STATE_OFF\"/>
    </enum>
  </enums>
  <messages/>
</mavlink>
";

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("parts")).unwrap();
    fs::write(folder.path().join("acme.xml"), ACME).unwrap();
    fs::write(folder.path().join("parts/base.xml"), BASE).unwrap();
    folder
}

fn vendor(folder: &Path, arguments: &[&str]) -> Output {
    mavgen(folder, &[&["vendor", "acme.xml", "--out", "xml"], arguments].concat())
}

#[test]
fn a_copy_generates_what_its_original_does() {
    let folder = folder();
    let copied = vendor(folder.path(), &[]);
    assert_eq!((copied.status.code(), stderr(&copied).as_str()), (Some(0), "xml: 2 files written, 0 kept\n"));
    assert!(fs::read_to_string(folder.path().join("xml/acme.xml")).unwrap().contains("<include>base.xml</include>"));
    let generated = |xml: &str, out: &str| {
        assert!(mavgen(folder.path(), &["generate", xml, "--out", out]).status.success());
        let mut files = tree(&folder.path().join(out));
        // It has a digest of the sources.
        files.retain(|(path, _)| path != Path::new("mod.rs"));
        files
    };
    assert_eq!(generated("xml/acme.xml", "copy"), generated("acme.xml", "original"));
}

/// Beside one's own dialect, which includes what is copied, and its overlay.
#[test]
fn what_else_is_in_the_folder_stays() {
    let folder = folder();
    let xml = folder.path().join("xml");
    fs::create_dir_all(xml.join("overlay")).unwrap();
    fs::write(xml.join("own.xml"), "<mavlink><include>acme.xml</include></mavlink>").unwrap();
    fs::write(xml.join("overlay/own.xml"), "<mavlink-overlay version='1' for='own.xml'/>").unwrap();
    let before = tree(&xml);
    for said in ["xml: 2 files written, 0 kept\n", "xml: 0 files written, 2 kept\n"] {
        let copied = vendor(folder.path(), &[]);
        assert_eq!((copied.status.code(), stderr(&copied).as_str()), (Some(0), said));
        let mut after = tree(&xml);
        after.retain(|(path, _)| !["acme.xml", "base.xml"].iter().any(|copy| path == Path::new(copy)));
        assert_eq!(after, before);
    }
    let linted = mavgen(folder.path(), &["lint", "xml/own.xml", "--overlay", "xml/overlay/own.xml"]);
    assert_eq!(linted.status.code(), Some(0), "{}", stderr(&linted));
}

#[test]
fn descriptions_are_kept_over_new_facts() {
    let folder = folder();
    let copy = folder.path().join("xml/acme.xml");
    assert_eq!(vendor(folder.path(), &["--no-prose"]).status.code(), Some(0));
    let bare = fs::read_to_string(&copy).unwrap();
    assert!(!bare.contains("sprayer does"));
    fs::write(&copy, bare.replace("name=\"level\"/>", "name=\"level\">In the tank.</field>")).unwrap();
    let changed = ACME.replace("\"level\">What is left.", "\"level\" units=\"cm\">What is left.");
    let changed =
        changed.replace("    </message>", "<field type=\"uint8_t\" name=\"nozzles\">How many.</field></message>");
    fs::write(folder.path().join("acme.xml"), &changed).unwrap();

    let kept = vendor(folder.path(), &["--prose-from", "xml"]);
    let said = "xml: 2 files written, 0 kept\n\
        xml/acme.xml: new, and without a description: message SPRAYER field nozzles\n\
        5 of 6 items have no description, 1 of them new; 0 descriptions found no place\n";
    assert_eq!((kept.status.code(), stderr(&kept).as_str()), (Some(0), said));
    let copied = fs::read_to_string(&copy).unwrap();
    assert!(
        copied.contains("name=\"level\" units=\"cm\">In the tank.</field>") && !copied.contains("How many"),
        "{copied}"
    );

    let all = vendor(folder.path(), &["--prose-from", "xml", "--all"]);
    assert!(stderr(&all).contains("xml/base.xml: without a description: enum SPRAY_STATE\n"), "{}", stderr(&all));
    fs::write(folder.path().join("acme.xml"), changed.replace("level", "height")).unwrap();
    let lost = vendor(folder.path(), &["--prose-from", "xml"]);
    let line = "xml/acme.xml: no longer in the definitions: message SPRAYER field level: In the tank.\n";
    assert!(stderr(&lost).contains(line), "{}", stderr(&lost));
}

#[test]
fn refusals_are_2_and_cost_nothing() {
    let folder = folder();
    fs::create_dir(folder.path().join("xml")).unwrap();
    fs::write(folder.path().join("xml/base.xml"), "<mavlink/>").unwrap();
    let mine = vendor(folder.path(), &[]);
    let said = "error: xml/base.xml: `mavgen vendor` did not write this file: remove it, or choose another folder\n";
    assert_eq!((mine.status.code(), stderr(&mine).as_str()), (Some(2), said));
    assert_eq!(vendor(folder.path(), &["--no-prose", "--prose-from", "xml"]).status.code(), Some(2));
    assert_eq!(tree(&folder.path().join("xml")), [("base.xml".into(), b"<mavlink/>".to_vec())]);
    fs::remove_file(folder.path().join("xml/base.xml")).unwrap();
    fs::write(folder.path().join("acme.xml"), ACME.replace("uint16_t", "uint24_t")).unwrap();
    let refused = vendor(folder.path(), &[]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(stderr(&refused).contains("acme.xml:7:20"), "{}", stderr(&refused));
    assert_eq!(fs::read_dir(folder.path().join("xml")).unwrap().count(), 0);
}

/// Nobody can mend what is included; what is one's own can be, and is not copied before that.
#[test]
fn denied_warnings_write_nothing() {
    let folder = folder();
    let warned = |text: &str| text.replace("<messages", "<!-- --><odd/><messages");
    fs::write(folder.path().join("parts/base.xml"), warned(BASE)).unwrap();
    let theirs = vendor(folder.path(), &["--deny-warnings"]);
    assert_eq!((theirs.status.code(), stderr(&theirs).as_str()), (Some(0), "xml: 2 files written, 0 kept\n"));
    let before = tree(&folder.path().join("xml"));

    fs::write(folder.path().join("acme.xml"), warned(ACME)).unwrap();
    let ours = vendor(folder.path(), &["--deny-warnings"]);
    let said = stderr(&ours);
    assert_eq!(ours.status.code(), Some(2));
    assert!(said.contains("acme.xml:3") && said.contains("are denied") && !said.contains("base.xml"), "{said}");
    assert_eq!(tree(&folder.path().join("xml")), before);
    let warned = vendor(folder.path(), &[]);
    assert!(warned.status.success() && stderr(&warned).starts_with("warning"), "{}", stderr(&warned));
}

#[test]
fn a_part_with_what_it_needs_and_what_decides_on_that() {
    let folder = folder();
    let wide = "<messages><message id=\"4712\" name=\"WIDE\"><field type=\"uint32_t\" name=\"x\" enum=\"SPRAY_STATE\"/></message>\
        <message id=\"4713\" name=\"OTHER\"><field type=\"uint8_t\" name=\"x\"/></message></messages>";
    fs::write(folder.path().join("parts/base.xml"), BASE.replace("<messages/>", wide)).unwrap();
    let copied = vendor(folder.path(), &["--messages", "SPR*"]);
    let said = "xml: 2 files written, 0 kept\n\
        also copied: message WIDE: without it, enum `SPRAY_STATE` would be another integer in Rust\n";
    // Two widths of one enum are worth a warning.
    assert!(copied.status.success() && stderr(&copied).ends_with(said), "{}", stderr(&copied));
    let dump = |xml: &str| {
        let dump = mavgen(folder.path(), &["dump", xml, "--json", "--messages", "SPRAYER"]);
        String::from_utf8(dump.stdout).unwrap()
    };
    assert_eq!(dump("xml/acme.xml"), dump("acme.xml"));
    let base = fs::read_to_string(folder.path().join("xml/base.xml")).unwrap();
    assert!(base.contains("a part, 1 of its 2 messages and 1 of its 1 enums: ") && !base.contains("OTHER"), "{base}");

    let before = tree(&folder.path().join("xml"));
    for (messages, said) in [
        ("SPRAYE", "error: no message of acme.xml is called `SPRAYE` (did you mean `SPRAYER`?)\n"),
        ("BELL_*", "error: no message of acme.xml is called `BELL_*`\n"),
        ("", "error: the list of messages is empty, or has an empty name: give names like HEARTBEAT, or PARAM_*\n"),
    ] {
        let refused = vendor(folder.path(), &["--messages", messages]);
        assert_eq!((refused.status.code(), stderr(&refused).as_str()), (Some(2), said));
    }
    assert_eq!(tree(&folder.path().join("xml")), before);
}

#[test]
fn an_edited_copy_stays() {
    let folder = folder();
    vendor(folder.path(), &[]);
    let copy = folder.path().join("xml/base.xml");
    let edited = fs::read_to_string(&copy).unwrap().replace("value=\"0\"", "value=\"1\"");
    fs::write(&copy, &edited).unwrap();
    fs::write(folder.path().join("acme.xml"), ACME.replace("What is left.", "What is left in it.")).unwrap();
    let before = tree(&folder.path().join("xml"));
    for prose in [&[][..], &["--no-prose"], &["--prose-from", "xml"]] {
        let refused = vendor(folder.path(), prose);
        let said = "error: xml/base.xml: this file was edited: move the edit to its source, or to a file that includes it, \
            and remove this one\n";
        assert_eq!((refused.status.code(), stderr(&refused).lines().next()), (Some(2), said.lines().next()));
        assert_eq!(tree(&folder.path().join("xml")), before);
    }
    fs::remove_file(&copy).unwrap();
    assert!(vendor(folder.path(), &[]).status.success());
}

#[test]
fn a_copy_is_not_made_of_itself_under_any_name() {
    let folder = folder();
    vendor(folder.path(), &[]);
    fs::create_dir(folder.path().join("linked")).unwrap();
    fs::hard_link(folder.path().join("xml/acme.xml"), folder.path().join("linked/acme.xml")).unwrap();
    // Only Unix knows files from their links.
    for out in if cfg!(unix) { &["xml", "./xml", "linked"][..] } else { &["xml"] } {
        let refused = mavgen(folder.path(), &["vendor", "xml/acme.xml", "--out", out]);
        let said = stderr(&refused);
        assert!(
            said.contains("acme.xml: this is the file that would be copied: choose another folder"),
            "{out}: {said}"
        );
        assert_eq!(refused.status.code(), Some(2));
    }
}
