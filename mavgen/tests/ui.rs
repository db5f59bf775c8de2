//! Every diagnostic as a user sees it: each `ui/*.xml`, and each folder with a `main.xml`, has its rendering beside it. The
//! `*.overlay.xml` of a folder are overlays of its `main.xml`, the `*.root.xml` are dialects beside it. So has each `ui/*.msg`,
//! and each folder with a `Main.msg` and its overlays; a folder `older` there is an older definition.
//!
//! Some are recorded in colour as well, as `*.coloured`.
//!
//! `MAVGEN_BLESS=1 cargo test -p mavgen --test library ui::` writes the renderings anew; review them like code.

#![expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may panic")]

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use mavgen::diag::{Diagnostics, Style, one_line, render};
use mavgen::read::load;
use mavgen::source::Sources;
use mavgen::{Builder, Failure, Resolved};

/// Relative to the crate, which is where cargo runs tests: no rendering names a folder of the machine.
const FOLDER: &str = "tests/ui";

/// The rendering whose input is made here.
const MANY: &str = "many_mistakes.stderr";

/// How the inputs are called that are about what only `lint` tells: of all others it would be told of nearly every message.
const FOR_LINT: &str = "refused";

/// The problems of a dialect, or of several together.
fn problems(top: &Path) -> (Diagnostics, Sources) {
    #[cfg(feature = "uorb")]
    if top.extension().is_some_and(|extension| extension == "msg") {
        if let Some(older) = top.parent().map(|folder| folder.join("older")).filter(|_| top.ends_with("Main.msg"))
            && older.exists()
        {
            return match Builder::new(top).definition("main").older("old", older).topics() {
                Err(Failure::Definitions(problems)) => (problems.diagnostics, problems.sources),
                topics => topics.map(|topics| (topics.diagnostics, topics.sources)).unwrap(),
            };
        }
        let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
        let overlays = beside(top, ".overlay.xml");
        let overlays = mavgen::uorb::overlays(&overlays, &[top], &mut sources, &mut diagnostics);
        mavgen::uorb::load(top, &overlays, |_| true, &mut sources, &mut diagnostics);
        return (diagnostics, sources);
    }
    match beside(top, ".root.xml").as_slice() {
        [] => of_one(top),
        others => of_several(top, others),
    }
}

/// What a user sees of a dialect: every diagnostic, drawn, and in one line.
fn rendering(top: &Path) -> String {
    let (diagnostics, sources) = problems(top);
    let mut text = String::new();
    for diagnostic in diagnostics.iter() {
        writeln!(text, "{}\n", render(diagnostic, &sources, Style::Plain)).unwrap();
    }
    for diagnostic in diagnostics.iter() {
        writeln!(text, "{}", one_line(diagnostic, &sources)).unwrap();
    }
    text
}

fn of_one(top: &Path) -> (Diagnostics, Sources) {
    let is_for_lint = top.file_stem().unwrap().to_str().unwrap().starts_with(FOR_LINT);
    let diagnostics = Diagnostics::default();
    let mut diagnostics = if is_for_lint { diagnostics.for_lint() } else { diagnostics };
    let mut sources = Sources::default();
    let loaded = load(top, &[], &beside(top, ".overlay.xml"), &mut sources, &mut diagnostics);
    match Resolved::of(loaded, sources, diagnostics) {
        Ok(Resolved { diagnostics, sources, .. }) => {
            assert!(!diagnostics.has_errors(), "{}", top.display());
            (diagnostics, sources)
        }
        Err(problems) => (problems.diagnostics, problems.sources),
    }
}

fn of_several(top: &Path, others: &[PathBuf]) -> (Diagnostics, Sources) {
    let builder = others.iter().fold(Builder::new(top), Builder::root);
    match beside(top, ".overlay.xml").iter().fold(builder, Builder::overlay).resolve() {
        Err(Failure::Definitions(problems)) => (problems.diagnostics, problems.sources),
        resolved => resolved.map(|resolved| (resolved.diagnostics, resolved.sources)).unwrap(),
    }
}

/// The files in the folder of a `main.xml` whose names end so, by name.
fn beside(top: &Path, end: &str) -> Vec<PathBuf> {
    if !top.ends_with("main.xml") && !top.ends_with("Main.msg") {
        return Vec::new();
    }
    let files = fs::read_dir(top.parent().unwrap()).unwrap().map(|entry| entry.unwrap().path());
    let mut found: Vec<PathBuf> = files.filter(|path| path.to_string_lossy().ends_with(end)).collect();
    found.sort();
    found
}

/// The inputs, each with the place of its rendering.
fn cases() -> Vec<(PathBuf, PathBuf)> {
    let mut cases = Vec::new();
    for entry in fs::read_dir(FOLDER).unwrap() {
        let path = entry.unwrap().path();
        let golden = path.with_extension("stderr");
        if path.is_dir() {
            let top = if path.join("Main.msg").exists() { "Main.msg" } else { "main.xml" };
            cases.push((path.join(top), golden));
        } else if path.extension().is_some_and(|extension| extension == "xml" || extension == "msg") {
            cases.push((path, golden));
        }
    }
    cases.sort();
    cases
}

