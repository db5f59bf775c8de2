//! `mavlink_autoquad::esc`, and the views that it rests on.

mod clock;
mod convert;
mod disarm;
mod golden;
mod layout;
mod members;
mod properties;
mod table;

use mavlink_autoquad::autoquad::{AqEscTelemetry, Esc, Esc32State, Esc32Status};
use mavlink_autoquad::wire::Message;

/// A controller that runs, with firmware 2.1.
fn running(id: u8, rpm: u16) -> Esc {
    let mut status = Esc32Status::from_bits(0, 21);
    status.set_state(Esc32State::RUNNING).unwrap();
    status.set_voltage_raw(1500).unwrap();
    status.set_rpm(rpm).unwrap();
    Esc { id, age_ms: Some(5), status: Some(status) }
}

/// A batch with these controllers.
fn batch(time_boot_ms: u32, seq: u8, num_motors: u8, escs: &[Esc]) -> AqEscTelemetry {
    let mut telemetry = AqEscTelemetry { time_boot_ms, seq, num_motors, ..AqEscTelemetry::DEFAULT };
    for &esc in escs {
        telemetry.push_esc(esc).unwrap();
    }
    telemetry
}

/// All batches of a cycle; motor `n` of `1..=num_motors` runs at `rpm + n`.
fn cycle(time_boot_ms: u32, num_motors: u8, rpm: u16) -> Vec<AqEscTelemetry> {
    let escs: Vec<Esc> = (1..=num_motors).map(|id| running(id, rpm + u16::from(id))).collect();
    let batches = escs.chunks(4).zip(1..);
    batches.map(|(escs, seq)| batch(time_boot_ms, seq, num_motors, escs)).collect()
}
