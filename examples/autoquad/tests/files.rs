//! What the commands leave behind: whole files or none, also where the disk is full or somebody ends them.

#![cfg(unix)]
#![expect(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "in what the tests share, too, a failure is a failed test"
)]

use std::fs::{self, File};
use std::io::{Read as _, Write as _};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::{Dialect as _, tlog};
use tempfile::TempDir;

/// Every command that writes a file, but for `record`: its arguments, and the option that names the file.
const WRITERS: [(&[&str], &str); 6] = [
    (&["simulate", "--duration", "20s", "--start", "0"], "--tlog"),
    (&["csv", "flight.tlog"], "--out"),
    (&["ulog", "flight.tlog"], "--out"),
    (&["plot", "flight.tlog"], "--out"),
    (&["salvage", "flight.mavlink"], "--out"),
    (&["px4-log", "flight.ulog"], "--out"),
];

/// A folder with a flight: as a tlog, as a log of AutoQuad's QGroundControl, and as a log of PX4.
fn flight() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    said(autoquad(&folder, &["simulate", "--tlog", "flight.tlog", "--duration", "20s", "--start", "0"]), 0, "");
    said(autoquad(&folder, &["ulog", "flight.tlog", "--out", "flight.ulog"]), 0, "");
    let (log, mut old) = (fs::read(at("flight.tlog")).unwrap(), Vec::new());
    for entry in tlog::entries(&log, Autoquad::TABLE) {
        let bytes = entry.frame.bytes();
        old.extend((1_400_000_000_000_000 + entry.time_us.unwrap()).to_le_bytes());
        old.extend(&bytes[..bytes.len() - 8]);
    }
    fs::write(at("flight.mavlink"), old).unwrap();
    folder
}

fn command(folder: &TempDir) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_autoquad"));
    command.current_dir(folder).stdin(Stdio::null());
    command
}

fn autoquad(folder: &TempDir, arguments: &[&str]) -> Output {
    command(folder).args(arguments).output().unwrap()
}

/// The same where no file grows beyond some kilobytes.
fn on_a_full_disk(folder: &TempDir, arguments: &[&str]) -> Output {
    let script = "trap '' XFSZ; ulimit -f 4; exec \"$@\"";
    let mut shell = Command::new("sh");
    shell.args(["-c", script, "sh", env!("CARGO_BIN_EXE_autoquad")]).args(arguments);
    shell.current_dir(folder).stdin(Stdio::null()).output().unwrap()
}

/// Checks the exit status, and that standard error has this in it; gives all of it.
#[track_caller]
fn said(output: Output, status: i32, part: &str) -> String {
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(status), "{text}");
    assert!(text.contains(part), "{part}: {text}");
    text
}

fn names(folder: &TempDir) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn on_a_full_disk_nothing_is_left_and_nothing_is_lost() {
    let folder = flight();
    let before = names(&folder);
    for (arguments, option) in WRITERS {
        let asked = [arguments, &[option, "out.svg"]].concat();
        said(on_a_full_disk(&folder, &asked), 1, "autoquad: out.svg: File too large");
        assert_eq!(names(&folder), before, "{arguments:?}");
        fs::write(folder.path().join("out.svg"), "old").unwrap();
        said(on_a_full_disk(&folder, &[&asked[..], &["--force"]].concat()), 1, "autoquad: out.svg: File too large");
        assert_eq!(fs::read(folder.path().join("out.svg")).unwrap(), b"old", "{arguments:?}");
        fs::remove_file(folder.path().join("out.svg")).unwrap();
        assert_eq!(names(&folder), before, "{arguments:?}");
    }
}

#[test]
fn a_dash_is_standard_input_and_output() {
    let folder = flight();
    for (arguments, option) in WRITERS {
        said(autoquad(&folder, &[arguments, &[option, "out.svg"]].concat()), 0, "out.svg: ");
        let expected = fs::read(folder.path().join("out.svg")).unwrap();
        fs::remove_file(folder.path().join("out.svg")).unwrap();
        let before = names(&folder);
        for name in ["-", "/dev/stdout"] {
            let output = autoquad(&folder, &[arguments, &[option, name]].concat());
            assert!(output.stdout == expected, "{arguments:?} {name}");
            assert!(!said(output, 0, "").contains("written"), "{arguments:?}");
        }
        let [name, file, ..] = *arguments else { continue };
        if name != "simulate" {
            let input = File::open(folder.path().join(file)).unwrap();
            let option = if name == "px4-log" { &["--csv"][..] } else { &[] };
            let output = command(&folder).args([name, "-"]).args(option).stdin(input).output().unwrap();
            assert!(output.stdout == expected, "{name}");
            said(output, 0, "");
        }
        assert_eq!(names(&folder), before, "{arguments:?}");
    }
}

