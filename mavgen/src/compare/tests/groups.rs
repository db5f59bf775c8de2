//! What does not come from messages and enums of one file alone: overlays, included files, places.

use super::*;
use crate::source::Span;

const ACME: &str = "<mavlink><include>base.xml</include><messages><message id='1' name='TANK'><description>.</description>\
    <field type='uint16_t' name='bits'/></message></messages></mavlink>";

const BASE: &str = "<mavlink><messages><message id='2' name='BASE'><description>.</description>\
    <field type='uint16_t' name='x'/></message></messages></mavlink>";

fn overlay(bits: &str) -> String {
    format!(
        "<mavlink-overlay version='1' for='acme.xml'><message name='TANK'><view name='TANK_BITS' words='bits' item='tank' partial='true'>\
         {bits}</view></message></mavlink-overlay>"
    )
}

#[test]
fn views_are_compared() {
    let of = |bits: &str| dialect(&[("acme.xml", ACME)], Some(&overlay(bits)));
    let old = of("<bits name='level' at='0' width='8'/><bits name='open' at='8' width='1'/>");
    let new = of("<bits name='level' at='0' width='12'/><bits name='leak' at='15' width='1'/>");
    let changes: Vec<String> = compare(&old, &new, None).unwrap().iter().map(shown).collect();
    assert_eq!(
        changes,
        [
            "api! TankBits::level() is const fn(self) -> u16, was const fn(self) -> u8",
            "api! TankBits::open() is gone",
            "api TankBits::leak() is new",
        ]
    );
    let without = dialect(&[("acme.xml", ACME)], None);
    let added: Vec<String> = compare(&without, &old, None).unwrap().iter().map(shown).collect();
    assert_eq!(added, ["api Tank::tank() is new", "api TankBits is new"]);
}

#[test]
fn a_message_that_moves_to_another_file_is_the_same() {
    let own = ACME.replace(
        "<messages>",
        "<messages><message id='2' name='BASE'><description>.</description><field type='uint16_t' name='x'/></message>",
    );
    let empty = "<mavlink><messages/></mavlink>";
    let old = dialect(&[("acme.xml", ACME), ("base.xml", BASE)], None);
    let new = dialect(&[("acme.xml", &own), ("base.xml", empty)], None);
    let changes: Vec<String> = compare(&old, &new, None).unwrap().iter().map(shown).collect();
    assert_eq!(changes, ["metadata message BASE: file acme.xml, was base.xml"]);
}

#[test]
fn both_places_are_told() {
    let new = ACME.replace("'uint16_t'", "'uint32_t'");
    let text = |source: &str, span: Option<Span>| source[span.unwrap().range()].to_owned();
    for change in compare(&of(ACME), &of(&new), None).unwrap() {
        assert_eq!(text(ACME, change.old), "<field type='uint16_t' name='bits'/>", "{change}");
        assert_eq!(text(&new, change.new), "<field type='uint32_t' name='bits'/>", "{change}");
    }
    let gone = compare(&of(ACME), &of("<mavlink><messages/></mavlink>"), None).unwrap();
    assert_eq!(gone.len(), 2);
    assert!(gone.iter().all(|change| change.old.is_some() && change.new.is_none()));
    assert_eq!(gone[0].group(), Group::Wire);
}
