//! What whole dialects resolve to; the parts have their tests beside them.

mod bits;
mod enums;
mod hostile;
mod messages;
mod overlays;
mod problems;

use crate::diag::{Code, Diagnostics};
use crate::ir::{Dialect, Enum, FileIndex};
use crate::read::{Loaded, read, read_overlay};
use crate::roots::resolve;
use crate::source::Sources;

/// What became of a dialect.
struct Outcome {
    dialect: Option<Dialect>,
    /// Code and message of every problem.
    problems: Vec<(Code, String)>,
}

impl Outcome {
    /// The dialect, which must be free of errors.
    fn dialect(&self) -> &Dialect {
        self.dialect.as_ref().unwrap_or_else(|| panic!("{:#?}", self.problems))
    }

    fn find_enum(&self, name: &str) -> &Enum {
        self.dialect().enums.iter().find(|found| found.name.text == name).unwrap()
    }

    /// The entries of an enum: name and value.
    fn values(&self, name: &str) -> Vec<(&str, u64)> {
        let entries = &self.find_enum(name).entries;
        entries.iter().map(|entry| (entry.name.text.as_str(), entry.value)).collect()
    }

    fn codes(&self) -> Vec<Code> {
        self.problems.iter().map(|(code, _)| *code).collect()
    }
}

/// Resolves files, given as name and content of `<mavlink>`, in merge order.
fn outcome(files: &[(&str, &str)]) -> Outcome {
    overlaid(files, &[])
}

/// Resolves files, with overlays, given as the content of `<mavlink-overlay>`.
fn overlaid(files: &[(&str, &str)], overlays: &[&str]) -> Outcome {
    let (mut sources, mut diagnostics, mut loaded) = (Sources::default(), Diagnostics::default(), Loaded::default());
    loaded.name = files[0].0.trim_end_matches(".xml").to_owned();
    for (name, content) in files {
        let id = sources.add(*name, format!("<mavlink>{content}</mavlink>"));
        loaded.files.push(read(id, &sources, &mut diagnostics).into());
    }
    for (index, content) in overlays.iter().enumerate() {
        let root = format!("<mavlink-overlay version='1' for='{}'>{content}</mavlink-overlay>", files[0].0);
        let id = sources.add(format!("{index}.overlay.xml"), root);
        loaded.overlays.push(read_overlay(id, &sources, &mut diagnostics).into());
    }
    let position = |path: &str| files.iter().position(|(name, _)| *name == path).map(FileIndex);
    let includes = loaded.files.iter().map(|file| &file.includes);
    loaded.includes = includes.map(|list| list.iter().filter_map(|path| position(&path.value)).collect()).collect();
    let dialect = resolve(&loaded, &sources, &mut diagnostics).map(|named| named.dialect);
    let problems = diagnostics.iter().map(|problem| (problem.code, problem.message.clone()));
    Outcome { dialect, problems: problems.collect() }
}

/// Resolves one file.
fn of(content: &str) -> Outcome {
    outcome(&[("a.xml", content)])
}

/// An `<enum>` whose entries are `NAME=VALUE` or, for automatic ones, `NAME`.
fn enumeration(name: &str, entries: &[&str]) -> String {
    let entry = |entry: &&str| match entry.split_once('=') {
        Some((name, value)) => format!("<entry name='{name}' value='{value}'/>"),
        None => format!("<entry name='{entry}'/>"),
    };
    let entries: String = entries.iter().map(entry).collect();
    format!("<enums><enum name='{name}'>{entries}</enum></enums>")
}

/// A `<message>` whose fields are `TYPE NAME` or `TYPE NAME ENUM`; `|` is `<extensions/>`.
fn message(id: u32, name: &str, fields: &[&str]) -> String {
    let field = |field: &&str| {
        let words: Vec<&str> = field.split(' ').collect();
        match words[..] {
            [ty, name] => format!("<field type='{ty}' name='{name}'>.</field>"),
            [ty, name, values] => {
                format!("<field type='{ty}' name='{name}' enum='{values}'>.</field>")
            }
            _ => "<extensions/>".to_owned(),
        }
    };
    let fields: String = fields.iter().map(field).collect();
    format!("<messages><message id='{id}' name='{name}'><description>.</description>{fields}</message></messages>")
}
