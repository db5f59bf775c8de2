//! Cycles, put together from batches.

use mavlink_autoquad::autoquad::{AqEscTelemetry, Esc};
use mavlink_autoquad::esc::{Counts, EscTable, MAX_ESCS, ONLINE_LIMIT_MS, Update};
use mavlink_autoquad::wire::Message;

use super::{batch, cycle, running};

fn speeds(table: &EscTable) -> Vec<(u8, u16)> {
    table.iter().map(|row| (row.id, row.status.unwrap().rpm())).collect()
}

fn expected(num_motors: u8, rpm: u16) -> Vec<(u8, u16)> {
    (1..=num_motors).map(|id| (id, rpm + u16::from(id))).collect()
}

#[test]
fn every_number_of_motors_makes_cycles() {
    for num_motors in 1..=16 {
        let mut table = EscTable::new();
        for number in 0..3_u16 {
            let batches = cycle(1000 + 5 * u32::from(number), num_motors, 100 * number);
            let (last, rest) = batches.split_last().unwrap();
            for one in rest {
                assert_eq!(table.update(one), Update::Partial);
            }
            assert_eq!(table.update(last), Update::Complete);
            assert_eq!(table.counts(), Counts { cycles: number + 1, ..Counts::default() });
            assert_eq!((table.num_motors(), speeds(&table)), (num_motors, expected(num_motors, 100 * number)));
        }
        assert!(table.iter_by_index().map(|row| row.index).eq(0..num_motors));
        assert_eq!((table.get(num_motors + 1), table.at_index(num_motors)), (None, None));
        assert_eq!((table.get(0), table.get(255), table.at_index(255)), (None, None, None));
    }
}

#[test]
fn order_within_a_cycle_is_free() {
    for order in [[0, 1, 2, 3], [3, 2, 1, 0], [2, 0, 3, 1]] {
        let (mut table, batches) = (EscTable::new(), cycle(7, 16, 0));
        let updates = order.map(|index| table.update(&batches[index]));
        assert_eq!(updates, [Update::Partial, Update::Partial, Update::Partial, Update::Complete]);
        assert_eq!(speeds(&table), expected(16, 0));
    }
}

#[test]
fn a_lost_batch_is_counted_and_keeps_its_rows() {
    let mut table = EscTable::new();
    for one in cycle(1000, 8, 100) {
        table.update(&one);
    }
    assert_eq!(table.update(&cycle(1010, 8, 200)[0]), Update::Partial);
    assert_eq!(table.update(&cycle(1020, 8, 300)[1]), Update::Partial);
    let counts = Counts { cycles: 1, lost: 1, ..Counts::default() };
    assert_eq!(table.counts(), counts);
    assert_eq!(speeds(&table)[..4], expected(8, 200)[..4]);
    assert_eq!(speeds(&table)[4..], expected(8, 300)[4..]);
    table.update(&cycle(1030, 8, 400)[0]);
    table.update(&cycle(1030, 8, 400)[1]);
    assert_eq!(table.counts(), Counts { cycles: 2, lost: 2, ..counts });
}

#[test]
fn a_repeated_batch_changes_nothing() {
    let (mut table, batches) = (EscTable::new(), cycle(1000, 5, 0));
    let updates = [0, 0, 1, 1, 0].map(|index| table.update(&batches[index]));
    assert_eq!(updates, [Update::Partial, Update::Repeated, Update::Complete, Update::Repeated, Update::Repeated]);
    assert_eq!(table.counts(), Counts { cycles: 1, repeated: 3, ..Counts::default() });
    assert_eq!(speeds(&table), expected(5, 0));
}

#[test]
fn a_late_batch_only_fills_gaps() {
    let (mut table, early, later) = (EscTable::new(), cycle(1000, 8, 100), cycle(1010, 8, 200));
    table.update(&early[0]);
    table.update(&later[0]);
    assert_eq!(table.update(&early[1]), Update::Late);
    assert_eq!(speeds(&table)[4..], expected(8, 100)[4..]);
    assert_eq!(table.update(&later[1]), Update::Complete);
    assert_eq!((table.update(&early[1]), table.update(&early[0])), (Update::Late, Update::Late));
    assert_eq!(speeds(&table), expected(8, 200));
    assert_eq!(table.counts(), Counts { cycles: 1, lost: 1, late: 3, ..Counts::default() });
}

