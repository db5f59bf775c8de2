//! Five messages of AutoQuad, with what they need and nothing else. That they compile alone is for the library to show.

use std::path::{Path, PathBuf};

use mavlink_autoquad::autoquad::{self, Autoquad};
use mavlink_conformance::dialects::selected::{AqEscTelemetry, GpsRawInt, Heartbeat, MavCmd, MavModeFlag, Selected};
use mavlink_conformance::random::Random;
use mavlink_wire::{Dialect, Encode, Message};

#[test]
fn five_messages_are_five_messages() {
    let names: Vec<&str> = Selected::TABLE.iter().map(|info| info.name).collect();
    assert_eq!(names, ["HEARTBEAT", "GPS_RAW_INT", "COMMAND_ACK", "RADIO_STATUS", "AQ_ESC_TELEMETRY"]);
}

#[test]
fn they_are_what_they_are_in_the_whole_dialect() {
    let mut random = Random::new(5);
    for info in Selected::TABLE.iter() {
        assert_eq!(Some(info), Autoquad::TABLE.get(info.id));
        let payload: Vec<u8> = (0..info.len_v2).map(|_| random.below(256) as u8).collect();
        let (ours, theirs) =
            (Selected::decode(info.id, &payload).unwrap(), Autoquad::decode(info.id, &payload).unwrap());
        assert_eq!(format!("{ours:?}"), format!("{theirs:?}"));
    }
    assert_eq!(Heartbeat::FIELDS.len(), autoquad::Heartbeat::FIELDS.len());
}

#[test]
fn views_and_enums_come_along() {
    let telemetry = AqEscTelemetry { num_in_seq: 2, ..AqEscTelemetry::DEFAULT };
    assert_eq!(telemetry.escs().count(), 2);
    assert_eq!((MavModeFlag::SAFETY_ARMED.bits(), MavCmd::NAV_WAYPOINT.0), (128, 16));
    assert_eq!(GpsRawInt::DEFAULT.info().crc_extra, 24);
}

/// The folder of generated sources, and how many files and bytes are in it.
fn size(folder: &Path) -> (usize, u64) {
    let (mut files, mut bytes) = (0, 0);
    for entry in std::fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let of_entry = if entry.path().is_dir() { size(&entry.path()) } else { (1, entry.metadata().unwrap().len()) };
        (files, bytes) = (files + of_entry.0, bytes + of_entry.1);
    }
    (files, bytes)
}

#[test]
fn without_commands_it_is_small() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("selected");
    let names = ["HEARTBEAT", "SYS_STATUS", "GPS_RAW_INT", "ATTITUDE", "AQ_ESC_TELEMETRY"];
    let builder = mavgen::Builder::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../xml/autoquad.xml")).messages(names);
    builder.out_dir(&folder).generate().unwrap();
    let (files, bytes) = size(&folder);
    assert!(files < 30 && bytes < 100_000, "{files} files, {bytes} bytes");
    let root = std::fs::read_to_string(folder.join("mod.rs")).unwrap();
    assert!(
        root.contains("\n// only AQ_ESC_TELEMETRY,ATTITUDE,GPS_RAW_INT,HEARTBEAT,SYS_STATUS, and what they need\n")
    );
}
