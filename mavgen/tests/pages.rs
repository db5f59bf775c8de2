//! Every diagnostic has a page, a recorded rendering, and examples that do what the page says: the wrong one causes this
//! diagnostic and no other, the right one causes none.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may panic")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use mavgen::diag::{Code, Diagnostic, Diagnostics, Severity};
use mavgen::read::load;
use mavgen::source::Sources;
use mavgen::{Builder, Failure, Resolved};

const PAGES: &str = "src/diag/pages";

/// The texts of an example, by file name.
type Files = BTreeMap<String, Vec<u8>>;

/// A fenced block of a page: what follows the fence, and the lines inside.
struct Block {
    info: String,
    text: String,
}

/// The wrong and the right example of a page.
struct Page {
    text: String,
    wrong: Vec<Block>,
    right: Vec<Block>,
}

impl Page {
    fn read(code: Code) -> Self {
        let path = Path::new(PAGES).join(format!("{code}.md"));
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let (_, rest) = text.split_once("\n\nWrong:\n\n").unwrap_or_else(|| panic!("{code} has no wrong example"));
        let (wrong, right) = rest.split_once("\n\nRight:\n\n").unwrap_or_else(|| panic!("{code} has no right example"));
        Self { wrong: blocks(wrong), right: blocks(right), text }
    }
}

fn blocks(markdown: &str) -> Vec<Block> {
    let parts: Vec<&str> = markdown.split("```").collect();
    let inside = parts.iter().skip(1).step_by(2);
    let split = inside.map(|block| block.split_once('\n').unwrap());
    split.map(|(info, text)| Block { info: info.to_owned(), text: text.to_owned() }).collect()
}

/// What the examples that cannot be printed stand for.
fn generated(code: Code, wrong: bool) -> String {
    let fields = |count: usize, ty: &str| -> String {
        (0..count).map(|index| format!("<field type='{ty}' name='f{index}'>.</field>")).collect()
    };
    let message = |fields: String| format!("<message id='1' name='PUMP_STATUS'>{fields}</message>");
    match code {
        Code::TooLarge if wrong => {
            let attributes: String = (0..65).map(|index| format!(" a{index}=''")).collect();
            format!("<message {attributes}/>")
        }
        Code::TooLarge => message(fields(1, "uint8_t")),
        Code::TooManyFields => message(fields(if wrong { 65 } else { 64 }, "uint8_t")),
        Code::NotListed => (0..if wrong { 201 } else { 200 })
            .map(|id| format!("<message id='{id}' name='M{id}'><field type='uint9_t' name='f'/></message>"))
            .collect(),
        _ => panic!("{code}: an example that is text has to be generated"),
    }
}

/// Adds the files of the blocks. Returns the path that a command line among them names.
fn add_files(code: Code, blocks: &[Block], wrong: bool, files: &mut Files) -> Option<String> {
    let mut asked = None;
    for block in blocks {
        match block.info.as_str() {
            "console" => asked = block.text.split_whitespace().last().map(str::to_owned),
            "text" if code == Code::IncludeDepth => {
                let names: Vec<&str> = block.text.trim().split(" → ").collect();
                for (name, next) in names.iter().zip(names.iter().skip(1)) {
                    add(files, name, &format!("<include>{next}</include>"));
                }
                add(
                    files,
                    names.last().unwrap(),
                    "<message id='1' name='A'><field type='uint8_t' name='f'/></message>",
                );
            }
            "text" => add(files, "acme.xml", &generated(code, wrong)),
            "xml latin-1" => {
                let text = wrapped("acme.xml", &block.text);
                let bytes = text.chars().map(|letter| u8::try_from(u32::from(letter)).unwrap());
                files.insert("acme.xml".to_owned(), bytes.collect());
            }
            "msg older" => {
                files.insert("older/A.msg".to_owned(), block.text.clone().into_bytes());
            }
            "msg" => {
                files.insert("A.msg".to_owned(), block.text.clone().into_bytes());
            }
            "xml" if code.number() >= 900 => {
                let text = match block.text.strip_prefix("<message") {
                    Some(_) => format!("<uorb-overlay version='1' for='msg'>{}</uorb-overlay>", block.text),
                    None => block.text.clone(),
                };
                files.insert("acme.overlay.xml".to_owned(), text.into_bytes());
            }
            "xml" => {
                let (name, text) = named(code, &block.text);
                add(files, name, text);
            }
            other => panic!("{code}: a block of `{other}`"),
        }
    }
    asked
}

