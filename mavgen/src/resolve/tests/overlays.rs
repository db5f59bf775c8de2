//! Enums, refinements, notes and bindings of overlays.

use super::{Outcome, enumeration, message, overlaid};
use crate::diag::Code;
use crate::ir::{Lifecycle, Repr};

/// Resolves one file with one overlay.
fn of(content: &str, overlay: &str) -> Outcome {
    overlaid(&[("a.xml", content)], &[overlay])
}

#[test]
fn enums_of_an_overlay_come_last_and_are_as_wide_as_their_bits() {
    let base = enumeration("E", &["E_A=1"]) + &message(1, "M", &["uint32_t f", "uint16_t g"]);
    let view = "<message name='M'>\
                <view name='V' words='f' item='v'><bits name='a' at='0' width='9' enum='NEW'/>\
                <bits name='b' at='9' width='23' enum='WIDE'/></view>\
                <bind name='c' field='g' enum='BOUND'/></message>";
    let overlay = ["NEW", "WIDE", "BOUND", "UNUSED"].map(|name| enumeration(name, &[&format!("{name}_A=1")])).concat();
    let outcome = of(&base, &(overlay + view));
    let dialect = outcome.dialect();
    let enums: Vec<_> = dialect.enums.iter().map(|values| (values.name.text.as_str(), values.repr)).collect();
    let expected =
        [("E", Repr::U8), ("NEW", Repr::U16), ("WIDE", Repr::U32), ("BOUND", Repr::U16), ("UNUSED", Repr::U8)];
    assert_eq!(enums, expected);
    let files: Vec<&str> = dialect.files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(files, ["a.xml", "0.overlay.xml"]);
    assert_eq!((outcome.find_enum("E").defined_in.0, outcome.find_enum("NEW").defined_in.0), (0, 1));
}

/// The definitions decide on the width of their own enums, whatever an overlay does with them.
#[test]
fn an_overlay_widens_no_enum_of_the_dialect() {
    let base = enumeration("E", &["E_A=1"]) + &message(1, "M", &["uint16_t f"]);
    let bind = |field: &str| format!("<message name='M'><bind name='x' field='{field}' enum='E'/></message>");
    assert_eq!(of(&base, &bind("f")).codes(), [Code::Bind]);
    let base = base.replace("</message>", "<field type='uint8_t' name='g'/></message>");
    assert_eq!(of(&base, &bind("g")).find_enum("E").repr, Repr::U8);
}

#[test]
fn refined_enums() {
    let base = enumeration("E", &["A=1", "B=2", "C=4", "D=8", "F=16"]);
    assert_eq!(of(&base, "").codes(), [Code::LikelyBitmask]);
    let refined = of(&base, "<refine enum='E' bitmask='true'/>");
    assert_eq!((refined.codes(), refined.find_enum("E").bitmask), (vec![], true));
    let base = base.replace("<enum ", "<enum bitmask='true' ");
    let refined = of(&base, "<refine enum='E' bitmask='false'/>");
    assert_eq!((refined.codes(), refined.find_enum("E").bitmask), (vec![], false));
}

#[test]
fn what_is_in_use_is_not_deprecated() {
    let deprecated = "<deprecated since='2018-04' replaced_by='F'>Slow.</deprecated>";
    let base = enumeration("E", &["A=1"]).replace("</enum>", &format!("{deprecated}</enum>"));
    let base = base.replace("<entry", "<description>Old.</description><entry");
    let plain = of(&base, "");
    assert!(matches!(plain.find_enum("E").origin.lifecycle, Some(Lifecycle::Deprecated(_))));
    let refined = of(&base, "<refine enum='E' deprecated='false'/>");
    let origin = &refined.find_enum("E").origin;
    assert_eq!(origin.lifecycle, None);
    assert_eq!(origin.description, "Old.\n\nDeprecated since 2018-04, replaced by F: Slow.");
    assert_eq!((plain.codes(), refined.codes()), (vec![], vec![]));
    for other in ["", "<wip/>", &deprecated.replace("deprecated", "superseded")] {
        let outcome = of(&base.replace(deprecated, other), "<refine enum='E' deprecated='false'/>");
        assert_eq!(outcome.codes(), [Code::NeedlessRefinement], "{other}");
    }
}

#[test]
fn notes_are_paragraphs_of_their_own() {
    let base = enumeration("E", &["E_A=1"]) + &message(1, "M", &["uint8_t f"]);
    let notes = "<note message='M'> One. </note><note message='M'>Two.</note><note message='M' field='f'>Three.</note>\
                 <note enum='E'>Four.</note><note enum='E' entry='E_A'>Five.</note>";
    let outcome = of(&base, notes);
    let found = &outcome.dialect().messages[0];
    assert_eq!(found.origin.description, ".\n\nOne.\n\nTwo.");
    assert_eq!(found.fields[0].origin.description, ".\n\nThree.");
    let values = outcome.find_enum("E");
    assert_eq!((&*values.origin.description, &*values.entries[0].origin.description), ("Four.", "Five."));
}

/// What an overlay says of a message that cannot be read is not a second mistake.
#[test]
fn what_is_broken_is_reported_once() {
    let base = message(1, "M", &["uint8_t f", "uin8_t g"]);
    let overlay = "<note message='M' field='f'>.</note>\
                   <message name='M'><bind name='x' field='f' enum='NONE'/></message>";
    assert_eq!(of(&base, overlay).codes(), [Code::UnknownType]);
}

#[test]
fn conditions_name_values_and_numbers() {
    let base =
        enumeration("E", &["E_A=1"]) + &enumeration("P", &["P_X=12"]) + &message(1, "M", &["uint8_t f", "uint8_t p P"]);
    for value in ["12", "0xC", "P_X"] {
        let bind =
            format!("<message name='M'><bind name='x' field='f' enum='E' if='p' is='{value}'>X.</bind></message>");
        let outcome = of(&base, &bind);
        let [binding] = &outcome.dialect().messages[0].bindings[..] else { panic!("one binding") };
        let condition = binding.condition.unwrap();
        assert_eq!((&*binding.name.shown(), binding.field.0, binding.description.as_str()), ("x", 0, "X."));
        assert_eq!((condition.field.0, condition.value, condition.enum_.unwrap().0), (1, 12, 1));
    }
}

#[test]
fn overlays_add_up() {
    let base = enumeration("E", &["E_A=1"]) + &message(1, "M", &["uint8_t f", "uint8_t g"]);
    let bind =
        |name: &str, field: &str| format!("<message name='M'><bind name='{name}' field='{field}' enum='E'/></message>");
    let two = |name: &str| overlaid(&[("a.xml", &base)], &[&bind("x", "f"), &bind(name, "g")]);
    assert_eq!(two("y").dialect().messages[0].bindings.len(), 2);
    assert_eq!(two("x").codes(), [Code::NameCollision]);
}
