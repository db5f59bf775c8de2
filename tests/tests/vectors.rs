//! Every golden frame, both ways, and every fact about every message.

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_conformance::autoquad::SUBJECTS;
use mavlink_conformance::frames;
use mavlink_conformance::vectors::{self, Vectors};
use mavlink_wire::{Dialect, Parser};

#[test]
fn every_frame_is_as_pymavlink_makes_it() {
    let findings = frames::check(&SUBJECTS, &vectors::read(vectors::AUTOQUAD));
    findings.expect_none();
    let (messages, cases, frames) = (findings.messages, findings.cases, findings.frames);
    println!("{messages} messages, {cases} cases, {frames} frames");
    assert!(messages >= 236 && cases >= 2_000 && frames >= 4_900, "{messages} {cases} {frames}");
}

/// All frames one after the other, with noise between them, cut where it hurts.
#[test]
fn every_frame_is_found_in_a_stream() {
    let cases = vectors::read(vectors::AUTOQUAD).into_iter().flat_map(|Vectors { cases, .. }| cases);
    let frames = cases.flat_map(|case| case.v1.into_iter().chain([case.v2, case.signed]));
    let expected: Vec<Vec<u8>> = frames.map(|frame| frame.bytes()).collect();
    let stream: Vec<u8> = expected.iter().flat_map(|frame| [&[0x55, 0xAA], &frame[..]].concat()).collect();
    for size in [1, 7, 64, 1000, stream.len()] {
        let (mut parser, mut found) = (Parser::new(Autoquad::TABLE), 0);
        for mut chunk in stream.chunks(size) {
            while let Some(frame) = parser.next(&mut chunk) {
                assert_eq!(frame.bytes(), expected[found], "frame {found} in chunks of {size}");
                assert!(frame.is_verified());
                found += 1;
            }
        }
        assert_eq!(found, expected.len(), "in chunks of {size}");
    }
}
