//! Reasons for disarming, of both versions.

use mavlink_autoquad::autoquad::{Esc32DisarmV2, Esc32DisarmV3, Esc32State, Esc32Status, EscFailureFlags};
use mavlink_autoquad::esc::DisarmReason::{self, *};

const VERSION_2: [DisarmReason; 8] =
    [Startup, BadDetects, CrossingTimeout, PwmTimeout, LowVoltage, CliUser, BinaryUser, CanUser];
const VERSION_3: [DisarmReason; 8] =
    [None, CliUser, BinaryUser, CanUser, Startup, BadDetects, CrossingTimeout, PwmTimeout];

/// A disarmed controller of this firmware with this reason.
fn disarmed(data_version: u8, reason: u64) -> Esc32Status {
    Esc32Status::from_bits(reason << 61 | 1512 << 3, data_version)
}

#[test]
fn both_versions_give_one_type() {
    for (number, (two, three)) in (0..).zip(VERSION_2.into_iter().zip(VERSION_3)) {
        for version in [0, 2, 10, 20, 21, 29] {
            assert_eq!(DisarmReason::of(disarmed(version, number)), Some(two), "{number} of {version}");
        }
        for version in [3, 9, 30, 31, 255] {
            assert_eq!(DisarmReason::of(disarmed(version, number)), Some(three), "{number} of {version}");
        }
    }
}

#[test]
fn faults_are_those_of_the_ground_station() {
    for (number, (two, three)) in (0..).zip(VERSION_2.into_iter().zip(VERSION_3)) {
        assert_eq!(two.is_fault(), ![0, 5, 6, 7].contains(&number), "{two}");
        assert_eq!(three.is_fault(), number > 4, "{three}");
    }
}

#[test]
fn an_undefined_number_stays() {
    for number in 8..=u8::MAX {
        for reason in [DisarmReason::from(Esc32DisarmV2(number)), DisarmReason::from(Esc32DisarmV3(number))] {
            assert_eq!((reason, reason.is_fault()), (Undefined(number), true));
            assert_eq!(reason.to_string(), format!("undefined reason {number}"));
        }
    }
}

#[test]
fn only_a_disarmed_controller_has_a_reason() {
    for state in 0..8 {
        let mut status = disarmed(21, 4);
        status.set_state(Esc32State(state)).unwrap();
        assert_eq!(DisarmReason::of(status), (state == 0).then_some(LowVoltage));
    }
}

#[test]
fn failures_of_common() {
    let flags = VERSION_2.map(DisarmReason::failure_flags);
    let (stuck, none) = (EscFailureFlags::MOTOR_STUCK, EscFailureFlags::empty());
    let (command, generic) = (EscFailureFlags::INCONSISTENT_CMD, EscFailureFlags::GENERIC);
    assert_eq!(flags, [none, stuck, stuck, command, generic, none, none, none]);
    assert_eq!((None.failure_flags(), Undefined(9).failure_flags()), (none, generic));
    for reason in VERSION_2.into_iter().chain(VERSION_3) {
        assert_eq!(reason.failure_flags().is_empty(), !reason.is_fault());
    }
}
