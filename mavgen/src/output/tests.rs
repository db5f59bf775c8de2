//! What is written, what is kept, and what is never touched.

use std::time::{Duration, SystemTime};

use super::*;
use crate::lower::{MARK, ROOT_MARK};

fn file(path: &str, text: &str) -> GeneratedFile {
    GeneratedFile { path: path.to_owned(), text: format!("{MARK}\n{text}") }
}

/// Every path below a folder with the text of its file, by path.
fn tree(folder: &Path) -> Vec<(PathBuf, String)> {
    let (mut tree, mut open) = (Vec::new(), vec![folder.to_owned()]);
    while let Some(below) = open.pop() {
        for path in fs::read_dir(below).unwrap().map(|entry| entry.unwrap().path()) {
            let relative = path.strip_prefix(folder).unwrap().to_owned();
            if path.is_dir() {
                tree.push((relative, String::new()));
                open.push(path);
            } else {
                tree.push((relative, fs::read_to_string(path).unwrap()));
            }
        }
    }
    tree.sort();
    tree
}

/// A folder that holds `mod.rs` and `messages/b.rs` of ours.
fn written() -> (tempfile::TempDir, PathBuf) {
    let parent = tempfile::tempdir().unwrap();
    let folder = parent.path().join("out");
    write(&folder, &[file("mod.rs", "a"), file("messages/b.rs", "b")]).unwrap();
    (parent, folder)
}

#[test]
fn writes_keeps_and_removes() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path().join("deep/out");
    let (a, b) = (file("mod.rs", "a"), file("messages/b.rs", "b"));
    let first = write(&folder, &[a.clone(), b.clone()]).unwrap();
    assert_eq!(first, Report { written: 2, kept: 0, removed: 0 });
    fs::write(folder.join("notes.txt"), "mine").unwrap();
    fs::write(folder.join("messages/mine.rs"), "// mine").unwrap();
    let second = write(&folder, &[a.clone(), file("messages/c.rs", "c")]).unwrap();
    assert_eq!(second, Report { written: 1, kept: 1, removed: 1 });
    assert!(folder.join("notes.txt").exists() && folder.join("messages/mine.rs").exists());
    assert!(!folder.join("messages/b.rs").exists());
    let differences = check(&folder, &[file("mod.rs", "changed"), b]).unwrap();
    assert_eq!((differences.changed.len(), differences.missing.len(), differences.stale.len()), (1, 1, 1));
}

#[cfg(unix)]
#[test]
fn a_file_that_cannot_be_read_is_not_called_somebody_elses() {
    use std::os::unix::fs::PermissionsExt;
    let (_parent, folder) = written();
    let hidden = folder.join("messages/b.rs");
    fs::set_permissions(&hidden, fs::Permissions::from_mode(0o000)).unwrap();
    if fs::File::open(&hidden).is_ok() {
        // The superuser reads everything.
        return;
    }
    let refused = write(&folder, &[file("mod.rs", "a"), file("messages/b.rs", "c")]).unwrap_err();
    assert_eq!((refused.path, refused.source.kind()), (hidden, io::ErrorKind::PermissionDenied));
}

#[test]
fn line_ends_are_told_from_contents() {
    let (_parent, folder) = written();
    let crlf = |path: &str, text: &str| {
        fs::write(folder.join(path), format!("{MARK}\n{text}\n").replace('\n', "\r\n")).unwrap()
    };
    crlf("mod.rs", "a\nb");
    crlf("messages/b.rs", "c");
    let found = check(&folder, &[file("mod.rs", "a\nb\n"), file("messages/b.rs", "b\n")]).unwrap();
    assert_eq!(
        (&*found.line_ends, &*found.changed),
        (&[folder.join("mod.rs")][..], &[folder.join("messages/b.rs")][..])
    );
    let shown = found.to_string();
    assert!(shown.starts_with("1 with CRLF line ends, ") && shown.lines().count() == 2, "{shown}");
    let only = Differences { changed: Vec::new(), ..found };
    assert!(!only.is_empty() && only.to_string().lines().count() == 1, "{only}");
}

#[test]
fn differences_are_listed_as_far_as_one_reads() {
    let mut differences = Differences { changed: vec!["a.rs".into()], ..Differences::default() };
    differences.stale.push("b.rs".into());
    assert_eq!(differences.to_string(), "a.rs differs\nb.rs is no longer generated");
    differences.missing = vec!["c.rs".into(); 30];
    let lines = differences.to_string();
    assert_eq!((lines.lines().count(), lines.lines().last()), (21, Some("... and 12 more")));
    assert_eq!(Differences::default().to_string(), "");
}

