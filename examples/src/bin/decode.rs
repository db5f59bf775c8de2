//! Decodes a byte stream and prints every message in it.
//!
//! `decode FILE` reads a file of frames (a raw serial log, or a tlog: what lies between frames is skipped), `decode` alone
//! reads standard input.

use std::error::Error;
use std::fs::File;
use std::io::{self, Read};

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::{Dialect, Encode, Frame, Parser};

fn main() -> Result<(), Box<dyn Error>> {
    let mut input: Box<dyn Read> = match std::env::args_os().nth(1) {
        Some(path) => Box::new(File::open(path)?),
        None => Box::new(io::stdin()),
    };
    let mut parser = Parser::new(Autoquad::TABLE);
    let mut buffer = [0; 4096];
    loop {
        let received = input.read(&mut buffer)?;
        if received == 0 {
            break;
        }
        let mut chunk = buffer.get(..received).unwrap_or_default();
        while let Some(frame) = parser.next(&mut chunk) {
            print(&frame);
        }
    }
    while let Some(frame) = parser.finish() {
        print(&frame);
    }
    Ok(())
}

fn print(frame: &Frame<'_>) {
    let (system, component, sequence) = (frame.system(), frame.component(), frame.sequence());
    match frame.message::<Autoquad>() {
        Some(message) => {
            println!("{system}/{component} #{sequence} {} {message:?}", message.info().name)
        }
        None => println!("{system}/{component} #{sequence} message {} {:02x?}", frame.id(), frame.payload()),
    }
}
