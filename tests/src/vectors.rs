//! The reader of vector files; `vectors/README.md` describes the format.

use std::array;

use crate::definition::Definition;
use crate::values::Values;

/// The vectors of the AutoQuad dialect.
pub const AUTOQUAD: &str = include_str!("../vectors/autoquad.txt");

/// The key of the signed frames: 00 01 02 … 1f.
pub fn key() -> [u8; 32] {
    array::from_fn(|at| at as u8)
}

/// A message and its cases.
#[derive(Clone, Debug)]
pub struct Vectors {
    /// The message.
    pub definition: Definition,
    /// Values and their frames.
    pub cases: Vec<Case>,
}

/// Values, and the frames that carry them.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its name in the file.
    pub name: String,
    /// Sequence number of the frames.
    pub sequence: u8,
    /// The sender.
    pub system: u8,
    /// The sender's component.
    pub component: u8,
    /// Link of the signed frame.
    pub link: u8,
    /// Timestamp of the signed frame, 48 bits.
    pub timestamp: u64,
    /// What the frames carry.
    pub values: Values,
    /// The MAVLink 1 frame; none if the id is too large.
    pub v1: Option<GoldenFrame>,
    /// The MAVLink 2 frame.
    pub v2: GoldenFrame,
    /// The signed MAVLink 2 frame.
    pub signed: GoldenFrame,
}

/// A frame in its parts, as they are on the wire.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct GoldenFrame {
    /// All before the payload.
    pub header: Vec<u8>,
    /// The payload.
    pub payload: Vec<u8>,
    /// The checksum.
    pub checksum: Vec<u8>,
    /// The signature; empty if the frame is not signed.
    pub signature: Vec<u8>,
}

impl GoldenFrame {
    /// The whole frame.
    pub fn bytes(&self) -> Vec<u8> {
        [&self.header[..], &self.payload, &self.checksum, &self.signature].concat()
    }
}

/// Reads a vector file.
///
/// # Panics
///
/// Here and below: if the file is not written as the format says.
pub fn read(text: &str) -> Vec<Vectors> {
    let mut lines = text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')).peekable();
    let mut vectors = Vec::new();
    while let Some(line) = lines.next() {
        let definition = Definition::read(line).unwrap_or_else(|| panic!("not a message line: {line}"));
        let mut cases = Vec::new();
        while let Some(words) = lines.peek().and_then(|line| line.strip_prefix("case ")) {
            lines.next();
            let mut parts = |keyword: &str| {
                let parts = lines.peek()?.strip_prefix(keyword)?.strip_prefix(' ')?;
                lines.next();
                Some(parts)
            };
            cases.push(case(&definition, words, &mut parts));
        }
        vectors.push(Vectors { definition, cases });
    }
    vectors
}

fn case<'t>(definition: &Definition, words: &str, parts: &mut impl FnMut(&str) -> Option<&'t str>) -> Case {
    let words: Vec<&str> = words.split(' ').collect();
    let [name, sequence, system, component, link, timestamp] = words[..] else { panic!("not a case: {words:?}") };
    let byte = |digits: &str| u8::from_str_radix(digits, 16).unwrap();
    Case {
        name: name.to_owned(),
        sequence: byte(sequence),
        system: byte(system),
        component: byte(component),
        link: byte(link),
        timestamp: u64::from_str_radix(timestamp, 16).unwrap(),
        values: values(definition, parts("values").unwrap()),
        v1: parts("v1").map(frame),
        v2: frame(parts("v2").unwrap()),
        signed: frame(parts("signed").unwrap()),
    }
}

fn values(definition: &Definition, text: &str) -> Values {
    let lists: Vec<&str> = text.split(' ').collect();
    assert_eq!(lists.len(), definition.fields.len(), "{}", definition.name);
    let fields = definition.fields.iter().zip(lists);
    let values = fields.map(|(field, list)| {
        let elements = runs(list, field.element_size());
        assert_eq!(elements.len(), field.elements(), "{} {}", definition.name, field.name);
        elements
    });
    values.collect()
}

fn frame(text: &str) -> GoldenFrame {
    let mut parts = text.split(' ').map(|part| runs(part, 1).into_iter().map(|byte| byte as u8).collect());
    let mut next = || parts.next().unwrap_or_default();
    GoldenFrame { header: next(), payload: next(), checksum: next(), signature: next() }
}

/// `0102,00*5,03` in units of `size` bytes.
fn runs(text: &str, size: usize) -> Vec<u64> {
    let mut units = Vec::new();
    for token in text.split(',') {
        let (digits, count) = token.split_once('*').map_or((token, 1), |(unit, count)| (unit, count.parse().unwrap()));
        let token: Vec<u64> = digits.as_bytes().chunks(2 * size).map(|unit| unit_of(unit, size)).collect();
        units.extend(token.repeat(count));
    }
    units
}

fn unit_of(digits: &[u8], size: usize) -> u64 {
    assert_eq!(digits.len(), 2 * size);
    u64::from_str_radix(str::from_utf8(digits).unwrap(), 16).unwrap()
}
