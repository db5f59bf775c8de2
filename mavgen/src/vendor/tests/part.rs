//! Copies of a part of a dialect: what is in them is what it is in the whole.

use std::collections::BTreeSet;

use super::same_model::shown;
use super::*;
use crate::diag::Diagnostics;
use crate::ir::Dialect;
use crate::read::load;
use crate::roots::resolve;
use crate::select::Selection;
use crate::source::Sources;
use crate::vendor::part::Part;
use crate::vendor::{originals, write};

fn resolved(builder: &Builder) -> Dialect {
    builder.resolve().unwrap_or_else(|failure| panic!("{failure}")).dialect
}

/// The copies of some messages of the dialect in `a.xml` of a folder.
fn cut(folder: &Path, messages: &[&str], prose: &Prose) -> Vendored {
    let builder = Builder::new(folder.join("a.xml")).messages(messages.iter().copied());
    vendor(&builder, prose).unwrap_or_else(|failure| panic!("{failure}"))
}

fn retained(vendored: &Vendored) -> Vec<(&str, &str)> {
    vendored.retained.iter().map(|one| (one.name.as_str(), one.why.as_str())).collect()
}

/// Holds copies of some messages against the whole: with the same selection both are the same; without one, the copies are the
/// selection and what was retained.
#[track_caller]
fn holds(xml: &Path, messages: &[&str], prose: &Prose) -> Vendored {
    let whole = || Builder::new(xml).messages(messages.iter().copied());
    let vendored = vendor(&whole(), prose).unwrap_or_else(|failure| panic!("{failure}"));
    let out = tempfile::tempdir().unwrap();
    write(out.path(), &vendored).unwrap();
    let copy = || Builder::new(out.path().join(xml.file_name().unwrap()));
    let words = *prose == Prose::Keep;
    let selected = copy().messages(messages.iter().copied());
    assert!(shown(resolved(&selected), words) == shown(resolved(&whole()), words), "{messages:?}");
    let also: Vec<&str> = vendored.retained.iter().filter_map(|one| one.name.strip_prefix("message ")).collect();
    let mut wanted = resolved(&whole().messages(also));
    let all = resolved(&copy());
    if vendored.retained.iter().all(|one| one.name.starts_with("message ")) {
        assert!(shown(all, words) == shown(wanted, words), "{messages:?}");
    } else {
        wanted.enums.clear();
        let names = |dialect: &Dialect| dialect.messages.iter().map(|one| one.name.text.clone()).collect::<Vec<_>>();
        assert_eq!(names(&all), names(&wanted));
    }
    vendored
}

fn xml() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../xml")
}

#[test]
fn parts_of_real_dialects_are_what_they_are_in_the_whole() {
    for (file, messages, prose) in [
        ("common.xml", &["HEARTBEAT", "PARAM_*"][..], Prose::Keep),
        ("common.xml", &["COMMAND_*", "MISSION_*"], Prose::Keep),
        ("common.xml", &["COMMAND_*", "MISSION_*"], Prose::From(xml())),
        ("autoquad.xml", &["AQ_*", "REQUEST_DATA_STREAM"], Prose::Drop),
        ("autoquad.xml", &["*"], Prose::Keep),
        ("autoquad.xml", &["*"], Prose::From(xml())),
    ] {
        let vendored = holds(&xml().join(file), messages, &prose);
        assert!(vendored.unplaced.is_empty());
        // Also of all messages some enums are left out: those that no message needs.
        assert_eq!(vendored.left_out.is_empty(), !matches!(prose, Prose::From(_)));
    }
}

