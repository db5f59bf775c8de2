//! Logs that a slip changed: in each, what stands before the change is read as it was, and the rest does no harm.

use std::{env, fs};

use mavlink_wire::uorb::ulog::Log;

use crate::golden::{MAIN, V1_14, V2026_02};
use crate::topic::{Any, EscStatus};

/// Mutants of a log.
const MUTANTS: u64 = 1500;

/// Numbers that are the same on every run.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        // splitmix64
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ z >> 31) % limit as u64) as usize
    }
}

/// The log with one to four changes, and where the first is.
fn mutant(log: &[u8], seed: u64) -> (Vec<u8>, usize) {
    let (mut bytes, mut first, mut random) = (log.to_vec(), log.len(), Random(seed));
    for _ in 0..=random.below(4) {
        if bytes.is_empty() {
            break;
        }
        let at = random.below(bytes.len());
        let end = (at + 1 + random.below(600)).min(bytes.len());
        match random.below(7) {
            0 => bytes[at] ^= 1 << random.below(8),
            1 => bytes[at] = random.below(256) as u8,
            2 => drop(bytes.drain(at..end)),
            3 => drop(bytes.splice(at..at, (0..end - at).map(|i| (i * 37 + seed as usize) as u8))),
            4 => bytes.extend_from_within(at..end),
            5 => bytes[at..end].fill(if random.below(2) == 0 { 0 } else { 0xff }),
            _ => bytes.truncate(at),
        }
        first = first.min(at);
    }
    (bytes, first)
}

/// For each record of data, where it ends.
fn ends(log: &[u8]) -> Vec<usize> {
    let (mut at, mut ends) = (16, Vec::new());
    for record in Log::new(log).unwrap().records() {
        at += 3 + record.payload.len();
        if record.kind == b'D' {
            ends.push(at);
        }
    }
    ends
}

/// Reads all mutants of a log; says how many records all of them gave.
fn read_mutants(log: &[u8]) -> usize {
    let (ends, mut all) = (ends(log), 0);
    let text = |log: &[u8]| -> Vec<String> {
        Log::new(log).map_or(vec![], |log| log.read::<EscStatus>().map(|sample| format!("{sample:?}")).collect())
    };
    let original = text(log);
    assert_eq!(original.len(), ends.len());
    for seed in 0..MUTANTS {
        let (bytes, first) = mutant(log, seed);
        let Ok(read) = Log::new(&bytes) else { continue };
        let mut samples = read.read::<EscStatus>();
        let count = samples.by_ref().count();
        assert!(samples.fit().to_string().len() < 4096, "{seed}");
        let streamed = read.messages::<Any>().filter(|logged| matches!(logged.message, Any::EscStatus(_)));
        assert_eq!(streamed.count(), count, "{seed}");
        all += count;
        let before = ends.iter().filter(|end| **end <= first).count();
        assert!(count >= before, "{seed}: {count} of {before}");
        if before > 0 {
            let now: Vec<String> = read.read::<EscStatus>().take(before).map(|sample| format!("{sample:?}")).collect();
            assert_eq!(now, original[..before], "{seed}");
        }
    }
    all
}

#[test]
fn mutants_of_written_logs() {
    for log in [MAIN, V2026_02, V1_14] {
        assert!(read_mutants(log) > 0);
    }
}

/// Those of real vehicles, in a folder that `PX4_LOGS` names.
#[test]
#[ignore = "needs the folder that PX4_LOGS names"]
fn mutants_of_real_logs() {
    let folder = env::var("PX4_LOGS").unwrap();
    for (name, records) in [("esc_status_log", 127), ("sample_px4_events", 126), ("ekf_failure", 320)] {
        let log = fs::read(format!("{folder}/{name}.esc.ulg")).unwrap();
        let read = read_mutants(&log);
        // Most mutants keep most of the records.
        assert!(read > MUTANTS as usize * records / 4, "{name}: {read}");
    }
}
