//! Changes to XML that a slip of the hand makes.

use std::ops::Range;

use proptest::prelude::*;

/// One change. Places are taken modulo what there is.
#[derive(Clone, Debug)]
pub(crate) enum Edit {
    /// Of an element or, more rarely, a single tag; as the next two.
    Delete(usize),
    Double(usize),
    Swap(usize, usize),
    DeleteAttribute(usize),
    DoubleAttribute(usize),
    /// The values of two attributes of the same name, or of any two.
    SwapValues(usize, usize, bool),
    SetValue(usize, &'static str),
    CutAt(usize),
    InsertAt(usize, &'static str),
}

/// Values that are legal somewhere and wrong elsewhere.
const VALUES: [&str; 26] = [
    "",
    "0",
    "-1",
    "1",
    "255",
    "256",
    "16777216",
    "18446744073709551616",
    "2**63",
    "0x",
    "NaN",
    "-INF",
    "1e999",
    "true",
    "type",
    "Self",
    "é",
    "uint8_t[255]",
    "uint64_t[32]",
    "char[1]",
    "float",
    "uint8_t_mavlink_version",
    "MAV_CMD",
    "[UINT16_MAX:]",
    "1/3",
    "a[i] b[*]",
];

/// Text that is legal somewhere and wrong elsewhere.
const TEXTS: [&str; 10] =
    ["<", ">", "&", "\"", "<!--", "-->", "<extensions/>", "<![CDATA[", "\u{feff}", "<field type=\"char\" name=\"x\"/>"];

pub(crate) fn any() -> impl Strategy<Value = Edit> {
    let at = || 0..100_000_usize;
    prop_oneof![
        2 => at().prop_map(Edit::Delete),
        2 => at().prop_map(Edit::Double),
        2 => (at(), at()).prop_map(|(a, b)| Edit::Swap(a, b)),
        3 => at().prop_map(Edit::DeleteAttribute),
        1 => at().prop_map(Edit::DoubleAttribute),
        4 => (at(), at(), any_bool()).prop_map(|(a, b, alike)| Edit::SwapValues(a, b, alike)),
        6 => (at(), prop::sample::select(&VALUES[..])).prop_map(|(at, value)| Edit::SetValue(at, value)),
        1 => at().prop_map(Edit::CutAt),
        1 => (at(), prop::sample::select(&TEXTS[..])).prop_map(|(at, text)| Edit::InsertAt(at, text)),
    ]
}

fn any_bool() -> impl Strategy<Value = bool> {
    prop::bool::ANY
}

impl Edit {
    pub(crate) fn apply(&self, text: &str) -> String {
        let (pieces, attributes) = (pieces(text), attributes(text));
        let edited = match *self {
            Self::Delete(at) => pick(&pieces, at).map(|piece| replace(text, &[(piece, "")])),
            Self::Double(at) => pick(&pieces, at).map(|piece| replace(text, &[(piece.end..piece.end, &text[piece])])),
            Self::Swap(a, b) => pick(&pieces, a).zip(pick(&pieces, b)).map(|(a, b)| swap(text, a, b)),
            Self::DeleteAttribute(at) => pick(&attributes, at).map(|one| replace(text, &[(one.whole, "")])),
            Self::DoubleAttribute(at) => {
                pick(&attributes, at).map(|one| replace(text, &[(one.whole.end..one.whole.end, &text[one.whole])]))
            }
            Self::SwapValues(a, b, alike) => pick(&attributes, a).and_then(|a| {
                let others: Vec<Attribute> = attributes
                    .iter()
                    .filter(|other| !alike || text[other.name.clone()] == text[a.name.clone()])
                    .cloned()
                    .collect();
                Some(swap(text, a.value, pick(&others, b)?.value))
            }),
            Self::SetValue(at, value) => pick(&attributes, at).map(|one| replace(text, &[(one.value, value)])),
            Self::CutAt(at) => Some(text[..boundary(text, at)].to_owned()),
            Self::InsertAt(at, what) => {
                let at = boundary(text, at);
                Some(replace(text, &[(at..at, what)]))
            }
        };
        edited.unwrap_or_else(|| text.to_owned())
    }
}

/// An attribute with the blank in front of it.
#[derive(Clone)]
struct Attribute {
    whole: Range<usize>,
    name: Range<usize>,
    value: Range<usize>,
}

fn pick<T: Clone>(list: &[T], at: usize) -> Option<T> {
    list.get(at.checked_rem(list.len())?).cloned()
}

fn boundary(text: &str, at: usize) -> usize {
    let at = at % (text.len() + 1);
    (0..=at).rev().find(|&at| text.is_char_boundary(at)).unwrap_or_default()
}

/// Every element from tag to tag, and every eighth tag alone: a lost tag is an error that hides all others.
fn pieces(text: &str) -> Vec<Range<usize>> {
    let mut pieces = Vec::new();
    for (nth, (start, _)) in text.match_indices('<').enumerate() {
        let Some(length) = text[start..].find('>') else { continue };
        let tag = start..start + length + 1;
        let name = text[start + 1..].split([' ', '>', '/']).next().unwrap_or_default();
        let end = text[tag.clone()].ends_with("/>").then_some(tag.end);
        let close = format!("</{name}>");
        let end = end.or_else(|| Some(start + text[start..].find(&close)? + close.len()));
        pieces.extend(end.filter(|_| !name.is_empty()).map(|end| start..end));
        if nth % 8 == 0 {
            pieces.push(tag);
        }
    }
    pieces
}

/// Every ` name="value"` in a tag, as far as that can be told from the text alone.
fn attributes(text: &str) -> Vec<Attribute> {
    let equals = text.match_indices("=\"").map(|(at, _)| at);
    equals
        .filter_map(|at| {
            let name = text[..at].rfind(' ')? + 1..at;
            let value = at + 2..at + 2 + text[at + 2..].find('"')?;
            Some(Attribute { whole: name.start - 1..value.end + 1, name, value })
        })
        .collect()
}

/// The text with ranges replaced, which must not overlap.
fn replace(text: &str, changes: &[(Range<usize>, &str)]) -> String {
    let mut changes: Vec<_> = changes.iter().collect();
    changes.sort_by_key(|(range, _)| range.start);
    let (mut result, mut at) = (String::with_capacity(text.len()), 0);
    for (range, with) in changes {
        result.push_str(&text[at..range.start]);
        result.push_str(with);
        at = range.end;
    }
    result.push_str(&text[at..]);
    result
}

fn swap(text: &str, a: Range<usize>, b: Range<usize>) -> String {
    if a.end > b.start && b.end > a.start {
        return text.to_owned();
    }
    replace(text, &[(a.clone(), &text[b.clone()]), (b, &text[a])])
}