#[test]
fn a_simulator_may_take_the_time_of_each_batch() {
    let mut table = EscTable::new();
    for start in [1000, 1005, 1010] {
        let batches = cycle(start, 12, 0);
        for (delay, one) in (0..).zip(batches) {
            table.update(&AqEscTelemetry { time_boot_ms: start + delay, ..one });
        }
    }
    assert_eq!(table.counts(), Counts { cycles: 3, ..Counts::default() });
}

#[test]
fn other_motors_in_use_make_a_new_table() {
    let mut table = EscTable::new();
    cycle(1000, 8, 100).iter().for_each(|one| _ = table.update(one));
    assert_eq!(table.update(&batch(1010, 1, 2, &[running(9, 1), running(3, 2)])), Update::Complete);
    assert_eq!((speeds(&table), table.num_motors()), (vec![(3, 2), (9, 1)], 2));
    assert!(table.iter_by_index().map(|row| (row.index, row.id)).eq([(0, 9), (1, 3)]));
    assert_eq!(table.update(&cycle(1000, 8, 100)[1]), Update::Late);
    assert_eq!(table.update(&cycle(1010, 8, 100)[1]), Update::Invalid, "two numbers of motors at one time");
    assert_eq!(table.iter().count(), 2);
    assert_eq!(table.counts(), Counts { cycles: 2, lost: 0, late: 1, invalid: 1, ..Counts::default() });
}

#[test]
fn a_motor_port_is_at_one_place() {
    let mut table = EscTable::new();
    table.update(&batch(1000, 1, 3, &[running(1, 10), running(2, 20), running(3, 30)]));
    table.update(&batch(1010, 1, 3, &[running(2, 21), running(1, 11), running(3, 31)]));
    assert_eq!(speeds(&table), [(1, 11), (2, 21), (3, 31)]);
    assert!(table.iter_by_index().map(|row| row.id).eq([2, 1, 3]));
}

#[test]
fn contradictions_are_ignored_and_counted() {
    let good = cycle(1000, 8, 0)[0];
    let bad = [
        AqEscTelemetry { seq: 0, ..good },
        AqEscTelemetry { seq: 3, ..good },
        AqEscTelemetry { seq: u8::MAX, ..good },
        AqEscTelemetry { num_in_seq: 0, ..good },
        AqEscTelemetry { num_in_seq: 5, ..good },
        AqEscTelemetry { num_motors: 0, ..good },
        AqEscTelemetry { num_motors: 17, ..good },
        AqEscTelemetry::DEFAULT,
    ];
    let mut table = EscTable::new();
    for telemetry in &bad {
        assert_eq!(table.update(telemetry), Update::Invalid);
    }
    assert_eq!((table.counts().invalid, table.iter().count(), table.uptime_us()), (8, 0, 0));
    assert_eq!(table.update(&batch(1, 1, 3, &[running(0, 1), running(17, 2), running(16, 3)])), Update::Complete);
    assert_eq!((table.counts().invalid, speeds(&table)), (10, vec![(16, 3)]));
    assert_eq!(table.at_index(2).unwrap().id, 16);
    assert_eq!(MAX_ESCS, 16);
}

#[test]
fn slots_that_are_not_in_use_are_not_read() {
    let mut telemetry = batch(1, 1, 4, &[1, 2, 3, 4].map(|id| running(id, 9)));
    telemetry.num_in_seq = 2;
    let mut table = EscTable::new();
    table.update(&telemetry);
    assert_eq!(speeds(&table), [(1, 9), (2, 9)]);
}

