//! `mavgen decode`: recordings in every layout, in every format.
//!
//! Needs the feature `cli`, without which there is no command to test.
#![cfg(feature = "cli")]
#![expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a failing test panics")]

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use mavgen::Builder;
use mavgen::decode::Tables;
use mavlink_wire::{Encode, MAX_FRAME, MAX_PAYLOAD, MessageInfo, Sender};
use serde_json::{Value, json};

const ACME: &str = r#"<mavlink>
  <version>3</version>
  <enums>
    <enum name="SPRAY_STATE">
      <entry value="0" name="SPRAY_STATE_OFF"/>
      <entry value="1" name="SPRAY_STATE_ON"/>
    </enum>
    <enum name="SPRAY_FLAGS" bitmask="true">
      <entry value="1" name="SPRAY_FLAGS_LEAK"/>
      <entry value="4" name="SPRAY_FLAGS_COLD"/>
    </enum>
  </enums>
  <messages>
    <message id="100" name="SPRAYER">
      <description/>
      <field type="uint8_t" name="state" enum="SPRAY_STATE"/>
      <field type="uint8_t" name="flags" enum="SPRAY_FLAGS"/>
      <field type="uint16_t" name="level" units="cm" invalid="UINT16_MAX"/>
      <field type="float[2]" name="flow" units="g/min" invalid="[NaN]"/>
      <field type="double" name="total"/>
      <field type="char[8]" name="label"/>
    </message>
    <message id="101" name="NOZZLES">
      <description/>
      <field type="uint8_t" name="count"/>
      <field type="uint8_t[3]" name="id"/>
      <field type="uint16_t[3]" name="word"/>
      <field type="uint8_t" name="mode"/>
    </message>
  </messages>
</mavlink>
"#;

const SIGNING: &str = r#"<mavlink>
  <messages>
    <message id="256" name="SETUP_SIGNING">
      <description/>
      <field type="uint8_t[32]" name="secret_key"/>
      <field type="uint8_t" name="target_system"/>
    </message>
  </messages>
</mavlink>
"#;

const OVERLAY: &str = r#"<mavlink-overlay version="1" for="acme.xml">
  <message name="SPRAYER">
    <bind name="mode" field="level" enum="SPRAY_LEVEL" if="state" is="SPRAY_STATE_ON"/>
  </message>
  <enums><enum name="SPRAY_LEVEL"><entry value="7" name="SPRAY_LEVEL_LOW"/><entry value="300" name="SPRAY_LEVEL_HIGH"/></enum></enums>
  <message name="NOZZLES">
    <view name="NOZZLE_STATUS" words="word[i]" item="nozzle" items="nozzles" count="count">
      <key name="id" field="id[i]" invalid="255"/>
      <invalid value="0"/>
      <bits name="state" at="0" width="1" enum="SPRAY_STATE"/>
      <bits name="angle" at="1" width="7" signed="true" scale="1/4" units="deg"/>
      <switch field="mode">
        <case value="1"><bits name="open" at="8" width="1" repeat="8"/></case>
        <default><bits name="speed" at="8" width="8" units="mm/s"/></default>
      </switch>
    </view>
  </message>
</mavlink-overlay>
"#;

/// A message in bytes.
struct Sent {
    info: &'static MessageInfo,
    payload: Vec<u8>,
}

impl Encode for Sent {
    fn info(&self) -> &'static MessageInfo {
        self.info
    }

    fn write(&self, payload: &mut [u8; MAX_PAYLOAD]) {
        payload[..self.payload.len()].copy_from_slice(&self.payload);
    }
}

/// A folder with the definitions, and frames of them.
struct Bench {
    folder: tempfile::TempDir,
    tables: Tables,
    sender: Sender,
}

impl Bench {
    fn new() -> Self {
        let bench = Self::of(ACME);
        fs::write(bench.folder.path().join("acme.overlay.xml"), OVERLAY).unwrap();
        bench
    }

