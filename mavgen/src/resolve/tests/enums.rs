//! Values, merging, ownership and width of enums.

use super::{Outcome, enumeration, message, of, outcome};
use crate::diag::Code;
use crate::ir::{Repr, Values};

/// Each file includes all that follow, and defines `E` with these entries.
fn merged(files: &[&[&str]]) -> Outcome {
    let names = ["top.xml", "mid.xml", "base.xml"];
    let contents: Vec<String> = (files.iter().enumerate())
        .map(|(index, entries)| {
            let below = &names[index + 1..files.len()];
            let includes: String = below.iter().map(|name| format!("<include>{name}</include>")).collect();
            includes + &enumeration("E", entries)
        })
        .collect();
    let files: Vec<(&str, &str)> = names.into_iter().zip(contents.iter().map(String::as_str)).collect();
    outcome(&files)
}

/// Automatic values: the largest so far plus one.
#[test]
fn automatic_values() {
    for (entries, expected) in [
        (&["A", "B"] as &[&str], &[("A", 1_u64), ("B", 2)] as &[(&str, u64)]),
        (&["A=0", "B"], &[("A", 0), ("B", 1)]),
        (&["A=10", "B=3", "C"], &[("B", 3), ("A", 10), ("C", 11)]),
        (&["A=0x10", "B=2**5", "C=0b1"], &[("C", 1), ("A", 16), ("B", 32)]),
        (&["A=18446744073709551614", "B"], &[("A", u64::MAX - 1), ("B", u64::MAX)]),
    ] {
        assert_eq!(of(&enumeration("E", entries)).values("E"), expected);
    }
    assert_eq!(of(&enumeration("E", &["A=2**63", "B=0xFFFFFFFFFFFFFFFF", "C"])).codes(), [Code::BadValue]);
}

/// pymavlink's `merge_enums`, oddities included; every row was run there.
#[test]
fn merging_moves_automatic_values() {
    for (files, expected) in [
        // The automatic value of the outer file makes way.
        (&[&["T"] as &[&str], &["B=0", "C=12"]] as &[&[&str]], &[("B", 0_u64), ("C", 12), ("T", 13)] as &[(&str, u64)]),
        // Ranges that do not overlap: nothing moves.
        (&[&["T"], &["B=5", "C=6"]], &[("T", 1), ("B", 5), ("C", 6)]),
        // Values of the inner file never move.
        (&[&["T=5"], &["B"]], &[("B", 1), ("T", 5)]),
        // Several that make way, one after the other.
        (&[&["T", "U"], &["B=1", "C=2"]], &[("B", 1), ("C", 2), ("T", 3), ("U", 4)]),
    ] {
        assert_eq!(merged(files).values("E"), expected, "{files:?}");
    }
}

#[test]
fn merging_can_end_in_duplicates() {
    for files in [
        // An automatic value of the inner file meets one of the outer.
        &[&["T=1"] as &[&str], &["B"]] as &[&[&str]],
        // 7 and 8 are given, and 8 is there.
        &[&["T", "U", "V=8"], &["B=5", "C=6"]],
        // All automatic, in three files.
        &[&["T"], &["M", "N"], &["B", "C"]],
        // The range of the first definition is not updated: T moves to 4 and stays there.
        &[&["T"], &["M=0", "N=3"], &["B=4", "C=5"]],
    ] {
        let codes = merged(files).codes();
        assert!(codes.contains(&Code::DuplicateValue), "{files:?}: {codes:?}");
    }
}

#[test]
fn one_file_can_define_an_enum_twice() {
    let content = enumeration("E", &["A", "B"]) + &enumeration("E", &["C=7"]);
    assert_eq!(of(&content).values("E"), [("A", 1), ("B", 2), ("C", 7)]);
}

#[test]
fn automatic_values_are_told() {
    let outcome = merged(&[&["T"], &["B=0", "C=12"]]);
    assert_eq!(outcome.problems, [(Code::AutomaticValue, "`T` has no value and is given 13".to_owned())]);
    let auto: Vec<bool> = outcome.find_enum("E").entries.iter().map(|entry| entry.auto).collect();
    assert_eq!(auto, [false, false, true]);
}

/// A dialect that adds an entry changes neither width nor names of what it includes.
#[test]
fn the_included_file_owns_an_enum() {
    let top = "<include>base.xml</include>".to_owned() + &enumeration("E", &["ACME_X=9"]);
    let top = top + &message(2, "B", &["uint32_t f E"]);
    let base = enumeration("E", &["E_A=1", "E_B=2"]) + &message(1, "A", &["uint16_t f E"]);
    let outcome = outcome(&[("top.xml", &top), ("base.xml", &base)]);
    let found = outcome.find_enum("E");
    assert_eq!((found.defined_in.0, found.origin.file.0, found.repr), (1, 0, Repr::U16));
    let values = |index: usize| outcome.dialect().messages[index].fields[0].values.unwrap();
    assert!(matches!(values(0), Values::Typed(_)));
    assert!(matches!(values(1), Values::Converted(_)));
}

