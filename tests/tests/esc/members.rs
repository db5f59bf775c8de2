//! Every member of the views: what is set is read, nothing else changes, and what does not fit is refused.

use mavlink_autoquad::autoquad::{Esc32DisarmV2, Esc32DisarmV3, Esc32State, Esc32Status, Esc32StatusUnpacked};
use mavlink_autoquad::wire::ViewError;
use proptest::prelude::*;

/// A member: its bits, and its raw getter and setter.
struct Member<V> {
    name: &'static str,
    at: u32,
    width: u32,
    get: fn(V) -> Option<u16>,
    set: fn(&mut V, u16) -> Result<(), ViewError>,
}

/// The members by name. A number that the setter's type cannot hold does not fit either.
macro_rules! members {
    ($($name:literal at $at:literal width $width:literal: $get:expr, $set:expr;)*) => {
        [$(Member { name: $name, at: $at, width: $width, get: $get, set: $set }),*]
    };
}

fn byte(value: u16) -> Result<u8, ViewError> {
    u8::try_from(value).map_err(|_| ViewError::OutOfRange)
}

fn members() -> [Member<Esc32Status>; 9] {
    members! {
        "state" at 0 width 3: |v| Some(v.state().0.into()), |v, x| v.set_state(Esc32State(byte(x)?));
        "voltage" at 3 width 12: |v| Some(v.voltage_raw()), Esc32Status::set_voltage_raw;
        "current" at 15 width 14: |v| Some(v.current_raw()), Esc32Status::set_current_raw;
        "rpm" at 29 width 15: |v| Some(v.rpm()), Esc32Status::set_rpm;
        "duty" at 44 width 8: |v| Some(v.duty_raw().into()), |v, x| byte(x).map(|raw| v.set_duty_raw(raw));
        "errors" at 52 width 9: |v| v.errors(), Esc32Status::set_errors;
        "temperature" at 52 width 9: |v| v.temperature_raw(), Esc32Status::set_temperature_raw;
        "disarm_v2" at 61 width 3: |v| Some(v.disarm_v2()?.0.into()), |v, x| v.set_disarm_v2(Esc32DisarmV2(byte(x)?));
        "disarm_v3" at 61 width 3: |v| Some(v.disarm_v3()?.0.into()), |v, x| v.set_disarm_v3(Esc32DisarmV3(byte(x)?));
    }
}

fn unpacked_members() -> [Member<Esc32StatusUnpacked>; 6] {
    members! {
        "state" at 0 width 3: |v| Some(v.state().0.into()), |v, x| v.set_state(Esc32State(byte(x)?));
        "voltage" at 3 width 12: |v| Some(v.voltage_raw()), Esc32StatusUnpacked::set_voltage_raw;
        "current" at 15 width 14: |v| Some(v.current_raw()), Esc32StatusUnpacked::set_current_raw;
        "rpm" at 32 width 15: |v| Some(v.rpm()), Esc32StatusUnpacked::set_rpm;
        "duty" at 47 width 8: |v| Some(v.duty_raw().into()), |v, x| byte(x).map(|raw| v.set_duty_raw(raw));
        "errors" at 55 width 9: |v| Some(v.errors()), Esc32StatusUnpacked::set_errors;
    }
}

/// Version 3 of the firmware; a literal 3 is the version of the XML's prose.
fn is_version_3(data_version: u8) -> bool {
    matches!(data_version, 3..=9 | 30..)
}

