//! The clock that starts again every 2^32 microseconds.

use mavlink_autoquad::esc::{UptimeClock, true_age_ms};
use mavlink_conformance::random::Random;

/// What the vehicle sends at an uptime in microseconds.
fn time_boot_ms(uptime_us: u64) -> u32 {
    uptime_us as u32 / 1000
}

/// That uptime as exact as the vehicle sends it.
fn sent_us(uptime_us: u64) -> u64 {
    uptime_us - u64::from(uptime_us as u32 % 1000)
}

#[test]
fn the_clock_goes_on_over_many_turns() {
    let (mut clock, mut random, mut uptime) = (UptimeClock::new(), Random::new(1), 0);
    while uptime < 20 << 32 {
        assert_eq!(clock.update(time_boot_ms(uptime)), sent_us(uptime));
        assert_eq!(clock.newest_us(), Some(sent_us(uptime)));
        // From a cycle to a silence of half an hour, after which the first report is doubted.
        let silence = random.number() % [20_000, 59_000_000, 1_800_000_000][random.below(3)];
        uptime += 5_000 + silence;
        if silence > 59_990_000 {
            let newest = clock.newest_us();
            assert_eq!((clock.update(time_boot_ms(uptime)), clock.newest_us()), (sent_us(uptime), newest));
            uptime += 5_000;
        }
    }
}

/// The reports of a case in milliseconds, and the newest uptime after each.
type Case = (&'static str, &'static [(u32, u64)]);

const CASES: [Case; 13] = [
    ("runs on", &[(300_000, 300_000), (300_005, 300_005), (360_005, 360_005)]),
    ("one report is ahead", &[(300_000, 300_000), (900_000, 300_000), (300_010, 300_010), (300_020, 300_020)]),
    ("every other report is ahead", &[(1, 1), (900_000, 1), (10, 10), (900_010, 10), (20, 20), (900_020, 20)]),
    ("ten minutes of silence", &[(300_000, 300_000), (900_000, 300_000), (900_005, 900_005), (900_010, 900_010)]),
    ("two batches of one time agree", &[(300_000, 300_000), (900_000, 300_000), (900_000, 900_000)]),
    ("reports that do not agree", &[(0, 0), (900_000, 0), (700_000, 0), (500_000, 0), (100, 100)]),
    ("restart after a minute", &[(59_000, 59_000), (1_000, 59_000), (1_005, 59_000), (1_010, 1_010), (1_015, 1_015)]),
    ("restart, batches of one time", &[(9_000, 9_000), (1, 9_000), (1, 9_000), (1, 9_000), (6, 9_000), (11, 11)]),
    ("restart after five minutes", &[(300_000, 300_000), (1_000, 300_000), (1_005, 1_005), (1_010, 1_010)]),
    ("restart after an hour", &[(3_600_000, 3_600_000), (1_000, 3_600_000), (1_100, 1_100)]),
    ("the first report is ahead", &[(900_000, 900_000), (300_000, 900_000), (300_005, 300_005)]),
    (
        "late ones that fall",
        &[(59_000, 59_000), (50_000, 59_000), (40_000, 59_000), (30_000, 59_000), (59_005, 59_005)],
    ),
    ("late by less than a second", &[(59_000, 59_000), (58_100, 59_000), (58_200, 59_000), (58_300, 59_000)]),
];

#[test]
fn restarts_and_jumps_are_told_apart() {
    for (case, reports) in CASES {
        let mut clock = UptimeClock::new();
        for (at, &(sent, newest)) in reports.iter().enumerate() {
            clock.update(sent);
            assert_eq!(clock.newest_us(), Some(newest * 1000), "{case}: report {at}");
        }
    }
}

#[test]
fn a_late_report_between_newer_ones_is_no_restart() {
    let mut clock = UptimeClock::new();
    for step in 0..100 {
        assert_eq!(clock.update(50_000 + 10 * step), u64::from(50_000 + 10 * step) * 1000);
        assert_eq!(clock.update(20_000 + 10 * step), u64::from(20_000 + 10 * step) * 1000);
    }
}

#[test]
fn a_turn_is_not_a_round_number_of_milliseconds() {
    let mut clock = UptimeClock::new();
    assert_eq!(clock.update(4_294_967), 4_294_967_000);
    assert_eq!(clock.update(0), 4_294_967_296);
    assert_eq!(clock.update(1), 4_294_968_296);
}

#[test]
fn what_comes_late_is_no_turn() {
    for newest in [70_000_000, (1 << 32) - 1_000, (1 << 32) + 3_000, (5 << 32) + 59_999_000] {
        let mut clock = UptimeClock::new();
        clock.update(time_boot_ms(newest & 0xffff_ffff));
        let turns = newest & !0xffff_ffff;
        for late in [0, 1_000, 30_000_000, 59_998_000] {
            let late = (newest - late).max(turns) - turns;
            assert_eq!(clock.update(time_boot_ms(late)), sent_us(late), "{newest} {late}");
        }
        assert_eq!(clock.newest_us(), Some(sent_us(newest - turns)));
    }
    let mut clock = UptimeClock::new();
    clock.update(4_294_900);
    clock.update(10);
    assert_eq!(clock.update(4_294_960), 4_294_960_000, "from before the turn");
    assert_eq!(clock.update(11), (1 << 32) + 11_000);
}

#[test]
fn a_report_from_before_the_first_is_at_zero() {
    let mut clock = UptimeClock::new();
    clock.update(3);
    assert_eq!(clock.update(4_294_967), 0);
    assert_eq!(clock.update(4), 4_000);
}

#[test]
fn a_true_clock_of_milliseconds_is_followed() {
    let mut clock = UptimeClock::new();
    for step in 0..180_000_u64 {
        let uptime_ms = step * 50_000;
        assert_eq!(clock.update(uptime_ms as u32), uptime_ms * 1000);
    }
}

#[test]
fn ages_over_the_turn_are_taken_back() {
    let mut restarted = 0;
    for then in ((1_u64 << 32) - 3_100_000..(1 << 32) + 3_100_000).step_by(777) {
        for age_us in (0..=3_000_000).step_by(12_345) {
            let now = then + age_us;
            let sent = time_boot_ms(now).wrapping_sub(time_boot_ms(then)) as u16;
            restarted += u32::from(sent > 3000);
            assert!(u64::from(true_age_ms(sent)).abs_diff(age_us / 1000) <= 1, "{then} {age_us}: {sent}");
        }
    }
    assert!(restarted > 1000);
    assert_eq!([0, 3000, 3001, 20_000, u16::MAX].map(true_age_ms), [0, 3000, 3001, 20_000, u16::MAX]);
}
