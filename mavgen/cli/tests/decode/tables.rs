//! `--format csv --out` and `--format parquet --out`: a table of each message.

use std::fs;
use std::io::Read as _;
use std::process::Stdio;

use crate::bench::{Bench, stderr};

#[test]
fn each_message_has_a_file() {
    let mut bench = Bench::new();
    let frames = [bench.nozzles(0), bench.sprayer(), bench.nozzles(1)];
    let timed = frames.iter().zip(0..).flat_map(|(frame, at)| {
        let time: u64 = 1_400_000_000_123_456 + at;
        [&time.to_be_bytes()[..], frame].concat()
    });
    let log: Vec<u8> = timed.collect();
    let options = ["--overlay", "acme.overlay.xml", "--format", "csv", "--out", "t/tables"];
    let table = |name: &str| fs::read_to_string(bench.folder.path().join("t/tables").join(name)).unwrap();
    for _ in 0..2 {
        let output = bench.decode(&[&["acme.xml"][..], &options].concat(), &log);
        let said = "frames: 3, of them unverified: 0, bytes skipped: 0\nt/tables: 2 tables written\n";
        assert_eq!((output.status.code(), &*stderr(&output), output.stdout.len()), (Some(0), said, 0));
        for (file, message) in [("NOZZLES.csv", "NOZZLES"), ("SPRAYER.csv", "SPRAYER")] {
            assert_eq!(table(file), bench.printed(&["--format", "csv", "--message", message], &log));
        }
    }
    let sprayer = table("SPRAYER.csv");
    assert!(sprayer.contains("\n2014-05-13T16:53:20.123457Z,1400000000.123457,1,2,1,SPRAY_STATE_ON,"), "{sprayer}");

    let less = bench.decode(&[&["acme.xml"][..], &options, &["--fields", "count"]].concat(), &log);
    assert!(less.status.success() && stderr(&less).contains("1 table written"), "{}", stderr(&less));
    assert!(table("NOZZLES.csv").starts_with("time,unix_time (s),system_id,component_id,sequence,count\n2014"));
}

#[test]
fn somebodys_file_is_not_written_over() {
    let mut bench = Bench::new();
    let stream = bench.sprayer();
    let theirs = bench.folder.path().join("SPRAYER.csv");
    for text in ["time,level\n1,2\n", ""] {
        fs::write(&theirs, text).unwrap();
        let refused = bench.decode(&["acme.xml", "--format", "csv", "--out", "."], &stream);
        let said = stderr(&refused);
        assert!(said.contains("SPRAYER.csv: `mavgen decode` did not write this file"), "{said}");
        assert_eq!((refused.status.code(), &*fs::read_to_string(&theirs).unwrap()), (Some(2), text));
    }
}

/// A limit on the length of files lets it write some of a table, then no more.
#[cfg(unix)]
#[test]
fn on_a_full_disk_there_is_no_part_of_a_table() {
    let mut bench = Bench::new();
    let one = bench.sprayer();
    let log = bench.folder.path().join("long.raw");
    let formats = if cfg!(feature = "parquet") { &["csv", "parquet"][..] } else { &["csv"] };
    for format in formats {
        let run = |limit: &str, count: usize| {
            fs::write(&log, one.repeat(count)).unwrap();
            let decode = format!("decode acme.xml long.raw --input raw --format {format} --out t");
            let script = format!("trap '' XFSZ; ulimit -f {limit}; exec \"$0\" {decode}");
            let mut shell = std::process::Command::new("sh");
            let output = shell.args(["-c", &script, env!("CARGO_BIN_EXE_mavgen")]).current_dir(&bench.folder).output();
            output.unwrap()
        };
        let table = bench.folder.path().join(format!("t/SPRAYER.{format}"));
        assert!(run("unlimited", 1).status.success());
        let before = fs::read(&table).unwrap();
        let output = run(if *format == "csv" { "16" } else { "0" }, 2_000);
        assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
        assert!(stderr(&output).contains(&format!("t/SPRAYER.{format}: ")), "{}", stderr(&output));
        assert!(fs::read(&table).unwrap() == before);
        assert_eq!(fs::read_dir(table.parent().unwrap()).unwrap().count(), 1);
        fs::remove_file(&table).unwrap();
    }
}

/// Nobody asked for a count of what was not read to its end.
#[test]
fn a_reader_that_has_seen_enough_ends_it_without_a_word() {
    let mut bench = Bench::new();
    fs::write(bench.folder.path().join("long.raw"), bench.sprayer().repeat(20_000)).unwrap();
    let mut mavgen = std::process::Command::new(env!("CARGO_BIN_EXE_mavgen"));
    mavgen.args(["decode", "acme.xml", "long.raw", "--input", "raw"]).current_dir(&bench.folder);
    let mut child = mavgen.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    child.stdout.take().unwrap().read_exact(&mut [0]).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), &*stderr(&output)), (Some(0), ""));
}

#[test]
fn nothing_is_written_where_there_is_nothing() {
    let bench = Bench::new();
    let output = bench.decode(&["acme.xml", "--format", "csv", "--out", "tables"], b"");
    assert!(output.status.success() && stderr(&output).ends_with("tables: 0 tables written\n"), "{}", stderr(&output));
    assert!(!bench.folder.path().join("tables").exists());
}

#[cfg(feature = "parquet")]
#[test]
fn typed_tables_are_whole_and_only_their_own_are_replaced() {
    let mut bench = Bench::new();
    let stream = [bench.nozzles(0), bench.sprayer()].concat();
    let options = ["acme.xml", "--overlay", "acme.overlay.xml", "--format", "parquet", "--out", "t"];
    let (folder, theirs) = (bench.folder.path().join("t"), bench.folder.path().join("t/SPRAYER.parquet"));
    for _ in 0..2 {
        let output = bench.decode(&options, &stream);
        assert!(output.status.success() && stderr(&output).ends_with("t: 2 tables written\n"), "{}", stderr(&output));
        let mut names: Vec<_> = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        assert_eq!(names, ["NOZZLES.parquet", "SPRAYER.parquet"]);
        let table = fs::read(&theirs).unwrap();
        assert!(table.starts_with(b"PAR1") && table.ends_with(b"PAR1"));
    }
    for foreign in [&b"PAR1 of somebody else \x05\0\0\0PAR1"[..], b"", b"text"] {
        fs::write(&theirs, foreign).unwrap();
        let refused = bench.decode(&options, &stream);
        let said = stderr(&refused);
        assert!(said.contains("SPRAYER.parquet: `mavgen decode` did not write this file"), "{said}");
        assert_eq!((refused.status.code(), fs::read(&theirs).unwrap().as_slice()), (Some(2), foreign));
    }
}

#[test]
fn typed_tables_need_a_folder_and_their_feature() {
    let bench = Bench::new();
    let said = stderr(&bench.decode(&["acme.xml", "--format", "parquet"], b""));
    assert!(said.contains("give --out a folder"), "{said}");
    if cfg!(not(feature = "parquet")) {
        let said = stderr(&bench.decode(&["acme.xml", "--format", "parquet", "--out", "t"], b""));
        assert!(said.contains("install it with --features parquet"), "{said}");
    }
}
