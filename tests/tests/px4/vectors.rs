//! The vectors that `tests/oracle/make_px4.py` writes: what rosbags and an independent reading say of messages.

use std::path::Path;

use mavgen::uorb::log_format;
use mavgen::uorb::model::{Message, Package};

use super::{DEFINITIONS, folder, package};

pub(super) const ESC_STATUS: &str = include_str!("../../vectors/px4/esc_status.txt");

/// A message of one definition, with values.
pub(super) struct Vectors<'t> {
    pub(super) message: &'t str,
    pub(super) definition: &'t str,
    pub(super) type_hash: &'t str,
    /// As CDR without header, as a struct, and as a record.
    pub(super) lengths: [u32; 3],
    /// Its own first.
    pub(super) formats: Vec<&'t str>,
    /// Name, payload with header, record.
    pub(super) values: Vec<(&'t str, Vec<u8>, Vec<u8>)>,
}

/// The vectors of a file.
pub(super) fn vectors(text: &str) -> Vec<Vectors<'_>> {
    let mut all: Vec<Vectors<'_>> = Vec::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let (kind, rest) = line.split_once(' ').unwrap();
        let words: Vec<&str> = rest.split(' ').collect();
        match (kind, &words[..]) {
            ("message", [message, definition, type_hash, lengths @ ..]) => {
                let lengths: Vec<u32> = lengths.iter().map(|number| number.parse().unwrap()).collect();
                let (lengths, formats, values) = (lengths.try_into().unwrap(), Vec::new(), Vec::new());
                all.push(Vectors { message, definition, type_hash, lengths, formats, values });
            }
            ("format", _) => all.last_mut().unwrap().formats.push(rest),
            ("value", [name, cdr, record]) => all.last_mut().unwrap().values.push((name, bytes(cdr), bytes(record))),
            _ => panic!("{line}"),
        }
    }
    all
}

fn bytes(digits: &str) -> Vec<u8> {
    let pairs = digits.as_bytes().as_chunks::<2>().0.iter();
    pairs.map(|pair| u8::from_str_radix(str::from_utf8(pair).unwrap(), 16).unwrap()).collect()
}

fn compare(vectors: &Vectors<'_>, package: &Package) {
    let find = |name: &str| package.messages.iter().find(|message| message.name == name).unwrap();
    let message: &Message = find(vectors.message);
    let name = format!("{} of {}", vectors.message, vectors.definition);
    assert_eq!(message.type_hash, vectors.type_hash, "{name}");
    let lengths = [message.cdr_len, message.struct_len, message.struct_len - message.struct_padding];
    assert_eq!(lengths, vectors.lengths, "{name}");
    for (i, format) in vectors.formats.iter().enumerate() {
        let (topic, fields) = format.split_once(':').unwrap();
        let own = package.messages.iter().find(|message| mavgen::uorb::topic_name(&message.name) == topic).unwrap();
        let ours = log_format(own, package);
        // The message's own format lacks the padding at its end.
        let ours = if i == 0 && own.struct_padding > 0 { ours.rsplit_once("uint8_t[").unwrap().0 } else { &ours };
        assert_eq!(ours, fields, "{name}");
    }
}

#[test]
fn the_model_is_what_others_say() {
    let all = vectors(ESC_STATUS);
    assert_eq!(all.iter().map(|one| one.definition).collect::<Vec<_>>(), DEFINITIONS);
    for vectors in &all {
        assert_eq!((vectors.formats.len(), vectors.values.len()), (2, 22));
        compare(vectors, &package(&folder(vectors.definition)));
    }
}

/// All messages of a folder: `PX4_MESSAGES` and `PX4_VECTORS` name it, and what `make_px4.py --all` writes of it.
#[test]
#[ignore = "needs PX4's messages"]
fn the_model_of_all_messages_is_what_others_say() {
    let [folder, text] = ["PX4_MESSAGES", "PX4_VECTORS"].map(|name| std::env::var(name).unwrap());
    let (package, text) = (package(Path::new(&folder)), std::fs::read_to_string(text).unwrap());
    let all = vectors(&text);
    assert_eq!(all.len(), package.messages.len());
    all.iter().for_each(|vectors| compare(vectors, &package));
}