/// The file of a block and its text: a comment in the first line names it.
fn named(code: Code, text: &str) -> (&str, &str) {
    let comment = text.strip_prefix("<!-- ").and_then(|rest| rest.split_once(" -->\n"));
    match comment {
        Some(named) => named,
        None if (700..800).contains(&code.number()) => ("acme.overlay.xml", text),
        None => ("acme.xml", text),
    }
}

fn add(files: &mut Files, name: &str, text: &str) {
    files.insert(name.to_owned(), wrapped(name, text).into_bytes());
}

/// The problems of an example of `.msg` files, which stand in a folder `msg`.
#[cfg(feature = "uorb")]
fn problems_of_uorb(files: &Files) -> Diagnostics {
    let above = tempfile::tempdir().unwrap();
    let folder = above.path().join("msg");
    fs::create_dir(&folder).unwrap();
    for (name, text) in files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    if files.contains_key("older/A.msg") {
        let builder = Builder::new(folder.join("A.msg")).older("old", folder.join("older"));
        return match builder.topics() {
            Err(Failure::Definitions(problems)) => problems.diagnostics,
            topics => topics.unwrap().diagnostics,
        };
    }
    let overlays: Vec<PathBuf> =
        files.keys().filter(|name| name.ends_with(".overlay.xml")).map(|name| folder.join(name)).collect();
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let overlays = mavgen::uorb::overlays(&overlays, &[&folder], &mut sources, &mut diagnostics);
    mavgen::uorb::load(&folder.join("A.msg"), &overlays, |_| true, &mut sources, &mut diagnostics);
    diagnostics
}

/// A part of a file in the elements where it belongs.
fn wrapped(name: &str, text: &str) -> String {
    let starts = |tags: &[&str]| tags.iter().any(|tag| text.starts_with(&format!("<{tag}")));
    let text = match name {
        "acme.overlay.xml" if starts(&["view", "bind"]) => format!("<message name='PUMP_STATUS'>{text}</message>"),
        _ => text.to_owned(),
    };
    if starts(&["mavlink", "mavlnk", "?xml", "!DOCTYPE"]) || name.contains(" is a link to ") {
        text
    } else if name == "acme.overlay.xml" {
        format!("<mavlink-overlay version='1' for='acme.xml'>{text}</mavlink-overlay>")
    } else if starts(&["message "]) {
        format!("<mavlink><messages>{text}</messages></mavlink>")
    } else if starts(&["enum "]) {
        format!("<mavlink><enums>{text}</enums></mavlink>")
    } else {
        format!("<mavlink>{text}</mavlink>")
    }
}

/// The problems of an example: of the dialect `top` or, for a code about several, of all of them together.
fn problems(code: Code, files: &Files, top: &str) -> Diagnostics {
    #[cfg(feature = "uorb")]
    if code.number() >= 900 {
        return problems_of_uorb(files);
    }
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        match name.split_once(" is a link to ") {
            #[cfg(unix)]
            Some((link, target)) => std::os::unix::fs::symlink(target, folder.path().join(link)).unwrap(),
            _ => fs::write(folder.path().join(name), text).unwrap(),
        }
    }
    let overlay: Vec<PathBuf> =
        files.keys().filter(|name| name.ends_with(".overlay.xml")).map(|name| folder.path().join(name)).collect();
    if code.number() >= 800 {
        let roots = files.keys().filter(|name| !name.ends_with(".overlay.xml") && *name != top);
        let builder = roots.fold(Builder::new(folder.path().join(top)), |all, name| all.root(folder.path().join(name)));
        return match overlay.iter().fold(builder, Builder::overlay).resolve() {
            Ok(resolved) => resolved.diagnostics,
            Err(Failure::Definitions(problems)) => problems.diagnostics,
            Err(other) => panic!("{code}: {other}"),
        };
    }
    // Of most examples `lint` tells more: they leave out what has nothing to do with their subject.
    let diagnostics = Diagnostics::default();
    let mut diagnostics = if code.is_for_lint() { diagnostics.for_lint() } else { diagnostics };
    let mut sources = Sources::default();
    let loaded = load(&folder.path().join(top), &[], &overlay, &mut sources, &mut diagnostics);
    match Resolved::of(loaded, sources, diagnostics) {
        Ok(resolved) => resolved.diagnostics,
        Err(problems) => problems.diagnostics,
    }
}

