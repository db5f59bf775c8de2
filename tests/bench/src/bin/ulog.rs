//! All `esc_status` of a log, beside PX4's own reader: `cargo run --release --features ulog --bin ulog`.
//!
//! The log is as large as that of a real flight: 2.9 MB with 320 messages among others of 109 topics, and 900 parameters.
//! `ULOG=FILE` takes another.

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use mavlink_autoquad::px4::{EscReport, EscStatus};
use mavlink_autoquad::wire::uorb::Topic;
use mavlink_autoquad::wire::uorb::ulog::Log;
use mavlink_bench::random::Random;
use mavlink_bench::rounds::{Contender, compare};
use px4_ulog::stream_parser::file_reader::{LogParser, Message, SimpleCallbackResult, read_file_with_simple_callback};
use px4_ulog::stream_parser::model::DataMessage;

const BYTES: usize = 2_900_000;
const STATUSES: usize = 320;
const TOPICS: u16 = 109;
const PARAMETERS: usize = 900;
/// Fields of the largest topic, beside its time.
const FIELDS: u16 = 40;

fn main() -> Result<(), Box<dyn Error>> {
    let made = std::env::temp_dir().join(format!("mavlink-bench-{}.ulg", std::process::id()));
    let path = match std::env::var_os("ULOG") {
        Some(path) => PathBuf::from(path),
        None => {
            fs::write(&made, log()?)?;
            made.clone()
        }
    };
    let bytes = fs::read(&path)?;
    let name = path.to_str().ok_or("the path is no text")?;
    let expected = sum(&bytes);
    assert_eq!((expected, expected), (streamed(name), streamed_in_memory(&bytes)), "sums of all speeds");
    let count = Log::new(&bytes)?.read::<EscStatus>().count();
    let each = |work: &dyn Fn() -> i64| if work() == expected { count } else { 0 };
    compare(
        "in memory",
        vec![
            Contender::new("typed", || each(&|| sum(&bytes))),
            Contender::new("px4-ulog, three fields", || each(&|| streamed_in_memory(&bytes))),
        ],
    );
    compare(
        "with the file read",
        vec![
            Contender::new("typed", || each(&|| fs::read(&path).map_or(0, |bytes| sum(&bytes)))),
            Contender::new("px4-ulog, three fields", || each(&|| streamed(name))),
        ],
    );
    fs::remove_file(&made).or_else(|error| if path == made { Err(error) } else { Ok(()) })?;
    Ok(())
}

/// The sum of all speeds, of whole messages.
fn sum(bytes: &[u8]) -> i64 {
    let Ok(log) = Log::new(bytes) else { return 0 };
    let speeds = |status: &EscStatus| status.esc.iter().map(|esc| i64::from(esc.esc_rpm)).sum::<i64>();
    log.read::<EscStatus>().map(|(_, status)| speeds(&std::hint::black_box(status))).sum()
}

/// The same by the peer, which looks fields up by name: the speeds and no other field.
#[derive(Default)]
struct Speeds {
    places: Option<Vec<usize>>,
    sum: i64,
}

impl Speeds {
    fn add(&mut self, data: &DataMessage<'_>) {
        if data.flattened_format.message_name() != "esc_status" {
            return;
        }
        let places = self.places.get_or_insert_with(|| {
            let place = |k| data.flattened_format.get_field_parser::<i32>(&format!("esc[{k}].esc_rpm")).ok();
            (0..12).filter_map(place).map(|parser| usize::from(parser.offset())).collect()
        });
        for at in places {
            let bytes = data.data.get(*at..).and_then(<[u8]>::first_chunk).copied();
            self.sum += i64::from(bytes.map_or(0, i32::from_le_bytes));
        }
    }
}

fn streamed_in_memory(bytes: &[u8]) -> i64 {
    let mut speeds = Speeds::default();
    let mut add = |data: &DataMessage<'_>| speeds.add(data);
    let mut parser = LogParser::default();
    parser.set_data_message_callback(&mut add);
    let whole = parser.consume_bytes(bytes).is_ok();
    drop(parser);
    if whole { speeds.sum } else { 0 }
}

fn streamed(path: &str) -> i64 {
    let mut speeds = Speeds::default();
    let mut take = |message: &Message<'_>| {
        if let Message::Data(data) = message {
            speeds.add(data);
        }
        SimpleCallbackResult::KeepReading
    };
    let whole = read_file_with_simple_callback(path, &mut take).is_ok();
    if whole { speeds.sum } else { 0 }
}

/// A log of one vehicle: `esc_status` among other topics.
fn log() -> Result<Vec<u8>, Box<dyn Error>> {
    let newest = EscStatus::DEFINITIONS.first().ok_or("no definition")?;
    let mut log = [b"ULog\x01\x12\x35\x01".as_slice(), &[0; 8]].concat();
    record(&mut log, b'B', &[&[0; 40]])?;
    newest.formats.iter().try_for_each(|format| record(&mut log, b'F', &[format.as_bytes()]))?;
    for topic in 1..=TOPICS {
        let fields: String = (0..fields_of(topic)).map(|field| format!("float value_{field};")).collect();
        record(&mut log, b'F', &[format!("other_{topic}:uint64_t timestamp;{fields}").as_bytes()])?;
    }
    for number in 0..PARAMETERS {
        let key = format!("float PARAMETER_{number}");
        record(&mut log, b'P', &[&[key.len() as u8], key.as_bytes(), &[0; 4]])?;
    }
    record(&mut log, b'A', &[&[0, 0, 0], b"esc_status"])?;
    for topic in 1..=TOPICS {
        record(&mut log, b'A', &[&[0], &topic.to_le_bytes(), format!("other_{topic}").as_bytes()])?;
    }
    let mut random = Random::new(152);
    let mut data = vec![0; 512];
    for number in 0..STATUSES {
        while log.len() < BYTES / STATUSES * number {
            let topic = 1 + (random.bits() % u64::from(TOPICS)) as u16;
            data.resize(8 + 4 * usize::from(fields_of(topic)), number as u8);
            record(&mut log, b'D', &[&topic.to_le_bytes(), &data])?;
        }
        let mut status = EscStatus { timestamp: number as u64, esc_count: 4, ..EscStatus::UNKNOWN };
        for (function, esc) in (101..).zip(&mut status.esc) {
            let esc_rpm = (random.bits() % 10_000) as i32;
            *esc = EscReport { esc_rpm, actuator_function: function, ..EscReport::UNKNOWN };
        }
        let mut bytes = vec![0; newest.record_len as usize];
        status.store_record(&mut bytes)?;
        record(&mut log, b'D', &[&[0, 0], &bytes])?;
    }
    Ok(log)
}

fn fields_of(topic: u16) -> u16 {
    1 + topic % FIELDS
}

fn record(log: &mut Vec<u8>, kind: u8, parts: &[&[u8]]) -> Result<(), std::num::TryFromIntError> {
    let length = u16::try_from(parts.iter().map(|part| part.len()).sum::<usize>())?;
    log.extend(length.to_le_bytes());
    log.push(kind);
    parts.iter().for_each(|part| log.extend_from_slice(part));
    Ok(())
}
