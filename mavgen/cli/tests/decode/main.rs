//! `mavgen decode`: recordings in every layout, in every format.

#![expect(clippy::unwrap_used, clippy::indexing_slicing, reason = "a failing test panics")]

mod bench;
mod choice;
mod parameters;
mod recorded;
mod tables;

use std::fs;

use serde_json::{Value, json};

use bench::{ACME, Bench, SIGNING, stderr};

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
        "time": null, "unix_time": null, "version": 2, "system_id": 1, "component_id": 2, "sequence": 0, "signed": false,
        "message_id": 100, "verified": true,
        "message": {
            "type": "SPRAYER", "state": "SPRAY_STATE_ON", "flags": "SPRAY_FLAGS_LEAK | SPRAY_FLAGS_COLD | 0x40",
            "level": 300, "flow": [null, 0.1], "total": 0.1, "label": [97, 44, 34, 98, 255, 0, 0, 0],
        },
        "units": {"level": "cm", "flow": "g/min"},
        "views": {"mode": "SPRAY_LEVEL_HIGH"},
        "view_units": {},
    });
    assert_eq!(lines[0], expected);
    let open = [true, true, false, false, false, false, false, false];
    let status = json!({"state": "SPRAY_STATE_ON", "angle": -0.5, "open": open});
    assert_eq!(lines[1]["views"], json!({"nozzles": [{"id": 9, "status": status}, {"id": null, "status": null}]}),);
    assert_eq!(lines[1]["view_units"], json!({"nozzles": {"status": {"angle": "deg"}}}));
    assert_eq!(lines[2]["views"], json!({}), "the condition does not hold");
    assert_eq!((&lines[2]["message"]["flags"], &lines[2]["message"]["label"]), (&json!(""), &json!("")));
    assert_eq!(lines.len(), 3);
}

#[test]
fn a_key_is_not_shown() {
    let mut bench = Bench::of(SIGNING);
    let frame = bench.frame(256, &[&[0xa7; 32][..], &[9]].concat());
    assert_eq!(bench.printed_without(&[], &frame), "1/2 #0 SETUP_SIGNING { secret_key: secret, target_system: 9 }\n");
    let json: Value = serde_json::from_str(&bench.printed_without(&["--format", "json"], &frame)).unwrap();
    assert_eq!(json["message"], json!({"type": "SETUP_SIGNING", "secret_key": "secret", "target_system": 9}));
    let csv = bench.printed_without(&["--format", "csv"], &frame);
    assert_eq!(
        csv.lines().collect::<Vec<_>>(),
        ["time,unix_time (s),system_id,component_id,sequence,secret_key,target_system", ",,1,2,0,secret,9"]
    );
}

