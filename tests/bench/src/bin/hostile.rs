//! What streams cost that are made to cost much, beside rust-mavlink: `cargo run --release --bin hostile`.

use std::hint::black_box;

use mavlink::MavlinkReader;
use mavlink::dialects::common::MavMessage;
use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::{Dialect as _, Parser};
use mavlink_bench::rounds::{Contender, compare};

/// They are those of the tests that bound the work.
#[path = "../../../../mavlink-wire/tests/wire/hostile/streams.rs"]
#[expect(clippy::indexing_slicing, reason = "as in the tests")]
mod streams;

/// A unit of work is a byte.
fn main() {
    let mut all = streams::streams((0, 9, 50));
    all.extend((2..8).map(|seed| ("chance", streams::chance((0, 9, 50), seed))));
    for (name, stream) in &all {
        compare(
            name,
            vec![
                Contender::new("ours", || parse(stream, stream.len())),
                Contender::new("ours, chunks of 64", || parse(stream, 64)),
                Contender::new("ours, chunks of 1", || parse(stream, 1)),
                Contender::new("rust-mavlink", || peer_parse(stream)),
            ],
        );
    }
}

fn parse(stream: &[u8], size: usize) -> usize {
    let mut parser = Parser::new(Autoquad::TABLE);
    for mut chunk in stream.chunks(size) {
        while let Some(frame) = parser.next(&mut chunk) {
            black_box(&frame);
        }
    }
    while parser.finish().is_some() {}
    stream.len()
}

fn peer_parse(stream: &[u8]) -> usize {
    let mut reader = MavlinkReader::new(stream);
    while let Ok(frame) = reader.read_any_raw_message::<MavMessage>() {
        black_box(&frame);
    }
    stream.len()
}
