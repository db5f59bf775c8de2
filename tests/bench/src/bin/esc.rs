//! Reading the values of four motor controllers from a decoded message, beside what it takes to have the message:
//! `cargo run --release --bin esc`.

use std::hint::black_box;

use mavlink_autoquad::autoquad::{AqEscTelemetry, Autoquad, Esc, Esc32Status};
use mavlink_autoquad::esc::{DisarmReason, EscTable};
use mavlink_autoquad::wire::{Dialect, Encode, Frame, MAX_FRAME, MAX_PAYLOAD, Message, Sender, Version, ViewError};
use mavlink_bench::random::Random;
use mavlink_bench::rounds::{Contender, compare};

const MESSAGES: u32 = 1_000;

/// One round goes over the messages this often.
const REPEATS: usize = 200;

fn main() -> Result<(), ViewError> {
    let mut random = Random::new(152);
    let messages: Vec<_> = (0..MESSAGES).map(|number| message(number, &mut random)).collect::<Result<_, _>>()?;
    let payloads: Vec<_> = messages.iter().map(payload).collect();
    let frames: Vec<_> = messages.iter().map(frame).collect();
    let mut table = EscTable::new();
    compare(
        "four ESCs",
        vec![
            Contender::new("eight values of each", || all(&messages, read)),
            Contender::new("the same, as integers", || all(&messages, read_integers)),
            Contender::new("into a table", || all(&messages, |message| _ = black_box(table.update(message)))),
            Contender::new("decode the message", || all(&payloads, |payload| decode(payload))),
            Contender::new("check and decode a frame", || all(&frames, |frame| check_and_decode(frame))),
        ],
    );
    Ok(())
}

/// Four controllers with any bits; every other has firmware 3.
fn message(number: u32, random: &mut Random) -> Result<AqEscTelemetry, ViewError> {
    let time_boot_ms = number * 5;
    let mut message = AqEscTelemetry { time_boot_ms, seq: 1, num_motors: 4, ..AqEscTelemetry::DEFAULT };
    for id in 1..=4 {
        let status = Some(Esc32Status::from_bits(random.bits() | 8, if id % 2 == 0 { 30 } else { 21 }));
        message.push_esc(Esc { id, age_ms: Some(5), status })?;
    }
    Ok(message)
}

fn payload(message: &AqEscTelemetry) -> Vec<u8> {
    message.payload(Version::V1, &mut [0; MAX_PAYLOAD]).to_vec()
}

fn frame(message: &AqEscTelemetry) -> Vec<u8> {
    Sender::v1(1, 1).encode(message, &mut [0; MAX_FRAME]).map(<[u8]>::to_vec).unwrap_or_default()
}

fn all<T>(inputs: &[T], mut work: impl FnMut(&T)) -> usize {
    for _ in 0..REPEATS {
        inputs.iter().for_each(|input| work(black_box(input)));
    }
    REPEATS * inputs.len()
}

#[inline(never)]
fn decode(payload: &[u8]) {
    black_box(&AqEscTelemetry::decode(payload));
}

#[inline(never)]
fn check_and_decode(frame: &[u8]) {
    black_box(&Frame::parse(frame, Autoquad::TABLE).ok().and_then(|frame| frame.decode::<AqEscTelemetry>()));
}

#[inline(never)]
fn read(message: &AqEscTelemetry) {
    for status in message.escs().filter_map(|esc| esc.status) {
        black_box((status.state(), status.voltage(), status.current(), status.rpm(), status.duty()));
        black_box((status.temperature(), status.errors(), DisarmReason::of(status)));
    }
}

#[inline(never)]
fn read_integers(message: &AqEscTelemetry) {
    for status in message.escs().filter_map(|esc| esc.status) {
        black_box((status.state(), status.voltage_mv(), status.current_ma(), status.rpm(), status.duty_raw()));
        black_box((status.temperature_cdegc(), status.errors(), status.disarm_v2(), status.disarm_v3()));
    }
}
