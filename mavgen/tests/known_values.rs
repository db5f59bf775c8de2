//! What the dialect of this repository resolves to, held against numbers that pymavlink 2.4.50 made from it.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::path::Path;

use mavgen::Resolved;
use mavgen::diag::{Code, Diagnostics};
use mavgen::ir::{Dialect, Enum, Message, Repr, Values};
use mavgen::read::load;
use mavgen::source::Sources;

/// Name, id, crc_extra, length in MAVLink 1, length in MAVLink 2.
const MESSAGES: [(&str, u32, u8, u8, u8); 43] = [
    ("HEARTBEAT", 0, 50, 9, 9),
    ("SYS_STATUS", 1, 124, 31, 43),
    ("SYSTEM_TIME", 2, 137, 12, 12),
    ("PING", 4, 237, 14, 14),
    ("PARAM_VALUE", 22, 220, 25, 25),
    ("PARAM_SET", 23, 168, 23, 23),
    ("GPS_RAW_INT", 24, 24, 30, 52),
    ("GPS_STATUS", 25, 23, 101, 101),
    ("RAW_IMU", 27, 144, 26, 29),
    ("ATTITUDE", 30, 39, 28, 28),
    ("GLOBAL_POSITION_INT", 33, 104, 28, 28),
    ("MISSION_ITEM_INT", 73, 38, 37, 38),
    ("MISSION_COUNT", 44, 221, 4, 9),
    ("MISSION_ACK", 47, 153, 3, 8),
    ("MANUAL_CONTROL", 69, 243, 11, 30),
    ("RC_CHANNELS_OVERRIDE", 70, 124, 18, 38),
    ("COMMAND_INT", 75, 158, 35, 35),
    ("COMMAND_LONG", 76, 152, 33, 33),
    ("COMMAND_ACK", 77, 143, 3, 10),
    ("REQUEST_DATA_STREAM", 66, 148, 6, 6),
    ("FILE_TRANSFER_PROTOCOL", 110, 84, 254, 254),
    ("TIMESYNC", 111, 34, 16, 18),
    ("SERIAL_CONTROL", 126, 220, 79, 81),
    ("BATTERY_STATUS", 147, 154, 36, 54),
    ("AUTOPILOT_VERSION", 148, 178, 60, 78),
    ("AQ_TELEMETRY_F", 150, 241, 82, 82),
    ("AQ_ESC_TELEMETRY", 152, 115, 55, 55),
    ("STATUSTEXT", 253, 83, 51, 54),
    ("DEBUG", 254, 46, 9, 9),
    ("SETUP_SIGNING", 256, 71, 42, 42),
    ("CAMERA_IMAGE_CAPTURED", 263, 133, 255, 255),
    ("GIMBAL_DEVICE_INFORMATION", 283, 74, 144, 149),
    ("LOGGING_DATA", 266, 193, 255, 255),
    ("LOGGING_DATA_ACKED", 267, 35, 255, 255),
    ("PROTOCOL_VERSION", 300, 217, 22, 22),
    ("ODOMETRY", 331, 91, 230, 233),
    ("DEBUG_FLOAT_ARRAY", 350, 232, 20, 252),
    ("ESC_INFO", 290, 251, 46, 46),
    ("OPEN_DRONE_ID_SYSTEM", 12904, 77, 54, 54),
    ("TUNNEL", 385, 147, 133, 133),
    ("WHEEL_DISTANCE", 9000, 113, 137, 137),
    ("ENCAPSULATED_DATA", 131, 223, 255, 255),
    ("AVAILABLE_MODES_MONITOR", 437, 30, 1, 1),
];

fn autoquad() -> (Dialect, Vec<(Code, String)>) {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let loaded = load(Path::new("../xml/autoquad.xml"), &[], &[], &mut sources, &mut diagnostics);
    let resolved = Resolved::of(loaded, sources, diagnostics).unwrap();
    let problems = resolved.diagnostics.iter().map(|problem| (problem.code, problem.message.clone()));
    let problems = problems.collect();
    (resolved.dialect, problems)
}

fn message<'d>(dialect: &'d Dialect, name: &str) -> &'d Message {
    dialect.messages.iter().find(|message| message.name.text == name).unwrap()
}

