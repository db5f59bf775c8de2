//! What becomes one type, what becomes two, and where they are declared.

use std::fs;

use super::{Placement, Root, Union};
use crate::diag::Code;
use crate::ir::{EnumId, Lifecycle};
use crate::{Builder, Failure, Resolved};

/// Resolves dialects together: each a name and what stands in its `<mavlink>`. A name that ends in `.overlay` is that of an
/// overlay, for the dialect of the name before it.
fn resolve(files: &[(&str, &str)]) -> Result<Resolved, Failure> {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(format!("{name}.xml"));
    let mut builder: Option<Builder> = None;
    for (name, text) in files {
        let Some(base) = name.strip_suffix(".overlay") else {
            fs::write(path(name), format!("<mavlink>{text}</mavlink>")).unwrap();
            builder = Some(builder.map_or_else(|| Builder::new(path(name)), |builder| builder.root(path(name))));
            continue;
        };
        let overlay = format!("<mavlink-overlay version='1' for='{base}.xml'>{text}</mavlink-overlay>");
        fs::write(path(name), overlay).unwrap();
        builder = builder.map(|builder| builder.overlay(path(name)));
    }
    builder.unwrap().resolve()
}

fn union(files: &[(&str, &str)]) -> Union {
    resolve(files).unwrap_or_else(|failure| panic!("{failure}")).union.unwrap()
}

fn message(id: u32, name: &str, field: &str) -> String {
    format!("<messages><message id='{id}' name='{name}'><field name='a' {field}/></message></messages>")
}

fn values(name: &str, attributes: &str, entries: &[(&str, u64)]) -> String {
    let entries = entries.iter().map(|(name, value)| format!("<entry name='{name}' value='{value}'/>"));
    format!("<enum name='{name}' {attributes}>{}</enum>", entries.collect::<String>())
}

/// Names and placements of the messages.
fn messages(union: &Union) -> Vec<(&str, Placement)> {
    let names = union.all.messages.iter().map(|message| message.name.text.as_str());
    names.zip(union.message_placements.iter().map(|at| at.placement)).collect()
}

#[test]
fn of_three_definitions_the_equal_ones_are_one_type() {
    let (one, other) = (message(1, "TANK", "type='uint8_t'"), message(1, "TANK", "type='uint16_t'"));
    let union = union(&[("a", &other), ("b", &one), ("c", &one)]);
    assert_eq!(messages(&union), [("TANK", Placement::Root(0)), ("TANK", Placement::Root(1))]);
    let of_roots: Vec<_> = union.roots.iter().map(|root| root.messages.clone()).collect();
    assert_eq!(of_roots, [[0], [1], [1]]);
}

#[test]
fn names_that_are_one_in_rust_are_apart() {
    let union = union(&[
        ("a", &message(1, "FUEL_TANK", "type='uint8_t'")),
        ("b", &message(1, "FuelTank", "type='uint8_t'")),
        ("c", &message(2, "FUEL", "type='uint8_t'")),
    ]);
    let apart = [("FUEL_TANK", Placement::Root(0)), ("FuelTank", Placement::Root(1)), ("FUEL", Placement::Shared)];
    assert_eq!(messages(&union), apart);
}

#[test]
fn width_and_kind_make_an_enum_another() {
    for (attributes, entry, types) in [("", 3, 1), ("", 300, 2), ("bitmask='true'", 4, 2)] {
        let (a, b) = (values("E", "", &[("E_A", 1)]), values("E", attributes, &[("E_B", entry)]));
        let wrapped = |values: String| format!("<enums>{values}</enums>");
        let union = union(&[("a", &wrapped(a)), ("b", &wrapped(b))]);
        assert_eq!(union.all.enums.len(), types, "{attributes} {entry}");
        let shared = union.enum_placements.iter().all(|placement| *placement == Placement::Shared);
        assert_eq!(shared, types == 1, "{attributes} {entry}");
        assert_eq!(union.all.enums[0].entries.len(), 3 - types);
    }
}