/// Of files that do not include each other, the one whose messages use the enum owns it.
#[test]
fn ties_go_to_the_user() {
    let top = "<include>x.xml</include><include>y.xml</include>";
    let (x, y) = (enumeration("E", &["A=1"]), enumeration("E", &["B=2"]));
    let used = message(1, "M", &["int8_t f E"]);
    let own = |x: &str, y: &str| {
        let outcome = outcome(&[("top.xml", top), ("x.xml", x), ("y.xml", y)]);
        outcome.find_enum("E").defined_in.0
    };
    assert_eq!(own(&x, &y), 1);
    assert_eq!(own(&x, &(y.clone() + &used)), 2);
}

/// Of three files that define an enum, the one that both others include.
#[test]
fn the_most_included_file_owns_an_enum() {
    for files in [&[&["T=1"] as &[&str], &["M=2"], &["B=3"]] as &[&[&str]], &[&["T=1"], &["B=3"]], &[&["B=3"]]] {
        assert_eq!(merged(files).find_enum("E").defined_in.0, files.len() - 1, "{files:?}");
    }
}

#[test]
fn widths() {
    for (entries, fields, expected) in [
        (&["A=255"] as &[&str], &[] as &[&str], Repr::U8),
        (&["A=256"], &[], Repr::U16),
        (&["A=4294967296"], &[], Repr::U64),
        (&["A=1"], &["uint8_t a E", "uint32_t b E", "uint16_t c E"], Repr::U32),
        (&["A=1"], &["int16_t a E", "uint16_t b E"], Repr::U16),
        (&["A=1"], &["uint16_t a E", "int32_t b E"], Repr::I32),
        (&["A=1"], &["int8_t[4] a E"], Repr::I8),
        (&["A=1"], &["float a E", "char b E", "double c E"], Repr::U8),
        (&["A=300"], &["uint8_t a E"], Repr::U16),
        (&["A=300"], &["int8_t a E"], Repr::I16),
    ] {
        let fields = [fields, &["uint8_t z"]].concat();
        let outcome = of(&(enumeration("E", entries) + &message(1, "M", &fields)));
        assert_eq!(outcome.find_enum("E").repr, expected, "{entries:?} {fields:?}");
    }
}

/// The file that owns an enum says whether an enum is a bitmask; pymavlink asks the first definition.
#[test]
fn bitmasks_stay_bitmasks() {
    let top = "<include>base.xml</include>".to_owned() + &enumeration("E", &["X=4"]);
    let base = enumeration("E", &["A=1", "B=2"]).replace("<enum ", "<enum bitmask='true' ");
    let outcome = outcome(&[("top.xml", &top), ("base.xml", &base)]);
    assert!(outcome.find_enum("E").bitmask);
    assert_eq!(outcome.codes(), [Code::BitmaskDiffers]);
    assert!(of(&base.replace("true", "1")).find_enum("E").bitmask);
}

#[test]
fn descriptions_come_from_the_first_that_has_one() {
    let described = |entry: &str, description: &str| {
        let description = format!("<enum name='E'><description>{description}</description>");
        enumeration("E", &[entry]).replace("<enum name='E'>", &description)
    };
    let outcome = outcome(&[("top.xml", &described("A=1", "")), ("base.xml", &described("B=2", "base"))]);
    assert_eq!(outcome.find_enum("E").origin.description, "base");
}

#[test]
fn commands() {
    let params = "<entry name='MAV_CMD_GO' value='1' hasLocation='true'>\
                  <param index='5' label='Latitude' minValue='-90' maxValue='90' enum='E'>.</param>\
                  <param index='2' reserved='1' default='NaN'/></entry><entry name='MAV_CMD_NO' value='2'/>";
    let content = format!("<enums><enum name='MAV_CMD'>{params}</enum></enums>") + &enumeration("E", &["A=1"]);
    let outcome = of(&content);
    let [go, no] = &outcome.find_enum("MAV_CMD").entries[..] else { panic!("two entries") };
    let go = go.command.as_ref().unwrap();
    assert!(go.has_location && !go.is_destination && !go.mission_only);
    let indices: Vec<u8> = go.params.iter().map(|param| param.index).collect();
    assert_eq!(indices, [2, 5]);
    assert!(go.params[0].reserved && go.params[0].default.is_some_and(f64::is_nan));
    assert_eq!((go.params[1].limits.min, go.params[1].limits.max), (Some(-90.0), Some(90.0)));
    assert!(go.params[1].enum_.is_some());
    assert!(no.command.as_ref().is_some_and(|command| command.params.is_empty()));
    assert!(outcome.find_enum("E").entries[0].command.is_none());
}

/// pymavlink takes the last of two params with one index, and has no use for one beyond the seven.
#[test]
fn the_last_param_of_an_index_counts() {
    let params = [(1, "first"), (2, "other"), (1, "last"), (8, "beyond")]
        .map(|(index, text)| format!("<param index='{index}'>{text}</param>"));
    let entry = format!("<entry name='MAV_CMD_A' value='1'>{}</entry>", params.concat());
    let outcome = of(&format!("<enums><enum name='MAV_CMD'>{entry}</enum></enums>"));
    assert_eq!(outcome.codes(), [Code::ParamIndex; 2]);
    let command = outcome.find_enum("MAV_CMD").entries[0].command.as_ref().unwrap();
    let params: Vec<_> = command.params.iter().map(|param| (param.index, &*param.origin.description)).collect();
    assert_eq!(params, [(1, "last"), (2, "other")]);
}
