//! Counts the work of a parser, for the tests that bound it; elsewhere nothing is left of it.

/// Adds to the work: a byte that was looked at, walked over or moved is one.
#[cfg(not(test))]
#[inline(always)]
pub(crate) const fn count(_: usize) {}

#[cfg(test)]
pub(crate) use counted::count;

/// They lie with the tests of the whole crate.
#[cfg(test)]
#[path = "../../tests/wire/hostile/streams.rs"]
mod streams;

#[cfg(test)]
mod counted {
    use std::cell::Cell;
    use std::vec::Vec;
    use std::{format, println, thread_local};

    use super::super::Parser;
    use super::streams;
    use crate::{MessageInfo, Table, tlog};

    thread_local! {
        static WORK: Cell<u64> = const { Cell::new(0) };
    }

    pub(crate) fn count(work: usize) {
        WORK.with(|sum| sum.set(sum.get() + work as u64));
    }

    const HEARTBEAT: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
    static TABLE: Table<'static> = Table::of(&[HEARTBEAT]);

    /// The work for each byte of a stream that comes in chunks of this size.
    fn work(stream: &[u8], size: usize) -> f64 {
        WORK.set(0);
        let mut parser = Parser::new(&TABLE);
        for mut chunk in stream.chunks(size) {
            while parser.next(&mut chunk).is_some() {}
        }
        while parser.finish().is_some() {}
        WORK.get() as f64 / stream.len() as f64
    }

    /// The most that any of the streams takes for a byte, however it is cut.
    fn worst(streams: Vec<(&'static str, Vec<u8>)>) -> f64 {
        let mut worst = 0.0;
        for (name, stream) in streams {
            for size in [1, 2, 3, 7, 16, 64, 255, 280, 281, 1000, stream.len()] {
                let work = work(&stream, size);
                if work > worst {
                    println!("{work:6.1} a byte: {name}, chunks of {size}");
                    worst = work;
                }
            }
        }
        worst
    }

    /// Before there was a bound, these took up to 300 for a byte.
    const BOUND: f64 = 30.0;

    #[test]
    fn the_work_for_a_byte_is_bounded() {
        assert!(worst(streams::streams((0, 9, 50))) < BOUND);
    }

    #[test]
    fn so_is_that_for_a_byte_of_a_log() {
        for (name, stream) in streams::streams((0, 9, 50)) {
            WORK.set(0);
            let _ = tlog::entries(&stream, &TABLE).count();
            let work = WORK.get() as f64 / stream.len() as f64;
            assert!(work < BOUND, "{name}: {work}");
        }
    }

    #[test]
    fn chance_finds_nothing_worse() {
        let streams = (1..40).map(|seed| ("chance", streams::chance((0, 9, 50), seed))).collect();
        assert!(worst(streams) < BOUND);
    }

    #[test]
    fn good_frames_take_little() {
        let (_, good) = streams::streams((0, 9, 50)).swap_remove(0);
        for size in [64, 1000, good.len()] {
            let work = work(&good, size);
            assert!(work < 5.0, "{}", format!("{work} in chunks of {size}"));
        }
    }
}
