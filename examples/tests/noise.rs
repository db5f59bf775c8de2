//! What makes no frame does not end the program, however much of it there is: the wrong baud rate of a recording.

use std::fs;
use std::process::Command;

use mavlink_autoquad::autoquad::Heartbeat;
use mavlink_autoquad::wire::{MAX_FRAME, Message, Sender};

#[test]
fn files_are_read_on_behind_noise() {
    let (mut sender, mut frame) = (Sender::v2(1, 1), [0; MAX_FRAME]);
    let frame = sender.encode(&Heartbeat::DEFAULT, &mut frame).unwrap();
    let path = std::env::temp_dir().join(format!("noise-{}.bin", std::process::id()));
    fs::write(&path, [&[0xFE; 200_000], frame].concat()).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_decode")).arg(&path).output().unwrap();
    let (text, said) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert!(output.status.success() && text.starts_with("1/1 #0 HEARTBEAT "), "{text}{said}");
    fs::remove_file(&path).unwrap();
}
