//! What the documents say is so: links lead somewhere, paths exist, examples are compiled, and modules use each other as the table
//! says.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use pulldown_cmark::{Event, Parser, Tag, TagEnd};

/// Those whose every path is one of this repository. Others show paths of a reader's project as well.
const DOCUMENTS: [&str; 5] = ["ARCHITECTURE.md", "CONTRIBUTING.md", "README.md", "docs/firmware.md", "docs/proof.md"];

/// All that a reader may open: the documents of the top folder, the pages of `docs`, and what a registry shows of each package.
fn documents() -> Vec<String> {
    let folders =
        ["", "docs/", "mavgen/", "mavgen/cli/", "mavlink-wire/", "mavlink-services/", "mavlink-autoquad/"].into_iter();
    let names = folders.flat_map(|folder| {
        let files = fs::read_dir(top(folder)).unwrap();
        files.map(move |file| format!("{folder}{}", file.unwrap().file_name().to_str().unwrap()))
    });
    names.filter(|name| name.ends_with(".md")).collect()
}

/// The targets of the links of a text.
fn links(text: &str) -> Vec<String> {
    let links = Parser::new(text).filter_map(|event| match event {
        Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => Some(dest_url.into_string()),
        _ => None,
    });
    links.collect()
}

/// The anchors of a text's headings.
fn anchors(text: &str) -> BTreeSet<String> {
    let (mut anchors, mut heading) = (BTreeSet::new(), None);
    for event in Parser::new(text) {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => anchors.extend(heading.take()),
            Event::Text(piece) | Event::Code(piece) => {
                if let Some(heading) = &mut heading {
                    let letters = piece.chars().filter(|letter| letter.is_alphanumeric() || " -_".contains(*letter));
                    heading.extend(letters.map(|letter| if letter == ' ' { '-' } else { letter.to_ascii_lowercase() }));
                }
            }
            _ => {}
        }
    }
    anchors
}

/// What is wrong with a link of a document.
fn fault(document: &str, link: &str) -> Option<&'static str> {
    let (file, anchor) = link.split_once('#').map_or((link, None), |(file, anchor)| (file, Some(anchor)));
    let target = if file.is_empty() { top(document) } else { top(document).parent().unwrap().join(file) };
    if !target.exists() {
        return Some("there is no such file");
    }
    let missing = anchor.is_some_and(|anchor| !anchors(&fs::read_to_string(target).unwrap()).contains(anchor));
    missing.then_some("there is no such heading")
}

