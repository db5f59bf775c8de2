//! PX4's own reader of logs, `px4-ulog`: it reads what we write, and our types read records that it found.

use std::fs;
use std::path::Path;

use mavlink_autoquad::px4::{EscFailures, EscStatus};
use mavlink_autoquad::wire::uorb::ulog::{Binding, Log, Writer};
use px4_ulog::stream_parser::file_reader::{Message, SimpleCallbackResult, read_file_with_simple_callback};

/// What it finds of `esc_status`: the instance, the message by our binding, and the speed of the second motor by its own.
fn read(path: &Path, binding: &Binding<EscStatus>) -> Vec<(u8, EscStatus, i32)> {
    let mut found = Vec::new();
    let mut take = |message: &Message<'_>| {
        if let Message::Data(data) = message
            && data.flattened_format.message_name() == "esc_status"
        {
            let rpm = data.flattened_format.get_field_parser::<i32>("esc[1].esc_rpm").unwrap().parse(data.data);
            // Its data begins with the id of the subscription.
            found.push((data.multi_id.value(), binding.read(&data.data[2..]).unwrap(), rpm));
        }
        SimpleCallbackResult::KeepReading
    };
    read_file_with_simple_callback(path.to_str().unwrap(), &mut take).unwrap();
    found
}

/// Both readers give the same; as text, since NaN is not equal to itself.
fn compare(path: &Path, expected: usize) {
    let bytes = fs::read(path).unwrap();
    let log = Log::new(&bytes).unwrap();
    let ours: Vec<_> = log.read::<EscStatus>().map(|(instance, status)| format!("{instance} {status:?}")).collect();
    // The definitions are enough to bind: a program that streams has no more of the file.
    let theirs = read(path, &Log::new(&bytes[..1000]).unwrap().bind("esc_status").unwrap());
    assert!(theirs.iter().all(|(_, status, rpm)| status.esc[1].esc_rpm == *rpm));
    let theirs: Vec<_> = theirs.iter().map(|(instance, status, _)| format!("{instance} {status:?}")).collect();
    assert_eq!((ours.len(), theirs), (expected, ours));
}

#[test]
fn logs_of_three_definitions() {
    for name in ["main", "v2026_02", "v1_14"] {
        compare(&Path::new("../vectors/px4").join(format!("{name}.ulg")), 2);
    }
}

#[test]
fn logs_that_we_write() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("written.ulg");
    let mut log = Writer::new(Vec::new(), 5).info("sys_name", "AutoQuad").topic::<EscStatus>().begin().unwrap();
    for i in 0..50_u8 {
        let mut status = EscStatus { timestamp: 1000 + u64::from(i), counter: i.into(), ..EscStatus::UNKNOWN };
        status.esc[1].esc_rpm = i32::from(i) * 100 - 70;
        status.esc[1].failures = EscFailures::from_bits_retain(1 << (i % 16));
        log.write(i % 3, &status).unwrap();
    }
    fs::write(&path, log.finish().unwrap()).unwrap();
    compare(&path, 50);
}
