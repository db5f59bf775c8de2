//! Documentation attributes: what the XML says, and what only the generator knows.

use std::fmt::Write as _;

use crate::docs::{first_sentence, prose_with, words, wrap};
use crate::rust::{Cell, Docs, ListItem, Paragraph};
use crate::tokens::{TokenStream, quote};

/// Characters of a line of a list, without indentation.
const LIST_WIDTH: usize = 92;

/// The documentation of a file, a `//!` each line.
pub(crate) fn inner_documentation(docs: &Docs<'_>) -> TokenStream {
    commented("//!", docs)
}

/// The documentation of an item, a `///` each line.
pub(crate) fn documentation(docs: &Docs<'_>) -> TokenStream {
    commented("///", docs)
}

fn commented(sign: &'static str, docs: &Docs<'_>) -> TokenStream {
    let mut tokens = TokenStream::default();
    lines(docs).iter().for_each(|line| tokens.push_doc(sign, line));
    tokens
}

/// The paragraphs, of which those that say nothing are left out.
fn lines(docs: &Docs<'_>) -> Vec<String> {
    join(docs.0.iter().map(|paragraph| match paragraph {
        Paragraph::Prose(text, sentences) => {
            let words = sentences.iter().flat_map(|sentence| sentence.split(' ')).map(str::to_owned);
            prose_with(text, words.collect())
        }
        Paragraph::Lines(lines) => lines.clone(),
        Paragraph::List(items) => items.iter().flat_map(list_item).collect(),
        Paragraph::Table(head, rows) => {
            let cells = |row: &Vec<Cell<'_>>| row.iter().map(cell).collect();
            table(head, &rows.iter().map(cells).collect::<Vec<_>>())
        }
    }))
}

/// An item of a list, wrapped and indented; nothing if it says nothing.
fn list_item(item: &ListItem<'_>) -> Vec<String> {
    let ListItem { head, label, text, sentences, link } = item;
    let mut text = words(text);
    text.extend(sentences.iter().flat_map(|sentence| sentence.split(' ')).map(str::to_owned));
    text.extend(link.clone());
    if text.is_empty() && label.is_empty() {
        return Vec::new();
    }
    let end = if text.is_empty() { "" } else { ":" };
    let mut item: Vec<String> = format!("{head}{label}{end}").split(' ').map(str::to_owned).collect();
    item.append(&mut text);
    let lines = wrap(&item, LIST_WIDTH).into_iter().enumerate();
    lines.map(|(at, line)| if at == 0 { format!("- {line}") } else { format!("  {line}") }).collect()
}

fn cell(cell: &Cell<'_>) -> String {
    match cell {
        Cell::Plain(text) => text.clone(),
        Cell::FirstSentence(text) => first_sentence(text),
    }
}

/// `#[deprecated(note = "since 2018-04, replaced by X")]`
pub(crate) fn deprecated(note: Option<&String>) -> Option<TokenStream> {
    note.map(|note| quote!(#[deprecated(note = #note)]))
}

/// `#[doc(alias = "GPS_RAW_INT")]`
pub(crate) fn alias(alias: Option<&str>) -> Option<TokenStream> {
    alias.map(|alias| quote!(#[doc(alias = #alias)]))
}

/// Paragraphs joined into one documentation, empty ones left out.
fn join(paragraphs: impl IntoIterator<Item = Vec<String>>) -> Vec<String> {
    let mut joined: Vec<String> = Vec::new();
    for paragraph in paragraphs.into_iter().filter(|paragraph| !paragraph.is_empty()) {
        if !joined.is_empty() {
            joined.push(String::new());
        }
        joined.extend(paragraph);
    }
    joined
}

/// A markdown table with aligned columns: the first to the right, the last as it is.
///
/// A column without content is left out.
fn table(head: &[&str], rows: &[Vec<String>]) -> Vec<String> {
    let told = |column: &usize| rows.iter().filter_map(|row| row.get(*column)).any(|cell| !cell.is_empty());
    let head_len = head.len();
    let columns: Vec<usize> = (0..head_len).filter(told).collect();
    let head: Vec<&str> = columns.iter().filter_map(|&column| head.get(column).copied()).collect();
    let chosen = |row: &Vec<String>| columns.iter().filter_map(|&column| row.get(column).cloned()).collect();
    if columns.len() == head_len {
        return aligned(&head, rows);
    }
    aligned(&head, &rows.iter().map(chosen).collect::<Vec<_>>())
}

fn aligned(head: &[&str], rows: &[Vec<String>]) -> Vec<String> {
    let width = |(column, title): (usize, &&str)| {
        let cells = rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count());
        cells.fold(title.chars().count(), usize::max)
    };
    let mut columns: Vec<Column> = head.iter().enumerate().map(width).map(Column::Left).collect();
    // A table of one column has it to the right.
    if let Some(last) = columns.last_mut() {
        *last = Column::AsItIs;
    }
    if let (Some(first), Some(title)) = (columns.first_mut(), head.first()) {
        *first = Column::Right(width((0, title)));
    }
    let mut lines = vec![row(&columns, head), rule(&columns)];
    lines.extend(rows.iter().map(|cells| row(&columns, cells)));
    lines
}

/// How a column of a table is aligned, and how wide it is.
enum Column {
    Right(usize),
    Left(usize),
    AsItIs,
}

fn row(columns: &[Column], cells: &[impl AsRef<str>]) -> String {
    let mut line = "|".to_owned();
    for (column, text) in columns.iter().zip(cells) {
        let text = text.as_ref();
        // Writing into a String cannot fail.
        let _ = match column {
            Column::Right(width) => write!(line, " {text:>width$} |"),
            Column::Left(width) => write!(line, " {text:<width$} |"),
            Column::AsItIs => write!(line, " {text} |"),
        };
    }
    line
}

fn rule(columns: &[Column]) -> String {
    let rule = |column: &Column| match column {
        Column::Right(width) => format!("{}:|", "-".repeat(width + 1)),
        Column::Left(width) => format!("{}|", "-".repeat(width + 2)),
        Column::AsItIs => "---|".to_owned(),
    };
    columns.iter().map(rule).fold("|".to_owned(), |line, rule| line + &rule)
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
