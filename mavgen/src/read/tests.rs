//! What XML allows is understood; the rest is refused with a place. How refusals look is recorded in `tests/ui`.

use super::read;
use crate::diag::{Code, Diagnostics};
use crate::source::Sources;
use crate::syntax::{File, Stage, Text};

/// Reads a text of which nothing is reported.
fn understood(text: &str) -> (File, Sources) {
    let (file, sources, diagnostics) = attempt(text);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    (file, sources)
}

fn attempt(text: &str) -> (File, Sources, Diagnostics) {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let id = sources.add("a.xml", text);
    let file = read(id, &sources, &mut diagnostics);
    (file, sources, diagnostics)
}

/// A dialect with one message, which has these children.
fn with_message(children: &str) -> String {
    format!("<mavlink><messages><message id='1' name='A'>{children}</message></messages></mavlink>")
}

/// The description of a message, spelled like this in the XML.
fn description(spelled: &str) -> Option<String> {
    let text = with_message(&format!("<description>{spelled}</description>"));
    understood(&text).0.messages[0].description.as_ref().map(|text| text.value.clone())
}

/// What the source has where a text was written.
fn spelling<'s>(sources: &'s Sources, text: &Text) -> &'s str {
    &sources.get(text.span.file).unwrap().text()[text.span.range()]
}

#[test]
fn everything_of_a_message() {
    let (file, sources) = understood(concat!(
        "<mavlink><messages><message name='A'\n\tid = \"7\" >",
        "<deprecated since='2020-01' replaced_by='' remove_on_date='x'>Why.<description>x</description></deprecated>",
        "<description>What.</description>",
        "<field name='f' type='uint8_t[4]' enum='E' display='bitmask' units='m' print_format='%d' default='0' ",
        "minValue='1' maxValue='2' increment='3' multiplier='4' invalid='5' instance='true'>F<description>x</description>G</field>",
        "<extensions/><field type='float' name='g'/>",
        "</message></messages></mavlink>",
    ));
    let message = &file.messages[0];
    assert_eq!((message.name.value.as_str(), message.id.value.as_str()), ("A", "7"));
    assert_eq!((spelling(&sources, &message.name), spelling(&sources, &message.id)), ("A", "7"));
    let lifecycle = message.lifecycle.as_ref().unwrap();
    assert_eq!(lifecycle.stage, Stage::Deprecated);
    assert_eq!(lifecycle.since.as_ref().unwrap().value, "2020-01");
    assert_eq!(lifecycle.replaced_by.as_ref().unwrap().value, "");
    assert_eq!(lifecycle.description.as_ref().unwrap().value, "Why.");
    assert_eq!(message.description.as_ref().unwrap().value, "What.");
    assert_eq!(message.extensions.iter().map(|at| at.value).collect::<Vec<_>>(), [1]);

    let [f, g] = &message.fields[..] else { panic!("two fields") };
    let optional = [
        &f.enum_,
        &f.display,
        &f.units,
        &f.print_format,
        &f.default,
        &f.min,
        &f.max,
        &f.increment,
        &f.multiplier,
        &f.invalid,
        &f.instance,
        &f.description,
    ];
    let values = optional.map(|text| text.as_ref().unwrap().value.as_str());
    assert_eq!(values, ["E", "bitmask", "m", "%d", "0", "1", "2", "3", "4", "5", "true", "FG"]);
    assert_eq!((spelling(&sources, &f.ty), spelling(&sources, &f.name)), ("uint8_t[4]", "f"));
    assert_eq!(spelling(&sources, f.description.as_ref().unwrap()), "F<description>x</description>G");
    assert!(g.description.is_none() && g.units.is_none());
    let tag = &sources.get(g.span.file).unwrap().text()[g.span.range()];
    assert_eq!(tag, "<field type='float' name='g'/>");
}

