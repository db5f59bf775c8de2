//! Documentation attributes: what the XML says, and what only the generator knows.

use proc_macro2::TokenStream;
use quote::quote;

use crate::docs::{line, prose, prose_with};
use crate::emit::Context;
use crate::ir::{Lifecycle, Limits, Name, Origin, Successor};
use crate::rust::{Docs, Paragraph};

/// One `#[doc]` a line, which prints as `///`.
pub(crate) fn attributes(lines: &[String]) -> TokenStream {
    let lines = lines.iter().map(|line| spaced(line));
    quote!(#(#[doc = #lines])*)
}

/// One inner `#![doc]` a line, which prints as `//!`.
pub(crate) fn inner_attributes(lines: &[String]) -> TokenStream {
    let lines = lines.iter().map(|line| spaced(line));
    quote!(#(#![doc = #lines])*)
}

/// A documentation: its paragraphs, of which those that say nothing are left out.
pub(crate) fn documentation(docs: &Docs<'_>) -> TokenStream {
    let paragraphs = docs.0.iter().map(|paragraph| match paragraph {
        Paragraph::Prose(text, sentences) => {
            let words = sentences.iter().flat_map(|sentence| sentence.split(' ')).map(str::to_owned);
            prose_with(text, words.collect())
        }
        Paragraph::Lines(lines) => lines.clone(),
        Paragraph::Table(head, rows) => table(head, rows),
    });
    attributes(&join(paragraphs))
}

fn spaced(line: &str) -> String {
    if line.is_empty() { String::new() } else { format!(" {line}") }
}

/// Paragraphs joined into one documentation, empty ones left out.
pub(crate) fn join(paragraphs: impl IntoIterator<Item = Vec<String>>) -> Vec<String> {
    let mut joined: Vec<String> = Vec::new();
    for paragraph in paragraphs.into_iter().filter(|paragraph| !paragraph.is_empty()) {
        if !joined.is_empty() {
            joined.push(String::new());
        }
        joined.extend(paragraph);
    }
    joined
}

/// The description, and the stage of life.
pub(crate) fn description(origin: &Origin) -> Vec<String> {
    join([prose(&origin.description), lifecycle(origin).into_iter().collect()])
}

/// The stage of life in a sentence: `Superseded since 2015-08 by SET_MESSAGE_INTERVAL.`
fn lifecycle(origin: &Origin) -> Option<String> {
    match origin.lifecycle.as_ref()? {
        Lifecycle::Wip => Some("**Work in progress**: may still change.".to_owned()),
        Lifecycle::Superseded(successor) => Some(format!("**Superseded**{}", succession(successor))),
        Lifecycle::Deprecated(successor) => Some(format!("**Deprecated**{}", succession(successor))),
    }
}

/// ` since 2015-08, replaced by X. Why.`
fn succession(successor: &Successor) -> String {
    let since = successor.since.as_ref().map_or_else(String::new, |since| format!(" since {}", line(since)));
    let by = successor.replaced_by.as_ref().map(|by| line(by)).filter(|by| !by.is_empty());
    let by = by.map_or_else(String::new, |by| format!(", replaced by {by}"));
    let why = line(&successor.description);
    if why.is_empty() { format!("{since}{by}.") } else { format!("{since}{by}. {why}") }
}

/// `#[deprecated(note = "since 2018-04: replaced by X")]`, if the item is and the options ask for it.
///
/// The date stands in the note because `since` takes nothing but a version.
pub(crate) fn deprecated(context: &Context<'_>, origin: &Origin) -> TokenStream {
    let Some(Lifecycle::Deprecated(successor)) = origin.lifecycle.as_ref().filter(|_| context.is_deprecated(origin))
    else {
        return TokenStream::new();
    };
    // Rustdoc shows the note as markdown, so it is made safe like all other text.
    let by = successor.replaced_by.as_deref().map(line).filter(|by| !by.is_empty());
    let by = by.map_or_else(|| "do not use".to_owned(), |by| format!("replaced by {by}"));
    let note = successor.since.as_ref().map_or_else(|| by.clone(), |since| format!("since {}: {by}", line(since)));
    quote!(#[deprecated(note = #note)])
}

/// `#[doc(alias = "GPS_RAW_INT")]`, so that a search for the XML's name finds the type; nothing where both are spelled alike.
pub(crate) fn alias(name: &Name) -> TokenStream {
    let Name { text, rust, .. } = name;
    if text == rust { quote!() } else { quote!(#[doc(alias = #text)]) }
}

/// `In m/s, from 0 to 100, in steps of 5`: what units and limits say; empty where they say nothing.
pub(crate) fn quantity(units: Option<&str>, multiplier: Option<&str>, limits: &Limits) -> Vec<String> {
    let unit = units.map(|units| match multiplier {
        Some(multiplier) => format!("in {} times {}", line(units), line(multiplier)),
        None => format!("in {}", line(units)),
    });
    let range = match (limits.min, limits.max) {
        (Some(min), Some(max)) => Some(format!("from {min} to {max}")),
        (Some(min), None) => Some(format!("at least {min}")),
        (None, Some(max)) => Some(format!("at most {max}")),
        (None, None) => None,
    };
    let step = limits.increment.map(|step| format!("in steps of {step}"));
    [unit, range, step].into_iter().flatten().collect()
}

/// `in m/s` becomes `In m/s`.
pub(crate) fn capitalised(sentence: &str) -> String {
    let mut chars = sentence.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

/// A link to a type; one that is called like a derive macro has to say what it is.
pub(crate) fn link(name: &Name) -> String {
    let derives = ["Clone", "Copy", "Debug", "Default", "Eq", "Hash", "Ord", "PartialEq", "PartialOrd"];
    let rust = &name.rust;
    if derives.contains(&rust.as_str()) { format!("[`struct@{rust}`]") } else { format!("[`{rust}`]") }
}

/// A markdown table with aligned columns: the first to the right, the last as it is.
///
/// A column without content is left out.
pub(crate) fn table(head: &[&str], rows: &[Vec<String>]) -> Vec<String> {
    let told = |column: &usize| rows.iter().filter_map(|row| row.get(*column)).any(|cell| !cell.is_empty());
    let columns: Vec<usize> = (0..head.len()).filter(told).collect();
    let head: Vec<&str> = columns.iter().filter_map(|&column| head.get(column).copied()).collect();
    let chosen = |row: &Vec<String>| columns.iter().filter_map(|&column| row.get(column).cloned()).collect();
    aligned(&head, &rows.iter().map(chosen).collect::<Vec<_>>())
}

fn aligned(head: &[&str], rows: &[Vec<String>]) -> Vec<String> {
    let last = head.len().saturating_sub(1);
    let width = |(column, title): (usize, &&str)| {
        let cells = rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count());
        cells.fold(title.chars().count(), usize::max)
    };
    let widths: Vec<usize> = head.iter().enumerate().map(width).collect();
    let cell = |column: usize, width: usize, text: &str| match column {
        0 => format!(" {text:>width$} "),
        _ if column == last => format!(" {text} "),
        _ => format!(" {text:<width$} "),
    };
    let row = |cells: &mut dyn Iterator<Item = &str>| {
        let cells = widths.iter().zip(cells).enumerate().map(|(column, (width, text))| cell(column, *width, text));
        format!("|{}|", cells.collect::<Vec<_>>().join("|"))
    };
    let rule = |(column, width): (usize, &usize)| match column {
        0 => format!("{}:", "-".repeat(width + 1)),
        _ if column == last => "---".to_owned(),
        _ => "-".repeat(width + 2),
    };
    let rules: Vec<String> = widths.iter().enumerate().map(rule).collect();
    let mut lines = vec![row(&mut head.iter().copied()), format!("|{}|", rules.join("|"))];
    lines.extend(rows.iter().map(|cells| row(&mut cells.iter().map(String::as_str))));
    lines
}

/// The files of upstream that have a page in the public message reference.
const PUBLISHED: [&str; 20] = [
    "ASLUAV",
    "AVSSUAS",
    "all",
    "ardupilotmega",
    "common",
    "csAirLink",
    "cubepilot",
    "development",
    "icarous",
    "loweheiser",
    "marsh",
    "minimal",
    "paparazzi",
    "python_array_test",
    "standard",
    "stemstudios",
    "storm32",
    "test",
    "uAvionix",
    "ualberta",
];

/// A link to the public reference, where the file is one that it covers.
pub(crate) fn reference(file: &str, anchor: &str) -> Option<String> {
    let stem = file.strip_suffix(".xml").filter(|stem| PUBLISHED.contains(stem))?;
    Some(format!("[message reference](https://mavlink.io/en/messages/{stem}.html#{anchor})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_aligned() {
        let rows = [["0", "`time`", "us"], ["10", "`x`", ""]].map(|row| row.map(str::to_owned).to_vec());
        let lines = [
            "| offset | field  | units |",
            "|-------:|--------|---|",
            "|      0 | `time` | us |",
            "|     10 | `x`    |  |",
        ];
        assert_eq!(table(&["offset", "field", "units"], &rows), lines);
    }

    #[test]
    fn a_table_has_no_empty_column() {
        let rows = [["0", "`time`", ""], ["10", "`x`", ""]].map(|row| row.map(str::to_owned).to_vec());
        let lines = ["| offset | field |", "|-------:|---|", "|      0 | `time` |", "|     10 | `x` |"];
        assert_eq!(table(&["offset", "field", "units"], &rows), lines);
    }
}
