//! What `ARCHITECTURE.md` and `CONTRIBUTING.md` say is so: the paths exist, and modules use each other as the table says.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

const DOCUMENTS: [&str; 2] = ["ARCHITECTURE.md", "CONTRIBUTING.md"];

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
