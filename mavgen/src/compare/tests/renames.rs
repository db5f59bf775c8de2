//! What is called differently in Rust, and what a name is made of.

use super::*;

fn with_enum(entries: &str) -> String {
    format!("<mavlink><enums><enum name='GEAR'>{entries}</enum></enums><messages/></mavlink>")
}

/// An entry without the prefix that the others share takes it from all of them: constants are renamed that the XML leaves alone.
#[test]
fn an_entry_that_renames_the_constants_of_others() {
    let old = "<entry value='1' name='LG_UP'/><entry value='2' name='LG_DOWN'/>";
    let new = format!("{old}<entry value='3' name='STUCK'/>");
    assert_eq!(
        changes(&with_enum(old), &with_enum(&new)),
        [
            "enums entry GEAR.STUCK is new: 3",
            "api! Gear::DOWN is called Gear::LG_DOWN now",
            "api! Gear::UP is called Gear::LG_UP now",
            "api Gear::STUCK is new",
        ]
    );
}

fn with_field(field: &str) -> String {
    format!(
        "<mavlink><enums><enum name='GEAR'><entry value='1' name='GEAR_UP'/></enum></enums><messages>\
         <message id='1' name='WHEELS'><description>.</description>{field}</message></messages></mavlink>"
    )
}

#[test]
fn a_renamed_field_takes_its_accessors_along() {
    let old = with_field("<field type='uint16_t' name='gear' enum='GEAR' invalid='0'/>");
    let renamed = changes(&old, &old.replace("name='gear'", "name='wheel'"));
    assert_eq!(renamed.len(), 2, "{renamed:?}");
    assert_eq!(renamed[1], "api! Wheels.gear is called Wheels.wheel now");
}

#[test]
fn fields_of_a_renamed_enum_are_not_changed() {
    let old = with_field("<field type='uint8_t[4]' name='gear' enum='GEAR'/>");
    let new = old.replace("'GEAR'", "'LANDING_GEAR'");
    assert_eq!(
        changes(&old, &new),
        [
            "enums enum GEAR is called LANDING_GEAR now",
            "api! Gear is called LandingGear now",
            "api! Gear::UP is called LandingGear::GEAR_UP now"
        ]
    );
}

/// Two names change places: neither type is the one that it was.
#[test]
fn messages_that_swap_their_names() {
    let message = |id: u8, name: &str, ty: &str| {
        format!("<message id='{id}' name='{name}'><description>.</description><field type='{ty}' name='x'/></message>")
    };
    let of = |first: &str, second: &str| {
        format!(
            "<mavlink><messages>{}{}</messages></mavlink>",
            message(1, first, "uint8_t"),
            message(2, second, "float")
        )
    };
    let swapped = changes(&of("A", "B"), &of("B", "A"));
    assert!(swapped.iter().filter(|change| change.starts_with("wire!")).count() >= 2, "{swapped:#?}");
    assert!(swapped.iter().any(|change| change == "api! A.x is f32, was u8"), "{swapped:#?}");
    let moved = changes(&of("A", "B"), &of("B", "C"));
    let api: Vec<&str> = moved.iter().filter(|change| change.starts_with("api")).map(String::as_str).collect();
    assert_eq!(api, ["api! A is gone", "api! B.x is u8, was f32", "api C is new"]);
}

/// The code of the message is the same to the letter, and its type is another.
#[test]
fn a_field_whose_type_left_its_name_to_another() {
    let old = "<mavlink><enums><enum name='FOO_BAR'><entry name='FOO_BAR_A' value='1'/></enum></enums><messages>\
               <message id='1' name='WHEELS'><description>.</description><field type='uint8_t' name='x' enum='FOO_BAR'/>\
               </message></messages></mavlink>";
    let new = old.replace("name='FOO_BAR'>", "name='BAR'>").replace("enum='FOO_BAR'", "enum='FOO__BAR'");
    let new = new.replace("</enums>", "<enum name='FOO__BAR'><entry name='C' value='2'/></enum></enums>");
    let told = changes(old, &new);
    assert!(told.contains(&"api! FooBar is called Bar now".to_owned()), "{told:#?}");
    assert!(told.contains(&"api! Wheels.x is FooBar, was FooBar".to_owned()), "{told:#?}");
}
