//! A conversation: we send a heartbeat with a number, the other side answers with that number and 1000 more. What it sends on
//! its own has number 0. It takes nothing but its own version, and if it signs, nothing that is not signed.

use std::time::{Duration, Instant};

use mavlink_autoquad::autoquad::Heartbeat;
use mavlink_autoquad::wire::link::{Link, LinkError, Options, tokio};
use mavlink_autoquad::wire::{Frame, Message};

use super::{Kind, LONG};

const NUMBERS: u32 = 20;

/// A link, however it waits.
pub(super) trait Talks {
    fn send(&mut self, beat: &Heartbeat) -> Result<usize, LinkError>;
    fn receive(&mut self, deadline: Instant) -> Option<(Kind, Option<Heartbeat>)>;
}

fn read(frame: &Frame<'_>) -> (Kind, Option<Heartbeat>) {
    let kind = match frame.version() {
        mavlink_autoquad::wire::Version::V1 => Kind::V1,
        _ if frame.signature().is_some() => Kind::Signed,
        _ => Kind::V2,
    };
    (kind, frame.decode())
}

impl Talks for Link {
    fn send(&mut self, beat: &Heartbeat) -> Result<usize, LinkError> {
        Link::send(self, beat)
    }

    fn receive(&mut self, deadline: Instant) -> Option<(Kind, Option<Heartbeat>)> {
        self.receive_until(deadline).unwrap().as_ref().map(read)
    }
}

/// A link of async tasks, and what runs them.
pub(super) struct Polling {
    runtime: ::tokio::runtime::Runtime,
    link: tokio::Link,
}

impl Polling {
    pub(super) fn connect(address: &str, options: Options) -> Result<Self, LinkError> {
        let runtime = ::tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        let link = runtime.block_on(tokio::Link::connect(address, options))?;
        Ok(Self { runtime, link })
    }
}

impl Talks for Polling {
    fn send(&mut self, beat: &Heartbeat) -> Result<usize, LinkError> {
        self.runtime.block_on(self.link.send(beat))
    }

    fn receive(&mut self, deadline: Instant) -> Option<(Kind, Option<Heartbeat>)> {
        self.runtime.block_on(self.link.receive_until(deadline)).unwrap().as_ref().map(read)
    }
}

/// Talks until every number was answered, in what the other side speaks.
pub(super) fn with(link: &mut impl Talks, kind: Kind, place: &str) {
    let end = Instant::now() + LONG;
    for number in 1..=NUMBERS {
        // Until both sides are there, and have heard of each other's version.
        while !is_answered(link, number, kind, place) {
            assert!(Instant::now() < end, "{place}, {kind:?}: no answer to {number}");
        }
    }
}

fn is_answered(link: &mut impl Talks, number: u32, kind: Kind, place: &str) -> bool {
    link.send(&Heartbeat { custom_mode: number, ..Heartbeat::DEFAULT })
        .unwrap_or_else(|error| panic!("{place}: {error}"));
    let deadline = Instant::now() + Duration::from_millis(200);
    while let Some((spoken, beat)) = link.receive(deadline) {
        assert_eq!(spoken, kind, "{place}");
        if beat.is_some_and(|beat| beat.custom_mode == number + 1000) {
            return true;
        }
    }
    false
}
