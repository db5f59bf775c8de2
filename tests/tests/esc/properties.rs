//! Whatever comes: nothing panics, and the table stays in order.

use std::ops::Range;

use mavlink_autoquad::autoquad::AqEscTelemetry;
use mavlink_autoquad::esc::{Conversion, EscTable, InfoBits, Silent, Update, UptimeClock};
use proptest::array::uniform4;
use proptest::collection::vec;
use proptest::prelude::*;

use super::cycle;

/// Messages that are mostly consistent, from few motors and times, so that they meet.
fn telemetry() -> impl Strategy<Value = AqEscTelemetry> {
    let near: fn(Range<u32>) -> BoxedStrategy<u32> = |range| prop_oneof![9 => range, 1 => any::<u32>()].boxed();
    let small: fn(Range<u8>) -> BoxedStrategy<u8> = |range| prop_oneof![9 => range, 1 => any::<u8>()].boxed();
    let words = (
        uniform4(any::<u32>()),
        uniform4(prop_oneof![Just(0), any::<u32>()]),
        uniform4(any::<u16>()),
        uniform4(any::<u8>()),
    );
    (near(0..50), small(1..5), small(1..17), small(1..5), uniform4(small(1..17)), words).prop_map(
        |(time_boot_ms, seq, num_motors, num_in_seq, escid, (data0, data1, status_age, data_version))| AqEscTelemetry {
            time_boot_ms,
            seq,
            num_motors,
            num_in_seq,
            escid,
            status_age,
            data_version,
            data0,
            data1,
        },
    )
}

/// What holds of every table at every time.
fn holds(table: &EscTable, now_us: u64) {
    let mut ids: Vec<u8> = table.iter().map(|row| row.id).collect();
    assert!(ids.is_sorted() && ids.iter().all(|id| (1..=16).contains(id)));
    ids.dedup();
    assert_eq!(ids.len(), table.iter_by_index().count());
    for row in table.iter_by_index() {
        assert_eq!((table.at_index(row.index), table.get(row.id)), (Some(row), Some(row)));
        assert!(!row.is_online(now_us, u64::MAX) || row.status.is_some());
    }
    for silent in [Silent::Unknown, Silent::Zero] {
        for info in [InfoBits::Batch, InfoBits::Vehicle] {
            let options = Conversion { silent, info, ..Conversion::DEFAULT };
            for batch in [0, 1, 3, 4, 63, 64, 255] {
                let there = batch < table.num_motors().div_ceil(4);
                assert_eq!(table.to_esc_info(batch, now_us, &options).is_some(), there);
                assert_eq!(table.to_esc_status(batch, now_us, &options).is_some(), there);
            }
        }
    }
}

proptest! {
    #[test]
    fn any_messages_leave_a_table_in_order(messages in vec(telemetry(), 0..40), now: u64) {
        let mut table = EscTable::new();
        for message in &messages {
            let uptime = table.uptime_us();
            let restarted = table.update(message) == Update::Restarted;
            prop_assert!(restarted || table.uptime_us() >= uptime);
            holds(&table, table.uptime_us());
        }
        holds(&table, now);
    }

    /// A vehicle that restarts, a message with a wrong time now and then, and late ones: from the fourth message after each on
    /// the uptime is that of the vehicle, but for a second.
    #[test]
    fn the_uptime_is_soon_that_of_the_vehicle(steps in vec((0..8_u8, 5..1_000_u32, any::<u32>()), 0..200)) {
        let (mut clock, mut uptime_ms, mut since) = (UptimeClock::new(), 0_u32, 0);
        for (kind, step, other) in steps {
            since += 1;
            match kind {
                // The vehicle restarts.
                0 if since > 4 => (uptime_ms, since) = (other % 3_000, 1),
                // A report of any time.
                1 if since > 4 => {
                    clock.update(other % 4_294_968);
                    since = 0;
                }
                // One that comes late, of before the newest.
                2 if since > 4 => _ = clock.update(uptime_ms.saturating_sub(other % 900)),
                _ => uptime_ms += step,
            }
            clock.update(uptime_ms);
            let newest = clock.newest_us().unwrap();
            let right = newest.abs_diff(u64::from(uptime_ms) * 1000) <= 1_000_000;
            prop_assert!(right || since < 4, "{newest} for {uptime_ms} ms, {since} after a change");
        }
    }

    #[test]
    fn any_order_and_repetition_of_a_cycle_makes_the_same_table(
        num_motors in 1..=16_u8,
        order in Just((0..4_usize).collect::<Vec<_>>()).prop_shuffle(),
        again in vec(0..4_usize, 0..6),
    ) {
        let batches = cycle(5000, num_motors, 100);
        let (mut straight, mut mixed) = (EscTable::new(), EscTable::new());
        batches.iter().for_each(|one| _ = straight.update(one));
        let sent = again.iter().chain(&order).filter_map(|&index| batches.get(index));
        let complete = sent.filter(|one| mixed.update(one) == Update::Complete).count();
        prop_assert_eq!((complete, mixed.counts().cycles), (1, 1));
        prop_assert!(mixed.iter_by_index().eq(straight.iter_by_index()));
    }
}
