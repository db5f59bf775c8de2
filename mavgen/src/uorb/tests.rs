//! Facts of messages against what PX4's own generator says of them, and odd files.

use std::path::{Path, PathBuf};
use std::{env, fs};

use super::model::{Message, Package};
use super::{load, log_format, topic_name};
use crate::diag::{Code, Diagnostics, Severity};
use crate::ir::{Invalid, Repr, Scope, Sentinel};
use crate::source::Sources;

fn package(files: &[(&str, &str)]) -> (Package, Vec<Code>) {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(format!("{name}.msg")), text).unwrap();
    }
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let package = load(folder.path(), &[], |_| true, &mut sources, &mut diagnostics);
    (package, diagnostics.iter().map(|problem| problem.code).collect())
}

/// The codes of a file with a timestamp and these lines.
fn problems(lines: &str) -> Vec<Code> {
    package(&[("A", &format!("uint64 timestamp\n{lines}\n"))]).1
}

/// The codes of so many messages, each of which nests the next; the outermost is the first or the last that is read.
fn chain(length: usize, outermost_first: bool) -> Vec<Code> {
    let name = |at: usize| format!("N{:05}", if outermost_first { at } else { length - at });
    let text = |at: usize| match at + 1 < length {
        true => format!("uint64 timestamp\n{} inner\n", name(at + 1)),
        false => "uint64 timestamp\n".to_owned(),
    };
    let files: Vec<_> = (0..length).map(|at| (name(at), text(at))).collect();
    package(&files.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect::<Vec<_>>()).1
}

#[test]
fn messages_are_nested_as_deep_as_a_compiler_takes() {
    for outermost_first in [true, false] {
        assert_eq!(chain(32, outermost_first), [], "{outermost_first}");
        for too_many in [33, 1000] {
            assert_eq!(chain(too_many, outermost_first).first(), Some(&Code::UorbNested), "{outermost_first}");
        }
    }
}

#[test]
fn what_px4_refuses_or_takes_by_accident_is_an_error() {
    for (line, code) in [
        ("uint8", Code::UorbLine),
        ("uint8 a b", Code::UorbLine),
        ("uint8 a 5", Code::UorbLine),
        ("uint8\ta", Code::UorbLine),
        ("uint8 fooBar", Code::UorbName),
        ("uint8 1st", Code::UorbName),
        ("uint8 a-b", Code::UorbName),
        ("uint8 größe", Code::UorbName),
        ("uint9 a", Code::UorbType),
        ("string a", Code::UorbType),
        ("byte a", Code::UorbType),
        ("Other a", Code::UorbType),
        ("uint8[] a", Code::UorbArray),
        ("uint8[<=4] a", Code::UorbArray),
        ("uint8[0] a", Code::UorbArray),
        ("uint8[-1] a", Code::UorbArray),
        ("uint8[70000] a", Code::UorbArray),
        ("uint8[3 a", Code::UorbArray),
        ("uint8 A = ", Code::UorbConstant),
        ("uint8 A = 256", Code::UorbConstant),
        ("uint8 A = -1", Code::UorbConstant),
        ("uint8 A = 0x10", Code::UorbConstant),
        ("uint8 A = 1.5", Code::UorbConstant),
        ("uint8 A = 010", Code::UorbConstant),
        ("float32 A = 1", Code::UorbConstant),
        ("bool A = 1", Code::UorbConstant),
        ("uint8[2] A = 1", Code::UorbConstant),
        ("A a", Code::UorbNested),
        ("uint8 a\nuint8 a", Code::UorbDuplicate),
        ("uint8 A = 1\nuint8 A = 1", Code::UorbDuplicate),
        ("uint8 a\nuint8 a = 1", Code::UorbDuplicate),
        ("uint8 a # [@enum A]", Code::UorbEnum),
        ("uint8 a # [@unit m]", Code::UorbGroup),
    ] {
        assert_eq!(problems(line), [code], "{line}");
    }
    assert_eq!(package(&[("A", "uint8 a")]).1, [Code::UorbTimestamp]);
    assert_eq!(package(&[("A", "uint32 timestamp")]).1, [Code::UorbTimestamp]);
    assert_eq!(package(&[("A", "\u{feff}uint64 timestamp")]).1, [Code::UorbEncoding]);
}