/// The two texts as lines, with those that differ marked.
fn difference(expected: &str, actual: &str) -> String {
    let (old, new): (Vec<_>, Vec<_>) = (expected.lines().collect(), actual.lines().collect());
    let same = old.iter().zip(&new).take_while(|(old, new)| old == new).count();
    let rest = old.len().min(new.len()) - same;
    let tail = old.iter().rev().zip(new.iter().rev()).take(rest).take_while(|(o, n)| o == n).count();
    let mut text = String::new();
    for (mark, line) in (old[..same].iter().map(|line| (' ', line)))
        .chain(old[same..old.len() - tail].iter().map(|line| ('-', line)))
        .chain(new[same..new.len() - tail].iter().map(|line| ('+', line)))
        .chain(new[new.len() - tail..].iter().map(|line| (' ', line)))
    {
        writeln!(text, "{mark} {line}").unwrap();
    }
    text
}

/// Compares with what is recorded, or records it; what differs is added to `wrong`.
fn compare(golden: &Path, actual: &str, wrong: &mut String) {
    if std::env::var_os("MAVGEN_BLESS").is_some() {
        fs::write(golden, actual).unwrap();
        return;
    }
    match fs::read_to_string(golden) {
        Ok(expected) if expected == actual => {}
        Ok(expected) => writeln!(wrong, "{}:\n{}", golden.display(), difference(&expected, actual)).unwrap(),
        Err(_) => writeln!(wrong, "{} is missing", golden.display()).unwrap(),
    }
}

#[test]
fn renderings_are_as_recorded() {
    let mut wrong = String::new();
    let cases = cases();
    assert!(cases.len() > 150, "only {} cases were found", cases.len());
    let read_here =
        |(input, _): &&(PathBuf, PathBuf)| cfg!(feature = "uorb") || input.extension() != Some("msg".as_ref());
    for (input, golden) in cases.iter().filter(read_here) {
        compare(golden, &rendering(input), &mut wrong);
    }
    assert!(wrong.is_empty(), "\n{wrong}MAVGEN_BLESS=1 records what is printed now");
}

/// One with labels in two files, one with warnings and a note.
#[test]
fn colours_are_as_recorded() {
    let mut wrong = String::new();
    for name in [
        "include_cycle/main",
        "message_duplicate_of_included/main",
        "command_param_default",
        "enum_automatic_value/main",
    ] {
        let input = Path::new(FOLDER).join(name).with_extension("xml");
        let (diagnostics, sources) = problems(&input);
        let text: String =
            diagnostics.iter().map(|problem| render(problem, &sources, Style::Coloured) + "\n\n").collect();
        assert!(text.contains('\u{1b}'), "{name}");
        compare(&recorded(&input, "coloured"), &text, &mut wrong);
    }
    assert!(wrong.is_empty(), "\n{wrong}MAVGEN_BLESS=1 records what is printed now");
}

/// Where more is recorded of an input.
fn recorded(input: &Path, extension: &str) -> PathBuf {
    let case = if input.ends_with("main.xml") { input.parent().unwrap() } else { input };
    case.with_extension(extension)
}

/// Mistakes of twenty kinds in one file: each is told, none twice, and from top to bottom.
#[test]
fn twenty_mistakes_are_twenty_problems() {
    let (diagnostics, _) = problems(&Path::new(FOLDER).join("twenty_mistakes.xml"));
    let places: Vec<u32> = diagnostics.iter().map(|problem| problem.span.unwrap().start).collect();
    assert_eq!(places.len(), 20);
    assert!(places.is_sorted_by(|a, b| a < b), "{places:?}");
}

/// A file that is nothing but mistakes: how the list ends.
#[test]
fn many_mistakes_end_as_recorded() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("many.xml");
    let fields = "<field type='uint9_t' name='f'/>".repeat(60);
    let messages: String = (0..5).map(|id| format!("<message id='{id}' name='M{id}'>{fields}</message>")).collect();
    fs::write(&input, format!("<mavlink><messages>{messages}</messages></mavlink>")).unwrap();
    let (diagnostics, sources) = problems(&input);
    let last = diagnostics.iter().last().unwrap();
    let text = format!("{}\n\n{}\n", render(last, &sources, Style::Plain), one_line(last, &sources));
    let mut wrong = String::new();
    compare(&Path::new(FOLDER).join(MANY), &text, &mut wrong);
    assert!(wrong.is_empty(), "\n{wrong}MAVGEN_BLESS=1 records what is printed now");
}

#[test]
fn no_rendering_is_without_input() {
    let mut known: BTreeSet<PathBuf> = cases().into_iter().map(|(_, golden)| golden).collect();
    known.insert(Path::new(FOLDER).join(MANY));
    let found = fs::read_dir(FOLDER).unwrap().map(|entry| entry.unwrap().path());
    let orphans: Vec<PathBuf> = found
        .filter(|path| path.extension().is_some_and(|extension| extension == "stderr"))
        .filter(|path| !known.contains(path))
        .collect();
    assert!(orphans.is_empty(), "{orphans:?}");
}
