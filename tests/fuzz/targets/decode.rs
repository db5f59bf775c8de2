//! Any payload of any message: decoded and encoded it is the same, and views and accessors take what is in it.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavlink_autoquad::autoquad::{AqEscTelemetry, Autoquad};
use mavlink_autoquad::esc::EscTable;
use mavlink_autoquad::wire::{Dialect, Encode, MAX_PAYLOAD, Message};

fuzz_target!(|input: (u8, Vec<u8>)| {
    let (pick, payload) = input;
    let infos: Vec<_> = Autoquad::TABLE.iter().collect();
    let info = infos[usize::from(pick) % infos.len()];
    let message = Autoquad::decode(info.id, &payload).expect("a message of the table");
    let mut encoded = [0; MAX_PAYLOAD];
    message.write(&mut encoded);
    let mut expected = [0; MAX_PAYLOAD];
    let length = payload.len().min(usize::from(info.len_v2));
    expected[..length].copy_from_slice(&payload[..length]);
    assert_eq!(encoded, expected, "{}", info.name);
    let _ = format!("{message:?}");

    let telemetry = AqEscTelemetry::decode(&payload);
    for esc in telemetry.escs() {
        let _ = format!("{esc:?}");
    }
    for esc in telemetry.legacy_escs() {
        let _ = format!("{esc:?}");
    }
    let mut table = EscTable::new();
    table.update(&telemetry);
});