#[test]
fn what_both_readers_of_px4_take_is_taken() {
    for line in [
        "  uint8 a",
        "uint8 a\r",
        "uint8 a#x",
        "uint8 a__b",
        "uint8 type",
        "uint8[1] a",
        "uint8 A=1",
        "int8   A  =  -128",
    ] {
        assert_eq!(problems(line), [], "{line:?}");
    }
}

#[test]
fn a_mistake_in_a_nested_message_is_told_in_both() {
    let (package, codes) = package(&[("A", "uint64 timestamp\nB b\n"), ("B", "uint64 timestamp\nuint8 X\n")]);
    assert!(package.messages.is_empty());
    assert_eq!(codes, [Code::UorbNested, Code::UorbName]);
    let (_, codes) = self::package(&[("A", "uint64 timestamp\nB b\n"), ("B", "uint64 timestamp\nA a\n")]);
    assert!(codes.iter().all(|code| *code == Code::UorbNested), "{codes:?}");
}

#[test]
fn comments_belong_to_what_follows_or_stands_before_them() {
    let text = "# What it is.\n# More.\n\n# TOPICS a a_groundtruth\nuint64 timestamp # [us] when\n# [m]\n# Where.\nfloat32 x # [@invalid NaN] far\n\n# Alone.\n\nuint8 y\n";
    let (package, codes) = package(&[("A", text)]);
    let message = &package.messages[0];
    assert_eq!(
        (&message.about[..], &message.topics[..], codes),
        (&["What it is.".into(), "More.".into()][..], &["a".into(), "a_groundtruth".into()][..], vec![])
    );
    let docs: Vec<_> = message.fields.iter().map(|field| &field.docs).collect();
    assert_eq!((docs[0].units.as_deref(), &docs[0].lines[..]), (Some("us"), &["when".to_owned()][..]));
    assert_eq!((docs[1].units.as_deref(), docs[1].invalid.as_deref()), (Some("m"), Some("NaN")));
    assert_eq!(docs[1].lines, ["", "Where.", "far"]);
    assert!(docs[2].lines.is_empty());
}

#[test]
fn names_and_patterns_mean_messages_of_the_folder() {
    let folder = tempfile::tempdir().unwrap();
    let versioned = folder.path().join("versioned");
    fs::create_dir(&versioned).unwrap();
    for file in ["EscReport.msg", "EscStatus.msg", "notes.txt", "versioned/VehicleStatus.msg"] {
        fs::write(folder.path().join(file), "uint64 timestamp\n").unwrap();
    }
    let selected = |path: &Path, names: &[&str]| {
        super::selected(path, &names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>())
    };
    let all = ["EscReport", "EscStatus", "VehicleStatus"];
    assert_eq!(selected(folder.path(), &[]).unwrap(), all);
    assert_eq!(selected(folder.path(), &["*Status"]).unwrap(), all[1..]);
    assert_eq!(selected(&versioned, &[]).unwrap(), all[2..]);
    assert_eq!(selected(&folder.path().join("EscReport.msg"), &[]).unwrap(), all[..1]);
    let wrong = selected(folder.path(), &["EscStats", "Esc*"]).unwrap_err();
    assert!(wrong.ends_with("is called `EscStats` (did you mean `EscStatus`?)"), "{wrong}");
    assert!(selected(folder.path(), &[""]).is_err());
    assert!(selected(Path::new("no such folder"), &[]).is_err());
}