#[test]
fn nothing_but_the_tree_is_left() {
    let (_parent, folder) = written();
    let names: Vec<PathBuf> = tree(&folder).into_iter().map(|(path, _)| path).collect();
    assert_eq!(names, ["messages", "messages/b.rs", "mod.rs"].map(PathBuf::from));
}

#[test]
fn what_is_current_is_not_touched() {
    let (_parent, folder) = written();
    let long_ago = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000);
    let kept = fs::File::options().write(true).open(folder.join("messages/b.rs")).unwrap();
    kept.set_modified(long_ago).unwrap();
    let modified = |path: &str| fs::metadata(folder.join(path)).unwrap().modified().unwrap();
    let report = write(&folder, &[file("mod.rs", "changed"), file("messages/b.rs", "b")]).unwrap();
    assert_eq!(report, Report { written: 1, kept: 1, removed: 0 });
    assert_eq!(modified("messages/b.rs"), long_ago);
    assert!(modified("mod.rs") > long_ago);
}

#[test]
fn a_reader_sees_all_of_the_old_file_or_all_of_the_new_one() {
    use std::io::Read;
    let (_parent, folder) = written();
    let mut reader = fs::File::open(folder.join("mod.rs")).unwrap();
    write(&folder, &[file("mod.rs", "much longer than it was"), file("messages/b.rs", "b")]).unwrap();
    let mut seen = String::new();
    reader.read_to_string(&mut seen).unwrap();
    assert_eq!(seen, file("", "a").text, "the file was replaced, not overwritten");
}

#[test]
fn somebodys_folder_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("thesis.txt"), "x").unwrap();
    let error = write(folder.path(), &[file("mod.rs", "a")]).unwrap_err();
    assert!(error.to_string().contains("not empty"));
    assert!(!folder.path().join("mod.rs").exists());
    // An empty path is the current folder, which is that of this package.
    let error = write(Path::new(""), &[file("mod.rs", "a")]).unwrap_err();
    assert!(error.to_string().contains("not empty"));
}

/// Generated files somewhere below do not make a folder one of ours: it may be the root of everything.
#[test]
fn a_folder_around_somebodys_tree_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir_all(folder.path().join("crate/src")).unwrap();
    fs::write(folder.path().join("crate/src/acme.rs"), MARK).unwrap();
    let before = tree(folder.path());
    let error = write(folder.path(), &[file("mod.rs", "a"), file("messages/b.rs", "b")]).unwrap_err();
    assert!(error.to_string().contains("not empty"), "{error}");
    assert!(check(folder.path(), &[file("mod.rs", "a")]).unwrap().stale.is_empty());
    assert_eq!(tree(folder.path()), before);
}

/// What lies in the folder, and whether it is written into. What is not of its tree stays as it was.
#[test]
fn what_is_not_ours_is_never_touched() {
    let root = format!("{MARK} from b.xml; do not edit.\n{ROOT_MARK}0.1.0\n");
    let root = root.as_str();
    for (there, is_written) in [
        (vec![], true),
        (vec![("thesis.txt", "x")], false),
        (vec![("below/thesis.txt", "x")], false),
        (vec![(".git/config", "x")], false),
        (vec![(".mavgen-staging-1-0", "x")], false),
        (vec![("mod.rs", "// by hand")], false),
        (vec![("gen/mod.rs", root)], false),
        (vec![("crate/src/acme.rs", MARK)], false),
        (vec![("mod.rs", MARK), ("thesis.txt", "x"), ("below/mine.rs", "// by hand")], true),
        (vec![("mod.rs", MARK), ("inner/mod.rs", root), ("inner/messages/m.rs", MARK)], true),
        (vec![("mod.rs", MARK), (".hidden/m.rs", MARK)], true),
        (vec![("mod.rs", MARK), ("1/2/3/4/m.rs", MARK)], true),
        (vec![("mod.rs", MARK), ("b.txt", MARK)], true),
        (vec![("mod.rs", MARK), ("messages/b.rs", "// by hand")], false),
        (vec![("mod.rs", MARK), ("messages", "mine")], false),
    ] {
        let folder = tempfile::tempdir().unwrap();
        for (path, text) in &there {
            fs::create_dir_all(folder.path().join(path).parent().unwrap()).unwrap();
            fs::write(folder.path().join(path), text).unwrap();
        }
        let result = write(folder.path(), &[file("mod.rs", "a"), file("messages/b.rs", "b")]);
        assert_eq!(result.is_ok(), is_written, "{there:?} {result:?}");
        for (path, text) in there.iter().filter(|(path, _)| !is_written || *path != "mod.rs") {
            assert_eq!(fs::read_to_string(folder.path().join(path)).unwrap(), *text, "{path}");
        }
    }
}

