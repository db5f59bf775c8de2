//! Finding, decoding and encoding frames beside rust-mavlink: `cargo run --release --bin runtime`.

use std::error::Error;
use std::fs;
use std::hint::black_box;

use mavlink::dialects::common::MavMessage;
use mavlink::{MavlinkReader, Message as _, write_versioned_msg};
use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::autoquad::{Attitude, Heartbeat};
use mavlink_autoquad::wire::{Dialect as _, MAX_FRAME, Message as _, Parser, Sender, Table, Version};
use mavlink_bench::corpus::{Corpus, Place, their_version};
use mavlink_bench::rounds::{Contender, compare};
use mavlink_bench::{damage, golden::Golden, stream};

/// The golden frames are few: one round goes over them this often.
const GOLDEN_REPEATS: usize = 20;

fn main() -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../vectors/autoquad.txt"))?;
    let golden = Golden::read(&text);
    println!(
        "golden: {} frames; left out {} of messages that are not in the peer's dialect with this definition and {} with an enum value \
         that makes the peer refuse the message; of the rest the peer changes {} by decoding and encoding, we {}",
        golden.corpus.frames.len(),
        golden.unknown,
        golden.refused,
        changed_by_peer(&golden.corpus),
        changed_by_us(&golden.corpus)
    );
    let stream = stream::stream();
    println!(
        "stream: {} frames, {} bytes; the peer changes {}, we {}",
        stream.frames.len(),
        stream.bytes.len(),
        changed_by_peer(&stream),
        changed_by_us(&stream)
    );
    sound("golden", &golden.corpus, GOLDEN_REPEATS);
    sound("stream", &stream, 1);
    finding("lossy", &damage::lossy(&stream), 1);
    finding("corrupt", &damage::corrupt(&stream), 1);
    Ok(())
}

/// Everything that can be done with undamaged frames.
fn sound(name: &str, corpus: &Corpus, repeats: usize) {
    finding(name, &corpus.bytes, repeats);
    compare(
        &format!("{name}: decode only"),
        vec![
            Contender::new("ours, into", || repeated(repeats, || decode_only_into(corpus))),
            Contender::new("ours, by value", || repeated(repeats, || decode_only_by_value(corpus))),
            Contender::new("rust-mavlink", || repeated(repeats, || peer_decode_only(corpus))),
        ],
    );
    let (mut ours, mut theirs) = (Vec::new(), Vec::new());
    compare(
        &format!("{name}: encode"),
        vec![
            Contender::new("ours", || repeated(repeats, || encode(corpus, &mut ours))),
            Contender::new("rust-mavlink", || repeated(repeats, || peer_encode(corpus, &mut theirs))),
        ],
    );
}

/// What can be done with any stream.
fn finding(name: &str, bytes: &[u8], repeats: usize) {
    compare(
        &format!("{name}: parse"),
        vec![
            Contender::new("ours", || repeated(repeats, || parse(bytes))),
            Contender::new("ours, two messages", || repeated(repeats, || parse_two(bytes))),
            Contender::new("rust-mavlink", || repeated(repeats, || peer_parse(bytes))),
        ],
    );
    compare(
        &format!("{name}: decode"),
        vec![
            Contender::new("ours, into", || repeated(repeats, || decode_into(bytes))),
            Contender::new("ours, by value", || repeated(repeats, || decode_by_value(bytes))),
            Contender::new("rust-mavlink", || repeated(repeats, || peer_decode(bytes))),
        ],
    );
}

fn repeated(times: usize, mut work: impl FnMut() -> usize) -> usize {
    (0..times).map(|_| work()).sum()
}

fn parse(bytes: &[u8]) -> usize {
    let (mut parser, mut input, mut found) = (Parser::new(Autoquad::TABLE), bytes, 0);
    while let Some(frame) = parser.next(&mut input) {
        found += usize::from(black_box(&frame).is_verified());
    }
    while let Some(frame) = parser.finish() {
        found += usize::from(frame.is_verified());
    }
    found
}

/// The table of a firmware: nearly all frames are of messages that it does not have, and unverified.
fn parse_two(bytes: &[u8]) -> usize {
    const TABLE: &Table<'static> = &Table::of(&[Heartbeat::INFO, Attitude::INFO]);
    let (mut parser, mut input) = (Parser::new(TABLE), bytes);
    while let Some(frame) = parser.next(&mut input) {
        black_box(&frame);
    }
    while parser.finish().is_some() {}
    parser.statistics().frames as usize
}

