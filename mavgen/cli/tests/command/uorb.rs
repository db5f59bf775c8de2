//! uORB messages: a folder of `.msg` files in place of a dialect.

use std::fs;

use serde_json::Value;

use crate::{mavgen, stderr, stdout};

const STATUS: &str = "# What the pump does.

uint64 timestamp # [us] when
uint8 state # [@enum STATE]
uint16 failures
float32 level # [m] [@invalid NaN]
Valve[2] valve

uint8 STATE_OFF = 0
uint8 STATE_ON = 1
uint8 FAILURE_DRY = 0
uint8 FAILURE_HOT = 9
uint8 MOST = 3
";

const OVERLAY: &str = "<uorb-overlay version='1' for='msg'><message name='PumpStatus'>
<field name='failures' flags='PumpFailures' bits='FAILURE_*'/></message></uorb-overlay>";

/// `msg`, `old` and an overlay.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (path, text) in [
        ("msg/PumpStatus.msg", STATUS),
        ("msg/Valve.msg", "uint64 timestamp\nint8 turns\n"),
        ("msg/Broken.msg", "uint64 timestamp\nuint9 x\n"),
        ("old/PumpStatus.msg", "uint64 timestamp\nuint8 state\n"),
        ("pump.overlay.xml", OVERLAY),
    ] {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

#[test]
fn only_what_is_selected_is_read() {
    let folder = folder();
    let all = mavgen(folder.path(), &["lint", "msg"]);
    assert_eq!(all.status.code(), Some(1));
    assert!(stderr(&all).contains("error[M902]: there is no type `uint9`"), "{}", stderr(&all));
    for arguments in [
        &["lint", "msg", "--messages", "Pump*"][..],
        &["lint", "msg/PumpStatus.msg"],
        &["lint", "msg/PumpStatus.msg", "msg/Valve.msg"],
        &["lint", "msg", "--messages", "PumpStatus", "--older", "v1=old", "--overlay", "pump.overlay.xml"],
    ] {
        let answer = mavgen(folder.path(), arguments);
        assert_eq!(answer.status.code(), Some(0), "{arguments:?}: {}", stderr(&answer));
        assert!(stderr(&answer).ends_with(": 0 errors, 0 warnings, 0 notes\n"), "{}", stderr(&answer));
    }
}

#[test]
fn what_is_wrong_with_the_usage_is_2() {
    let folder = folder();
    fs::create_dir(folder.path().join("empty")).unwrap();
    for (arguments, said) in [
        (
            &["lint", "msg", "--messages", "PumpStats"][..],
            "error: no message of msg is called `PumpStats` (did you mean `PumpStatus`?)\n",
        ),
        (&["lint", "empty"], "error[M001]: no `.msg` file is in empty\n\n"),
        (&["dump", "msg/Pump.msg"], "error: there is no file msg/Pump.msg\n"),
        (
            &["dump", "msg/PumpStatus.msg", "old/PumpStatus.msg"],
            "error: the `.msg` files stand in several folders; `--older NAME=DIR` adds older definitions\n",
        ),
        (
            &["dump", "msg", "pump.overlay.xml"],
            "error: give dialects, or one folder of `.msg` files, or files of one folder\n",
        ),
        (&["dump", "msg", "--older", "old"], "error: `--older old` is not of the form NAME=DIR\n"),
        (&["lint", "pump.overlay.xml", "--older", "v1=old"], "error: `--older` is for folders of `.msg` files\n"),
    ] {
        let answer = mavgen(folder.path(), arguments);
        assert_eq!((answer.status.code(), &*stderr(&answer)), (Some(2), said), "{arguments:?}");
    }
}

#[test]
fn warnings_can_be_denied_and_allowed() {
    let folder = folder();
    fs::write(folder.path().join("old/PumpStatus.msg"), "uint64 timestamp # [@enum NOTHING]\n").unwrap();
    let lint = |more: &[&str]| mavgen(folder.path(), &[&["lint", "old"], more].concat()).status.code();
    assert_eq!(lint(&[]), Some(0));
    assert_eq!(lint(&["--deny-warnings"]), Some(1));
    assert_eq!(lint(&["--deny-warnings", "--allow", "M909"]), Some(0));
    assert_eq!(mavgen(folder.path(), &["dump", "old", "--deny-warnings"]).status.code(), Some(2));
}

#[test]
fn a_person_sees_both_layouts() {
    let folder = folder();
    let dump = mavgen(folder.path(), &["dump", "msg/PumpStatus.msg", "--overlay", "pump.overlay.xml"]);
    let expected = "\
PumpStatus: hash e70e771c, 41 bytes as CDR, 48 as a struct
  RIHS01_2500c68924bf8233d742cb492616465b4de1e1757ac613befdf92cedf0553d38
  topics: pump_status
   cdr struct
     0      0  timestamp: uint64 us
     8     14  state: uint8 PumpStatusState
    10     12  failures: uint16 PumpFailures
    12      8  level: float32 m unknown: NaN
    16     16  valve: Valve[2]
  MOST = 3: uint8
enum PumpStatusState: u8
           0 OFF (STATE_OFF)
           1 ON (STATE_ON)
flags PumpFailures: u16
           1 DRY (FAILURE_DRY)
         512 HOT (FAILURE_HOT)
";
    let said = stdout(&dump);
    let (_, said) = said.split_once("turns: int8\n").unwrap();
    assert_eq!(said, expected);
}

#[test]
fn json_has_everything() {
    let folder = folder();
    let arguments = ["dump", "msg/PumpStatus.msg", "--json", "--overlay", "pump.overlay.xml", "--older", "v1=old"];
    let text = stdout(&mavgen(folder.path(), &arguments));
    let objects: Vec<Value> = serde_json::Deserializer::from_str(&text).into_iter().collect::<Result<_, _>>().unwrap();
    let [newest, older] = &objects[..] else { panic!("{text}") };
    assert_eq!((&newest["definition"], &older["definition"]), (&"newest".into(), &"v1".into()));
    assert_eq!(older["messages"][0]["cdr_len"], 9);
    let status = &newest["messages"][1];
    assert_eq!(
        (&status["name"], &status["topics"][0], &status["cdr_len"], &status["record_len"]),
        (&"PumpStatus".into(), &"pump_status".into(), &41.into(), &48.into())
    );
    assert_eq!(
        status["log_format"],
        "uint64_t timestamp;float level;uint16_t failures;uint8_t state;uint8_t[1] _padding0;valve[2] valve;"
    );
    let field = |i: usize, name: &str| &status["fields"][i][name];
    assert_eq!((field(1, "enum"), field(2, "enum")), (&"PumpStatusState".into(), &"PumpFailures".into()));
    assert_eq!((field(3, "units"), field(3, "invalid"), field(4, "array")), (&"m".into(), &"NaN".into(), &2.into()));
    assert_eq!(newest["enums"][1]["entries"][1]["value"], 512);
    assert_eq!(status["constants"][0]["value"], 3);
}

#[test]
fn generated_topics_are_current_until_a_file_changes() {
    let folder = folder();
    let options = [
        "msg/PumpStatus.msg",
        "--overlay",
        "pump.overlay.xml",
        "--older",
        "v1=old",
        "--definition",
        "main",
        "--name",
        "pumps",
    ];
    let run = |command: &str| mavgen(folder.path(), &[&[command][..], &options, &["--out", "src/px4"]].concat());
    let generated = run("generate");
    assert_eq!(generated.status.code(), Some(0), "{}", stderr(&generated));
    let text = fs::read_to_string(folder.path().join("src/px4/messages/pump_status.rs")).unwrap();
    assert!(text.contains("const MAIN: ") && text.contains("const V1: "), "{text}");
    let module = fs::read_to_string(folder.path().join("src/px4/mod.rs")).unwrap();
    assert!(module.starts_with("// @generated by mavgen from pumps; do not edit."), "{module}");
    assert!(!folder.path().join("src/px4/messages/broken.rs").exists());
    assert_eq!(run("check").status.code(), Some(0));
    fs::write(folder.path().join("msg/Valve.msg"), "uint64 timestamp\nint16 turns\n").unwrap();
    let checked = run("check");
    assert_eq!(checked.status.code(), Some(1));
    assert!(stdout(&checked).contains("i16"), "{}", stdout(&checked));
}