#[test]
fn everything_of_an_enum() {
    let (file, _) = understood(concat!(
        "<mavlink><enums><enum bitmask='true' name='E'><wip since='2024-01'/><description>D</description>",
        "<entry name='E_A'><superseded since='2018-04' replaced_by='X'>S</superseded></entry>",
        "<entry value='2' name='E_B' hasLocation='true' isDestination='false' missionOnly='1' command='true'>",
        "<param index='1' label='L' units='s' enum='E' increment='1' minValue='2' maxValue='3' reserved='true' ",
        "default='NaN' multiplier='1E-2'>P</param><param index='2'/></entry>",
        "</enum></enums><enums/><enums><enum name='F'></enum></enums></mavlink>",
    ));
    let [e, f] = &file.enums[..] else { panic!("two enums") };
    assert_eq!((e.name.value.as_str(), e.bitmask.as_ref().unwrap().value.as_str()), ("E", "true"));
    assert_eq!(e.lifecycle.as_ref().unwrap().stage, Stage::Wip);
    assert_eq!((f.name.value.as_str(), f.entries.len()), ("F", 0));
    let [a, b] = &e.entries[..] else { panic!("two entries") };
    assert!(a.value.is_none());
    assert_eq!(a.lifecycle.as_ref().unwrap().stage, Stage::Superseded);
    let flags = [&b.value, &b.has_location, &b.is_destination, &b.mission_only];
    assert_eq!(flags.map(|text| text.as_ref().unwrap().value.as_str()), ["2", "true", "false", "1"]);
    let p = &b.params[0];
    let optional =
        [&p.label, &p.units, &p.enum_, &p.increment, &p.min, &p.max, &p.reserved, &p.default, &p.description];
    let values = optional.map(|text| text.as_ref().unwrap().value.as_str());
    assert_eq!(values, ["L", "s", "E", "1", "2", "3", "true", "NaN", "P"]);
    assert_eq!((p.index.value.as_str(), b.params[1].index.value.as_str()), ("1", "2"));
}

#[test]
fn everything_of_a_file() {
    let (file, sources) = understood(concat!(
        "\u{feff}<?xml version='1.0' encoding='ISO-8859-1'?><?hint?><!-- - --><mavlink file='x' xmlns='y' xsi:z='w'>",
        "<include> a&#46;xml\n</include><messages><message id='1' name='A'/></messages>",
        "<version> 3 </version><dialect>4</dialect><include>b.xml</include><messages></messages></mavlink>\n<!-- end -->\n",
    ));
    let includes: Vec<_> = file.includes.iter().map(|path| path.value.as_str()).collect();
    assert_eq!(includes, ["a.xml", "b.xml"]);
    assert_eq!(spelling(&sources, &file.includes[0]), "a&#46;xml");
    let version = file.version.unwrap();
    assert_eq!((version.text.value.as_str(), version.messages_before), ("3", 1));
    assert_eq!(spelling(&sources, &version.text), "3");
    assert_eq!(file.dialect.unwrap().value, "4");
}

#[test]
fn character_data_is_joined() {
    for (spelled, expected) in [
        ("", None),
        (" a ", Some(" a ")),
        ("a &amp; b", Some("a & b")),
        ("&lt;&gt;&quot;&apos;&#176;&#xB0;", Some("<>\"'°°")),
        ("a<!-- b -->c", Some("ac")),
        ("a<?b c?>d", Some("ad")),
        ("<![CDATA[<a> & ]]]]><![CDATA[>b]]>", Some("<a> & ]]>b")),
        ("a\r\nb\rc\nd", Some("a\nb\nc\nd")),
        ("&amp;lt;", Some("&lt;")),
    ] {
        assert_eq!(description(spelled).as_deref(), expected, "{spelled}");
    }
}

#[test]
fn attribute_values_are_normalised() {
    let text = with_message("<field type='float' name='f' units='a&amp;b\r\nc\td&#10;e'/>");
    let (file, sources) = understood(&text);
    let units = file.messages[0].fields[0].units.as_ref().unwrap();
    assert_eq!(units.value, "a&b c d\ne");
    assert_eq!(spelling(&sources, units), "a&amp;b\r\nc\td&#10;e");
}