/// In PX4's own tree, messages that have versions nest those in the folder above.
#[test]
fn what_is_nested_stands_beside_or_above() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("versioned")).unwrap();
    fs::write(folder.path().join("A.msg"), "uint64 timestamp\nB b\n").unwrap();
    fs::write(folder.path().join("C.msg"), "uint64 timestamp\n").unwrap();
    fs::write(folder.path().join("versioned/B.msg"), "uint64 timestamp\nC c\n").unwrap();
    for (path, names) in [("", &["C", "B", "A"][..]), ("versioned", &["C", "B"]), ("versioned/B.msg", &["C", "B"])] {
        let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
        let package = load(&folder.path().join(path), &[], |_| true, &mut sources, &mut diagnostics);
        assert!(diagnostics.is_empty(), "{diagnostics:?}");
        let mut found: Vec<_> = package.messages.iter().map(|message| message.name.as_str()).collect();
        found.sort_by_key(|name| names.iter().position(|known| known == name));
        assert_eq!(found, names, "{path}");
    }
}

#[test]
fn a_file_is_called_as_its_message() {
    for name in ["esc_status", "Esc-Status", "Esc.Status", "1Esc", "Üsc"] {
        assert_eq!(package(&[(name, "uint64 timestamp\n")]).1, [Code::UorbName], "{name}");
    }
}

/// An enum: its name, whether it is flags, and its entries.
type EnumFacts<'p> = (&'p str, bool, Vec<(&'p str, i128)>);

/// The enum of a field.
fn enum_of(package: &Package, field: usize) -> Option<EnumFacts<'_>> {
    let enum_ = package.enum_(package.messages[0].fields[field].enum_?).unwrap();
    let entries = enum_.entries.iter().map(|entry| (entry.label.as_str(), entry.value));
    Some((&enum_.name.text, enum_.flags, entries.collect()))
}

#[test]
fn brackets_make_enums_of_constants() {
    let (package, codes) = package(&[(
        "BatteryStatus",
        "uint64 timestamp\nint8 warning # [@enum WARNING STATE] [@invalid -1]\nint8[4] each # [@enum WARNING STATE]\nuint16 rest\n\
         int8 WARNING_LOW = -1\nint8 WARNING_3S = 1\nint8 STATE_LOW = 4\nuint8 STATE_OFF = 1\nuint8 MAX = 9\n",
    )]);
    assert_eq!(codes, []);
    let entries = vec![("WARNING_LOW", -1), ("WARNING_3S", 1), ("STATE_LOW", 4), ("OFF", 1)];
    let expected = Some(("BatteryStatusWarning", false, entries));
    assert_eq!((enum_of(&package, 1), enum_of(&package, 2), enum_of(&package, 3)), (expected.clone(), expected, None));
    let message = &package.messages[0];
    assert_eq!((package.enums.len(), package.enums[0].repr, package.enums[0].message.0), (1, Repr::I8, 0));
    assert_eq!(message.constants.iter().map(|one| one.name.as_str()).collect::<Vec<_>>(), ["MAX"]);
    assert_eq!(message.fields[1].invalid.map(|invalid| invalid.sentinel), Some(Sentinel::Integer(-1)));
}

#[test]
fn prose_says_which_elements_tell_that_an_array_is_unknown() {
    let lines = "float32[3] a # [@invalid NaN First value if unknown]\nfloat32[3] b # [@invalid NaN]\n\
                 uint8[3] c # [@invalid 0 All bytes]\nchar[3] d # [@invalid empty if not there]\n";
    let (package, codes) = package(&[("A", &format!("uint64 timestamp\n{lines}"))]);
    assert_eq!(codes, []);
    let said: Vec<_> = package.messages[0].fields.iter().skip(1).map(|field| field.invalid).collect();
    let expected = [(Scope::Whole, Sentinel::NotANumber), (Scope::Each, Sentinel::NotANumber)];
    assert_eq!(said[..2], expected.map(|(scope, sentinel)| Some(Invalid { scope, sentinel })));
    assert_eq!(said[2..], [None, Some(Invalid { scope: Scope::Whole, sentinel: Sentinel::Integer(0) })]);
}

