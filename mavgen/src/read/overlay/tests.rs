//! Everything of an overlay is understood, with its place. How refusals look is recorded in `tests/ui`.

use super::read;
use crate::diag::{Code, Diagnostics};
use crate::source::Sources;
use crate::syntax::overlay::{Bits, Part, Piece, View};
use crate::syntax::{Overlay, Text};

fn attempt(content: &str) -> (Overlay, Sources, Diagnostics) {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let id = sources.add("a.xml", format!("<mavlink-overlay version='1' for='b.xml'>{content}</mavlink-overlay>"));
    let overlay = read(id, &sources, &mut diagnostics);
    (overlay, sources, diagnostics)
}

fn understood(content: &str) -> (Overlay, Sources) {
    let (overlay, sources, diagnostics) = attempt(content);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    (overlay, sources)
}

/// The view that a message has.
fn view(content: &str) -> (View, Sources) {
    let (mut overlay, sources) = understood(&format!("<message name='M'>{content}</message>"));
    (overlay.messages.remove(0).views.remove(0), sources)
}

/// The values of attributes, each checked to be what stands at its place.
fn values<const N: usize>(sources: &Sources, texts: [&Option<Text>; N]) -> [String; N] {
    texts.map(|text| {
        let text = text.as_ref().unwrap();
        assert_eq!(&sources.get(text.span.file).unwrap().text()[text.span.range()], text.value);
        text.value.clone()
    })
}

fn bits(piece: &Piece) -> &Bits {
    match piece {
        Piece::Bits(bits) => bits,
        Piece::Reserved(_) => panic!("reserved"),
    }
}

#[test]
fn everything_beside_views() {
    let (overlay, sources) = understood(concat!(
        "<enums><enum name='E'><entry name='E_A' value='1'/></enum></enums>",
        "<refine enum='F' bitmask='true' deprecated='false'/>",
        "<note message='M' field='f' enum='E' entry='E_A'> Text &amp; text. </note>",
        "<message name='M'><bind name='b' field='f' enum='F' if='g' is='3'>Why.</bind></message>",
    ));
    assert_eq!(values(&sources, [&overlay.version, &overlay.base]), ["1", "b.xml"]);
    assert_eq!((overlay.enums.len(), overlay.enums[0].name.value.as_str()), (1, "E"));
    let refinement = &overlay.refinements[0];
    assert_eq!(values(&sources, [&refinement.bitmask, &refinement.deprecated]), ["true", "false"]);
    let note = &overlay.notes[0];
    assert_eq!(values(&sources, [&note.message, &note.field, &note.enum_, &note.entry]), ["M", "f", "E", "E_A"]);
    assert_eq!(note.text.as_ref().unwrap().value, "Text & text.");
    let bind = &overlay.messages[0].bindings[0];
    assert_eq!((bind.name.value.as_str(), bind.field.value.as_str(), bind.enum_.value.as_str()), ("b", "f", "F"));
    assert_eq!(values(&sources, [&bind.condition.field, &bind.condition.value]), ["g", "3"]);
    assert_eq!(values(&sources, [&bind.description]), ["Why."]);
}

#[test]
fn a_view_of_values() {
    let (view, sources) = view(concat!(
        "<view name='V' item='v' if='g' is='3'><value name='a' field='x' units='m' invalid='9'>A.</value>",
        "<value name='b' field='y'/></view>",
    ));
    assert!(view.words.is_none() && view.parts.is_empty() && view.keys.is_empty());
    assert_eq!(values(&sources, [&view.item, &view.condition.field, &view.condition.value]), ["v", "g", "3"]);
    let [first, second] = &view.values[..] else { panic!("{:?}", view.values) };
    assert_eq!(values(&sources, [&first.units, &first.invalid, &first.description]), ["m", "9", "A."]);
    assert_eq!((second.name.value.as_str(), second.field.value.as_str()), ("b", "y"));
}

#[test]
fn everything_of_a_view() {
    let (view, sources) = view(concat!(
        "<view name='V' words='a[i] b[i]' item='v' items='vs' count='n' partial='true' if='g' is='3'>",
        "<description>All.</description><key name='k' field='c[i]' units='ms' invalid='9'>Key.</key>",
        "<invalid field='c[i]' value='9'/><invalid value='0'/>",
        "<bits name='x' at='0' width='2' enum='E' signed='true' scale='1/2' bias='-3' ",
        "units='V' exact='mV' repeat='4' stride='5'>X.</bits>",
        "<switch field='d[i]'><case value='1..=2'><bits name='y' at='2' width='3'/></case>",
        "<default><reserved at='2' width='3'/></default></switch>",
        "<reserved at='5' width='1'>Zero.</reserved></view>",
    ));
    assert_eq!(view.name.value, "V");
    assert_eq!(values(&sources, [&view.words]), ["a[i] b[i]"]);
    let attributes =
        [&view.item, &view.items, &view.count, &view.partial, &view.condition.field, &view.condition.value];
    assert_eq!(values(&sources, attributes), ["v", "vs", "n", "true", "g", "3"]);
    assert_eq!(values(&sources, [&view.description]), ["All."]);
    let key = &view.keys[0];
    assert_eq!((key.name.value.as_str(), key.field.value.as_str()), ("k", "c[i]"));
    assert_eq!(values(&sources, [&key.units, &key.invalid, &key.description]), ["ms", "9", "Key."]);
    let invalids: Vec<_> = view.invalids.iter().map(|one| (one.field.is_some(), one.value.value.as_str())).collect();
    assert_eq!(invalids, [(true, "9"), (false, "0")]);

    let [Part::Piece(first), Part::Switch(switch), Part::Piece(Piece::Reserved(last))] = &view.parts[..] else {
        panic!("{:?}", view.parts)
    };
    let x = bits(first);
    assert_eq!((x.name.value.as_str(), x.at.value.as_str(), x.width.value.as_str()), ("x", "0", "2"));
    let attributes = [&x.enum_, &x.signed, &x.scale, &x.bias, &x.units, &x.exact, &x.repeat, &x.stride, &x.description];
    assert_eq!(values(&sources, attributes), ["E", "true", "1/2", "-3", "V", "mV", "4", "5", "X."]);
    assert_eq!((last.at.value.as_str(), last.width.value.as_str()), ("5", "1"));
    assert_eq!((values(&sources, [&switch.field]), switch.bits.is_none()), (["d[i]".to_owned()], true));
    let [case, default] = &switch.cases[..] else { panic!("{:?}", switch.cases) };
    assert_eq!(values(&sources, [&case.value]), ["1..=2"]);
    assert_eq!(bits(&case.pieces[0]).name.value, "y");
    assert!(default.value.is_none() && matches!(default.pieces[..], [Piece::Reserved(_)]));
}

#[test]
fn a_switch_inside_a_switch_is_left_out() {
    let (overlay, _, diagnostics) = attempt(concat!(
        "<message name='M'><view name='V' words='a'><switch bits='x'><case value='1'>",
        "<switch bits='y'><case><bits/></case></switch><bits name='z' at='0' width='1'/>",
        "</case></switch></view></message>",
    ));
    assert_eq!(diagnostics.iter().map(|problem| problem.code).collect::<Vec<_>>(), [Code::NestedSwitch]);
    let Part::Switch(switch) = &overlay.messages[0].views[0].parts[0] else { panic!("no switch") };
    assert_eq!(bits(&switch.cases[0].pieces[0]).name.value, "z");
}