/// Every row: the entries in two dialects, and how many types they become.
#[test]
fn an_entry_with_two_values_makes_an_enum_another() {
    for (a, b, types, constants) in [
        (&[("E_A", 1)][..], &[("E_A", 1), ("E_B", 2)][..], 1, &["A", "B"][..]),
        // Renamed, and one name in Rust; the entry keeps its first name.
        (&[("SAILING", 1), ("MOORED", 2)], &[("E_SAILING", 1), ("E_MOORED", 2)], 1, &["SAILING", "MOORED"]),
        // Renamed, with two names in Rust.
        (&[("E_OLD", 1), ("E_X", 2)], &[("E_NEW", 1), ("E_X", 2)], 1, &["OLD", "NEW", "X"]),
        // Another value under one name, in the definitions or in Rust.
        (&[("E_A", 1)], &[("E_A", 2)], 2, &["A"]),
        (&[("A", 1), ("B", 3)], &[("E_A", 2), ("E_C", 4)], 2, &["A", "B"]),
    ] {
        let wrapped = |entries: &[(&str, u64)]| format!("<enums>{}</enums>", values("E", "", entries));
        let union = union(&[("a", &wrapped(a)), ("b", &wrapped(b))]);
        assert_eq!((union.all.enums.len(), union.names.enums.len()), (types, types), "{a:?} {b:?}");
        assert_eq!(union.names.enums[0].constants, constants, "{a:?} {b:?}");
        assert_eq!(union.all.enums[0].entries[0].name.text, a[0].0);
        let apart = union.enum_placements == [Placement::Root(0), Placement::Root(1)];
        assert_eq!(apart, types == 2, "{a:?} {b:?}");
    }
}

