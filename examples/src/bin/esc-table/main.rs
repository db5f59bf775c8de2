//! Shows the motor controllers of AutoQuads: a line each with its values, state and age, and a warning where one failed.
//!
//! * `esc-table udp ADDRESS` listens, for example on `0.0.0.0:14550`, and asks every AutoQuad that it hears for telemetry;
//! * `esc-table tlog FILE` reads a recording, or any other file of frames;
//! * `esc-table --simulate` shows four motors that it makes up, and ends by itself.

mod display;
mod simulator;

use std::error::Error;
use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::net::UdpSocket;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use display::Display;
use mavlink_autoquad::autoquad::{Autoquad, Heartbeat, MavAutopilot, MavComponent, MavDataStream, RequestDataStream};
use mavlink_autoquad::wire::io::FrameReader;
use mavlink_autoquad::wire::udp::Endpoint;
use mavlink_autoquad::wire::{Dialect, Frame, Message, Sender, Targeted};

const USAGE: &str = "usage: esc-table udp ADDRESS | tlog FILE | --simulate";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever reads the output has seen enough.
        Err(error) if error.downcast_ref().is_some_and(|error: &io::Error| error.kind() == ErrorKind::BrokenPipe) => {
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("esc-table: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut display = Display::new(io::stdout().lock());
    match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["udp", address] => {
            let socket = UdpSocket::bind(address).map_err(|error| format!("{address}: {error}"))?;
            Ok(listen(socket, &mut display)?)
        }
        ["tlog", path] => {
            let file = File::open(path).map_err(|error| format!("{path}: {error}"))?;
            Ok(read(file, &mut display)?)
        }
        ["--simulate"] => Ok(read(simulator::Stream::default(), &mut display)?),
        _ => Err(USAGE.into()),
    }
}

/// Shows what a file has to say. What lies between its frames, like the times of a tlog, is skipped.
fn read(input: impl Read, display: &mut Display<impl io::Write>) -> io::Result<()> {
    let mut reader = FrameReader::new(input, Autoquad::TABLE);
    loop {
        match reader.receive() {
            Ok(Some(frame)) => display.receive(&frame)?,
            Ok(None) => return Ok(()),
            // Much of it was no frame; there may be more.
            Err(error) if error.kind() == ErrorKind::WouldBlock => {}
            Err(error) => return Err(error),
        }
    }
}

/// Shows what comes in, and once a second how what has fallen silent ages.
fn listen(socket: UdpSocket, display: &mut Display<impl io::Write>) -> io::Result<()> {
    const SECOND: Duration = Duration::from_secs(1);
    socket.set_read_timeout(Some(SECOND))?;
    let mut station = Endpoint::new(socket, Autoquad::TABLE, Sender::v1(255, MavComponent::MISSIONPLANNER));
    let mut shown = Instant::now();
    loop {
        match station.receive() {
            Ok((frame, from)) => {
                display.receive(&frame)?;
                if let Some(request) = request(&frame) {
                    station.send_to(&request, from)?;
                }
            }
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => {}
            Err(error) => return Err(error),
        }
        if shown.elapsed() >= SECOND {
            display.show_silent(SECOND)?;
            shown = Instant::now();
        }
    }
}

/// What asks for telemetry, which AutoQuad does not send by itself, whenever there is a heartbeat: a request may get lost.
fn request(frame: &Frame<'_>) -> Option<RequestDataStream> {
    let heartbeat: Heartbeat = frame.decode()?;
    let request = RequestDataStream {
        req_stream_id: MavDataStream::PROPULSION,
        req_message_rate: 10,
        start_stop: 1,
        ..RequestDataStream::DEFAULT
    };
    (heartbeat.autopilot == MavAutopilot::AUTOQUAD).then(|| request.to(frame.system_id(), frame.component_id()))
}