/// Sets a member of a view with these bits, and demands what has to follow.
fn set<V: Copy>(member: &Member<V>, view: V, bits: fn(V) -> u64, value: u16, present: bool) {
    let (mut changed, mask, name) = (view, ((1 << member.width) - 1) << member.at, member.name);
    let expected = if u64::from(value) >> member.width != 0 {
        Err(ViewError::OutOfRange)
    } else if present {
        Ok(bits(view) & !mask | u64::from(value) << member.at)
    } else {
        Err(ViewError::Absent)
    };
    match (member.set)(&mut changed, value) {
        Ok(()) => assert_eq!((Ok(bits(changed)), (member.get)(changed)), (expected, Some(value)), "{name}"),
        Err(error) => {
            // What is absent and does not fit may be refused for either.
            assert!(expected == Err(error) || !present && expected.is_err(), "{name}");
            assert_eq!(bits(changed), bits(view), "{name}");
        }
    }
    let read = (bits(view) & mask) >> member.at;
    assert_eq!((member.get)(view).map(u64::from), present.then_some(read), "{name}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5_000))]

    #[test]
    fn what_is_set_is_read(bits: u64, data_version: u8, value: u16, narrow in 0..0x200_u16) {
        let view = Esc32Status::from_bits(bits, data_version);
        for (member, value) in members().iter().flat_map(|member| [(member, value), (member, narrow)]) {
            let present = match member.name {
                "temperature" | "disarm_v3" => is_version_3(data_version),
                "errors" | "disarm_v2" => !is_version_3(data_version),
                _ => true,
            };
            set(member, view, Esc32Status::bits, value, present);
        }
        prop_assert_eq!((view.bits(), view.data_version()), (bits, data_version));
    }

    #[test]
    fn what_is_set_is_read_unpacked(bits: u64, value: u16, narrow in 0..0x200_u16) {
        let view = Esc32StatusUnpacked::from_bits(bits);
        for (member, value) in unpacked_members().iter().flat_map(|member| [(member, value), (member, narrow)]) {
            set(member, view, Esc32StatusUnpacked::bits, value, true);
        }
    }

    #[test]
    fn any_word_can_be_shown(bits: u64, data_version: u8) {
        let shown = format!("{:?}", Esc32Status::from_bits(bits, data_version));
        prop_assert_eq!(shown.contains("temperature"), is_version_3(data_version));
    }
}

#[test]
fn members_cover_all_bits() {
    let mut covered = [0_u64; 2];
    for member in members() {
        let mask = ((1_u64 << member.width) - 1) << member.at;
        let others =
            [!["temperature", "disarm_v3"].contains(&member.name), !["errors", "disarm_v2"].contains(&member.name)];
        for (covered, counts) in covered.iter_mut().zip(others) {
            assert!(!counts || *covered & mask == 0, "{}", member.name);
            *covered |= if counts { mask } else { 0 };
        }
    }
    assert_eq!(covered, [u64::MAX; 2]);
}

#[test]
fn every_value_comes_back_from_its_unit() {
    let mut status = Esc32Status::from_bits(0, 30);
    for raw in 0..1 << 14 {
        if raw < 1 << 9 {
            status.set_temperature(f32::from(raw) / 4.0 - 32.0).unwrap();
            assert_eq!(
                (status.temperature_raw(), status.temperature_cdegc()),
                (Some(raw), Some(i32::from(raw) * 25 - 3200))
            );
        }
        if let Ok(duty) = u8::try_from(raw) {
            status.set_duty(f32::from(duty) / 255.0 * 100.0).unwrap();
            assert_eq!((status.duty_raw(), status.duty()), (duty, (f64::from(duty) * 100.0 / 255.0) as f32));
        }
        if raw < 1 << 12 {
            status.set_voltage(f32::from(raw) / 100.0).unwrap();
            assert_eq!((status.voltage_raw(), status.voltage_mv()), (raw, i32::from(raw) * 10));
            assert_eq!(status.voltage(), (f64::from(raw) / 100.0) as f32);
        }
        status.set_current(f32::from(raw) / 100.0).unwrap();
        assert_eq!((status.current_raw(), status.current_ma()), (raw, i32::from(raw) * 10));
        assert_eq!(status.current(), (f64::from(raw) / 100.0) as f32);
    }
}

#[test]
fn units_round_and_end() {
    let mut status = Esc32Status::from_bits(0, 30);
    for (value, raw) in [(15.124, 1512), (15.126, 1513), (0.0, 0), (-0.004, 0), (40.954, 4095)] {
        status.set_voltage(value).unwrap();
        assert_eq!(status.voltage_raw(), raw, "{value}");
    }
    let before = status;
    for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -0.01, 40.96, 1e30] {
        assert_eq!(status.set_voltage(value), Err(ViewError::OutOfRange), "{value}");
    }
    for value in [f32::NAN, -32.25, 96.0] {
        assert_eq!(status.set_temperature(value), Err(ViewError::OutOfRange), "{value}");
    }
    assert_eq!((status, status.set_errors(1)), (before, Err(ViewError::Absent)));
}