#[test]
fn the_rest_of_a_file_is_read_after_a_bad_element() {
    let (file, _, diagnostics) = attempt(concat!(
        "<mavlink><messages><message id='1'><field/></message><message id='2' name='B'><field type='x'/>",
        "<field type='float' name='g'/></message></messages></mavlink>",
    ));
    assert!(diagnostics.iter().all(|diagnostic| diagnostic.code == Code::MissingAttribute));
    assert_eq!(diagnostics.len(), 3);
    let names: Vec<_> = file.messages.iter().map(|message| message.name.value.as_str()).collect();
    assert_eq!((names, file.messages[0].fields.len()), (vec!["B"], 1));
}

#[test]
fn what_stands_before_a_fault_is_read() {
    let (file, _, diagnostics) =
        attempt("<mavlink><messages><message id='1' name='A'/><message id='2' name='B'></mesage></messages></mavlink>");
    assert_eq!(diagnostics.iter().map(|diagnostic| diagnostic.code).collect::<Vec<_>>(), [Code::NotWellFormed]);
    assert_eq!(file.messages.len(), 1);
}

#[test]
fn what_other_namespaces_and_the_schema_have_is_ignored_silently() {
    understood(&with_message("<field type='float' name='f' xml:lang='en' a:b='c' xmlns:a='d'/><wip/>"));
}

#[test]
fn a_tag_has_a_reasonable_number_of_attributes() {
    let many: String = (0..100).map(|number| format!(" a{number}=''")).collect();
    let (_, _, diagnostics) = attempt(&format!("<mavlink{many}/>"));
    assert_eq!(diagnostics.iter().map(|diagnostic| diagnostic.code).collect::<Vec<_>>(), [Code::TooLarge]);
}

/// A dialect with one of everything that XML has.
const SAMPLE: &str = concat!(
    "<?xml version=\"1.0\"?>\n<!-- c -->\n<mavlink><include>a.xml</include><version>3</version><enums>\n",
    "<enum name='E'><entry value=\"1\" name='E_A'><param index='1'>a &amp; b</param></entry></enum></enums>\n",
    "<messages><message id='1' name=\"A\"><description><![CDATA[°]]>&#176;</description>\n",
    "<field type='float' name='f'>x</field><extensions/></message></messages></mavlink>",
);

#[test]
fn a_truncated_file_is_an_error() {
    understood(SAMPLE);
    for (end, _) in SAMPLE.char_indices() {
        let (_, sources, diagnostics) = attempt(&SAMPLE[..end]);
        assert!(diagnostics.has_errors(), "cut at {end}");
        assert_places(&sources, &diagnostics);
    }
}

#[test]
fn no_single_change_goes_wrong_unseen_or_breaks_the_reader() {
    for (at, was) in SAMPLE.char_indices() {
        for put in ["", "<", ">", "&", "\"", "'", "/", "=", "!", "?", "-", "]", " ", "\0", "é", "\u{feff}"] {
            let text = format!("{}{put}{}", &SAMPLE[..at], &SAMPLE[at + was.len_utf8()..]);
            let (_, sources, diagnostics) = attempt(&text);
            assert_places(&sources, &diagnostics);
            if was == '<' && put != "<" && put != "&" {
                assert!(!diagnostics.is_empty(), "`{put}` for `<` at {at}");
            }
        }
    }
}

/// Every problem has a place in the text, and can be drawn.
fn assert_places(sources: &Sources, diagnostics: &Diagnostics) {
    for diagnostic in diagnostics.iter() {
        let spans = diagnostic.span.into_iter().chain(diagnostic.related.iter().map(|r| r.span));
        for span in spans {
            let text = sources.get(span.file).unwrap().text();
            assert!(text.get(span.range()).is_some(), "{diagnostic:?}");
        }
        assert!(diagnostic.span.is_some());
        let drawn = crate::diag::render(diagnostic, sources, crate::diag::Style::Plain);
        assert!(drawn.contains("--> a.xml:"), "{drawn}");
    }
}
