//! When a frame of an unknown message is handed over, although its checksum proves little.

use mavlink_wire::{Dialect, Message, Parser, Sender, Table};
use proptest::prelude::*;

use crate::small::{Heartbeat, Small};
use crate::streams::pieces::{Piece, encoded, with_checksum};
use crate::streams::reference::{parsed, scanned};

/// A heartbeat, which ends like no frame starts.
fn known(sequence: u8) -> Vec<u8> {
    encoded(Sender::v2(1, 1), sequence, &Heartbeat::DEFAULT.into())
}

fn unknown(payload: &[u8]) -> Vec<u8> {
    Piece::Unknown { id: 70_000, crc_extra: 7, payload: payload.to_vec() }.bytes(0)
}

/// What is found, wherever the stream is cut.
fn found(stream: &[u8]) -> Vec<Vec<u8>> {
    let whole = parsed(Small::TABLE, [stream]);
    for size in [1, 7, 100] {
        assert_eq!(parsed(Small::TABLE, stream.chunks(size)), whole, "chunks of {size}");
    }
    whole
}

#[test]
fn damage_that_passes_for_an_unknown_frame_takes_no_known_frame_along() {
    // A start of 30 bytes that were never sent as one, with a checksum that some crc_extra explains.
    let inner = [known(1), known(2)].concat();
    let mut stream = [&[0xFD, 40, 0, 0, 9, 9, 9, 9, 9, 9][..], &inner[..40]].concat();
    stream = with_checksum(stream, 3);
    stream.splice(0..0, [1, 2, 3]);
    assert_eq!(scanned(&Table::of(&[]), &stream).first().map(|place| place.end - place.start), Some(52));
    assert_eq!(found(&[&stream[..], &[5], &known(3)].concat()), [known(1), known(3)]);
}

#[test]
fn a_known_frame_that_begins_in_damage_and_ends_behind_it_is_found() {
    // The checksum of the false frame falls into the known one: find a crc_extra for it by trying sequences.
    let start = [1, 0xFD, 20, 0, 0, 9, 9, 9, 9, 9, 9];
    let stream = |sequence, filler: u8| [&start[..], &[filler; 12], &known(sequence), &known(0)].concat();
    let (stream, sequence) = (0..=255)
        .flat_map(|sequence| (0..=250).map(move |filler| (stream(sequence, filler), sequence)))
        .find(|(stream, _)| scanned(&Table::of(&[]), stream).first().is_some_and(|place| place.start == 1))
        .unwrap();
    assert_eq!(found(&stream), [known(sequence), known(0)]);
}

#[test]
fn a_frame_between_others_keeps_the_frame_that_it_carries() {
    let tunnel = unknown(&[&[1, 2], &known(9)[..], &[3]].concat());
    assert_eq!(found(&[&tunnel[..], &known(0)].concat()), [&tunnel[..], &known(0)]);
    assert_eq!(found(&[&known(0)[..], &tunnel, &tunnel].concat()), [&known(0)[..], &tunnel, &tunnel]);
    // Behind damage nobody can tell: verified frames win.
    assert_eq!(found(&[&[1][..], &tunnel, &known(0)].concat()), [known(9), known(0)]);
    assert_eq!(found(&[&known(0)[..], &tunnel, &[1], &known(1)].concat()), [known(0), known(9), known(1)]);
    let other = unknown(&[1; 60]);
    assert_eq!(found(&[&[1][..], &other, &[1], &tunnel, &known(0)].concat()), [other, known(9), known(0)]);
}

#[test]
fn a_frame_waits_only_if_it_might_carry_a_known_one() {
    let mut parser = Parser::new(Small::TABLE);
    let frame = unknown(&[1, 2, 0xFD, 0xFE, 3]);
    assert!(parser.next(&mut &frame[..]).is_none(), "five bytes of a known frame may have come");
    assert!(parser.next(&mut &[0xFD][..]).is_some_and(|found| found.bytes() == frame), "a frame follows");
    let mut parser = Parser::new(Small::TABLE);
    for payload in [&[1, 2, 3][..], &[0xFE, 0, 0, 0, 0, 77, 1, 1], &[0xFD, 0, 2]] {
        assert!(parser.next(&mut &unknown(payload)[..]).is_some());
    }
}

/// A frame of another unknown message.
fn other(id: u32) -> Vec<u8> {
    Piece::Unknown { id, crc_extra: 9, payload: vec![1, 2, 3] }.bytes(0)
}

#[test]
fn a_message_that_was_seen_twice_is_believed_behind_noise() {
    let (seen, tunnel) = (unknown(&[1; 20]), unknown(&[&[1, 2], &known(9)[..], &[3]].concat()));
    let noise = &[1][..];
    assert_eq!(found(&[&seen[..], noise, &tunnel, noise].concat()), [seen.clone(), known(9)]);
    assert_eq!(found(&[&seen[..], &seen, noise, &tunnel, noise].concat()), [&seen[..], &seen, &tunnel]);
    assert_eq!(
        found(&[&seen[..], &known(0), &seen, noise, noise, &tunnel, noise, &known(1)].concat()),
        [&seen[..], &known(0), &seen, &tunnel, &known(1)]
    );
    // What stands behind noise is no sighting.
    assert_eq!(found(&[noise, &seen, noise, &seen, noise, &tunnel, noise].concat()).last(), Some(&known(9)));
}

