//! Copies that somebody edited.

use super::*;
use crate::vendor::write;

const A: &str = "<mavlink>\r\n  <include>parts/b.xml</include>\r\n  <messages>\r\n\
    \x20   <message id='1' name='M'><field type='uint8_t' name='x' enum='E'>A field.</field></message>\r\n\
    \x20 </messages>\r\n</mavlink>\r\n";
const B: &str = "<?xml version='1.0'?>\n<mavlink>\n  <enums>\n    <enum name='E'><entry value='0' name='E_A'/></enum>\n\
    \x20   <enum name='UNUSED'><entry value='0' name='UNUSED_A'/></enum>\n  </enums>\n  <messages/>\n</mavlink>\n";

fn dialect() -> tempfile::TempDir {
    folder(&[("a.xml", A), ("parts/b.xml", B)])
}

/// What people do to a copy, by its text.
type Edit = dyn Fn(&str) -> String;

/// Edits one of two copies and gives the sources a new state; whether the copies can then be written anew, and why not.
fn again(first: &Prose, edited: (&str, &Edit), then: &Prose) -> Result<(), String> {
    let folder = dialect();
    let out = written(&copies(folder.path(), first), folder.path());
    let path = out.join(edited.0);
    put(&path, &edited.1(&fs::read_to_string(&path).unwrap()));
    let before = fs::read(&path).unwrap();
    put(&folder.path().join("a.xml"), &A.replace("A field.", "Another one."));
    put(&folder.path().join("parts/b.xml"), &B.replace("'E_A'/>", "'E_A'/><entry value='1' name='E_B'/>"));
    let then = match then {
        Prose::From(_) => Prose::From(out.clone()),
        other => other.clone(),
    };
    let result = vendor(&Builder::new(folder.path().join("a.xml")), &then).unwrap();
    let result = write(&out, &result).map(|_| ()).map_err(|error| {
        assert_eq!(error.path, path);
        error.to_string()
    });
    assert_eq!(result.is_err(), fs::read(&path).unwrap() == before);
    result
}

fn here() -> Prose {
    Prose::From(PathBuf::new())
}

#[test]
fn what_nobody_edited_is_written_anew() {
    let converted: [&Edit; 4] = [
        &|text| text.to_owned(),
        &|text| text.replace("\r\n", "\n").replace('\n', "\r\n"),
        &|text| text.replace("\r\n", "\n"),
        &|text| format!("\u{feff}{text}"),
    ];
    for edit in converted {
        for name in ["a.xml", "b.xml"] {
            for (first, then) in [
                (Prose::Keep, Prose::Keep),
                (Prose::Keep, Prose::Drop),
                (Prose::Drop, Prose::Keep),
                (Prose::Drop, here()),
            ] {
                assert_eq!(again(&first, (name, edit), &then), Ok(()), "{first:?} {then:?}");
            }
        }
    }
}

#[test]
fn an_edited_text_is_not_written_over() {
    let edits: [(&str, &Edit); 5] = [
        ("a.xml", &|text| text.replace("A field.", "A  field.")),
        ("a.xml", &|text| text.replace("uint8_t", "uint16_t")),
        ("b.xml", &|text| text.replace("<enums>", "<!-- mine --><enums>")),
        ("b.xml", &|text| text.replace("version='1.0'", "version='1.0' encoding='UTF-8'")),
        ("b.xml", &|text| text.replace("; to notice edits", "")),
    ];
    for (name, edit) in edits {
        for then in [Prose::Keep, Prose::Drop] {
            let refusal = again(&Prose::Keep, (name, edit), &then).unwrap_err();
            assert!(refusal.contains("this file was edited: move the edit to its source"), "{refusal}");
        }
    }
}