#[test]
fn folders_that_a_killed_run_made_are_no_obstacle() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir_all(folder.path().join("one/messages")).unwrap();
    fs::create_dir_all(folder.path().join(".mavgen-staging-1-0/new")).unwrap();
    assert_eq!(write(folder.path(), &[file("mod.rs", "a")]).unwrap().written, 1);
}

#[test]
fn somebodys_file_is_not_overwritten() {
    let (_parent, folder) = written();
    fs::write(folder.join("messages/c.rs"), "// by hand").unwrap();
    let before = tree(&folder);
    let error = write(&folder, &[file("mod.rs", "changed"), file("messages/c.rs", "c")]).unwrap_err();
    assert!(
        error.to_string().contains("was not written by mavgen") && error.path.ends_with("messages/c.rs"),
        "{error}"
    );
    assert_eq!(tree(&folder), before);
}

#[test]
fn folders_that_are_no_longer_used_are_removed_if_nothing_else_is_in_them() {
    let (_parent, folder) = written();
    write(&folder, &[file("mod.rs", "a"), file("views/v.rs", "v"), file("one/messages/m.rs", "m")]).unwrap();
    fs::write(folder.join("views/mine.txt"), "x").unwrap();
    let report = write(&folder, &[file("mod.rs", "a")]).unwrap();
    assert_eq!(report, Report { written: 0, kept: 1, removed: 2 });
    let names: Vec<PathBuf> = tree(&folder).into_iter().map(|(path, _)| path).collect();
    assert_eq!(names, ["mod.rs", "views", "views/mine.txt"].map(PathBuf::from));
}

#[test]
fn a_tree_inside_of_another_is_left_alone() {
    let (_parent, folder) = written();
    let root =
        GeneratedFile { path: "mod.rs".into(), text: format!("{MARK} from b.xml; do not edit.\n{ROOT_MARK}0.1.0\n") };
    write(&folder.join("inner"), &[root, file("messages/m.rs", "m")]).unwrap();
    let report = write(&folder, &[file("mod.rs", "a")]).unwrap();
    assert_eq!(report.removed, 1);
    assert!(folder.join("inner/mod.rs").exists() && folder.join("inner/messages/m.rs").exists());
}

#[test]
fn a_folder_in_the_way_leaves_the_old_tree_whole() {
    let (_parent, folder) = written();
    fs::create_dir(folder.join("enums.rs")).unwrap();
    let before = tree(&folder);
    let new = [file("mod.rs", "changed"), file("views/v.rs", "v"), file("enums.rs", "e")];
    let error = write(&folder, &new).unwrap_err();
    assert!(
        error.path.ends_with("enums.rs") && error.to_string().contains("there is a folder of that name"),
        "{error}"
    );
    assert_eq!(tree(&folder), before);
}

#[test]
fn a_file_in_place_of_a_folder_leaves_the_old_tree_whole() {
    let (_parent, folder) = written();
    fs::write(folder.join("views"), "mine").unwrap();
    let before = tree(&folder);
    let error = write(&folder, &[file("mod.rs", "changed"), file("views/v.rs", "v")]).unwrap_err();
    assert!(error.path.ends_with("views"), "{error}");
    assert_eq!(tree(&folder), before);
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let (_parent, folder) = written();
    let error = write(&folder.join("mod.rs/out"), &[file("mod.rs", "a")]).unwrap_err();
    assert!(error.path.starts_with(folder.join("mod.rs")), "{error}");
    let first = tempfile::tempdir().unwrap();
    let name = "x".repeat(300);
    let error = write(&first.path().join("a"), &[file("mod.rs", "a"), file(&format!("{name}.rs"), "a")]).unwrap_err();
    assert!(error.to_string().contains(&name), "{error}");
    assert!(tree(first.path()).is_empty(), "folders that were made for nothing are gone");
}

