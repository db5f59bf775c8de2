//! The mistakes that people make: elements and attributes lost, doubled, swapped and misspelled.

use std::ops::Range;

use crate::case::{Case, case};
use crate::chance::Chance;

/// Values that are legal somewhere and wrong elsewhere.
const VALUES: [&str; 30] = [
    "",
    "0",
    "-1",
    "1",
    "3",
    "255",
    "256",
    "16777216",
    "18446744073709551616",
    "2**63",
    "0x",
    "NaN",
    "1e999",
    "true",
    "type",
    "Self",
    "é",
    "uint8_t[255]",
    "uint64_t[32]",
    "char[1]",
    "float",
    "int8_t",
    "MAV_CMD",
    "[UINT16_MAX:]",
    "1/3",
    "a[i] b[*]",
    "status",
    "bits",
    "0..=9",
    "TANK",
];

/// Text that is legal somewhere and wrong elsewhere.
const TEXTS: [&str; 8] =
    ["<", "&", "\"", "<!--", "<extensions/>", "\u{feff}", "<field type=\"char\" name=\"x\"/>", "<default/>"];

/// The case of a seed with two to four mistakes; most are refused.
pub fn mutant(seed: u64) -> Case {
    let mut made = case(seed);
    let mut chance = Chance::new(seed ^ 0x6d75_7461_6e74);
    for _ in 0..chance.between(2, 4) {
        let at = chance.below(made.files.len());
        let text = &mut made.files[at].1;
        *text = edited(&mut chance, text);
    }
    made
}

fn edited(chance: &mut Chance, text: &str) -> String {
    let (elements, attributes) = (elements(text), attributes(text));
    let element = chance.pick(&elements).cloned().unwrap_or_default();
    let (whole, value) = chance.pick(&attributes).cloned().unwrap_or_default();
    let (_, other) = chance.pick(&attributes).cloned().unwrap_or_default();
    match chance.below(12) {
        0 => replaced(text, element, ""),
        1 => replaced(text, element.end..element.end, &text[element]),
        2 | 3 => replaced(text, whole, ""),
        4 => replaced(text, whole.end..whole.end, &text[whole]),
        5 | 6 => replaced(text, value, &text[other]),
        7 => {
            let misspelled: String = text[value.clone()].chars().rev().collect();
            replaced(text, value, &misspelled)
        }
        8 => replaced(text, element.end..element.end, chance.word(&TEXTS)),
        _ => replaced(text, value, chance.word(&VALUES)),
    }
}

fn replaced(text: &str, range: Range<usize>, with: &str) -> String {
    format!("{}{with}{}", &text[..range.start], &text[range.end..])
}

/// The elements of a text, from tag to tag; without those around everything.
pub fn elements(text: &str) -> Vec<Range<usize>> {
    let starts = text.match_indices('<').map(|(start, _)| start);
    let found = starts.filter_map(|start| {
        let rest = text.get(start + 1..)?;
        let name = rest.split([' ', '>', '/']).next().filter(|name| !name.is_empty())?;
        let tag = rest.find('>')? + start + 2;
        let end = if text[..tag].ends_with("/>") {
            tag
        } else {
            start + text[start..].find(&format!("</{name}>"))? + name.len() + 3
        };
        Some(start..end)
    });
    found.filter(|range| range.len() < text.len() / 2).collect()
}

/// ` name="value"`, whole and the value alone.
fn attributes(text: &str) -> Vec<(Range<usize>, Range<usize>)> {
    let equals = text.match_indices("=\"").map(|(at, _)| at);
    let found = equals.filter_map(|at| {
        let start = text[..at].rfind(' ')?;
        let value = at + 2..at + 2 + text[at + 2..].find('"')?;
        Some((start..value.end + 1, value))
    });
    found.collect()
}
