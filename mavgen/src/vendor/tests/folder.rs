use super::*;
use crate::vendor::write;

const A: &str = "<mavlink><include>b.xml</include><messages/></mavlink>";
const B: &str = "<mavlink><enums><enum name='E'><entry value='0' name='E_A'/></enum></enums><messages/></mavlink>";

fn dialect() -> tempfile::TempDir {
    folder(&[("a.xml", A), ("b.xml", B)])
}

#[test]
fn again_writes_nothing() {
    let folder = dialect();
    for prose in [Prose::Keep, Prose::Drop] {
        let (vendored, out) = (copies(folder.path(), &prose), folder.path().join(format!("{prose:?}")));
        let first = write(&out, &vendored).unwrap();
        assert_eq!((first.written, first.kept), (2, 0));
        let second = write(&out, &copies(folder.path(), &prose)).unwrap();
        assert_eq!((second.written, second.kept), (0, 2));
    }
}

/// The user's own dialect is there first, and includes what is vendored beside it.
#[test]
fn what_else_is_in_the_folder_stays_as_it_is() {
    let folder = dialect();
    let mine = folder.path().join("mine");
    let files = [
        ("own.xml", "<mavlink><include>a.xml</include></mavlink>"),
        ("overlay/own.xml", "<mavlink-overlay version='1' for='own.xml'/>"),
        ("notes.txt", "x"),
    ];
    files.iter().for_each(|(name, text)| put(&mine.join(name), text));
    for prose in [Prose::Keep, Prose::Keep, Prose::From(mine.clone())] {
        let vendored = copies(folder.path(), &prose);
        if matches!(prose, Prose::From(_)) {
            fs::remove_file(mine.join("a.xml")).unwrap();
            fs::remove_file(mine.join("b.xml")).unwrap();
        }
        let done = write(&mine, &vendored).unwrap();
        assert!(done.others.is_empty());
        files.iter().for_each(|(name, text)| assert_eq!(fs::read_to_string(mine.join(name)).unwrap(), *text));
        assert_eq!(fs::read_dir(&mine).unwrap().count(), 5);
    }
    assert!(Builder::new(mine.join("own.xml")).overlay(mine.join("overlay/own.xml")).resolve().is_ok());
}

#[test]
fn somebodys_file_is_never_written_over() {
    let folder = dialect();
    let vendored = copies(folder.path(), &Prose::Keep);
    let out = written(&vendored, folder.path());
    put(&out.join("b.xml"), B);
    put(&out.join("a.xml"), &vendored.files[0].text.replace("unchanged", "changed"));
    let error = write(&out, &vendored).unwrap_err();
    assert!(error.path.ends_with("b.xml") && error.to_string().contains("did not write"), "{error}");
    assert_eq!(fs::read_to_string(out.join("b.xml")).unwrap(), B);
    let first = fs::read_to_string(out.join("a.xml")).unwrap();
    assert!(first.contains(" changed below"), "nothing is written where something is refused");
}

#[test]
fn what_is_not_of_the_dialect_stays() {
    let folder = dialect();
    let out = written(&copies(folder.path(), &Prose::Keep), folder.path());
    put(&out.join("notes.txt"), "mine");
    put(&folder.path().join("a.xml"), "<mavlink><messages/></mavlink>");
    let done = write(&out, &copies(folder.path(), &Prose::Keep)).unwrap();
    assert_eq!((done.written, done.others), (1, vec![out.join("b.xml")]));
    assert!(out.join("notes.txt").exists() && out.join("b.xml").exists());
}

/// Without this, one forgotten option would cost every description that was written into the copies.
#[test]
fn descriptions_are_not_written_over() {
    let folder = dialect();
    put(&folder.path().join("words/b.xml"), &B.replace("'E'>", "'E'><description>Ours.</description>"));
    let out = written(&copies(folder.path(), &Prose::From(folder.path().join("words"))), folder.path());
    let refuses = || {
        for prose in [Prose::Keep, Prose::Drop] {
            let error = write(&out, &copies(folder.path(), &prose)).unwrap_err();
            assert!(error.path.ends_with("b.xml") && error.to_string().contains("--prose-from"), "{error}");
        }
        assert!(fs::read_to_string(out.join("b.xml")).unwrap().contains("Ours."));
    };
    refuses();
    fs::remove_file(out.join("b.xml")).unwrap();
    write(&out, &copies(folder.path(), &Prose::Drop)).unwrap();
    write(&out, &copies(folder.path(), &Prose::Drop)).unwrap();
    let described = fs::read_to_string(out.join("b.xml")).unwrap().replace("name=\"E\">", "name=\"E\"><!-- Ours. -->");
    put(&out.join("b.xml"), &described);
    refuses();
}

#[test]
fn a_source_is_not_its_own_copy() {
    let folder = dialect();
    let out = written(&copies(folder.path(), &Prose::Drop), folder.path());
    let error = write(&out, &copies(&out, &Prose::Drop)).unwrap_err();
    assert!(error.to_string().contains("choose another folder"), "{error}");
}

#[test]
fn two_files_of_one_name_are_an_error() {
    for (first, second) in [("b.xml", "b.xml"), ("b.xml", "B.xml")] {
        let top = format!("<mavlink><include>x/{first}</include><include>y/{second}</include><messages/></mavlink>");
        let folder = folder(&[
            ("a.xml", &top),
            (&format!("x/{first}"), B),
            (&format!("y/{second}"), "<mavlink><messages/></mavlink>"),
        ]);
        let failure = vendor(&Builder::new(folder.path().join("a.xml")), &Prose::Keep).unwrap_err().to_string();
        assert!(failure.contains("one file in one folder") && failure.contains(&format!("y/{second}")), "{failure}");
    }
}

#[test]
fn wrong_definitions_are_not_copied() {
    let folder = folder(&[("a.xml", "<mavlink><include>missing.xml</include><messages/></mavlink>")]);
    let failure = vendor(&Builder::new(folder.path().join("a.xml")), &Prose::Keep).unwrap_err();
    assert!(failure.to_string().contains("missing.xml"), "{failure}");
}