/// Each message of the project's definitions alone: cut out of the text and of the facts, and read again.
#[test]
fn every_message_alone_is_what_it_is_in_the_whole() {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let loaded = load(&xml().join("autoquad.xml"), &[], &[], &mut sources, &mut diagnostics);
    let named = resolve(&loaded, &sources, &mut diagnostics).unwrap();
    let whole = &named.dialect;
    let mut originals = originals(&loaded, &sources).unwrap();
    let (mut retained, mut sizes) = (BTreeSet::new(), Vec::new());
    for (index, message) in whole.messages.iter().enumerate() {
        let name = &*message.name.text;
        let part = Part::of(&Selection::new([name]).unwrap(), &named, &loaded, &sources).unwrap();
        retained.extend(part.retained.iter().map(|one| one.name.clone()));
        let (words, folder) = (index % 2 == 0, tempfile::tempdir().unwrap());
        for (original, file) in originals.iter_mut().zip(&loaded.files) {
            original.leave_out(file, &part);
            let copy = if words { original.whole() } else { original.facts(None) };
            put(&folder.path().join(copy.name), &copy.text);
        }
        let copy = Builder::new(folder.path().join("autoquad.xml")).messages([name]);
        let (copied, mut expected) = (resolved(&copy), whole.clone());
        expected.cut(&Selection::new([name]).unwrap().kept(whole));
        sizes.push(copied.enums.len());
        assert!(shown(copied, words) == shown(expected, words), "{name}");
    }
    assert!(sizes.len() > 200 && sizes.iter().any(|size| *size > 40), "{sizes:?}");
    assert_eq!(retained.iter().collect::<Vec<_>>(), ["message AUTOPILOT_VERSION", "message GIMBAL_MANAGER_STATUS"]);
}

/// `STATE` is four bytes wide because of `WIDE`, which is in the file of the enum; `ALSO_WIDE` is not.
const WIDTHS: [(&str, &str); 2] = [
    (
        "a.xml",
        "<mavlink><include>b.xml</include><messages>\n\
         <message id='1' name='ASKS'><field type='uint8_t' name='s' enum='STATE'/></message>\n\
         <message id='2' name='ALSO_WIDE'><field type='uint64_t' name='s' enum='STATE'/></message>\n\
         </messages></mavlink>",
    ),
    (
        "b.xml",
        "<mavlink><enums><enum name='STATE'><entry value='0' name='STATE_A'/></enum>\n\
         <enum name='OF_WIDE'><entry value='0' name='OF_WIDE_A'/></enum></enums><messages>\n\
         <message id='3' name='NARROW'><field type='uint8_t' name='s' enum='STATE'/></message>\n\
         <message id='4' name='WIDE'><field type='uint32_t' name='s' enum='STATE'/>\
         <field type='uint8_t' name='o' enum='OF_WIDE'/></message>\n\
         <message id='5' name='AS_WIDE'><field type='uint32_t' name='s' enum='STATE'/></message>\n\
         </messages></mavlink>",
    ),
];

#[test]
fn a_message_stays_that_decides_how_wide_an_enum_is() {
    let folder = folder(&WIDTHS);
    let why = "without it, enum `STATE` would be another integer in Rust";
    for (messages, expected) in [
        (&["ASKS"][..], &[("message WIDE", why)][..]),
        (&["NARROW"], &[("message WIDE", why)]),
        (&["ASKS", "AS_WIDE"], &[]),
        (&["WIDE"], &[]),
    ] {
        for prose in [Prose::Keep, Prose::Drop] {
            assert_eq!(retained(&holds(&folder.path().join("a.xml"), messages, &prose)), expected);
        }
    }
}

/// Neither file includes the other, and the enum is that of the one whose message carries it.
#[test]
fn a_message_stays_that_decides_whose_an_enum_is() {
    let part = |bitmask: &str, messages: &str| {
        format!(
            "<mavlink><enums><enum name='E'{bitmask}><entry value='{}' name='E_{}'/></enum></enums>\
             <messages>{messages}</messages></mavlink>",
            bitmask.len(),
            messages.len()
        )
    };
    let folder = folder(&[
        (
            "a.xml",
            "<mavlink><include>b.xml</include><include>c.xml</include><messages>\
             <message id='1' name='ASKS'><field type='uint8_t' name='e' enum='E'/></message></messages></mavlink>",
        ),
        ("b.xml", &part("", "")),
        (
            "c.xml",
            &part(" bitmask='true'", "<message id='2' name='OWNS'><field type='uint8_t' name='e' enum='E'/></message>"),
        ),
    ]);
    let vendored = holds(&folder.path().join("a.xml"), &["ASKS"], &Prose::Keep);
    assert_eq!(retained(&vendored), [("message OWNS", "without it, enum `E` would be another integer in Rust")]);
}

