//! Any sequence of frames, some of them damaged, some signed with another key, before a verifier: it decides as a map of
//! streams does, and nothing is taken twice.

#![no_main]

use std::collections::HashMap;

use libfuzzer_sys::fuzz_target;
use mavlink_autoquad::autoquad::{Autoquad, Heartbeat};
use mavlink_autoquad::wire::signing::{Key, Signer, SigningError, Trust, Verifier};
use mavlink_autoquad::wire::{Dialect, Frame, MAX_FRAME, Message, Sender, Timestamp};

const STREAMS: usize = 3;
const LATE: u64 = 6_000_000;

/// A frame that comes: who sends it and when, and what happens to it.
type Arrival = (u8, u8, u32, u16, u8);

/// What is expected of a verifier.
#[derive(Default)]
struct Model {
    streams: HashMap<(u8, u8), u64>,
    local: u64,
}

impl Model {
    fn accepts(&mut self, stream: (u8, u8), timestamp: u64, genuine: bool) -> bool {
        if !self.streams.contains_key(&stream) && self.streams.len() == STREAMS && genuine {
            self.streams.retain(|_, last| *last + LATE >= self.local);
        }
        let fits = self.streams.contains_key(&stream) || self.streams.len() < STREAMS;
        let is_new = match self.streams.get(&stream) {
            Some(&last) => timestamp > last,
            None => timestamp + LATE >= self.local,
        };
        let accepted = genuine && fits && is_new;
        if accepted {
            self.streams.insert(stream, timestamp);
            self.local = self.local.max(timestamp);
        }
        accepted
    }
}

fuzz_target!(|arrivals: Vec<Arrival>| {
    let (mut verifier, mut model) = (Verifier::<STREAMS>::with_streams(Some(Key::new([1; 32]))), Model::default());
    for (link, system, time, damaged, flip) in arrivals {
        let (link, system, timestamp) = (link % 3, system % 3, u64::from(time));
        let key = Key::new([if damaged == 1 { 2 } else { 1 }; 32]);
        let mut sender = Sender::v2(system, 1).signed(Signer::new(key, link, Timestamp::new(timestamp)));
        let mut buffer = [0; MAX_FRAME];
        let mut frame = sender.encode(&Heartbeat::DEFAULT, &mut buffer).expect("a frame").to_vec();
        if let Some(byte) = frame.get_mut(usize::from(damaged)) {
            *byte ^= flip;
        }
        let genuine = damaged != 1 && (flip == 0 || usize::from(damaged) >= frame.len());
        let Ok(frame) = Frame::parse(&frame, Autoquad::TABLE) else { continue };
        if frame.signature().is_none() {
            assert!(matches!(verifier.check(&frame, Timestamp::ZERO), Err(SigningError::Unsigned { .. })));
            continue;
        }
        let trust = verifier.check(&frame, Timestamp::ZERO);
        assert_eq!(trust == Ok(Trust::Signed), model.accepts((link, system), timestamp, genuine), "{trust:?}");
        assert_ne!(verifier.check(&frame, Timestamp::ZERO), Ok(Trust::Signed), "a replay");
    }
    assert_eq!(verifier.timestamp().units(), model.local);
});
