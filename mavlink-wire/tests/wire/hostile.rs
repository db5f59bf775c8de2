//! Streams that are made to cost much, or to be taken for something else.

pub(crate) mod streams;

use mavlink_wire::Dialect;

use crate::small::Small;
use crate::streams::reference::{parsed, scanned};

const HEARTBEAT: streams::Known = (0, 9, 50);

/// The same frames as by the definition, however the stream is cut.
fn check(name: &str, stream: &[u8]) {
    let expected: Vec<&[u8]> =
        scanned(Small::TABLE, stream).iter().map(|place| &stream[place.start..place.end]).collect();
    for size in [1, 2, 3, 7, 64, 255, 280, 281, 561, stream.len()] {
        assert!(parsed(Small::TABLE, stream.chunks(size)) == expected, "{name}, chunks of {size}");
    }
}

#[test]
fn hostile_streams_hold_the_frames_of_the_definition() {
    for (name, stream) in streams::streams(HEARTBEAT) {
        check(name, &stream);
    }
}

#[test]
fn so_do_streams_of_chance() {
    for seed in 1..30 {
        check(&format!("seed {seed}"), &streams::chance(HEARTBEAT, seed));
    }
}

/// Every byte of garbage may start a frame that reaches over the next good ones.
#[test]
fn good_frames_are_found_in_crowds_of_starts() {
    let (_, good) = streams::streams(HEARTBEAT).swap_remove(0);
    let frame = &good[..17];
    for byte in [0xFE, 0xFD] {
        let garbage = [byte; 300];
        let stream = [&garbage[..], frame, &garbage[..7], frame, frame, &garbage].concat();
        assert_eq!(parsed(Small::TABLE, stream.chunks(50)), [frame; 3]);
    }
}