/// `script` gives a command a terminal.
#[cfg(target_os = "linux")]
#[test]
fn a_terminal_gets_no_log() {
    let folder = flight();
    let autoquad = env!("CARGO_BIN_EXE_autoquad");
    for arguments in ["simulate --tlog -", "ulog flight.tlog --out -", "salvage flight.mavlink --out -"] {
        let mut script = Command::new("script");
        script.args(["-qec", &format!("{autoquad} {arguments}"), "/dev/null"]).current_dir(&folder);
        // Not every system has it.
        let Ok(output) = script.stdin(Stdio::null()).output() else { return };
        let shown = String::from_utf8_lossy(&output.stdout);
        assert!(shown.starts_with("autoquad: standard output is a terminal"), "{arguments}: {shown}");
        assert_eq!(output.status.code(), Some(1));
    }
}

#[test]
fn a_stream_is_read_as_a_file_is() {
    let folder = flight();
    let path = folder.path().join("flight.tlog");
    let piped = |arguments: &[&str]| {
        let mut child = command(&folder);
        child.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = child.spawn().unwrap();
        let sent = child.stdin.take().unwrap().write_all(&fs::read(&path).unwrap());
        (child.wait_with_output().unwrap(), sent.is_ok())
    };
    let expected = autoquad(&folder, &["csv", "flight.tlog"]).stdout;
    for name in ["-", "/dev/stdin"] {
        assert!(piped(&["csv", name]).0.stdout == expected, "{name}");
    }
    let lines = autoquad(&folder, &["monitor", "--plain", "flight.tlog"]).stdout;
    assert!(!lines.is_empty() && piped(&["monitor", "--plain", "-"]).0.stdout == lines);
    let empty = command(&folder).args(["csv", "-"]).output().unwrap();
    assert!(empty.stdout.is_empty());
    said(empty, 1, "autoquad: standard input: is empty");
}

#[test]
fn devices_and_pipes_are_written_to_as_they_are() {
    let folder = flight();
    for (arguments, option) in WRITERS {
        // A picture has to be called `.svg`.
        std::os::unix::fs::symlink("/dev/full", folder.path().join("full.svg")).unwrap();
        if cfg!(target_os = "linux") {
            let output = autoquad(&folder, &[arguments, &[option, "full.svg"]].concat());
            said(output, 1, "autoquad: full.svg: No space left on device");
        }
        fs::remove_file(folder.path().join("full.svg")).unwrap();
        let pipe = folder.path().join("pipe.svg");
        assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read(pipe).unwrap()
        });
        said(autoquad(&folder, &[arguments, &[option, "pipe.svg"]].concat()), 0, "pipe.svg: ");
        assert!(reader.join().unwrap().len() > 1_000, "{arguments:?}");
        fs::remove_file(pipe).unwrap();
    }
}

#[test]
fn nothing_is_written_onto_what_is_read_under_another_name() {
    let folder = flight();
    for (arguments, option) in &WRITERS[1..] {
        let read = folder.path().join(arguments[1]);
        fs::hard_link(&read, folder.path().join("linked.svg")).unwrap();
        let before = fs::read(&read).unwrap();
        let output = autoquad(&folder, &[arguments, &[*option, "linked.svg", "--force"][..]].concat());
        said(output, 1, "autoquad: linked.svg: is what is read");
        assert!(fs::read(&read).unwrap() == before);
        fs::remove_file(folder.path().join("linked.svg")).unwrap();
    }
}

#[test]
fn what_is_ended_midway_leaves_nothing() {
    let folder = flight();
    let before = names(&folder);
    let mut child = command(&folder);
    child.args(["csv", "-", "--out", "flight.csv"]).stdin(Stdio::piped()).stderr(Stdio::piped());
    let mut child = child.spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    input.write_all(&fs::read(folder.path().join("flight.tlog")).unwrap()).unwrap();
    // More may come: the command is at work.
    let waits = (0..1_000).take_while(|_| names(&folder) == before);
    waits.for_each(|_| std::thread::sleep(Duration::from_millis(10)));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let status = child.wait().unwrap();
    drop(input);
    assert_eq!((status.code(), names(&folder)), (Some(130), before));
}

