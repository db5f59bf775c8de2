//! What the parser counts.

use mavlink_wire::{Dialect, Message, Parser, Sender, Statistics};
use proptest::prelude::*;

use crate::small::{AqEscTelemetry, Heartbeat, Small};
use crate::streams::pieces::{Piece, encoded, pieces};
use crate::streams::reference::scanned;

fn counted<'c>(chunks: impl IntoIterator<Item = &'c [u8]>) -> Statistics {
    let mut parser = Parser::new(Small::TABLE);
    for mut chunk in chunks {
        while parser.next(&mut chunk).is_some() {}
    }
    while parser.finish().is_some() {}
    parser.statistics()
}

#[test]
fn a_damaged_frame_counts_once() {
    let frame = |sequence| encoded(Sender::v2(1, 1), sequence, &Heartbeat::DEFAULT.into());
    let mut damaged = frame(0);
    // The damage looks like the start of another frame.
    damaged[12..15].copy_from_slice(&[0xFE, 1, 1]);
    let unknown = Piece::Unknown { id: 70_000, crc_extra: 7, payload: vec![1] }.bytes(0);
    let stream = [&frame(1)[..], &damaged, &[1, 2, 3], &frame(2), &unknown].concat();
    for size in [1, 5, 1000] {
        let counts = counted(stream.chunks(size));
        assert_eq!((counts.frames, counts.unverified, counts.bad_checksums), (3, 1, 1));
        assert_eq!(counts.skipped_bytes, damaged.len() as u64 + 3);
    }
}

#[test]
fn damaged_frames_in_a_row_count_each() {
    let mut damaged = encoded(Sender::v1(1, 1), 0, &Heartbeat::DEFAULT.into());
    damaged[7] ^= 1;
    assert_eq!(counted([&damaged.repeat(3)[..]]).bad_checksums, 3);
}

#[test]
fn a_parser_tells_of_which_message_a_checksum_is_wrong() {
    let mut damaged = encoded(Sender::v1(1, 1), 0, &AqEscTelemetry::DEFAULT.into());
    damaged[20] ^= 1;
    let stream = [&damaged[..], &encoded(Sender::v1(1, 1), 0, &Heartbeat::DEFAULT.into()), &damaged, &[0xFE]].concat();
    let (mut parser, mut told) = (Parser::new(Small::TABLE), vec![]);
    for mut chunk in stream.chunks(7) {
        while parser.next_reporting_bad_checksums(&mut chunk, |id| told.push(id)).is_some() {}
    }
    while parser.finish_reporting_bad_checksums(|id| told.push(id)).is_some() {}
    assert_eq!((told, parser.statistics().frames), (vec![152, 152], 1));
}

proptest! {
    #[test]
    fn every_byte_is_accounted_for(pieces in pieces(), size in 1..40_usize) {
        let stream = pieces.concat();
        let counts = counted(stream.chunks(size));
        prop_assert_eq!(counts, counted([&stream[..]]));
        let frames = scanned(Small::TABLE, &stream);
        prop_assert_eq!(counts.frames, frames.len() as u64);
        prop_assert_eq!(counts.unverified, frames.iter().filter(|place| !place.verified).count() as u64);
        let used: usize = frames.iter().map(|place| place.end - place.start).sum();
        prop_assert_eq!(counts.skipped_bytes, (stream.len() - used) as u64);
    }
}

#[test]
fn a_parser_that_is_reset_waits_for_nothing() {
    let frame = |sequence| encoded(Sender::v2(1, 1), sequence, &Heartbeat::DEFAULT.into());
    for cut in 1..frame(0).len() {
        let mut parser = Parser::new(Small::TABLE);
        assert!(parser.next(&mut &frame(0)[..]).is_some());
        assert!(parser.next(&mut &frame(1)[..cut]).is_none());
        parser.reset();
        assert_eq!(parser.next(&mut &frame(2)[..]).map(|frame| frame.sequence()), Some(2), "{cut}");
        assert!(parser.finish().is_none());
        assert_eq!((parser.statistics().frames, parser.statistics().bad_checksums), (2, 0), "{cut}");
    }
}
