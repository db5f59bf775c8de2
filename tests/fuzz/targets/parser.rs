//! Any bytes as a stream: the same frames however it is cut, each a piece of it, and none twice.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::{Dialect, FrameBuf, Parser};

/// The frames of a stream that comes in pieces of these lengths, over and over.
fn frames(stream: &[u8], lengths: &[usize]) -> Vec<FrameBuf> {
    let (mut parser, mut frames, mut rest) = (Parser::new(Autoquad::TABLE), Vec::new(), stream);
    for length in lengths.iter().cycle() {
        let (mut chunk, behind) = rest.split_at((*length).clamp(1, rest.len().max(1)).min(rest.len()));
        while let Some(frame) = parser.next(&mut chunk) {
            frames.push(FrameBuf::from(frame));
        }
        assert!(chunk.is_empty());
        rest = behind;
        if rest.is_empty() {
            break;
        }
    }
    while let Some(frame) = parser.finish() {
        frames.push(FrameBuf::from(frame));
    }
    frames
}

fuzz_target!(|input: (Vec<u8>, [u8; 3])| {
    let (stream, lengths) = input;
    let whole = frames(&stream, &[usize::MAX]);
    assert_eq!(whole, frames(&stream, &[1]));
    assert_eq!(whole, frames(&stream, &lengths.map(|length| usize::from(length) + 1)));
    let mut rest = &stream[..];
    for frame in &whole {
        let bytes = frame.as_frame().bytes();
        let at = rest.windows(bytes.len()).position(|window| window == bytes).expect("a piece of the stream");
        rest = &rest[at + bytes.len()..];
        if let Some(message) = frame.as_frame().message::<Autoquad>() {
            assert!(frame.as_frame().is_verified());
            let _ = format!("{message:?}");
        }
    }
});