    fn of(xml: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("acme.xml"), xml).unwrap();
        let dialect = Builder::new(folder.path().join("acme.xml")).resolve().unwrap().dialect;
        Self { folder, tables: Tables::leak(&dialect), sender: Sender::v2(1, 2) }
    }

    fn frame(&mut self, id: u32, payload: &[u8]) -> Vec<u8> {
        let sent = Sent { info: self.tables.table().get(id).unwrap(), payload: payload.to_vec() };
        self.sender.encode(&sent, &mut [0; MAX_FRAME]).unwrap().to_vec()
    }

    fn sprayer(&mut self) -> Vec<u8> {
        let mut payload = vec![];
        payload.extend(0.1_f64.to_le_bytes());
        payload.extend(f32::NAN.to_le_bytes());
        payload.extend(0.1_f32.to_le_bytes());
        payload.extend(300_u16.to_le_bytes());
        payload.extend([1, 0x45]);
        payload.extend(b"a,\"b\xff");
        self.frame(100, &payload)
    }

    /// Three slots, of which the second says nothing and the third is not in use.
    fn nozzles(&mut self, mode: u8) -> Vec<u8> {
        let words = [0x03fd_u16, 0, 0xffff].map(u16::to_le_bytes).concat();
        self.frame(101, &[&words[..], &[2, 9, 255, 7, mode]].concat())
    }

    fn decode(&self, arguments: &[&str], input: &[u8]) -> Output {
        decode(self.folder.path(), arguments, input)
    }

    /// What is printed with the overlay, from standard input.
    fn printed(&self, arguments: &[&str], input: &[u8]) -> String {
        self.printed_without(&[&["--overlay", "acme.overlay.xml"], arguments].concat(), input)
    }

    fn printed_without(&self, arguments: &[&str], input: &[u8]) -> String {
        let output = self.decode(&[&["acme.xml"], arguments].concat(), input);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        String::from_utf8(output.stdout).unwrap()
    }
}

fn decode(folder: &Path, arguments: &[&str], input: &[u8]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mavgen"));
    let command = command.current_dir(folder).arg("decode").args(arguments);
    let command = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    // A command that refuses its arguments does not read.
    let _ = child.stdin.take().unwrap().write_all(input);
    child.wait_with_output().unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

#[test]
fn text_is_a_line_for_each_message_view_and_slot() {
    let mut bench = Bench::new();
    let stream = [bench.sprayer(), bench.nozzles(0), bench.nozzles(1)].concat();
    assert_eq!(
        bench.printed(&[], &stream),
        r#"1/2 #0 SPRAYER { state: SPRAY_STATE_ON, flags: SPRAY_FLAGS_LEAK | SPRAY_FLAGS_COLD | 0x40, level: 300 cm, flow: [unknown, 0.1] g/min, total: 0.1, label: b"a,\"b\xff" }
    mode: SPRAY_LEVEL_HIGH
1/2 #1 NOZZLES { count: 2, id: [9, 255, 7], word: [1021, 0, 65535], mode: 0 }
    nozzles[0]: id 9, state SPRAY_STATE_ON, angle -0.50 deg, speed 3 mm/s
    nozzles[1]: id unknown, status unknown
1/2 #2 NOZZLES { count: 2, id: [9, 255, 7], word: [1021, 0, 65535], mode: 1 }
    nozzles[0]: id 9, state SPRAY_STATE_ON, angle -0.50 deg, open [true, true, false, false, false, false, false, false]
    nozzles[1]: id unknown, status unknown
"#
    );
}

#[test]
fn json_is_an_object_on_each_line() {
    let mut bench = Bench::new();
    let stream = [bench.sprayer(), bench.nozzles(1), bench.frame(100, &[])].concat();
    let text = bench.printed(&["--format", "json", "-"], &stream);
    let lines: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let expected = json!({
        "time": null, "version": 2, "system": 1, "component": 2, "sequence": 0, "signed": false,
        "id": 100, "verified": true, "name": "SPRAYER",
        "fields": {
            "state": "SPRAY_STATE_ON", "flags": "SPRAY_FLAGS_LEAK | SPRAY_FLAGS_COLD | 0x40", "level": 300,
            "flow": [null, 0.1], "total": 0.1, "label": "a,\"b\u{fffd}",
        },
        "units": {"level": "cm", "flow": "g/min"},
        "views": {"mode": "SPRAY_LEVEL_HIGH"},
    });
    assert_eq!(lines[0], expected);
    let open = [true, true, false, false, false, false, false, false];
    let status = json!({"state": "SPRAY_STATE_ON", "angle": -0.5, "open": open});
    assert_eq!(lines[1]["views"], json!({"nozzles": [{"id": 9, "status": status}, {"id": null, "status": null}]}),);
    assert_eq!(lines[2]["views"], json!({}), "the condition does not hold");
    assert_eq!(lines[2]["fields"]["flags"], "0");
    assert_eq!(lines.len(), 3);
}

#[test]
fn a_key_is_not_shown() {
    let mut bench = Bench::of(SIGNING);
    let frame = bench.frame(256, &[&[0xa7; 32][..], &[9]].concat());
    assert_eq!(bench.printed_without(&[], &frame), "1/2 #0 SETUP_SIGNING { secret_key: secret, target_system: 9 }\n");
    let json: Value = serde_json::from_str(&bench.printed_without(&["--format", "json"], &frame)).unwrap();
    assert_eq!(json["fields"], json!({"secret_key": "secret", "target_system": 9}));
    let csv = bench.printed_without(&["--format", "csv"], &frame);
    assert_eq!(
        csv.lines().collect::<Vec<_>>(),
        ["time,system,component,sequence,secret_key,target_system", ",1,2,0,secret,9"]
    );
}

#[test]
fn csv_has_a_column_for_each_value_that_there_can_be() {
    let mut bench = Bench::new();
    let stream = [bench.nozzles(0), bench.sprayer(), bench.nozzles(1)].concat();
    let text = bench.printed(&["--format", "csv", "--message", "NOZZLES"], &stream);
    let mut rows = csv::Reader::from_reader(text.as_bytes());
    let head: Vec<String> = rows.headers().unwrap().iter().map(str::to_owned).collect();
    assert_eq!(head[..6], ["time", "system", "component", "sequence", "count", "id[0]"]);
    assert_eq!(head.len(), 4 + 8 + 3 * (1 + 2 + 8 + 1));
    let rows: Vec<csv::StringRecord> = rows.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 2);
    let cell = |row: usize, name: &str| rows[row][head.iter().position(|column| column == name).unwrap()].to_owned();
    for (name, cells) in [
        ("sequence", ["0", "2"]),
        ("word[2]", ["65535", "65535"]),
        ("nozzles[0].id", ["9", "9"]),
        ("nozzles[0].status.angle (deg)", ["-0.5", "-0.5"]),
        ("nozzles[0].status.speed (mm/s)", ["3", ""]),
        ("nozzles[0].status.open[1]", ["", "true"]),
        ("nozzles[1].id", ["", ""]),
        ("nozzles[2].status.state", ["", ""]),
    ] {
        assert_eq!([cell(0, name), cell(1, name)], cells, "{name}");
    }
    let text = bench.printed(&["--format", "csv", "--message", "SPRAYER"], &stream);
    assert_eq!(
        text,
        "time,system,component,sequence,state,flags,level (cm),flow[0] (g/min),flow[1] (g/min),total,label,mode\n\
         ,1,2,1,SPRAY_STATE_ON,SPRAY_FLAGS_LEAK | SPRAY_FLAGS_COLD | 0x40,300,,0.1,0.1,\"a,\"\"b\u{fffd}\",SPRAY_LEVEL_HIGH\n"
    );
}

