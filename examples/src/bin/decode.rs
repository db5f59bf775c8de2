//! Decodes a byte stream and prints every message in it.
//!
//! `decode FILE.tlog` reads the log of a ground station, `decode FILE` any other file of frames, such as a raw serial log,
//! and `decode` alone standard input. What could not be read is counted at the end.

use std::error::Error;
use std::fs::File;
use std::io::{self, ErrorKind, Read, Write};
use std::path::Path;
use std::process::ExitCode;

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::io::FrameReader;
use mavlink_autoquad::wire::{Dialect, Encode, Frame, tlog};

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever reads the output has seen enough.
        Err(error) if error.downcast_ref().is_some_and(|error: &io::Error| error.kind() == ErrorKind::BrokenPipe) => {
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("decode: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let mut out = io::stdout().lock();
    let Some(path) = std::env::args_os().nth(1) else { return Ok(print_stream(io::stdin(), &mut out)?) };
    let path = Path::new(&path);
    let file = File::open(path).map_err(|error| format!("{}: {error}", path.display()))?;
    match path.extension() {
        Some(extension) if extension == "tlog" => Ok(print_log(file, &mut out)?),
        _ => Ok(print_stream(file, &mut out)?),
    }
}

fn print_log(input: impl Read, out: &mut impl Write) -> io::Result<()> {
    let mut reader = tlog::Reader::new(input, Autoquad::TABLE);
    while let Some(entry) = reader.read()? {
        match entry.time_us {
            Some(us) => write!(out, "{}.{:06} ", us / 1_000_000, us % 1_000_000)?,
            None => write!(out, "time unknown ")?,
        }
        print(&entry.frame, out)?;
    }
    eprintln!("{} bytes belong to no entry", reader.skipped_bytes());
    Ok(())
}

fn print_stream(input: impl Read, out: &mut impl Write) -> io::Result<()> {
    let mut reader = FrameReader::new(input, Autoquad::TABLE);
    loop {
        match reader.receive() {
            Ok(Some(frame)) => print(&frame, out)?,
            Ok(None) => break,
            // Much of it was no frame; there may be more.
            Err(error) if error.kind() == ErrorKind::WouldBlock => {}
            Err(error) => return Err(error),
        }
    }
    let counts = reader.statistics();
    eprintln!("{} frames, {} damaged, {} bytes skipped", counts.frames, counts.bad_checksums, counts.skipped_bytes);
    Ok(())
}

fn print(frame: &Frame<'_>, out: &mut impl Write) -> io::Result<()> {
    let (system, component, sequence) = (frame.system_id(), frame.component_id(), frame.sequence());
    match frame.message::<Autoquad>() {
        Some(message) => {
            writeln!(out, "{system}/{component} #{sequence} {} {message:?}", message.info().name)
        }
        None => {
            writeln!(out, "{system}/{component} #{sequence} message {} {:02x?}", frame.message_id(), frame.payload())
        }
    }
}
