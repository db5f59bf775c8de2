//! Decodes a byte stream and prints every message in it.
//!
//! `decode FILE.tlog` reads the log of a ground station, `decode FILE` any other file of frames, such as a raw serial log,
//! and `decode` alone standard input. What could not be read is counted at the end.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::io::FrameReader;
use mavlink_autoquad::wire::{Dialect, Encode, Frame, tlog};

fn main() -> io::Result<()> {
    match std::env::args_os().nth(1) {
        Some(path) if Path::new(&path).extension().is_some_and(|extension| extension == "tlog") => {
            print_log(File::open(path)?)
        }
        Some(path) => print_stream(File::open(path)?),
        None => print_stream(io::stdin()),
    }
}

fn print_log(input: impl Read) -> io::Result<()> {
    let mut reader = tlog::Reader::new(input, Autoquad::TABLE);
    while let Some(entry) = reader.read()? {
        match entry.time_us {
            Some(us) => print!("{}.{:06} ", us / 1_000_000, us % 1_000_000),
            None => print!("time unknown "),
        }
        print(&entry.frame);
    }
    eprintln!("{} bytes belong to no entry", reader.skipped_bytes());
    Ok(())
}

fn print_stream(input: impl Read) -> io::Result<()> {
    let mut reader = FrameReader::new(input, Autoquad::TABLE);
    while let Some(frame) = reader.receive()? {
        print(&frame);
    }
    let counts = reader.statistics();
    eprintln!("{} frames, {} damaged, {} bytes skipped", counts.frames, counts.bad_checksums, counts.skipped_bytes);
    Ok(())
}

fn print(frame: &Frame<'_>) {
    let (system, component, sequence) = (frame.system_id(), frame.component_id(), frame.sequence());
    match frame.message::<Autoquad>() {
        Some(message) => {
            println!("{system}/{component} #{sequence} {} {message:?}", message.info().name)
        }
        None => println!("{system}/{component} #{sequence} message {} {:02x?}", frame.message_id(), frame.payload()),
    }
}