#[test]
fn an_overlay_says_what_files_cannot() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    write(
        "A.msg",
        "uint64 timestamp\nuint16 failures # [@enum FAILURE]\nuint8 mode\nfloat32 speed # [m/s]\n\
         uint8 FAILURE_RPM = 3\nuint8 FAILURE_HEAT = 9\nuint8 FAILURE_COUNT = 10\nuint8 MODE_A = 1\nuint8 OFF = 0\n",
    );
    let base = folder.path().file_name().unwrap().to_str().unwrap().to_owned();
    let fields = "<field name='failures' flags='Failures' bits='FAILURE_*' except='FAILURE_COUNT'/>\
                  <field name='mode' enum='Mode' constants='MODE_* OFF' invalid='OFF'/>\
                  <field name='speed' units='km/h' invalid='NaN' was='velocity'/>";
    let overlay = |base: &str| {
        format!("<uorb-overlay version='1' for='{base}'><message name='A'>{fields}</message></uorb-overlay>")
    };
    write("own.xml", &overlay(&base));
    write("other.xml", &overlay("v1_14"));
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let paths = ["own.xml", "other.xml"].map(|name| folder.path().join(name));
    let folders = [folder.path(), Path::new("v1_14")];
    let overlays = super::overlays(&paths, &folders, &mut sources, &mut diagnostics);
    let package = load(folder.path(), &overlays, |_| true, &mut sources, &mut diagnostics);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    assert_eq!(enum_of(&package, 1), Some(("Failures", true, vec![("RPM", 8), ("HEAT", 512)])));
    assert_eq!(enum_of(&package, 2), Some(("Mode", false, vec![("A", 1), ("OFF", 0)])));
    let [_, _, mode, speed] = &package.messages[0].fields[..] else { panic!() };
    assert_eq!(mode.invalid.map(|invalid| invalid.sentinel), Some(Sentinel::Integer(0)));
    assert_eq!(speed.invalid.map(|invalid| invalid.sentinel), Some(Sentinel::NotANumber));
    assert_eq!((speed.docs.units.as_deref(), speed.was.as_deref()), (Some("km/h"), Some("velocity")));
    assert_eq!(package.messages[0].constants[0].name, "FAILURE_COUNT");
}

#[test]
fn layouts_and_hashes_of_esc_status() {
    let report = "uint64 timestamp\nuint32 esc_errorcount\nint32 esc_rpm\nfloat32 esc_voltage\nfloat32 esc_current\nfloat32 esc_temperature\n\
                  int16 motor_temperature\nuint8 esc_state\nuint8 actuator_function\nuint16 failures\nint8 esc_power\n";
    let status = "uint64 timestamp\nuint16 counter\nuint8 esc_count\nuint8 esc_connectiontype\nuint16 esc_online_flags\n\
                  uint16 esc_armed_flags\nEscReport[12] esc\n";
    let (package, codes) = package(&[("EscReport", report), ("EscStatus", status)]);
    assert_eq!(codes, []);
    let status = &package.messages[1];
    assert_eq!((status.hash, status.cdr_len, status.struct_len), (0x4d8f_7be2, 491, 496));
    let places = status.fields.iter().map(|field| (field.cdr_offset, field.struct_offset));
    assert_eq!(places.collect::<Vec<_>>(), [(0, 0), (8, 8), (10, 14), (11, 15), (12, 10), (14, 12), (16, 16)]);
    assert_eq!(status.type_hash, "RIHS01_85dc04703b64002f2a39e5909078ae7b7301da32ef14a04329f4ca9e40e635a2");
    assert_eq!(
        log_format(status, &package),
        "uint64_t timestamp;uint16_t counter;uint16_t esc_online_flags;uint16_t esc_armed_flags;uint8_t esc_count;\
         uint8_t esc_connectiontype;esc_report[12] esc;"
    );
    assert_eq!(
        log_format(&package.messages[0], &package),
        "uint64_t timestamp;uint32_t esc_errorcount;int32_t esc_rpm;float esc_voltage;float esc_current;float esc_temperature;\
         int16_t motor_temperature;uint16_t failures;uint8_t esc_state;uint8_t actuator_function;int8_t esc_power;\
         uint8_t[5] _padding0;"
    );
}