fn peer_parse(bytes: &[u8]) -> usize {
    let (mut reader, mut found) = (MavlinkReader::new(bytes), 0);
    while let Ok(frame) = reader.read_any_raw_message::<MavMessage>() {
        black_box(&frame);
        found += 1;
    }
    found
}

fn decode_into(bytes: &[u8]) -> usize {
    let (mut parser, mut input, mut found) = (Parser::new(Autoquad::TABLE), bytes, 0);
    let mut message = Autoquad::DEFAULT;
    while let Some(frame) = parser.next(&mut input) {
        found += usize::from(frame.decode_into(&mut message));
        black_box(&message);
    }
    while let Some(frame) = parser.finish() {
        found += usize::from(frame.decode_into(&mut message));
    }
    found
}

fn decode_by_value(bytes: &[u8]) -> usize {
    let (mut parser, mut input, mut found) = (Parser::new(Autoquad::TABLE), bytes, 0);
    while let Some(frame) = parser.next(&mut input) {
        if let Some(message) = frame.message::<Autoquad>() {
            black_box(&message);
            found += 1;
        }
    }
    while let Some(frame) = parser.finish() {
        found += usize::from(frame.message::<Autoquad>().is_some());
    }
    found
}

/// A message that the peer refuses is an error, after which it goes on; only the end of input ends it.
fn peer_decode(bytes: &[u8]) -> usize {
    let (mut reader, mut found) = (MavlinkReader::new(bytes), 0);
    loop {
        match reader.read_any_message::<MavMessage>() {
            Ok(message) => {
                black_box(&message);
                found += 1;
            }
            Err(mavlink::error::MessageReadError::Parse(_)) => {}
            Err(_) => return found,
        }
    }
}

fn decode_only_into(corpus: &Corpus) -> usize {
    let (mut message, mut found) = (Autoquad::DEFAULT, 0);
    for (place, payload) in corpus.payloads() {
        found += usize::from(message.decode_into(place.id, payload));
        black_box(&message);
    }
    found
}

fn decode_only_by_value(corpus: &Corpus) -> usize {
    let mut found = 0;
    for (place, payload) in corpus.payloads() {
        if let Some(message) = Autoquad::decode(place.id, payload) {
            black_box(&message);
            found += 1;
        }
    }
    found
}

fn peer_decode_only(corpus: &Corpus) -> usize {
    let mut found = 0;
    for (place, payload) in corpus.payloads() {
        if let Ok(message) = MavMessage::parse(their_version(place.version), place.id, payload) {
            black_box(&message);
            found += 1;
        }
    }
    found
}

/// All frames of the corpus again, one after the other.
fn encode(corpus: &Corpus, bytes: &mut Vec<u8>) -> usize {
    let (mut buffer, mut made) = ([0; MAX_FRAME], 0);
    bytes.clear();
    for (place, message) in corpus.frames.iter().zip(&corpus.ours) {
        if let Ok(frame) = sender(place).encode(message, &mut buffer) {
            bytes.extend_from_slice(frame);
            made += 1;
        }
    }
    black_box(&bytes);
    made
}

/// The sender of this frame. To make one costs nothing worth mentioning.
fn sender(place: &Place) -> Sender {
    let (system, component) = (place.header.system_id as u8, place.header.component_id);
    let mut sender = match place.version {
        Version::V1 => Sender::v1(system, component),
        Version::V2 => Sender::v2(system, component),
    };
    sender.set_sequence(place.header.sequence);
    sender
}

fn peer_encode(corpus: &Corpus, bytes: &mut Vec<u8>) -> usize {
    let mut made = 0;
    bytes.clear();
    for (place, message) in corpus.frames.iter().zip(&corpus.theirs) {
        made += usize::from(write_versioned_msg(bytes, their_version(place.version), place.header, message).is_ok());
    }
    black_box(&bytes);
    made
}

fn changed_by_us(corpus: &Corpus) -> usize {
    let mut buffer = [0; MAX_FRAME];
    let same = |((place, frame), message)| sender(place).encode(message, &mut buffer) == Ok(frame);
    corpus.iter().zip(&corpus.ours).map(same).filter(|same| !same).count()
}

fn changed_by_peer(corpus: &Corpus) -> usize {
    let same = |((place, frame), message): ((&Place, &[u8]), &MavMessage)| {
        let mut bytes = Vec::new();
        write_versioned_msg(&mut bytes, their_version(place.version), place.header, message).is_ok() && bytes == frame
    };
    corpus.iter().zip(&corpus.theirs).map(same).filter(|same| !same).count()
}