#[test]
fn a_silent_controller_ages() {
    let silent = |age_ms| Esc { id: 1, age_ms, status: None };
    let mut table = EscTable::new();
    table.update(&batch(10_000, 1, 1, &[silent(None)]));
    let row = *table.get(1).unwrap();
    assert_eq!((row.status, row.age_ms(u64::MAX), row.silent), (None, None, true));
    assert!(!row.is_online(10_000_000, u64::MAX));

    table.update(&batch(11_000, 1, 1, &[running(1, 5)]));
    let row = *table.get(1).unwrap();
    assert_eq!((row.received_us, row.age_ms(table.uptime_us())), (10_995_000, Some(5)));
    assert!(row.is_online(12_194_999, ONLINE_LIMIT_MS) && !row.is_online(12_195_000, ONLINE_LIMIT_MS));
    assert_eq!((row.age_ms(0), row.age_ms(u64::MAX)), (Some(0), Some((u64::MAX - 10_995_000) / 1000)));

    for (now, age_ms) in [(12_000, Some(1005)), (13_000, Some(2005)), (14_000, None)] {
        table.update(&batch(now, 1, 1, &[silent(age_ms)]));
        let row = *table.get(1).unwrap();
        assert_eq!(row.age_ms(table.uptime_us()), Some(u64::from(now) - 10_995));
        assert_eq!((row.silent, row.status.unwrap().rpm()), (true, 5), "the last status stays");
        assert!(!row.is_online(table.uptime_us(), 10_000));
    }
    table.update(&batch(15_000, 1, 1, &[running(1, 6)]));
    assert!(table.get(1).unwrap().is_online(table.uptime_us(), ONLINE_LIMIT_MS));
}

#[test]
fn after_a_restart_nobody_is_online_by_what_was() {
    for uptime in [5_000, 59_000, 300_000, 3_000_000] {
        let mut table = EscTable::new();
        cycle(uptime, 8, 5_000).iter().for_each(|one| _ = table.update(one));
        let updates: Vec<Update> = (0..3).map(|step| table.update(&cycle(1_000 + 10 * step, 8, 0)[0])).collect();
        assert!(updates.contains(&Update::Restarted), "{uptime}: {updates:?}");
        assert_eq!((table.counts().restarts, table.uptime_us() / 1_000_000), (1, 1), "{uptime}");
        // Of the second batch, which has not come since, nothing is known any more.
        assert_eq!(speeds(&table), expected(4, 0), "{uptime}");
        assert_eq!(table.update(&cycle(1_030, 8, 7)[1]), Update::Partial);
        assert_eq!(speeds(&table)[4..], expected(8, 7)[4..]);
    }
}

#[test]
fn one_message_from_the_future_changes_nothing() {
    let mut table = EscTable::new();
    for step in 0..10 {
        cycle(300_000 + 10 * step, 8, 100).iter().for_each(|one| _ = table.update(one));
    }
    let (rows, counts) = (speeds(&table), table.counts());
    assert_eq!(table.update(&cycle(900_000, 8, 999)[0]), Update::Doubted);
    assert_eq!((speeds(&table), table.uptime_us()), (rows, 300_090_000));
    assert_eq!(table.counts(), Counts { doubted: 1, ..counts });
    assert_eq!(table.update(&cycle(300_100, 8, 200)[0]), Update::Partial);
    assert_eq!(table.uptime_us(), 300_100_000);
    assert!(table.get(1).unwrap().is_online(table.uptime_us(), ONLINE_LIMIT_MS));
}

#[test]
fn ages_are_right_over_a_turn_of_the_clock() {
    let mut table = EscTable::new();
    table.update(&cycle(4_294_966, 4, 1)[0]);
    // 7 ms later; the status is from 10 ms before, and the firmware makes 2^16 - 35127 + 10 of it.
    let mut telemetry = cycle(6, 4, 2)[0];
    telemetry.status_age = [30_419; 4];
    assert_eq!(table.update(&telemetry), Update::Complete);
    assert_eq!(table.uptime_us(), (1 << 32) + 6_000);
    assert!(table.iter().all(|row| row.age_ms(table.uptime_us()) == Some(10)));
    assert_eq!(table.counts().cycles, 2);
}

#[test]
fn the_count_of_cycles_wraps() {
    let mut table = EscTable::new();
    for number in 0..65_537_u32 {
        table.update(&batch(number * 5, 1, 1, &[running(1, 1)]));
    }
    assert_eq!(table.counts(), Counts { cycles: 1, ..Counts::default() });
}
