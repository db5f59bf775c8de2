//! Whatever comes: nothing panics, and the table stays in order.

use std::ops::Range;

use mavlink_autoquad::autoquad::AqEscTelemetry;
use mavlink_autoquad::esc::{Conversion, EscTable, InfoBits, Silent, Update};
use proptest::array::uniform4;
use proptest::collection::vec;
use proptest::prelude::*;

use crate::cycle;

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
            table.update(message);
            prop_assert!(table.uptime_us() >= uptime);
            holds(&table, table.uptime_us());
        }
        holds(&table, now);
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
