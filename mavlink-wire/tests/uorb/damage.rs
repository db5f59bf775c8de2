//! Logs that are cut, damaged, appended to, or made to do harm.

use mavlink_wire::uorb::ulog::{End, Log, LogError};
use proptest::prelude::*;

use crate::golden::{V1_14, read};
use crate::topic::EscStatus;

const SYNC: &[u8] = &[8, 0, b'S', 0x2f, 0x73, 0x13, 0x20, 0x25, 0x0c, 0xbb, 0x12];
/// A record of data of `V1_14`.
const RECORD: usize = 3 + 2 + 336;

fn end(log: &[u8]) -> (usize, usize, End) {
    let log = Log::new(log).unwrap();
    let mut samples = log.read::<EscStatus>();
    (samples.by_ref().count(), samples.unreadable(), samples.end())
}

#[test]
fn a_log_that_is_cut_gives_what_is_whole() {
    for cut in 1..RECORD {
        assert_eq!(end(&V1_14[..V1_14.len() - cut]), (1, 0, End::Truncated), "{cut}");
    }
    assert_eq!(end(&V1_14[..V1_14.len() - RECORD]), (1, 0, End::Complete));
}

#[test]
fn a_broken_length_costs_what_stands_before_the_next_synchronisation() {
    let first = V1_14.len() - 2 * RECORD;
    let mut log = V1_14[..first + RECORD].to_vec();
    log.extend(SYNC);
    log.extend(&V1_14[first + RECORD..]);
    assert_eq!(end(&log), (2, 0, End::Complete));
    log[first + 1] = 0xff;
    assert_eq!(end(&log), (1, 0, End::Damaged { at: first }));
    log[first + 1] = 1;
    log[first + 2] = 0x80;
    assert_eq!(end(&log), (1, 0, End::Damaged { at: first }));
}

#[test]
fn data_that_was_appended_is_read_and_what_stands_between_is_not() {
    let second = V1_14.len() - RECORD;
    let mut log = V1_14[..second].to_vec();
    log.extend([0xff; 7]);
    let appended = log.len() as u64;
    log.extend(&V1_14[second..]);
    assert_eq!(end(&log), (1, 0, End::Damaged { at: second }));
    log[16 + 3 + 8] |= 1;
    log[16 + 3 + 16..][..8].copy_from_slice(&appended.to_le_bytes());
    assert_eq!(end(&log).0, 2);
}

#[test]
fn a_record_that_is_too_short_is_counted() {
    let mut log = V1_14.to_vec();
    log.extend([5, 0, b'D', 0, 0, 1, 2, 3]);
    assert_eq!(end(&log), (2, 1, End::Complete));
}

#[test]
fn what_is_no_log_or_needs_more_is_refused() {
    assert_eq!(Log::new(b"ULog").err(), Some(LogError::NotALog));
    assert_eq!(Log::new(&V1_14[1..]).err(), Some(LogError::NotALog));
    let mut log = V1_14.to_vec();
    log[16 + 3 + 8 + 2] = 4;
    assert_eq!(Log::new(&log).err(), Some(LogError::Incompatible { byte: 2, bits: 4 }));
}

proptest! {
    /// Whatever is changed: no panic, and no more records than there were bytes for.
    #[test]
    fn a_mutated_log_is_read_to_its_end(changes in prop::collection::vec((16..V1_14.len(), any::<u8>()), 1..20), cut in 16..=V1_14.len()) {
        let mut log = V1_14.to_vec();
        for (at, byte) in changes {
            log[at] = byte;
        }
        log.truncate(cut.max(16));
        if let Ok(log) = Log::new(&log) {
            let mut samples = log.read::<EscStatus>();
            prop_assert!(samples.by_ref().count() <= 3);
            let _ = samples.fit().to_string();
        }
    }

    /// What comes behind a synchronisation record is found, whatever stands before it.
    #[test]
    fn damage_costs_only_itself(noise in prop::collection::vec(any::<u8>(), 0..300)) {
        let first = V1_14.len() - 2 * RECORD;
        let mut log = V1_14[..first].to_vec();
        log.extend([0xff, 0xff, 0xff]);
        log.extend(noise);
        log.extend(SYNC);
        log.extend(&V1_14[first..]);
        prop_assert_eq!(format!("{:?}", read(&log)), format!("{:?}", read(V1_14)));
    }
}