#[test]
fn what_is_called_alike_stays_called_otherwise() {
    let enums = "<enums><enum name='SPRAYER'><entry value='0' name='SPRAYER_A'/></enum>\
        <enum name='A'><entry value='0' name='A_A'/></enum></enums>";
    let text = format!(
        "<mavlink>{enums}<messages><message id='1' name='SPRAYER'><field type='uint8_t' name='x'/></message>\
         <message id='2' name='ASKS'><field type='uint8_t' name='e' enum='SPRAYER'/></message></messages></mavlink>"
    );
    let folder = folder(&[("a.xml", &text)]);
    let vendored = holds(&folder.path().join("a.xml"), &["ASKS"], &Prose::Drop);
    let names: Vec<&str> = vendored.retained.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names, ["message SPRAYER", "enum A"]);
    let out = written(&vendored, folder.path());
    let copied = Builder::new(out.join("a.xml")).resolve().unwrap();
    assert_eq!((&*copied.names.dialect, &*copied.names.enums[0].ty), ("ADialect", "SprayerEnum"));
}

#[test]
fn an_enum_stays_that_a_sentinel_names() {
    let folder = folder(&[(
        "a.xml",
        "<mavlink><enums><enum name='LANDED'><entry value='7' name='LANDED_UNKNOWN'/></enum></enums><messages>\
         <message id='1' name='ASKS'><field type='uint8_t[2]' name='x' invalid='[LANDED_UNKNOWN:]'/></message>\
         <message id='2' name='B'><field type='uint8_t' name='x'/></message></messages></mavlink>",
    )]);
    let vendored = holds(&folder.path().join("a.xml"), &["ASKS"], &Prose::Keep);
    assert_eq!(retained(&vendored), [("enum LANDED", "`invalid` of `ASKS.x` is an entry of it")]);
}

/// The model has no enum there, but the XML has to.
#[test]
fn an_enum_stays_that_is_named_where_it_has_no_say() {
    let folder = folder(&[(
        "a.xml",
        "<mavlink><enums><enum name='GROUP'><entry value='7' name='GROUP_ALL'/></enum>\
         <enum name='MAV_CMD'><entry value='1' name='MAV_CMD_GO'><param index='1' reserved='true' enum='WAY'/></entry></enum>\
         <enum name='WAY'><entry value='1' name='WAY_UP'/></enum></enums><messages>\
         <message id='1' name='ASKS'><field type='float' name='x' enum='GROUP'/></message>\
         <message id='2' name='GOES'><field type='uint16_t' name='x' enum='MAV_CMD'/></message></messages></mavlink>",
    )]);
    let xml = folder.path().join("a.xml");
    assert_eq!(retained(&holds(&xml, &["ASKS"], &Prose::Keep)), [("enum GROUP", "`ASKS.x` names it")]);
    let goes = holds(&xml, &["GOES"], &Prose::Keep);
    assert!(goes.files[0].text.contains("WAY_UP"), "{}", goes.files[0].text);
}

/// A message that stands before `<version>` does not see it, whatever stood before it.
#[test]
fn a_version_is_seen_by_the_same_messages() {
    let of_version = |id: u8, name: &str| {
        format!("<message id='{id}' name='{name}'><field type='uint8_t_mavlink_version' name='v'/></message>")
    };
    let (first, second) = (of_version(1, "A1") + &of_version(2, "A2"), of_version(3, "A3"));
    let text =
        format!("<mavlink><messages>{first}</messages><version>9</version><messages>{second}</messages></mavlink>");
    let folder = folder(&[("a.xml", &text)]);
    for message in ["A1", "A2", "A3"] {
        holds(&folder.path().join("a.xml"), &[message], &Prose::Keep);
    }
}

const TIDY: &str = "<?xml version=\"1.0\"?>\r\n<mavlink>\r\n  <include>parts/b.xml</include>\r\n  <enums>\r\n\
    \x20   <!-- of the first -->\r\n    <enum name=\"ONE\">\r\n      <entry value=\"1\" name=\"ONE_A\"/>\r\n    </enum>\r\n\
    \x20   <enum name=\"TWO\"> <entry value=\"1\" name=\"TWO_A\"/></enum> <!-- of the second -->\r\n  </enums>\r\n\r\n\
    \x20 <messages>\r\n    <!-- a group -->\r\n\r\n    <message id=\"1\" name=\"A&#95;1\">\r\n\
    \x20     <description>What  it is.</description>\r\n      <field name='x' type='uint8_t' enum='ONE'/>\r\n    </message>\r\n\
    \x20   <message id=\"2\" name=\"A2\"><field name='x' type='uint8_t'/></message>\r\n  </messages>\r\n</mavlink>\r\n";