fn find_enum<'d>(dialect: &'d Dialect, name: &str) -> &'d Enum {
    dialect.enums.iter().find(|found| found.name.text == name).unwrap()
}

#[test]
fn checksums_and_lengths() {
    let (dialect, _) = autoquad();
    for (name, id, crc_extra, len_v1, len_v2) in MESSAGES {
        let found = message(&dialect, name);
        let numbers = (found.id, found.crc_extra, found.len_v1, found.len_v2);
        assert_eq!(numbers, (id, crc_extra, len_v1, len_v2), "{name}");
    }
}

/// Fields in wire order, each with its offset.
#[test]
fn layouts() {
    let (dialect, _) = autoquad();
    let layout = |name: &str| -> Vec<(String, u8)> {
        let fields = message(&dialect, name).wire_order();
        fields.iter().map(|field| (field.name.text.clone(), field.offset)).collect()
    };
    let expect = |name: &str, expected: &[(&str, u8)]| {
        let expected: Vec<_> = expected.iter().map(|(name, at)| ((*name).to_owned(), *at)).collect();
        assert_eq!(layout(name), expected);
    };
    #[rustfmt::skip]
    expect("GPS_RAW_INT", &[
        ("time_usec", 0), ("lat", 8), ("lon", 12), ("alt", 16), ("eph", 20), ("epv", 22), ("vel", 24), ("cog", 26),
        ("fix_type", 28), ("satellites_visible", 29), ("alt_ellipsoid", 30), ("h_acc", 34), ("v_acc", 38),
        ("vel_acc", 42), ("hdg_acc", 46), ("yaw", 50),
    ]);
    #[rustfmt::skip]
    expect("AQ_ESC_TELEMETRY", &[
        ("time_boot_ms", 0), ("data0", 4), ("data1", 20), ("status_age", 36), ("seq", 44), ("num_motors", 45),
        ("num_in_seq", 46), ("escid", 47), ("data_version", 51),
    ]);
    let telemetry = message(&dialect, "AQ_TELEMETRY_F");
    assert_eq!((telemetry.fields[0].name.text.as_str(), telemetry.fields[0].offset), ("Index", 80));
}

#[test]
fn integers_and_owners_of_enums() {
    let (dialect, _) = autoquad();
    for (name, repr, owner) in [
        ("MAV_STATE", Repr::U8, "minimal.xml"),
        ("MAV_CMD", Repr::U16, "common.xml"),
        ("MAV_DATA_STREAM", Repr::U8, "common.xml"),
        ("MAV_BOOL", Repr::U8, "standard.xml"),
        ("GIMBAL_DEVICE_CAP_FLAGS", Repr::U32, "common.xml"),
        ("MAV_PROTOCOL_CAPABILITY", Repr::U64, "standard.xml"),
        ("AUTOQUAD_NAV_STATUS", Repr::U32, "autoquad.xml"),
    ] {
        let found = find_enum(&dialect, name);
        let file = dialect.file(found.defined_in).map(|file| file.name.as_str());
        assert_eq!((found.repr, file), (repr, Some(owner)), "{name}");
    }
    let converted = dialect.messages.iter().flat_map(|message| &message.fields);
    let converted = converted.filter(|field| matches!(field.values, Some(Values::Converted(_))));
    let names: Vec<&str> = converted.map(|field| field.name.text.as_str()).collect();
    assert_eq!(names, ["capture_result", "cap_flags"]);
}

/// The two entries without a value, and the few things that are odd about upstream's files.
#[test]
fn nothing_else_is_odd() {
    let (dialect, problems) = autoquad();
    let streams = &find_enum(&dialect, "MAV_DATA_STREAM").entries;
    let last = streams.last().unwrap();
    assert_eq!((last.name.text.as_str(), last.value, last.auto), ("MAV_DATA_STREAM_PROPULSION", 13, true));
    let mut codes: Vec<Code> = problems.iter().map(|(code, _)| *code).collect();
    codes.sort_unstable();
    let expected = [
        Code::ValueBeyondField,
        Code::EnumWidths,
        Code::EnumWidths,
        Code::AutomaticValue,
        Code::AutomaticValue,
        Code::LikelyBitmask,
    ];
    assert_eq!(codes, expected, "{problems:#?}");
}