#[test]
fn csv_has_a_column_for_each_value_that_there_can_be() {
    let mut bench = Bench::new();
    let stream = [bench.nozzles(0), bench.sprayer(), bench.nozzles(1)].concat();
    let text = bench.printed(&["--format", "csv", "--message", "NOZZLES"], &stream);
    let mut rows = csv::Reader::from_reader(text.as_bytes());
    let head: Vec<String> = rows.headers().unwrap().iter().map(str::to_owned).collect();
    assert_eq!(head[..4], ["time", "unix_time (s)", "system_id", "component_id"]);
    assert_eq!(head[4..7], ["sequence", "count", "id[0]"]);
    assert_eq!(head.len(), 5 + 8 + 3 * (1 + 2 + 8 + 1));
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
        "time,unix_time (s),system_id,component_id,sequence,\
         state,flags,level (cm),flow[0] (g/min),flow[1] (g/min),total,label,mode\n\
         ,,1,2,1,SPRAY_STATE_ON,SPRAY_FLAGS_LEAK | SPRAY_FLAGS_COLD | 0x40,300,,0.1,0.1,\
         \"b\"\"a,\\\"\"b\\xff\"\"\",SPRAY_LEVEL_HIGH\n"
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
    assert!(printed("csv").lines().last().unwrap().starts_with(",,1,2,0,SPRAY_STATE_ON,"));
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
    assert_eq!((&line["payload"], line.get("message")), (&json!("fd030000ffff0209ff0701"), None));
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
        (&["acme.xml", "--format", "csv", "--messages", "*"], b"", "not of 2: name it with --messages, or give --out"),
        (&["acme.xml", "--out", "tables"], b"", "--out is for tables: give --format csv"),
        (
            &["acme.xml", "--fields", "levle"],
            b"",
            "no field or value of a view of these messages is called `levle`; did you mean `level`?",
        ),
        (&["acme.xml", "--messages", "NOZZLES", "--fields", "level"], b"", "is called `level`"),
        (&["acme.xml", "--views", "nozzles"], b"", "no view of these messages is called `nozzles`"),
        (&["acme.xml", "--views", "a", "--no-view", "b"], b"", "cannot be used with"),
    ] {
        let output = bench.decode(arguments, input);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(said), "{}", stderr(&output));
    }
    for name in ["flight.tlog", "flight"] {
        fs::write(bench.folder.path().join(name), [0, 4, 0xf9, 0x4d, 0xba, 0xd8, 0x41, 0, 0xfe, 9]).unwrap();
    }
    for (arguments, instead) in [
        (&["flight.tlog"][..], "xml/common.xml flight.tlog"),
        (&["flight", "--format", "csv"], "xml/common.xml flight"),
        (&["flight.tlog", "acme.xml"], "acme.xml flight.tlog"),
        (&["-"], "xml/common.xml -"),
    ] {
        let output = bench.decode(arguments, b"");
        let recording = arguments[0];
        let said = format!(
            "error: `{recording}` is not a dialect's XML file, which is named first: mavgen decode {instead}\n"
        );
        assert_eq!((output.status.code(), stderr(&output)), (Some(2), said));
    }
    for named in [&["acme.xml", "--input", "hex"][..], &["acme.xml", "-", "--input", "hex"]] {
        assert!(stderr(&bench.decode(named, b"x")).starts_with("error: standard input: line 1: "));
    }
    let nothing = bench.decode(&["acme.xml"], b"");
    assert_eq!((nothing.status.code(), nothing.stdout.len()), (Some(0), 0));
}

/// As a shell makes it of `<(…)`: nothing of it can be read twice.
#[cfg(unix)]
#[test]
fn a_dialect_comes_through_a_pipe() {
    let mut bench = Bench::new();
    let (frame, pipe) = (bench.sprayer(), bench.folder.path().join("pipe"));
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let writer = std::thread::spawn(move || fs::write(pipe, bench::ACME));
    let output = bench.decode(&["pipe", "--messages", "SPRAYER"], &frame);
    writer.join().unwrap().unwrap();
    assert!(output.status.success() && !output.stdout.is_empty(), "{}", stderr(&output));
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

#[test]
fn a_value_of_a_signed_enum_can_be_negative() {
    let mut bench = Bench::of(
        "<mavlink><enums><enum name='TILT'><entry value='1' name='TILT_UP'/></enum></enums><messages>\
         <message id='7' name='BOOM'><field type='int8_t' name='a' enum='TILT'/><field type='int8_t' name='b'/></message>\
         </messages></mavlink>",
    );
    let overlay = "<mavlink-overlay version='1' for='acme.xml'><message name='BOOM'>\
                   <bind name='c' field='b' enum='TILT'/></message></mavlink-overlay>";
    fs::write(bench.folder.path().join("acme.overlay.xml"), overlay).unwrap();
    let frames = [bench.frame(7, &[0xff, 0xfe]), bench.frame(7, &[1, 1])].concat();
    let expected = "1/2 #0 BOOM { a: -1, b: -2 }\n    c: -2\n1/2 #1 BOOM { a: TILT_UP, b: 1 }\n    c: TILT_UP\n";
    assert_eq!(bench.printed(&[], &frames), expected);
}