#[test]
fn what_stays_is_the_text_byte_for_byte() {
    let folder = folder(&[("a.xml", TIDY), ("parts/b.xml", "<mavlink><messages/></mavlink>")]);
    let vendored = cut(folder.path(), &["A_1"], &Prose::Keep);
    let (head, below) = text(&vendored, "a.xml").split_once(" -->\r\n").unwrap();
    let share = "a part, 1 of its 2 messages and 1 of its 2 enums: unchanged below but for its includes;";
    assert!(head.starts_with("<?xml version=\"1.0\"?>\r\n<!-- Vendored") && head.contains(share), "{head}");
    let expected = TIDY
        .replace("<?xml version=\"1.0\"?>\r\n", "")
        .replace("parts/", "")
        .replace("    <enum name=\"TWO\"> <entry value=\"1\" name=\"TWO_A\"/></enum> <!-- of the second -->\r\n", "")
        .replace("    <message id=\"2\" name=\"A2\"><field name='x' type='uint8_t'/></message>\r\n", "");
    assert_eq!(below, expected);
    let included = text(&vendored, "b.xml");
    assert!(included.contains(": unchanged below;"), "nothing is left out of it: {included}");
}

/// The order of the elements is free.
#[test]
fn includes_may_stand_behind_what_goes() {
    let text = "<mavlink>\n<messages>\n<message id='1' name='GOES'><field type='uint8_t' name='x'/></message>\n\
        <message id='2' name='STAYS'><field type='uint8_t' name='x'/></message>\n</messages>\n<enums>\n\
        <enum name='GOES'><entry value='0' name='GOES_A'/></enum>\n</enums>\n<include>parts/b.xml</include>\n</mavlink>\n";
    let folder = folder(&[("a.xml", text), ("parts/b.xml", "<mavlink><messages/></mavlink>")]);
    let vendored = cut(folder.path(), &["STAYS"], &Prose::Keep);
    let expected = "<mavlink>\n<messages>\n<message id='2' name='STAYS'><field type='uint8_t' name='x'/></message>\n\
        </messages>\n<enums>\n</enums>\n<include>b.xml</include>\n</mavlink>\n";
    assert_eq!(below_header(super::text(&vendored, "a.xml")), expected);
}

#[test]
fn facts_of_a_part() {
    let folder = folder(&[("a.xml", TIDY), ("parts/b.xml", "<mavlink><messages/></mavlink>")]);
    let vendored = cut(folder.path(), &["A2"], &Prose::Drop);
    let a = text(&vendored, "a.xml");
    assert!(
        a.contains("a part, 1 of its 2 messages and 0 of its 2 enums: its facts, without its descriptions;"),
        "{a}"
    );
    assert!(!a.contains("ONE") && !a.contains("A&#95;1") && a.contains("A2"), "{a}");
    assert_eq!(
        vendored.files[0].items.iter().map(|item| &*item.name).collect::<Vec<_>>(),
        ["message A2", "message A2 field x"]
    );
}

#[test]
fn words_about_what_is_left_out_are_told_from_those_without_a_home() {
    let gone = "<field name='gone' type='uint8_t'>Lost.</field>";
    let folder = folder(&[
        ("a.xml", TIDY),
        ("parts/b.xml", "<mavlink><messages/></mavlink>"),
        ("words/a.xml", &TIDY.replace("</description>", &format!("</description>{gone}"))),
    ]);
    let prose = Prose::From(folder.path().join("words"));
    let names = |list: &[super::super::Unplaced]| list.iter().map(|one| one.name.clone()).collect::<Vec<_>>();
    let vendored = cut(folder.path(), &["A_1"], &prose);
    assert_eq!(names(&vendored.unplaced), ["message A&#95;1 field gone"]);
    assert!(text(&vendored, "a.xml").contains("<description>What  it is.</description>"));
    let vendored = cut(folder.path(), &["A2"], &prose);
    assert_eq!(
        names(&vendored.left_out),
        ["enum ONE", "message A&#95;1", "message A&#95;1 description", "message A&#95;1 field gone"]
    );
}

#[test]
fn a_wrong_selection_copies_nothing() {
    let folder = folder(&WIDTHS);
    for (messages, said) in [
        (&["ASK", "NONE_*"][..], "no message of a.xml is called `ASK` (did you mean `ASKS`?), `NONE_*`"),
        (&[], "the list of messages is empty"),
    ] {
        let builder = Builder::new(folder.path().join("a.xml")).messages(messages.iter().copied());
        let failure = vendor(&builder, &Prose::Keep).unwrap_err().to_string();
        assert!(failure.starts_with(said), "{failure}");
    }
}