/// It need not be named.
#[test]
fn the_one_message_of_a_dialect_is_a_table() {
    let mut bench = Bench::new();
    let (head, tail) = ACME.split_once("<message id=\"101\"").unwrap();
    let (_, end) = tail.split_once("</message>").unwrap();
    fs::write(bench.folder.path().join("one.xml"), format!("{head}{end}")).unwrap();
    let stream = bench.sprayer();
    let table = bench.decode(&["one.xml", "--format", "csv"], &stream);
    assert_eq!((table.status.code(), String::from_utf8(table.stdout).unwrap().lines().count()), (Some(0), 2));
}

#[test]
fn every_layout_is_recognised() {
    let mut bench = Bench::new();
    let frames = [bench.sprayer(), bench.nozzles(0)];
    let expected = bench.printed(&[], &frames.concat());
    let hex: Vec<String> =
        frames.iter().map(|frame| frame.iter().map(|byte| format!("{byte:02X} ")).collect()).collect();
    assert_eq!(bench.printed(&[], hex.join("\n").as_bytes()), expected);
    let log: Vec<u8> =
        frames.iter().flat_map(|frame| [&1_400_000_000_123_456_u64.to_be_bytes()[..], frame].concat()).collect();
    let timed = bench.printed(&[], &log);
    assert!(timed.starts_with("2014-05-13T16:53:20.123456Z 1/2 #0 SPRAYER {"), "{timed}");
    assert_eq!(timed.replace("2014-05-13T16:53:20.123456Z ", ""), expected);
    fs::write(bench.folder.path().join("flight.tlog"), &log).unwrap();
    assert_eq!(bench.printed(&["flight.tlog"], &[]), timed);
    assert_eq!(bench.printed(&["--input", "raw"], &log), expected, "times are skipped like noise");
}

