//! Documentation attributes: what the XML says, and what only the generator knows.

use crate::collect::CollectVec as _;
use crate::docs::{first_sentence, prose_with, words, wrap};
use crate::rust::{Cell, Docs, ListItem, Paragraph};
use crate::tokens::{ToTokens, TokenStream, quote};

/// Characters of a line of a list, without indentation.
const LIST_WIDTH: usize = 92;

/// The documentation of an item, a `///` each line.
impl ToTokens for Docs<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        lines(self).iter().for_each(|line| tokens.push_doc("///", line));
    }
}

/// The documentation of a file, a `//!` each line.
pub(super) fn inner_documentation(docs: &Docs<'_>) -> TokenStream {
    let mut tokens = TokenStream::default();
    lines(docs).iter().for_each(|line| tokens.push_doc("//!", line));
    tokens
}

/// The paragraphs, of which those that say nothing are left out.
fn lines(docs: &Docs<'_>) -> Vec<String> {
    let paragraphs = docs.0.iter().map(|paragraph| match paragraph {
        Paragraph::Prose(text, sentences) => prose_with(text, own_words(sentences).collect_vec()),
        Paragraph::Lines(lines) => lines.clone(),
        Paragraph::List(items) => items.iter().flat_map(list_item).collect_vec(),
        Paragraph::Table(head, rows) => {
            table(head, &rows.iter().map(|row| row.iter().map(cell).collect_vec()).collect_vec())
        }
    });
    paragraphs.filter(|paragraph| !paragraph.is_empty()).collect_vec().join(&String::new())
}

fn own_words(sentences: &[String]) -> impl Iterator<Item = String> {
    sentences.iter().flat_map(|sentence| sentence.split(' ')).map(str::to_owned)
}

/// An item of a list, wrapped and indented; nothing if it says nothing.
fn list_item(item: &ListItem<'_>) -> Vec<String> {
    let ListItem { head, label, text, sentences, link } = item;
    let mut text = words(text);
    text.extend(own_words(sentences));
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

/// A markdown table with aligned columns: the first to the right, the last as it is.
///
/// A column without content is left out.
fn table(head: &[&str], rows: &[Vec<String>]) -> Vec<String> {
    let column = |at: usize| rows.iter().map(move |row| row.get(at).map_or("", String::as_str));
    let told = head.iter().enumerate().filter(|(at, _)| column(*at).any(|cell| !cell.is_empty())).collect_vec();
    let mut lines = vec!["|".to_owned(); rows.len() + 2];
    for (place, (at, title)) in told.iter().enumerate() {
        let width = column(*at).chain([**title]).fold(0, |width, cell| width.max(cell.chars().count()));
        // A table of one column has it to the right.
        let (is_first, is_last) = (place == 0, place + 1 == told.len());
        let shown = |cell: &str| match (is_first, is_last) {
            (true, _) => format!(" {cell:>width$} |"),
            (_, true) => format!(" {cell} |"),
            _ => format!(" {cell:<width$} |"),
        };
        let rule = match (is_first, is_last) {
            (true, _) => format!("{:-<width$}-:|", ""),
            (_, true) => "---|".to_owned(),
            _ => format!("{:-<width$}--|", ""),
        };
        let cells = [shown(title), rule].into_iter().chain(column(*at).map(shown));
        lines.iter_mut().zip(cells).for_each(|(line, cell)| line.push_str(&cell));
    }
    lines
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
