//! Four motors that are made up: one stalls, one falls silent. The vehicle's clock starts again meanwhile.

use std::io::{self, Read};

use mavlink_autoquad::autoquad::{AqEscTelemetry, Esc, Esc32DisarmV3, Esc32State, Esc32Status, MavComponent};
use mavlink_autoquad::wire::{MAX_FRAME, Message, Sender, ViewError};

const SECONDS: u32 = 6;
const STALLS_AT: u32 = 2;
const FALLS_SILENT_AT: u32 = 3;

/// Two seconds before the 32 bits of microseconds are used up.
const START_US: u32 = 0_u32.wrapping_sub(2_000_000);

/// The bytes that the vehicle sends: one message a second.
pub(crate) struct Stream {
    second: u32,
    sender: Sender,
}

impl Default for Stream {
    fn default() -> Self {
        Self { second: 0, sender: Sender::v1(1, MavComponent::AUTOPILOT1) }
    }
}

impl Read for Stream {
    fn read(&mut self, output: &mut [u8]) -> io::Result<usize> {
        if self.second == SECONDS {
            return Ok(0);
        }
        let telemetry = telemetry(self.second).map_err(io::Error::other)?;
        let mut buffer = [0; MAX_FRAME];
        let frame = self.sender.encode(&telemetry, &mut buffer).map_err(io::Error::other)?;
        let room = output.get_mut(..frame.len()).ok_or(io::ErrorKind::InvalidInput)?;
        room.copy_from_slice(frame);
        self.second += 1;
        Ok(frame.len())
    }
}

fn telemetry(second: u32) -> Result<AqEscTelemetry, ViewError> {
    let uptime_us = START_US.wrapping_add(second * 1_000_000);
    let mut telemetry =
        AqEscTelemetry { time_boot_ms: uptime_us / 1000, seq: 1, num_motors: 4, ..AqEscTelemetry::DEFAULT };
    for id in 1..=4 {
        telemetry.push_esc(esc(id, second)?)?;
    }
    Ok(telemetry)
}

/// Motors 1 and 2 have firmware 2.1, which counts errors, 3 and 4 have 3.0, which measures the temperature.
fn esc(id: u8, second: u32) -> Result<Esc, ViewError> {
    if id == 4 && second >= FALLS_SILENT_AT {
        // After a second without an answer the status is gone, after three the age as well.
        let age_ms = u16::try_from((second - FALLS_SILENT_AT + 1) * 1000).ok().filter(|&age| age < 3000);
        return Ok(Esc { id, age_ms, status: None });
    }
    let mut status = Esc32Status::from_bits(0, if id <= 2 { 21 } else { 30 });
    status.set_voltage(15.2 - 0.02 * second as f32)?;
    if id == 3 && second >= STALLS_AT {
        status.set_state(Esc32State::DISARMED)?;
        status.set_disarm_v3(Esc32DisarmV3::CROSSING_TIMEOUT)?;
    } else {
        status.set_state(Esc32State::RUNNING)?;
        status.set_current(8.5 + 0.1 * f32::from(id))?;
        status.set_rpm(6500 + 10 * u16::from(id))?;
        status.set_duty(50.0)?;
    }
    if id <= 2 {
        status.set_errors(17)?;
    } else {
        status.set_temperature(30.0 + second as f32 / 4.0)?;
    }
    Ok(Esc { id, age_ms: Some(3 + u16::from(id)), status: Some(status) })
}