#[test]
fn examples_do_what_the_pages_say() {
    let mut lies = Vec::new();
    let read_here = |code: &&Code| cfg!(feature = "uorb") || code.number() < 900;
    for &code in Code::ALL.iter().filter(read_here) {
        let page = Page::read(code);
        let mut files = Files::new();
        if (700..800).contains(&code.number()) {
            files.insert("acme.xml".to_owned(), fs::read(Path::new(PAGES).join("acme.xml")).unwrap());
        }
        let asked = add_files(code, &page.wrong, true, &mut files);
        let wrong = problems(code, &files, asked.as_deref().unwrap_or("acme.xml"));
        let stranger = |problem: &Diagnostic| problem.code != code && code != Code::NotListed;
        if !wrong.iter().any(|problem| problem.code == code) || wrong.iter().any(stranger) {
            lies.push(format!("{code}: the wrong example causes {:?}", codes(&wrong)));
        }
        if code == Code::RootModule {
            // It is about the names of files, and those of the wrong example are still there.
            files.clear();
        }
        let asked = add_files(code, &page.right, false, &mut files);
        let right = problems(code, &files, asked.as_deref().unwrap_or("acme.xml"));
        if right.iter().any(|problem| problem.code == code || stranger(problem)) {
            lies.push(format!("{code}: the right example causes {:?}", codes(&right)));
        }
    }
    assert!(lies.is_empty(), "{lies:#?}");
}

fn codes(diagnostics: &Diagnostics) -> Vec<(Code, &str)> {
    diagnostics.iter().map(|problem| (problem.code, problem.message.as_str())).collect()
}

/// A page is something to read: a paragraph before the examples, and one after them that says why.
#[test]
fn pages_are_pages() {
    for &code in Code::ALL {
        let page = Page::read(code);
        let before = page.text.split("\n\nWrong:").next().unwrap();
        let after = page.text.rsplit("```").next().unwrap().trim();
        assert!(before.len() > 25, "{code} says nothing before its examples");
        assert!(after.len() > 60, "{code} does not say why");
        assert!(page.text.lines().all(|line| line.chars().count() <= 125), "{code} has long lines");
        assert!(!page.text.contains("\n\n\n") && page.text.ends_with('\n'), "{code}");
    }
}

#[test]
fn no_page_is_without_a_code() {
    let known: Vec<String> = Code::ALL.iter().map(|code| format!("{code}.md")).collect();
    for entry in fs::read_dir(PAGES).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(known.contains(&name) || name == "acme.xml", "{name}");
    }
}

/// Each code is in a recorded rendering, and so has an input that causes it.
#[test]
fn every_code_has_a_golden() {
    let recorded = fs::read_dir("tests/ui").unwrap().map(|entry| entry.unwrap().path());
    let recorded = recorded.filter(|path| path.extension().is_some_and(|extension| extension == "stderr"));
    let texts: String = recorded.map(|path| fs::read_to_string(path).unwrap()).collect();
    let missing: Vec<String> = (Code::ALL.iter())
        .filter(|code| !texts.contains(&format!("{}[{code}]: ", code.severity())))
        .map(Code::to_string)
        .collect();
    assert!(missing.is_empty(), "{missing:?} are in no tests/ui/*.stderr");
}

/// The table that says why something is an error has every error, and no other.
#[test]
fn errors_are_argued_for() {
    let table = fs::read_to_string("../docs/errors.md").unwrap();
    let rows: Vec<&str> = table.lines().filter(|line| line.starts_with("| M")).collect();
    let errors = Code::ALL.iter().filter(|code| code.severity() == Severity::Error && code.number() < 700);
    let expected: Vec<String> = errors.map(|code| format!("| {code} | {} |", code.title())).collect();
    assert_eq!(rows.len(), expected.len());
    for (row, expected) in rows.iter().zip(&expected) {
        assert!(row.starts_with(expected), "{row}\n{expected}");
    }
}