#[test]
fn a_message_is_believed_with_one_crc_extra() {
    let with = |crc_extra, payload: &[u8]| Piece::Unknown { id: 70_000, crc_extra, payload: payload.to_vec() }.bytes(0);
    let (seen, seen_with_8) = (unknown(&[1; 20]), with(8, &[1; 20]));
    let (tunnel, tunnel_with_8) = (unknown(&known(9)), with(8, &known(9)));
    let stream = |frames: [&[u8]; 3], last: &[u8]| [&frames.concat(), &[1][..], last, &[1]].concat();
    let last = |stream: Vec<u8>| found(&stream).pop().unwrap();
    assert_eq!(last(stream([&seen, &seen, &seen], &tunnel_with_8)), known(9));
    assert_eq!(last(stream([&seen, &seen, &seen_with_8], &tunnel)), known(9));
    assert_eq!(last(stream([&seen, &seen_with_8, &seen_with_8], &tunnel_with_8)), tunnel_with_8);
}

#[test]
fn eight_messages_are_remembered() {
    let (seen, tunnel) = (unknown(&[1; 20]), unknown(&known(9)));
    let others = |count: u32| (0..count).flat_map(|id| other(80_000 + id)).collect::<Vec<u8>>();
    let last = |count| found(&[&seen[..], &seen, &others(count), &[1], &tunnel, &[1]].concat()).pop().unwrap();
    assert_eq!(last(7), tunnel);
    assert_eq!(last(8), known(9));
}

#[test]
fn a_frame_waits_for_no_more_than_the_start_of_the_next() {
    // Behind noise, with the starts of known ones in it that go on behind it.
    for start in [&[0xFD, 200, 0, 0, 0, 1, 1, 0, 0, 0][..], &[0xFE, 9, 0, 1, 1, 0], &[0xFE, 9], &[0xFD, 200, 0]] {
        let frame = unknown(start);
        let stream = [&[1][..], &frame, &known(0), &known(1)].concat();
        let (mut parser, mut needed) = (Parser::new(Small::TABLE), 0);
        for byte in stream.chunks(1) {
            needed += 1;
            if let Some(found) = parser.next(&mut &byte[..]) {
                assert_eq!(found.bytes(), frame);
                break;
            }
        }
        assert!(needed <= 1 + frame.len() + 10, "{needed}");
    }
}

#[test]
fn a_reset_parser_has_forgotten_what_it_saw() {
    let (seen, tunnel) = (unknown(&[1; 20]), unknown(&known(9)));
    let mut parser = Parser::new(Small::TABLE);
    let frames = |parser: &mut Parser<'_>, mut chunk: &[u8]| {
        let mut lengths = vec![];
        while let Some(frame) = parser.next(&mut chunk) {
            lengths.push(frame.bytes().len());
        }
        lengths
    };
    assert_eq!(frames(&mut parser, &[&seen[..], &seen, &[0xFE, 200]].concat()), [seen.len(); 2]);
    parser.reset();
    assert_eq!((parser.statistics().frames, parser.statistics().skipped_bytes), (2, 0));
    assert_eq!(frames(&mut parser, &[&[1][..], &tunnel, &[1]].concat()), [known(9).len()]);
}

#[test]
fn a_frame_at_the_end_is_handed_over_by_finish() {
    let mut parser = Parser::new(Small::TABLE);
    let tunnel = unknown(&known(9));
    assert_eq!(parser.next(&mut &tunnel[..]), None);
    assert_eq!(parser.finish().map(|frame| frame.bytes().to_vec()), Some(tunnel));
    assert_eq!(parser.finish(), None);
}

#[test]
fn frames_without_a_table_are_found_among_each_other() {
    let stream = [unknown(&[4; 200]), known(0), unknown(&[5; 3]), known(1)].concat();
    let (mut parser, mut input, mut lengths) = (Parser::new(const { &Table::of(&[]) }), &stream[..], vec![]);
    while let Some(frame) = parser.next(&mut input) {
        assert!(!frame.is_verified());
        lengths.push(frame.bytes().len());
    }
    assert_eq!(lengths, [212, known(0).len(), 15, known(1).len()]);
}

proptest! {
    /// The worst case: every byte starts something.
    #[test]
    fn crowds_of_starts_are_judged_like_by_the_definition(
        bytes in proptest::collection::vec(prop_oneof![Just(0xFE), Just(0xFD), Just(0), 0..20_u8], 0..700),
        extra in any::<u8>(),
        at in any::<prop::sample::Index>(),
        cut in 1..300_usize,
    ) {
        let mut stream = bytes;
        // Every insertion makes a frame that is explained, and may lie in others.
        for length in [60, 9, 30] {
            let place = at.index(stream.len() + 1);
            let payload: Vec<u8> = stream.iter().skip(place).take(length).copied().collect();
            let known = length == 9 && payload.len() == 9;
            let frame = if known { with_checksum([&[0xFE, 9, 0, 1, 1, 0], &payload[..]].concat(), 50) } else {
                Piece::Unknown { id: 7, crc_extra: extra, payload }.bytes(0)
            };
            stream.splice(place..place, frame);
        }
        let expected: Vec<Vec<u8>> =
            scanned(Small::TABLE, &stream).iter().map(|place| stream[place.start..place.end].to_vec()).collect();
        prop_assert_eq!(&parsed(Small::TABLE, [&stream[..]]), &expected);
        prop_assert_eq!(&parsed(Small::TABLE, stream.chunks(cut)), &expected);
        prop_assert_eq!(&parsed(Small::TABLE, stream.chunks(1)), &expected);
    }
}