/// Behind damage at the beginning of a log.
#[test]
fn a_time_that_nobody_knows_is_absent() {
    let mut bench = Bench::new();
    let log = [&[1; 9][..], &bench.sprayer()].concat();
    let printed = |format: &str| bench.printed(&["--input", "tlog", "--format", format, "--message", "SPRAYER"], &log);
    assert!(printed("text").starts_with("1/2 #0 SPRAYER {"));
    assert_eq!(serde_json::from_str::<Value>(&printed("json")).unwrap()["time"], Value::Null);
    assert!(printed("csv").lines().last().unwrap().starts_with(",1,2,0,SPRAY_STATE_ON,"));
}

#[test]
fn what_cannot_be_read_is_counted() {
    let mut bench = Bench::new();
    let (good, mut damaged) = (bench.nozzles(0), bench.sprayer());
    damaged[12] ^= 1;
    let output = bench.decode(&["acme.xml"], &[&good[..], &damaged, &good].concat());
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8(output.stdout.clone()).unwrap().lines().count(), 2);
    let length = damaged.len();
    assert_eq!(
        stderr(&output),
        format!(
            "frames: 2, of them unverified: 0, bytes skipped: {length}\n\
             checksums that do not fit SPRAYER (100): 1; damage, or another definition of it\n"
        )
    );
}

#[test]
fn unknown_messages_are_shown_as_they_are() {
    let mut bench = Bench::new();
    fs::write(bench.folder.path().join("less.xml"), ACME.replace("id=\"101\"", "id=\"102\"")).unwrap();
    let (stream, extra) = (bench.nozzles(1), bench.tables.table().get(101).unwrap().crc_extra);
    let text = bench.decode(&["less.xml"], &stream);
    assert_eq!(String::from_utf8(text.stdout).unwrap(), "1/2 #0 message 101, unverified: fd030000ffff0209ff0701\n",);
    assert_eq!(String::from_utf8(text.stderr).unwrap(), "frames: 1, of them unverified: 1, bytes skipped: 0\n");
    let json = bench.decode(&["less.xml", "--format", "json"], &stream);
    let line: Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!((&line["verified"], &line["crc_extra"]), (&json!(false), &json!(extra)));
    assert_eq!((&line["payload"], line.get("fields")), (&json!("fd030000ffff0209ff0701"), None));
    let filtered = bench.decode(&["less.xml", "--messages", "SPRAYER"], &stream);
    assert_eq!(String::from_utf8(filtered.stdout).unwrap(), "");
}

#[test]
fn messages_are_chosen_by_name() {
    let mut bench = Bench::new();
    let stream = [bench.sprayer(), bench.nozzles(0)].concat();
    let text = bench.printed(&["--messages", "SPRAY*"], &stream);
    assert!(text.starts_with("1/2 #0 SPRAYER {") && !text.contains("NOZZLES"), "{text}");
    assert_eq!(bench.printed(&["--messages", "SPRAYER,NOZZLES"], &stream), bench.printed(&[], &stream));
}

#[test]
fn wrong_input_is_2() {
    let bench = Bench::new();
    for (arguments, input, said) in [
        (&["acme.xml", "none.tlog"][..], &b""[..], "none.tlog: "),
        (&["none.xml"], b"", "none.xml"),
        (&["acme.xml"], b"fe 09 00 01 01 00 0g", "standard input: line 1: `g` is no hexadecimal digit"),
        (&["acme.xml", "--messages", "SPRYER"], b"", "SPRYER"),
        (&["acme.xml", "--format", "csv"], b"", "not of 2: name it with --messages"),
        (&["acme.xml", "--format", "csv", "--messages", "*"], b"", "not of 2: name it with --messages"),
    ] {
        let output = bench.decode(arguments, input);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(said), "{}", stderr(&output));
    }
    let nothing = bench.decode(&["acme.xml"], b"");
    assert_eq!((nothing.status.code(), nothing.stdout.len()), (Some(0), 0));
}

/// Noise, among it frames with any payload.
#[test]
fn any_bytes_are_survived() {
    let mut bench = Bench::new();
    let (mut state, mut noise) = (1_u64, Vec::new());
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 56) as u8
    };
    for round in 0..400_usize {
        noise.extend((0..round % 40).map(|_| random()));
        let payload: Vec<u8> = (0..round % 12).map(|_| random()).collect();
        noise.extend(bench.frame(100 + u32::from(random() & 1), &payload));
    }
    for layout in ["auto", "raw", "tlog"] {
        for format in [&["--format", "text"][..], &["--format", "json"], &["--format", "csv", "--message", "NOZZLES"]] {
            let text = bench.printed(&[&["--input", layout], format].concat(), &noise);
            assert!(text.lines().count() > 100, "{layout} {format:?}");
        }
    }
}
