//! `EscStatus` of 491 bytes from CDR and to it, beside the serde crates cdr and cdr-encoding with types written by hand.

use std::error::Error;
use std::hint::black_box;

use byteorder::LittleEndian;
use mavlink_autoquad::px4;
use mavlink_autoquad::wire::uorb::{Topic, TopicByLength};
use mavlink_bench::rounds::{Contender, compare};
use serde::{Deserialize, Serialize};

/// Messages of one round.
const MESSAGES: usize = 20_000;

#[derive(Clone, Copy, Default, Serialize, Deserialize)]
struct EscReport {
    timestamp: u64,
    esc_errorcount: u32,
    esc_rpm: i32,
    esc_voltage: f32,
    esc_current: f32,
    esc_temperature: f32,
    motor_temperature: i16,
    esc_state: u8,
    actuator_function: u8,
    failures: u16,
    esc_power: i8,
}

#[derive(Clone, Copy, Default, Serialize, Deserialize)]
struct EscStatus {
    timestamp: u64,
    counter: u16,
    esc_count: u8,
    esc_connectiontype: u8,
    esc_online_flags: u16,
    esc_armed_flags: u16,
    esc: [EscReport; 12],
}

/// Does the work for each message of a round.
fn round(mut work: impl FnMut()) -> usize {
    (0..MESSAGES).for_each(|_| work());
    MESSAGES
}

/// What is made is not thrown away before it is.
fn kept<T>(made: T) {
    black_box(made);
}

fn main() -> Result<(), Box<dyn Error>> {
    let report = px4::EscReport { timestamp: 1, esc_rpm: -4_000, esc_voltage: 15.1, ..px4::EscReport::UNKNOWN };
    let status = px4::EscStatus { timestamp: 2, esc_count: 12, esc: [report; 12], ..px4::EscStatus::UNKNOWN };
    let (definition, mut buffer, mut again) = (px4::EscStatus::MAIN, [0; 512], [0; 512]);
    let payload = status.to_cdr(&definition, &mut buffer)?;
    let body = payload.get(4..).unwrap_or_default();
    let theirs: EscStatus = cdr::deserialize(payload)?;
    assert_eq!(cdr::serialize::<_, _, cdr::CdrLe>(&theirs, cdr::Infinite)?, payload, "another message");
    assert_eq!(cdr_encoding::to_vec::<_, LittleEndian>(&theirs)?, body, "another message");

    let read = || round(|| kept(px4::EscStatus::from_cdr(black_box(payload))));
    let by_cdr = || round(|| kept(cdr::deserialize::<EscStatus>(black_box(payload))));
    let by_encoding = || round(|| kept(cdr_encoding::from_bytes::<EscStatus, LittleEndian>(black_box(body))));
    for (name, peer) in
        [("cdr", Contender::new("cdr", by_cdr)), ("cdr-encoding", Contender::new("cdr-encoding", by_encoding))]
    {
        compare(&format!("read, {name}"), vec![Contender::new("ours", read), peer]);
    }
    let write = || round(|| kept(black_box(&status).to_cdr(&definition, &mut again).is_ok()));
    let by_encoding = || round(|| kept(cdr_encoding::to_vec::<_, LittleEndian>(black_box(&theirs))));
    compare("write", vec![Contender::new("ours", write), Contender::new("cdr-encoding", by_encoding)]);
    Ok(())
}