/// Renaming hardly ever fails; here a staged file is taken away behind its back.
#[test]
fn what_was_put_in_place_is_taken_back() {
    let (_parent, folder) = written();
    let before = tree(&folder);
    let new = [file("mod.rs", "changed"), file("new.rs", "n"), file("messages/b.rs", "changed")];
    let mut staged = Staged::new(&folder);
    staged.prepare(&new.each_ref().map(|file| (Path::new(&file.path), &*file.text)), &[]).unwrap();
    let staging = fs::read_dir(&folder).unwrap().map(Result::unwrap).find(is_staging).unwrap();
    let outside = |(path, _): &(PathBuf, _)| !path.starts_with(staging.file_name());
    assert_eq!(before, tree(&folder).into_iter().filter(outside).collect::<Vec<_>>(), "nothing has changed yet");
    fs::remove_file(staging.path().join("new/messages/b.rs")).unwrap();
    let error = staged.commit().unwrap_err();
    assert!(error.path.ends_with("messages/b.rs"));
    assert!(fs::read_to_string(folder.join("mod.rs")).unwrap().ends_with("changed"), "the first one was put in place");
    staged.undo();
    fs::remove_dir_all(staging.path()).unwrap();
    assert_eq!(tree(&folder), before);
}

#[cfg(unix)]
#[test]
fn what_a_killed_run_left_is_no_obstacle_and_goes_in_the_end() {
    let parent = tempfile::tempdir().unwrap();
    let folder = parent.path().join("out");
    let staging = folder.join(".mavgen-staging-1-0");
    fs::create_dir_all(staging.join("new")).unwrap();
    fs::write(staging.join("new/old.rs"), MARK).unwrap();
    let report = write(&folder, &[file("mod.rs", "a")]).unwrap();
    assert_eq!((report.written, report.removed), (1, 0));
    assert!(staging.exists(), "it may be of a run of this moment");
    let yesterday = SystemTime::now() - Duration::from_secs(86_400);
    fs::File::open(&staging).unwrap().set_modified(yesterday).unwrap();
    write(&folder, &[file("mod.rs", "b")]).unwrap();
    assert_eq!(tree(&folder).len(), 1);
}

#[test]
fn runs_side_by_side_do_not_hurt_each_other() {
    let (_parent, folder) = written();
    for round in 0..20 {
        let mut new = vec![file("mod.rs", &round.to_string())];
        new.extend((0..20).map(|n| file(&format!("messages/m_{round}_{n}.rs"), "m")));
        let runs: Vec<Result<Report, OutputError>> = std::thread::scope(|scope| {
            let runs: Vec<_> = (0..4).map(|_| scope.spawn(|| write(&folder, &new))).collect();
            runs.into_iter().map(|run| run.join().unwrap()).collect()
        });
        assert!(runs.iter().all(Result::is_ok), "{runs:?}");
        assert!(check(&folder, &new).unwrap().is_empty());
        assert_eq!(tree(&folder).len(), 22, "the files, and their folder");
    }
}

#[cfg(unix)]
#[test]
fn links_are_replaced_and_what_they_point_to_is_left_alone() {
    use std::os::unix::fs::symlink;
    let (parent, folder) = written();
    let elsewhere = parent.path().join("elsewhere.rs");
    fs::rename(folder.join("mod.rs"), &elsewhere).unwrap();
    symlink(&elsewhere, folder.join("mod.rs")).unwrap();
    let linked = parent.path().join("linked");
    symlink(&folder, &linked).unwrap();
    symlink(parent.path(), folder.join("circle")).unwrap();

    let report = write(&linked, &[file("mod.rs", "changed")]).unwrap();
    assert_eq!(report, Report { written: 1, kept: 0, removed: 1 });
    assert!(linked.is_symlink() && !folder.join("mod.rs").is_symlink() && folder.join("circle").is_symlink());
    assert!(fs::read_to_string(folder.join("mod.rs")).unwrap().ends_with("changed"));
    assert!(fs::read_to_string(elsewhere).unwrap().ends_with('a'));

    symlink(parent.path().join("nowhere"), parent.path().join("dangling")).unwrap();
    let error = write(&parent.path().join("dangling"), &[file("mod.rs", "a")]).unwrap_err();
    assert!(error.path.ends_with("dangling"), "{error}");
}