#[test]
fn every_link_leads_somewhere() {
    let (mut followed, mut faults) = (0, vec![]);
    for document in documents() {
        for link in links(&text(&document)).iter().filter(|link| !link.contains("://")) {
            faults.extend(fault(&document, link).map(|fault| format!("{document}, {link}: {fault}")));
            followed += 1;
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
    assert!(followed > 40, "{followed}");
}

#[test]
fn a_link_that_leads_nowhere_is_noticed() {
    assert_eq!(fault("docs/links.md", "logs.md"), None);
    assert_eq!(fault("docs/links.md", "firmware.md#features"), None);
    assert_eq!(fault("docs/links.md", "docs/logs.md"), Some("there is no such file"));
    assert_eq!(fault("docs/links.md", "firmware.md#feature"), Some("there is no such heading"));
}

/// Rust in a document is compiled, as a documentation test of the examples.
#[test]
fn every_example_is_compiled() {
    let compiled = text("examples/src/lib.rs");
    for document in documents() {
        let has_rust = text(&document).lines().any(|line| line.starts_with("```rust") && !line.contains("ignore"));
        assert_eq!(compiled.contains(&format!("/{document}\")")), has_rust, "{document}");
    }
}

/// A package is read where the rest of the repository is not.
#[test]
fn the_readme_of_a_package_needs_nothing_beside_it() {
    let packages =
        documents().into_iter().filter(|document| document != "README.md" && document.ends_with("/README.md"));
    let links: Vec<_> =
        packages.flat_map(|document| links(&text(&document))).filter(|link| !link.contains("://")).collect();
    assert!(links.is_empty(), "{links:?}");
}

/// Tests are modules of few programs: a file that no program names would never run.
#[test]
fn every_file_of_tests_is_run() {
    for package in ["tests", "mavgen"] {
        let manifest = text(&format!("{package}/Cargo.toml"));
        let names = fs::read_dir(top(&format!("{package}/tests"))).unwrap().filter_map(|entry| {
            let name = entry.unwrap().file_name().into_string().unwrap();
            let folder = top(&format!("{package}/tests/{name}/main.rs")).exists();
            name.strip_suffix(".rs").map(str::to_owned).or(folder.then_some(name))
        });
        let names: Vec<_> = names.collect();
        let programs: String = ["conformance", "library"]
            .iter()
            .filter(|program| names.iter().any(|name| name == *program))
            .map(|program| text(&format!("{package}/tests/{program}.rs")))
            .collect();
        assert!(names.len() > 9, "{names:?}");
        for name in names {
            let run = programs.contains(&format!("mod {name};")) || manifest.contains(&format!("name = \"{name}\""));
            assert!(run, "{package}/tests/{name} is never run");
        }
    }
}

/// The door stays small.
#[test]
fn the_readme_has_at_most_900_words() {
    let words = text("README.md").split_whitespace().count();
    assert!(words <= 900, "{words}");
}

fn top(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().join(path)
}

fn text(path: &str) -> String {
    fs::read_to_string(top(path)).unwrap()
}

/// What stands in ticks, outside of fenced blocks.
fn ticked(text: &str) -> Vec<String> {
    let prose: String = text.split("```").step_by(2).collect();
    prose.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}

/// The words of a text that are paths of this repository.
fn paths(text: &str) -> BTreeSet<String> {
    let words = ticked(text).into_iter().flat_map(|code| code.split(' ').map(str::to_owned).collect::<Vec<_>>());
    let tops = ["mavgen/", "mavlink-", "tests/", "examples", "xml", "docs/", ".ci/", "ARCHITECTURE.md"];
    words.filter(|word| word.contains(['/', '.']) && tops.iter().any(|top| word.starts_with(top))).collect()
}

#[test]
fn every_path_exists() {
    let mut found = 0;
    for document in DOCUMENTS {
        for path in paths(&text(document)) {
            assert!(top(&path).exists(), "{document} names {path}");
            found += 1;
        }
    }
    assert!(found > 50, "{found}");
}

/// The modules of the table, with those that each uses.
fn table() -> BTreeMap<String, BTreeSet<String>> {
    let text = text("ARCHITECTURE.md");
    let (_, table) = text.split_once("| module | uses |\n").unwrap();
    let rows = table.lines().skip(1).take_while(|line| line.starts_with('|'));
    let rows = rows.map(|row| {
        let mut names = ticked(row).into_iter();
        (names.next().unwrap(), names.collect())
    });
    rows.collect()
}

/// The files of a module, without its tests.
fn files(module: &str) -> Vec<PathBuf> {
    let mut files = vec![top(&format!("mavgen/src/{module}.rs"))];
    let mut folders = vec![top(&format!("mavgen/src/{module}"))];
    while let Some(folder) = folders.pop().filter(|folder| folder.exists()) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.file_stem().unwrap() == "tests" {
                continue;
            }
            let list = if path.is_dir() { &mut folders } else { &mut files };
            list.push(path);
        }
    }
    files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    files
}

/// The modules that a file names by `crate::`, without comments and tests.
fn used(file: &Path) -> BTreeSet<String> {
    let text = fs::read_to_string(file).unwrap();
    let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    let names = lines.flat_map(|line| line.split("crate::").skip(1));
    names
        .map(|rest| rest.split(|letter: char| letter != '_' && !letter.is_alphanumeric()).next().unwrap().to_owned())
        .collect()
}

#[test]
fn modules_use_what_the_table_says() {
    let table = table();
    assert!(table.len() > 10, "{table:?}");
    for (module, allowed) in &table {
        let mut all = BTreeSet::new();
        for file in files(module) {
            for name in used(&file).into_iter().filter(|name| name != module) {
                assert!(allowed.contains(&name), "{} uses `{name}`, and `{module}` may not", file.display());
                all.insert(name);
            }
        }
        assert_eq!(all, *allowed, "`{module}` does not use all that the table says");
    }
}

/// A stage that uses another is not used by it, over any number of steps.
#[test]
fn the_table_has_no_circle() {
    let table = table();
    for start in table.keys() {
        let (mut reached, mut next) = (BTreeSet::new(), vec![start]);
        while let Some(uses) = next.pop().and_then(|module| table.get(module)) {
            next.extend(uses.iter().filter(|module| reached.insert((*module).clone())));
        }
        assert!(!reached.contains(start), "`{start}` uses itself by way of {reached:?}");
    }
}

#[test]
fn every_folder_of_the_generator_is_on_the_map() {
    let map = text("ARCHITECTURE.md");
    for entry in fs::read_dir(top("mavgen/src")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        assert!(!path.is_dir() || map.contains(&format!("`mavgen/src/{name}`")), "mavgen/src/{name} is not");
    }
}
