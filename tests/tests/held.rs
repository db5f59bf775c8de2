//! What people hold beside messages: made by builders, from nothing, and compared like other values.

use std::collections::HashSet;

use mavlink_autoquad::autoquad::{BatteryStatus, Esc, Esc32State, Esc32Status};
use mavlink_autoquad::esc::{Counts, EscRow, Update};
use mavlink_autoquad::wire::{Message, ViewError};
use mavlink_conformance::dialects::packed::{Channel, FirmwareVersion, FirmwareVersionType, Relays};

#[test]
fn a_view_is_built_member_by_member() -> Result<(), ViewError> {
    const STATUS: Esc32Status = match Esc32Status::from_bits(0, 3).with_state(Esc32State::RUNNING) {
        Ok(status) => status,
        Err(_) => Esc32Status::EMPTY,
    };
    let status = STATUS.with_voltage(15.2)?.with_current(8.73)?.with_rpm(6543)?.with_temperature(-3.25)?;
    assert_eq!((status.state(), status.voltage_mv(), status.current_ma()), (Esc32State::RUNNING, 15_200, 8730));
    assert_eq!((status.rpm(), status.temperature(), status.errors()), (6543, Some(-3.25), None));
    assert_eq!(status.with_rpm(32_768), Err(ViewError::OutOfRange));
    assert_eq!(Esc32Status::from_bits(0, 2).with_temperature(1.0), Err(ViewError::Absent));

    let version = FirmwareVersion::EMPTY.with_major(1).with_minor(15).with_type(FirmwareVersionType::ALPHA);
    assert_eq!(version.bits(), 0x010f_0040);
    assert_eq!(Relays::EMPTY.with_on(3, true)?.bits(), 8);
    assert_eq!(Relays::EMPTY.with_on(16, true), Err(ViewError::OutOfRange));
    Ok(())
}

#[test]
fn nothing_is_a_default() {
    assert_eq!((Esc32Status::default(), Esc32Status::EMPTY.bits()), (Esc32Status::EMPTY, 0));
    assert_eq!(Esc::default(), Esc { id: 0, age_ms: None, status: None });
    // A slot that always says something has no `Option`.
    assert_eq!(Channel::default().status.bits(), 0);
    assert_eq!(Counts::default().restarts, 0);
}

#[test]
fn they_can_be_kept_in_sets() {
    fn kept<T: Copy + Eq + std::hash::Hash + std::fmt::Debug>(value: T) {
        assert!(HashSet::from([value]).contains(&value));
    }
    kept(Esc::default());
    kept(Esc32Status::EMPTY);
    kept(Update::Complete);
    let row: Option<EscRow> = None;
    kept(row);
}

#[test]
fn arrays_with_unknown_elements_are_iterated() {
    let mut battery = BatteryStatus { voltages: [u16::MAX; 10], ..BatteryStatus::DEFAULT };
    (battery.voltages[0], battery.voltages[1]) = (4100, 4080);
    assert!(battery.iter_voltages().eq((0..10).map(|cell| battery.voltages(cell))));
    assert_eq!(battery.iter_voltages().flatten().map(u32::from).sum::<u32>(), 8180);
}
