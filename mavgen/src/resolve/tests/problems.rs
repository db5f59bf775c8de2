//! What is reported, and that it is reported once. The renderings are in `tests/ui`.

use super::{enumeration, message, of, outcome};
use crate::diag::Code;
use crate::ir::Repr;

#[test]
fn one_broken_message_does_not_hide_the_next() {
    let content = [
        message(1, "A", &["uint9_t a", "uint8_t[0] b", "float c"]),
        message(1, "B", &["uint8_t a", "uint8_t a"]),
        message(16_777_216, "C", &[]),
    ];
    let outcome = of(&content.concat());
    assert!(outcome.dialect.is_none());
    let expected = [
        Code::UnknownType,
        Code::ArrayLength,
        Code::DuplicateMessageId,
        Code::DuplicateField,
        Code::MessageId,
        Code::NoFields,
    ];
    assert_eq!(outcome.codes(), expected);
}

/// What reading lost is not missed a second time by those who name it.
#[test]
fn no_noise_after_broken_xml() {
    let content = message(1, "A", &["uint8_t a E"]) + "<enums><enum><entry name='E_A'/></enum></enums>";
    assert_eq!(of(&content).codes(), [Code::MissingAttribute]);
    let whole = message(1, "A", &["uint8_t a E"]);
    assert_eq!(of(&whole).codes(), [Code::UnknownEnum]);
}

#[test]
fn no_noise_after_a_bad_value() {
    let content = enumeration("E", &["A=x", "B", "C=1"]);
    assert_eq!(of(&content).codes(), [Code::BadValue]);
    // An entry that has no value is no unknown sentinel, and an unknown one is told where no entry is lost.
    for (entry, expected) in [("A=x", Code::BadValue), ("B=1", Code::Invalid)] {
        let field = message(1, "M", &["uint8_t f"]).replace("name='f'", "name='f' invalid='A'");
        assert_eq!(of(&(enumeration("E", &[entry]) + &field)).codes(), [expected], "{entry}");
    }
}

#[test]
fn payload_lengths() {
    for (fields, refused) in [
        (&["uint8_t[255] a"] as &[&str], None),
        (
            &["uint8_t[255] a", "|", "char b"],
            Some("the payload of `M` is 256 bytes long with its extensions; 255 are allowed"),
        ),
        (&["double[32] a"], Some("the payload of `M` is 256 bytes long; 255 are allowed")),
        (
            &["double[255] a", "double[255] b", "|", "char c"],
            Some("the payload of `M` is 4081 bytes long; 255 are allowed"),
        ),
    ] {
        let outcome = of(&message(1, "M", fields));
        let expected: Vec<_> = refused.iter().map(|text| (Code::PayloadTooLong, (*text).to_owned())).collect();
        assert_eq!(outcome.problems, expected);
    }
}

#[test]
fn numbers_of_fields() {
    let fields: Vec<String> = (0..65).map(|index| format!("uint8_t f{index}")).collect();
    let fields: Vec<&str> = fields.iter().map(String::as_str).collect();
    assert_eq!(of(&message(1, "M", &fields[..64])).codes(), []);
    assert_eq!(of(&message(1, "M", &fields)).codes(), [Code::TooManyFields]);
}

#[test]
fn names_that_become_one() {
    for (content, expected) in [
        (message(1, "AB_C", &["char a"]) + &message(2, "ABC", &["char a"]), &[] as &[Code]),
        (message(1, "AB_C", &["char a"]) + &message(2, "ab_c", &["char a"]), &[Code::NameCollision]),
        (message(1, "A1", &["char a"]) + &message(2, "A_1", &["char a"]), &[Code::NameCollision]),
        (message(1, "M", &["char fooBar", "char foo_bar"]), &[Code::NameCollision]),
        (enumeration("E_F", &["A=1"]) + &enumeration("e_f", &["B=1"]), &[Code::NameCollision]),
        (enumeration("E", &["E_a=1", "E_A=2"]), &[Code::NameCollision]),
        (
            message(1, "E", &["char a"]) + &enumeration("E", &["A=1"]) + &enumeration("E_ENUM", &["B=1"]),
            &[Code::NameCollision],
        ),
        (message(1, "_", &["char __"]), &[Code::BadName, Code::BadName]),
        (enumeration("é", &["1=1"]), &[Code::BadName, Code::BadName]),
    ] {
        assert_eq!(of(&content).codes(), expected, "{content}");
    }
}

#[test]
fn file_names() {
    let named = |name: &str| outcome(&[(name, "")]);
    assert_eq!(named("my-dialect.v2.xml").dialect().name, "my-dialect.v2");
    assert_eq!(named("---.xml").codes(), [Code::BadName]);
}

#[test]
fn flags_without_a_bitmask() {
    for (entries, expected) in [
        (&["A=1", "B=2", "C=4", "D=8", "E=16"] as &[&str], &[Code::LikelyBitmask] as &[Code]),
        (&["A=0", "B=4", "C=8", "D=16"], &[Code::LikelyBitmask]),
        (&["A=1", "B=2", "C=4", "D=128"], &[Code::LikelyBitmask]),
        (&["A=0", "B=1", "C=2", "D=4"], &[]),
        (&["A=1", "B=2", "C=4", "D=24", "E=32"], &[]),
    ] {
        assert_eq!(of(&enumeration("X", entries)).codes(), expected, "{entries:?}");
    }
}

/// An entry of another file that does not fit makes the enum wider; one of the same file does so silently.
#[test]
fn widening_is_told_where_it_crosses_files() {
    let top = "<include>base.xml</include>".to_owned() + &enumeration("E", &["X=256"]);
    let base = enumeration("E", &["A=1"]) + &message(1, "M", &["uint8_t a E"]);
    let outcome = outcome(&[("top.xml", &top), ("base.xml", &base)]);
    assert_eq!(outcome.codes(), [Code::WidenedEnum]);
    assert_eq!(outcome.find_enum("E").repr, Repr::U16);
    assert_eq!(of(&enumeration("E", &["A=1", "X=256"])).codes(), []);
}

/// Merging takes the square of the number of definitions, so that has a bound.
#[test]
fn definitions_are_bounded() {
    let definitions = |count: usize| -> String {
        (0..count).map(|index| enumeration("E", &[&format!("A{index}={index}")])).collect()
    };
    assert_eq!(of(&definitions(256)).codes(), [Code::EnumTwice]);
    assert_eq!(of(&definitions(300)).codes(), [Code::EnumTwice, Code::TooLarge]);
}
