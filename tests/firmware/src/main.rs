//! A gateway: AutoQuad's ESC telemetry in, ESC_INFO and ESC_STATUS of the common dialect out, until it is told to shut down.

#![no_std]
#![no_main]

mod panic;
mod uart;

use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};
use mavlink_autoquad::autoquad::{AqEscTelemetry, CommandLong, Heartbeat, MavCmd, MavState};
use mavlink_autoquad::esc::{Conversion, EscTable};
use mavlink_autoquad::wire::embedded_io::{FrameReader, FrameWriter, ReceiveError};
use mavlink_autoquad::wire::{Message, Sender, Table};

use uart::Uart;

static RECEIVED: Table<'static> = Table::of(&[Heartbeat::INFO, CommandLong::INFO, AqEscTelemetry::INFO]);
const BEAT: Heartbeat = Heartbeat { system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT };

#[entry]
fn main() -> ! {
    gateway(Uart::new(), Uart::new());
    debug::exit(EXIT_SUCCESS);
    loop {
        core::hint::spin_loop();
    }
}

fn gateway(rx: Uart, tx: Uart) {
    let (mut reader, mut writer) = (FrameReader::new(rx, &RECEIVED), FrameWriter::new(tx, Sender::v2(1, 99)));
    let mut escs = EscTable::new();
    loop {
        let frame = match reader.receive() {
            Ok(Some(frame)) => frame,
            Ok(None) => break,
            // Noise, as of a wrong baud rate: here a firmware that has more to do looks at its clock.
            Err(ReceiveError::NothingYet) => continue,
        };
        if frame.decode::<Heartbeat>().is_some() {
            sent(writer.send(&BEAT));
        } else if let Some(telemetry) = frame.decode::<AqEscTelemetry>() {
            escs.update(&telemetry);
            let (now_us, options) = (escs.uptime_us(), Conversion::DEFAULT);
            if let Some(info) = escs.to_esc_info(0, now_us, &options) {
                sent(writer.send(&info));
            }
            if let Some(status) = escs.to_esc_status(0, now_us, &options) {
                sent(writer.send(&status));
            }
        } else if let Some(command) = frame.decode::<CommandLong>()
            && command.command == MavCmd::PREFLIGHT_REBOOT_SHUTDOWN
        {
            break;
        }
    }
}

/// MAVLink 2 carries each of these messages, and the UART takes every byte.
fn sent<E>(result: Result<(), E>) {
    if result.is_err() {
        debug::exit(EXIT_FAILURE);
    }
}
