//! No circle of imports: of the modules in one room, those that one reads do not read it back, however indirectly.
//!
//! A room is a module with its children; a child counts with all below it. What a module and its own children take from each
//! other is no circle: a room and what is in it are read together.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// A module by its path: `["resolve", "view", "words"]`; the crate itself is empty.
type Module = Vec<String>;

/// For each module, the modules that its `use` lines name.
type Imports = BTreeMap<Module, BTreeSet<Module>>;

/// Reads the modules in a folder and below, without those that only tests have.
fn read(folder: &Path, prefix: &Module, texts: &mut BTreeMap<Module, String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let module: Module = [&prefix[..], std::slice::from_ref(&name)].concat();
        if path.is_dir() && name != "tests" {
            read(&path, &module, texts);
        } else if path.extension().is_some_and(|extension| extension == "rs") && name != "tests" {
            let module = if prefix.is_empty() && matches!(&*name, "lib" | "main") { Module::new() } else { module };
            texts.insert(module, fs::read_to_string(&path).unwrap());
        }
    }
}

/// The paths that the `use` declarations of a text name, each as its words, with groups written out.
fn uses(text: &str) -> Vec<Vec<String>> {
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find("use ") {
        let starts = rest.get(..at).unwrap();
        let line = starts.rsplit('\n').next().unwrap();
        rest = rest.get(at + 4..).unwrap();
        if line.is_empty() || line.trim_start().starts_with("pub") && !line.contains('"') && !line.contains("//") {
            let declaration = rest.split(';').next().unwrap();
            let flat: String = declaration.split_whitespace().collect::<Vec<_>>().join(" ");
            expand(&[], &flat, &mut found);
        }
    }
    found
}

/// Writes out `a::{b, c::d}` as `a::b` and `a::c::d`.
fn expand(before: &[String], tree: &str, found: &mut Vec<Vec<String>>) {
    let tree = tree.trim();
    match tree.split_once("::") {
        _ if tree.starts_with('{') => {
            let inner = tree.trim_start_matches('{').strip_suffix('}').unwrap();
            let mut depth = 0;
            let parts = inner.split(|letter| {
                depth += i32::from(letter == '{') - i32::from(letter == '}');
                letter == ',' && depth == 0
            });
            parts.filter(|part| !part.trim().is_empty()).for_each(|part| expand(before, part, found));
        }
        Some((first, rest)) => expand(&[before, &[first.trim().to_owned()]].concat(), rest, found),
        None => {
            let name = tree.split(" as ").next().unwrap().trim().to_owned();
            found.push([before, &[name]].concat());
        }
    }
}

/// The module that a path leads to, if it is one of the crate's.
fn target(from: &Module, path: &[String], texts: &BTreeMap<Module, String>) -> Option<Module> {
    let mut module = match path.first()?.as_str() {
        "crate" => Module::new(),
        "self" => from.clone(),
        "super" => from.get(..from.len().checked_sub(1)?)?.to_vec(),
        child => {
            let module = [&from[..], &[child.to_owned()]].concat();
            return texts.contains_key(&module).then_some(module);
        }
    };
    for word in path.iter().skip(1) {
        if word == "super" {
            module.pop();
            continue;
        }
        let next = [&module[..], std::slice::from_ref(word)].concat();
        if !texts.contains_key(&next) {
            break;
        }
        module = next;
    }
    Some(module)
}

fn imports() -> Imports {
    let mut texts = BTreeMap::new();
    read(Path::new("src"), &Module::new(), &mut texts);
    assert!(texts.len() > 100, "only {} modules", texts.len());
    let of = |module: &Module, text: &String| -> BTreeSet<Module> {
        uses(text).iter().filter_map(|path| target(module, path, &texts)).collect()
    };
    texts.iter().map(|(module, text)| (module.clone(), of(module, text))).collect()
}

/// For each room, which of its children reads which other.
fn rooms(imports: &Imports) -> BTreeMap<Module, BTreeMap<&str, BTreeSet<&str>>> {
    let mut rooms: BTreeMap<Module, BTreeMap<&str, BTreeSet<&str>>> = BTreeMap::new();
    for (from, targets) in imports {
        for to in targets {
            let common = from.iter().zip(to).take_while(|(a, b)| a == b).count();
            if let (Some(from_child), Some(to_child)) = (from.get(common), to.get(common)) {
                let room = rooms.entry(from.get(..common).unwrap().to_vec()).or_default();
                room.entry(from_child).or_default().insert(to_child);
            }
        }
    }
    rooms
}

/// A circle in which `start` is, if there is one.
fn circle<'m>(start: &'m str, reads: &BTreeMap<&'m str, BTreeSet<&'m str>>) -> Option<Vec<&'m str>> {
    let mut ways: Vec<Vec<&str>> = vec![vec![start]];
    let mut seen = BTreeSet::new();
    while let Some(way) = ways.pop() {
        for &next in reads.get(way.last().unwrap()).into_iter().flatten() {
            if next == start {
                return Some([&way[..], &[start]].concat());
            }
            if seen.insert(next) {
                ways.push([&way[..], &[next]].concat());
            }
        }
    }
    None
}

#[test]
fn no_module_reads_one_that_reads_it() {
    let imports = imports();
    let mut circles = BTreeMap::new();
    for (room, reads) in rooms(&imports) {
        for start in reads.keys() {
            if let Some(way) = circle(start, &reads) {
                circles.insert(format!("{}: {start}", room.join("::")), way.join(" → "));
            }
        }
    }
    assert!(circles.is_empty(), "{circles:#?}");
}

#[test]
fn uses_are_written_out() {
    let text = "use super::a::{self, B, c::{D as E, f}};\npub(crate) use crate::g;\n    let x = \"use nothing\";\n";
    let joined: Vec<String> = uses(text).iter().map(|path| path.join("::")).collect();
    assert_eq!(joined, ["super::a::self", "super::a::B", "super::a::c::D", "super::a::c::f", "crate::g"]);
}

#[test]
fn circles_are_found() {
    let of = |modules: &[(&'static str, &[&'static str])]| -> BTreeMap<&str, BTreeSet<&str>> {
        modules.iter().map(|(from, to)| (*from, to.iter().copied().collect())).collect()
    };
    assert_eq!(circle("a", &of(&[("a", &["b"]), ("b", &["c"]), ("c", &["a"])])), Some(vec!["a", "b", "c", "a"]));
    assert_eq!(circle("a", &of(&[("a", &["b", "c"]), ("b", &["c"])])), None);
}
