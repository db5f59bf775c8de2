//! Files that are whole or not there, and what nothing is written to.

use super::*;

fn write(overwriting: Overwriting, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let mut output = overwriting.whole(path, None)?;
    output.write_all(bytes).map_err(Failure::written)?;
    output.finish()
}

fn sentence<T>(result: Result<T, Failure>) -> String {
    match result {
        Err(Failure::Sentence(sentence)) => sentence,
        _ => panic!("no sentence"),
    }
}

const ASKED: Overwriting = Overwriting { force: false };
const FORCED: Overwriting = Overwriting { force: true };

#[test]
fn nothing_is_overwritten_without_force() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flight.tlog");
    write(ASKED, &path, b"first").unwrap();
    let said = sentence(write(ASKED, &path, b"second"));
    assert!(said.contains("exists already") && said.contains("--force"), "{said}");
    assert!(sentence(ASKED.growing(&path, None)).contains("exists already"));
    assert_eq!(fs::read(&path).unwrap(), b"first");
    write(FORCED, &path, b"third").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"third");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_file_that_comes_meanwhile_is_not_overwritten_either() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flight.tlog");
    let output = ASKED.whole(&path, None).unwrap();
    fs::write(&path, b"somebody's").unwrap();
    assert!(sentence(output.finish()).contains("exists already"));
    assert_eq!(fs::read(&path).unwrap(), b"somebody's");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_file_that_is_not_finished_is_not_there() {
    let folder = tempfile::tempdir().unwrap();
    let (new, old) = (folder.path().join("new.csv"), folder.path().join("old.csv"));
    fs::write(&old, b"first").unwrap();
    for path in [&new, &old] {
        let mut output = FORCED.whole(path, None).unwrap();
        output.write_all(&[b'x'; 100_000]).unwrap();
        drop(output);
    }
    assert!(!new.exists());
    assert_eq!(fs::read(&old).unwrap(), b"first");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    // A recording is of use as far as it goes.
    FORCED.growing(&new, None).unwrap().write_all(b"entry").unwrap();
    assert_eq!(fs::read(&new).unwrap(), b"entry");
}

#[test]
fn nothing_is_written_onto_what_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let [log, linked, other] = ["flight.tlog", "linked.tlog", "other.tlog"].map(|name| folder.path().join(name));
    fs::write(&log, b"first").unwrap();
    fs::hard_link(&log, &linked).unwrap();
    let mut names = vec![folder.path().join(".").join("flight.tlog")];
    #[cfg(unix)]
    {
        names.push(linked);
        names.push(folder.path().join("symlink.tlog"));
        std::os::unix::fs::symlink(&log, folder.path().join("symlink.tlog")).unwrap();
    }
    for same in names {
        assert!(sentence(FORCED.growing(&same, Some(&log))).contains("is what is read"), "{}", same.display());
        assert!(sentence(FORCED.whole(&same, Some(&log))).contains("is what is read"), "{}", same.display());
    }
    assert_eq!(fs::read(&log).unwrap(), b"first");
    assert!(FORCED.growing(&other, Some(&log)).is_ok());
}

#[test]
fn what_is_no_place_for_a_file_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("missing").join("flight.tlog");
    assert!(sentence(FORCED.whole(&missing, None)).contains("No such file or directory"));
    assert!(sentence(FORCED.whole(folder.path(), None)).contains("is a folder"));
}

#[cfg(unix)]
#[test]
fn links_and_permissions_stay() {
    use std::os::unix::fs::{PermissionsExt as _, symlink};
    let folder = tempfile::tempdir().unwrap();
    let (file, link) = (folder.path().join("flight.csv"), folder.path().join("latest.csv"));
    fs::write(&file, b"first").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    symlink(&file, &link).unwrap();
    assert!(sentence(write(ASKED, &link, b"second")).contains("exists already"));
    write(FORCED, &link, b"second").unwrap();
    assert!(link.is_symlink());
    assert_eq!(fs::read(&file).unwrap(), b"second");
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
}