/// A name that a constant had in one of the dialects means that constant in each.
#[test]
fn a_renamed_entry_keeps_both_names() {
    let wrapped = |entries: &[(&str, u64)]| format!("<enums>{}</enums>", values("E", "", entries));
    let (a, b) = (wrapped(&[("SAILING", 1), ("MOORED", 2)]), wrapped(&[("E_SAILING", 1), ("E_MOORED", 2)]));
    let renamed = [("E_SAILING", "SAILING"), ("E_MOORED", "MOORED")].map(|(a, b)| (a.to_owned(), b.to_owned()));
    // The third has the second name and another prefix, so that its constant alone would be a new one.
    let c = wrapped(&[("E_SAILING", 1), ("ADRIFT", 3)]);
    let all = union(&[("a", &a), ("b", &b), ("c", &c)]);
    let names = &all.names.enums[0];
    assert_eq!((names.constants.len(), names.renamed.as_slice()), (3, renamed.as_slice()));
    // And with another value it is another enum.
    let c = wrapped(&[("E_SAILING", 7), ("ADRIFT", 3)]);
    assert_eq!(union(&[("a", &a), ("b", &b), ("c", &c)]).all.enums.len(), 2);
    let files = Builder::new("a.xml").emit(&resolve(&[("a", &a), ("b", &b)]).unwrap()).unwrap();
    let file = files.iter().find(|file| file.path == "enums/e.rs").unwrap();
    let first = file.text.find(r#"(1, "SAILING")"#);
    assert!(first.is_some() && first < file.text.find(r#"(1, "E_SAILING")"#), "{}", file.text);
}

/// Who bridges two dialects reads at each of the types that there is another.
#[test]
fn enums_that_differ_name_each_other() {
    let wrapped = |value: u64| format!("<enums>{}</enums>", values("E", "", &[("E_A", value)]));
    let resolved = resolve(&[("a", &wrapped(1)), ("b", &wrapped(2))]).unwrap();
    assert_eq!(resolved.diagnostics.iter().map(|one| one.code).collect::<Vec<_>>(), [Code::SecondValue]);
    let files = Builder::new("a.xml").emit(&resolved).unwrap();
    for (path, line) in [
        ("a/enums/e.rs", "In `b` an entry has another value: [`b::E`](super::super::super::b::enums::E)."),
        ("b/enums/e.rs", "In `a` an entry has another value: [`a::E`](super::super::super::a::enums::E)."),
    ] {
        let file = files.iter().find(|file| file.path == path).unwrap();
        assert!(file.text.contains(line), "{}", file.text);
    }
}

/// The third dialect has what one of the two before it has.
#[test]
fn of_three_enums_those_that_agree_are_one() {
    let wrapped = |value: u64| format!("<enums>{}</enums>", values("E", "", &[("E_A", value)]));
    let union = union(&[("a", &wrapped(1)), ("b", &wrapped(2)), ("c", &wrapped(2))]);
    let enums: Vec<_> = union.roots.iter().map(|root| root.enums.clone()).collect();
    assert_eq!(enums, [[EnumId(0)], [EnumId(1)], [EnumId(1)]]);
}

/// A message with an enum that a dialect widens is not the message of the dialect that does not.
#[test]
fn a_message_goes_with_its_enums() {
    let text = |entry: u64| {
        format!(
            "<enums>{}</enums>{}",
            values("E", "", &[("E_A", entry)]),
            message(1, "TANK", "type='uint32_t' enum='E'").replace("</messages>", "")
        ) + "<message id='2' name='PLAIN'><field name='a' type='uint8_t'/></message></messages>"
    };
    let union = union(&[("a", &text(1)), ("b", &text(1 << 40))]);
    assert_eq!(
        messages(&union),
        [("TANK", Placement::Root(0)), ("PLAIN", Placement::Shared), ("TANK", Placement::Root(1))]
    );
    let Root { enums, messages, .. } = &union.roots[1];
    assert_eq!((enums.as_slice(), messages.as_slice()), (&[EnumId(1)][..], &[2, 1][..]));
}

#[test]
fn overlays_that_disagree_make_two_types() {
    let tank = message(1, "TANK", "type='uint8_t'");
    let bind = |values: &str| {
        let enums = format!("<enums><enum name='{values}'><entry name='{values}_A' value='1'/></enum></enums>");
        format!("{enums}<message name='TANK'><bind name='kind' field='a' enum='{values}'/></message>")
    };
    let union_of =
        |a: &str, b: &str| union(&[("a", &tank), ("b", &tank), ("a.overlay", &bind(a)), ("b.overlay", &bind(b))]);
    let same = union_of("E", "E");
    assert_eq!((messages(&same), same.all.messages[0].bindings.len()), (vec![("TANK", Placement::Shared)], 1));
    assert_eq!(messages(&union_of("E", "F")), [("TANK", Placement::Root(0)), ("TANK", Placement::Root(1))]);
}

#[test]
fn views_with_different_methods_are_on_one_type() {
    let tank = message(1, "TANK", "type='uint8_t'");
    let view = |[name, item]: [&str; 2]| {
        format!(
            "<message name='TANK'><view name='{name}' words='a' item='{item}'><bits name='x' at='0' width='8'/></view>\
             </message>"
        )
    };
    let shared = vec![("TANK", Placement::Shared)];
    let apart = vec![("TANK", Placement::Root(0)), ("TANK", Placement::Root(1))];
    for (a, b, placed, views) in [
        (["V", "v"], ["W", "w"], shared.clone(), 2),
        (["V", "v"], ["W", "v"], apart.clone(), 1),
        // The same text, but in two overlays: what one of them says tomorrow is not known.
        (["V", "v"], ["V", "v"], apart, 1),
    ] {
        let union = union(&[("a", &tank), ("b", &tank), ("a.overlay", &view(a)), ("b.overlay", &view(b))]);
        assert_eq!((messages(&union), union.all.messages[0].views.len()), (placed, views), "{a:?} {b:?}");
    }
    let include = "<include>base.xml</include>";
    let union = union(&[("base", &tank), ("base.overlay", &view(["V", "v"])), ("a", include), ("b", include)]);
    assert_eq!((messages(&union), union.all.messages[0].views.len()), (shared, 1));
}

#[test]
fn what_one_dialect_has_in_use_is_not_deprecated() {
    let old = "<enums><enum name='E'><deprecated since='2020-01'/><entry name='E_A' value='1'/></enum></enums>";
    let refine = "<refine enum='E' deprecated='false'/>";
    let stage = |files: &[(&str, &str)]| union(files).all.enums[0].origin.lifecycle.clone();
    assert!(matches!(stage(&[("a", old), ("b", old)]), Some(Lifecycle::Deprecated(_))));
    assert!(!matches!(stage(&[("a", old), ("b", old), ("b.overlay", refine)]), Some(Lifecycle::Deprecated(_))));
}

#[test]
fn what_is_shared_is_read_and_said_once() {
    let base = format!("<enums>{}</enums>", "<enum name='E'><entry name='E_A'/></enum>");
    let include = "<include>base.xml</include>";
    let resolved = resolve(&[("base", &base), ("a", include), ("b", include)]).unwrap();
    assert_eq!((resolved.sources.iter().count(), resolved.watched.len(), resolved.diagnostics.len()), (3, 3, 1));
    let union = resolved.union.unwrap();
    let files: Vec<&str> = union.all.files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!((files, union.all.enums.len()), (vec!["base.xml", "a.xml", "b.xml"], 1));
    assert_eq!(union.all.file(union.roots[2].file).map(|file| file.includes.len()), Some(1));
}