#[test]
fn the_exit_status_says_what_was_wrong() {
    let folder = tempfile::tempdir().unwrap();
    said(autoquad(&folder, &["--help"]), 0, "");
    said(autoquad(&folder, &["csv"]), 2, "<LOG>");
    said(autoquad(&folder, &["csv", "none.tlog"]), 1, "autoquad: none.tlog: ");
    if cfg!(target_os = "linux") {
        let full = File::options().write(true).open("/dev/full").unwrap();
        said(command(&folder).arg("--help").stdout(full).output().unwrap(), 1, "No space left on device");
    }
}

#[test]
fn a_reader_that_has_seen_enough_is_no_error() {
    let folder = flight();
    let commands: [&[&str]; 3] =
        [&["csv", "flight.tlog"], &["monitor", "flight.tlog", "--plain"], &["simulate", "--tlog", "-"]];
    for arguments in commands {
        let mut child = command(&folder);
        let mut child = child.args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let mut first = [0; 1];
        child.stdout.take().unwrap().read_exact(&mut first).unwrap();
        assert_eq!(said(child.wait_with_output().unwrap(), 0, ""), "", "{arguments:?}");
    }
}

#[test]
fn a_recording_of_a_file_ends_with_it() {
    let folder = flight();
    // No file is that large.
    let rotation = ["--rotate-size", "18446744073709551615"];
    let record = [&["record", "file:flight.tlog", "copy.tlog", "--listen-only"], &rotation[..]].concat();
    said(autoquad(&folder, &record), 0, "frames recorded");
    let frames = |name: &str| {
        let log = fs::read(folder.path().join(name)).unwrap();
        tlog::entries(&log, Autoquad::TABLE).map(|entry| entry.frame.bytes().to_vec()).collect::<Vec<_>>()
    };
    assert!(frames("copy.tlog") == frames("flight.tlog"));
}

/// A clock that is wrong, or damage, makes times of any number.
#[test]
fn no_time_of_a_recording_is_too_much() {
    let folder = flight();
    let log = fs::read(folder.path().join("flight.tlog")).unwrap();
    let times: [fn(u64) -> u64; 5] =
        [|_| u64::MAX, |_| 0, |n| u64::MAX - n, |n| 253_402_300_799_000_000 * (n % 2), |n| 1 << (n % 64)];
    for (kind, time) in times.into_iter().enumerate() {
        let entries = tlog::entries(&log, Autoquad::TABLE).zip(0..);
        let entries = entries.flat_map(|(entry, n)| [&time(n).to_be_bytes(), entry.frame.bytes()].concat());
        fs::write(folder.path().join("wrong.tlog"), entries.collect::<Vec<u8>>()).unwrap();
        for arguments in [
            &["csv", "wrong.tlog"][..],
            &["csv", "wrong.tlog", "--epoch", "1e13"],
            &["plot", "wrong.tlog", "--out", "-"],
            &["ulog", "wrong.tlog", "--out", "-"],
            &["monitor", "wrong.tlog", "--plain"],
        ] {
            let output = autoquad(&folder, arguments);
            assert!(!output.stdout.is_empty(), "{kind} {arguments:?}");
            said(output, 0, "");
        }
    }
}

/// `nohup` says that a hang-up is nothing to end for.
#[cfg(target_os = "linux")]
#[test]
fn who_wants_no_hang_up_gets_none() {
    // Where the tests themselves run under `nohup`, all that they start does.
    let inherited = ignores_hang_up("self");
    for (trap, ignored) in [("trap '' HUP;", true), ("", inherited)] {
        let folder = tempfile::tempdir().unwrap();
        let script = format!("{trap} exec \"$0\" record udpin:127.0.0.1:0 new.tlog --for 1m");
        let mut shell = Command::new("sh");
        shell.args(["-c", &script, env!("CARGO_BIN_EXE_autoquad")]).current_dir(&folder);
        let child = shell.stdin(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
        let waits = (0..1_000).take_while(|_| !folder.path().join("new.tlog").exists());
        waits.for_each(|_| std::thread::sleep(Duration::from_millis(10)));
        assert_eq!(ignores_hang_up(&child.id().to_string()), ignored);
        let signal = if ignored { "-TERM" } else { "-HUP" };
        assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
        said(child.wait_with_output().unwrap(), 0, "0 frames recorded");
    }
}

#[cfg(target_os = "linux")]
fn ignores_hang_up(process: &str) -> bool {
    let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:")).unwrap().trim();
    u64::from_str_radix(mask, 16).unwrap() & 1 == 1
}
