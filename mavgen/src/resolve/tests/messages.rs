//! Layout, checksum and names of messages.

use super::{message, of, outcome};
use crate::ir::Scalar;

/// Micro-cases made with pymavlink: message A, id 1.
#[test]
fn checksums() {
    for (fields, crc_extra) in [
        (&["uint8_t f"] as &[&str], 129),
        (&["uint8_t[1] f"], 137),
        (&["uint8_t[4] f"], 115),
        (&["float[2] f"], 1),
        (&["char f"], 47),
        (&["char[1] f"], 29),
        (&["char[5] f"], 127),
        (&["double f"], 86),
        (&["uint8_t[255] f"], 102),
        (&["uint8_t a", "uint32_t b"], 61),
        (&["uint8_t a", "uint32_t b", "|", "uint64_t c"], 61),
    ] {
        let outcome = of(&message(1, "A", fields));
        assert_eq!(outcome.dialect().messages[0].crc_extra, crc_extra, "{fields:?}");
    }
}

/// Spellings that only pymavlink accepts count as the ones that they stand for.
#[test]
fn checksums_of_old_spellings() {
    for (old, new) in [("uint8", "uint8_t"), ("array[4]", "int8_t[4]"), ("uint8_t_mavlink_version", "uint8_t")] {
        let crc = |ty: &str| of(&message(1, "A", &[&format!("{ty} f")])).dialect().messages[0].crc_extra;
        assert_eq!(crc(old), crc(new), "{old}");
    }
}

/// Offsets by field, then the two lengths.
#[test]
fn layouts() {
    let heartbeat = ["uint8_t a", "uint8_t b", "uint8_t c", "uint32_t d", "uint8_t e", "uint8_t_mavlink_version f"];
    let unsorted = ["uint8_t[3] a", "double b", "|", "uint8_t c", "uint64_t d", "uint16_t[2] e"];
    let ties = ["uint16_t a", "char[4] b", "int16_t[3] c", "float d", "uint8_t e", "uint32_t f"];
    for (fields, offsets, len_v1, len_v2) in [
        (&heartbeat, [4, 5, 6, 0, 7, 8], 9, 9),
        (&unsorted, [8, 0, 11, 12, 20, 0], 11, 24),
        (&ties, [8, 16, 10, 0, 20, 4], 21, 21),
    ] {
        let outcome = of(&message(1, "A", fields));
        let message = &outcome.dialect().messages[0];
        for (field, offset) in message.fields.iter().zip(offsets) {
            assert_eq!(field.offset, offset, "{}", field.name.text);
        }
        assert_eq!((message.len_v1, message.len_v2), (len_v1, len_v2));
    }
}

#[test]
fn extensions_are_marked() {
    let outcome = of(&message(1, "A", &["uint8_t a", "|", "uint64_t b"]));
    let extensions: Vec<bool> = outcome.dialect().messages[0].fields.iter().map(|field| field.extension).collect();
    assert_eq!(extensions, [false, true]);
}

#[test]
fn messages_are_sorted_by_id() {
    let files = [("top.xml", &*message(9, "A", &["char a"])), ("b.xml", &*message(3, "B", &["char a"]))];
    let outcome = outcome(&files);
    let ids: Vec<u32> = outcome.dialect().messages.iter().map(|message| message.id).collect();
    assert_eq!(ids, [3, 9]);
}

/// The version is that of the message's own file, as far as it has been read by then.
#[test]
fn versions() {
    let beat = message(0, "BEAT", &["uint8_t_mavlink_version v"]);
    let before = format!("<version>3</version>{beat}");
    let after = format!("{beat}<version>3</version>");
    for (top, base, expected) in [
        ("<version>7</version>", &before, 3),
        ("<version>7</version>", &beat, 2),
        ("<version>7</version>", &after, 2),
        ("", &before, 3),
    ] {
        let outcome = outcome(&[("top.xml", top), ("base.xml", base)]);
        let field = &outcome.dialect().messages[0].fields[0];
        assert_eq!(field.ty.scalar, Scalar::Version(expected), "{base}");
    }
    assert_eq!(of("<version>7</version>").dialect().version, 7);
    assert_eq!(of("").dialect().version, 2);
}