/// Nested arrays multiply: a few lines could ask for more work than anybody has time for.
#[test]
fn a_message_has_an_end() {
    let nest = |number: usize, length: usize| format!("uint64 timestamp\nA{}[{length}] a\n", number - 1);
    let texts: Vec<(String, String)> = (0..9)
        .map(|number| {
            (format!("A{number}"), if number == 0 { "uint64 timestamp".to_owned() } else { nest(number, 90) })
        })
        .collect();
    let files: Vec<(&str, &str)> = texts.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    let (package, codes) = package(&files);
    assert_eq!(package.messages.iter().map(|message| message.struct_len).collect::<Vec<_>>(), [8, 728, 65528]);
    assert_eq!(codes[0], Code::UorbArray);
    assert!(codes[1..].iter().all(|code| *code == Code::UorbNested));
}

#[test]
fn names_of_topics() {
    for (message, topic) in
        [("Px4ioStatus", "px4io_status"), ("EstimatorAidSource1d", "estimator_aid_source1d"), ("ADSB", "a_d_s_b")]
    {
        assert_eq!(topic_name(message), topic);
    }
}

/// Messages against a table that PX4's generator made of seven releases. `UORB_TABLE` names it; `UORB_MESSAGES` names folders, the first
/// of them with all messages of `UORB_RELEASE`. Rows of other releases are compared where a folder has their message by their hash:
/// types and names are the same then, and so must be sizes and type hash.
#[test]
#[ignore = "needs PX4's messages"]
fn all_messages_of_a_release() {
    let [table, release] = ["UORB_TABLE", "UORB_RELEASE"].map(|name| env::var(name).unwrap());
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let folders = env::var_os("UORB_MESSAGES").unwrap();
    let mut load = |folder: PathBuf| load(&folder, &[], |_| true, &mut sources, &mut diagnostics);
    let packages: Vec<_> = env::split_paths(&folders).map(&mut load).collect();
    let errors: Vec<_> = diagnostics.iter().filter(|problem| problem.severity() == Severity::Error).collect();
    assert!(errors.is_empty(), "{errors:?}");
    let (mut rows, mut compared, mut of_release) = (0, 0, 0);
    for row in fs::read_to_string(table).unwrap().lines().skip(1) {
        let [of, name, hash, length, unpadded, cdr, type_hash, topics] = row.split('\t').collect::<Vec<_>>()[..] else {
            panic!("{row}")
        };
        rows += 1;
        let own = packages.first().filter(|_| of == release).and_then(|package| named(package, name));
        assert_eq!(own.is_some(), of == release, "{name}");
        let by_hash = || packages.iter().filter_map(|package| named(package, name)).find(|one| of_hash(one) == hash);
        let Some(message) = own.or_else(by_hash) else { continue };
        let lengths = [message.struct_len, message.struct_len - message.struct_padding, message.cdr_len];
        assert_eq!(of_hash(message), hash, "{name} of {of}");
        assert_eq!(lengths.map(|length| length.to_string()), [length, unpadded, cdr], "{name} of {of}");
        assert_eq!(message.type_hash, format!("RIHS01_{type_hash}"), "{name} of {of}");
        compared += 1;
        if own.is_some() {
            assert_eq!(message.topics, topics.split(',').collect::<Vec<_>>(), "{name}");
            of_release += 1;
        }
    }
    assert_eq!(of_release, packages[0].messages.len());
    println!("{compared} of {rows} rows; the others are of messages that changed, whose files are not there");
}

fn named<'p>(package: &'p Package, name: &str) -> Option<&'p Message> {
    package.messages.iter().find(|message| message.name == name)
}

fn of_hash(message: &Message) -> String {
    format!("{:08x}", message.hash)
}