#[test]
fn edited_facts_are_not_written_over() {
    let edits: [(&str, &Edit); 5] = [
        ("a.xml", &|text| text.replace("uint8_t", "uint16_t")),
        ("a.xml", &|text| text.replace("name=\"x\"", "name=\"x\" units=\"m\"")),
        ("a.xml", &|text| text.replace("<messages>", "<version>4</version><messages>")),
        ("b.xml", &|text| text.replace("<enums>", "mine <enums>")),
        ("b.xml", &|text| text.replace("</mavlink>", "")),
    ];
    for (name, edit) in edits {
        for then in [Prose::Keep, Prose::Drop] {
            let refusal = again(&Prose::Drop, (name, edit), &then).unwrap_err();
            assert!(refusal.contains("more than descriptions was edited"), "{refusal}");
        }
    }
    let (name, edit) = edits[1];
    let refusal = again(&Prose::Drop, (name, edit), &here()).unwrap_err();
    assert!(refusal.contains("more than descriptions was edited"), "{refusal}");
}

#[test]
fn descriptions_are_for_people_to_write() {
    let describe: &Edit = &|text| {
        text.replace("<enum name=\"E\">", "<!-- mine -->\n    <enum name=\"E\"><description>Mine.</description>")
    };
    assert_eq!(again(&Prose::Drop, ("b.xml", describe), &here()), Ok(()));
    for then in [Prose::Keep, Prose::Drop] {
        let refusal = again(&Prose::Drop, ("b.xml", describe), &then).unwrap_err();
        assert!(refusal.contains("--prose-from"), "{refusal}");
    }
}

/// Descriptions of another folder are not those that somebody wrote into the copies.
#[test]
fn descriptions_of_another_folder_take_no_others_place() {
    let folder = dialect();
    put(&folder.path().join("words/b.xml"), &B.replace("'E'>", "'E'><description>Theirs.</description>"));
    let theirs = || copies(folder.path(), &Prose::From(folder.path().join("words")));
    let out = written(&theirs(), folder.path());
    let copy = fs::read_to_string(out.join("b.xml")).unwrap();
    put(&out.join("b.xml"), &copy.replace("Theirs.", "Mine."));
    let error = write(&out, &theirs()).unwrap_err().to_string();
    assert!(error.contains("b.xml") && error.contains("`--prose-from` its folder"), "{error}");
    put(&out.join("b.xml"), &copy);
    put(&folder.path().join("words/a.xml"), A);
    assert_eq!(write(&out, &theirs()).unwrap().written, 1, "what was there is there again");
}

#[test]
fn descriptions_are_not_lost_to_a_selection() {
    let folder = dialect();
    let out = written(&copies(folder.path(), &Prose::Drop), folder.path());
    let some = |prose: &Prose| vendor(&Builder::new(folder.path().join("a.xml")).messages(["M"]), prose).unwrap();
    let copy = fs::read_to_string(out.join("b.xml")).unwrap();
    put(&out.join("b.xml"), &copy.replace("\"UNUSED\">", "\"UNUSED\"><description>Mine.</description>"));
    let error = write(&out, &some(&Prose::From(out.clone()))).unwrap_err().to_string();
    assert!(error.contains("b.xml") && error.contains("what `--messages` leaves out"), "{error}");
    assert!(fs::read_to_string(out.join("b.xml")).unwrap().contains("Mine."));

    put(&out.join("b.xml"), &copy.replace("\"E\">", "\"E\"><description>Mine.</description>"));
    assert_eq!(write(&out, &some(&Prose::From(out.clone()))).unwrap().written, 2);
    let part = fs::read_to_string(out.join("b.xml")).unwrap();
    assert!(part.contains("Mine.") && !part.contains("UNUSED"), "{part}");
    assert_eq!(write(&out, &copies(folder.path(), &Prose::From(out.clone()))).unwrap().written, 1, "and back");
}

#[test]
fn what_is_no_text_any_more_was_edited() {
    let folder = dialect();
    let out = written(&copies(folder.path(), &Prose::Keep), folder.path());
    let mut bytes = fs::read(out.join("b.xml")).unwrap();
    bytes.extend(b"<!-- \xe9 -->");
    fs::write(out.join("b.xml"), &bytes).unwrap();
    let error = write(&out, &copies(folder.path(), &Prose::Keep)).unwrap_err().to_string();
    assert!(error.contains("this file was edited"), "{error}");
}
