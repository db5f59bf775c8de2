//! Logs that another program wrote of known values, one for each of three definitions.

use mavlink_wire::uorb::Fields;
use mavlink_wire::uorb::ulog::{End, Log};

use crate::topic::{EscReport, EscStatus};

pub(crate) const V1_14: &[u8] = include_bytes!("logs/v1_14.ulg");
pub(crate) const V2026_02: &[u8] = include_bytes!("logs/v2026_02.ulg");
pub(crate) const MAIN: &[u8] = include_bytes!("logs/main.ulg");

pub(crate) fn read(log: &[u8]) -> Vec<(u8, EscStatus)> {
    Log::new(log).unwrap().read::<EscStatus>().collect()
}

#[test]
fn one_type_reads_three_eras() {
    for (log, motors, addresses, motor_temperature) in
        [(V1_14, 8, true, false), (V2026_02, 8, true, true), (MAIN, 12, false, true)]
    {
        let samples = read(log);
        let [(0, vehicle), (0, edge)] = &samples[..] else { panic!("{samples:?}") };

        assert_eq!((vehicle.timestamp, vehicle.counter, vehicle.esc_online_flags), (123_456_000, 7, 0b0111));
        assert_eq!(vehicle.esc.map(|esc| esc.esc_rpm)[..4], [6543, 6601, 0, 0]);
        assert_eq!(vehicle.esc.map(|esc| esc.esc_voltage)[..3], [15.12, 15.10, 15.09]);
        assert!(vehicle.esc[3].esc_voltage.is_nan());
        assert_eq!(vehicle.esc.map(|esc| esc.actuator_function)[..5], [101, 102, 103, 104, 0]);
        assert_eq!(vehicle.esc.map(|esc| esc.esc_power)[..2], [50, 51]);
        assert_eq!(vehicle.esc[2].failures, 0x20);
        assert_eq!(vehicle.esc[1].esc_address, if addresses { 4 } else { 0 });

        assert_eq!((edge.timestamp, edge.counter, edge.esc_online_flags), (0x0102_0304_0506_0708, 0xbeef, 0xa5));
        for (k, esc) in (0_u8..).zip(&edge.esc[..motors]) {
            assert_eq!(esc.timestamp, u64::MAX - u64::from(k));
            assert_eq!(esc.esc_rpm, i32::MIN + i32::from(k));
            assert_eq!(esc.motor_temperature, if motor_temperature { i16::MIN + i16::from(k) } else { 0 });
            assert_eq!(esc.failures, 0x0200 + u16::from(k));
        }
        assert_eq!(format!("{:?}", edge.esc.get(motors)), format!("{:?}", (motors < 12).then_some(EscReport::UNKNOWN)));
    }
}

#[test]
fn a_log_is_read_to_its_end() {
    let log = Log::new(MAIN).unwrap();
    let mut samples = log.read::<EscStatus>();
    assert_eq!(samples.by_ref().count(), 2);
    assert_eq!((samples.unreadable(), samples.end(), log.start()), (0, End::Complete, 123_456));
    assert_eq!(log.records().map(|record| record.kind).collect::<Vec<_>>(), b"BFFADD");
}

#[test]
fn what_does_not_fit_is_told() {
    let fit = Log::new(V1_14).unwrap().read::<EscStatus>().fit();
    assert!(!fit.is_exact());
    assert_eq!(fit.to_string(), "esc[].motor_temperature: not in this log");
    let fit = Log::new(MAIN).unwrap().read::<EscStatus>().fit().to_string();
    assert_eq!(fit, "esc[].esc_address: not in this log; esc[].esc_cmdcount: not in this log");
    let none = Log::new(V1_14).unwrap().read_topic::<EscStatus>("esc_status_2").fit().to_string();
    assert_eq!(none, "esc_status_2: not in this log");
    for (ty, said) in [
        ("uint16_t", ""),
        ("uint32_t", "counter: uint32_t does not fit into uint16; "),
        ("counters", "counter: counters does not fit into uint16; "),
    ] {
        let (from, to) = (b"uint16_t counter;", format!("{ty} counter;"));
        let at = V1_14.windows(from.len()).position(|window| window == from).unwrap();
        let log = [&V1_14[..at], to.as_bytes(), &V1_14[at + from.len()..]].concat();
        let fit = Log::new(&log).unwrap().read::<EscStatus>().fit().to_string();
        assert_eq!(fit, format!("{said}esc[].motor_temperature: not in this log"));
    }
}

#[test]
fn the_number_of_places_counts_what_is_nested() {
    assert_eq!(EscStatus::ABSENT.len(), 7 + 13);
}
