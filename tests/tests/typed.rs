//! Views, slots and bindings over fields that carry enums: each is read as its number, and written as the enum again. That they
//! compile without a warning, deprecated ones included, is shown by `src/dialects.rs`.

use mavlink_conformance::dialects::typed::{
    Pod, PodCount, PodKind, PodModes, PodOne, PodRow, PodSlot, PodState, PodTilt, PodWide,
};
use mavlink_wire::{Message, ViewError};

fn armed() -> PodOne {
    PodOne { tilt: PodTilt::UP, modes: PodModes::ARMED, word: 0x0102_0304, ..PodOne::DEFAULT }
}

#[test]
fn a_condition_a_sentinel_and_a_switch_look_at_the_enums() {
    let message = armed();
    let state = message.state().unwrap();
    assert_eq!((state.bits(), state.kind()), (0x0001_0102_0304, 0));
    assert_eq!((state.volts_mv(), state.load()), (Some(-900), None), "the layout of POD_KIND_NONE");
    assert_eq!(PodOne { kind: PodKind(9), ..message }.state().unwrap().load(), Some(1), "that of all others");
    for nothing in [
        PodOne { tilt: PodTilt(-1), ..message },
        PodOne { kind: PodKind::HEAVY, ..message },
        PodOne { generation: 1.into(), ..message },
        PodOne { word: 0, modes: PodModes::empty(), ..message },
    ] {
        assert_eq!(nothing.state(), None);
    }
}

#[test]
fn what_is_set_is_in_the_enums() {
    let mut message = armed();
    message.set_state(PodState::from_bits(0xffff_0000_0001, 1));
    assert_eq!((message.kind, message.modes.bits(), message.word), (PodKind::LIGHT, 0xffff, 1));
}

#[test]
fn slots_are_counted_and_keyed_by_enums() {
    let mut row = PodRow { kind: PodKind(7), ..PodRow::DEFAULT };
    assert_eq!(row.pods().count(), 0);
    let modes = PodModes::OPEN;
    let status = Some(PodSlot::from_bits(0x0002_0007, modes.bits()));
    let slot = Pod { modes, kind: None, tilt: Some(PodTilt::UP), generation: None, letter: b'x', other: 3, status };
    for used in 1..=4 {
        row.push_pod(slot).unwrap();
        assert_eq!(row.used, PodCount(used));
    }
    assert_eq!(row.push_pod(slot), Err(ViewError::Full));
    let expected = Pod { kind: Some(PodKind(7)), ..slot };
    assert!(row.pods().all(|pod| pod == expected), "{row:?}");
    assert_eq!(row.text.as_bytes(), b"xxxx");

    row.set_pod(1, Pod { tilt: None, status: None, ..slot }).unwrap();
    let silent = row.pod(1).unwrap();
    assert_eq!((row.tilt[1], silent.tilt, silent.status), (PodTilt(-2), Some(PodTilt(-2)), None));
    row.kind = PodKind::NONE;
    assert_eq!(row.pod(0).map(|pod| (pod.kind, pod.status)), Some((None, None)));
}

#[test]
fn bindings_give_and_take_enums() {
    let mut message = PodWide { kind: 2, ..PodWide::DEFAULT };
    assert_eq!((message.typed(), message.older()), (PodKind::HEAVY, None));
    message.set_typed(PodKind(3));
    message.set_older(1.into());
    assert_eq!((message.kind, message.low, message.older().map(u8::from)), (3, 1, Some(1)));
}

#[test]
fn scaled_numbers_of_every_width_take_what_is_negative() {
    let mut message = PodWide::DEFAULT;
    let mut whole = message.scaled();
    whole.set_value(-0.25).unwrap();
    assert_eq!((whole.value_raw(), whole.value()), (-1, -0.25));
    let mut nearly = message.nearly();
    nearly.set_value(-16.0).unwrap();
    assert_eq!((nearly.value(), nearly.one()), (-16.0, 0));
    let mut halves = message.halves();
    halves.set_low(7.0).unwrap();
    halves.set_high(-5.0).unwrap();
    assert_eq!((halves.low_raw(), halves.low_v(), halves.high_raw(), halves.high_v()), (-7, 7, 6, -5));
    message.set_halves(halves);
    assert_eq!(message.halves().high(), -5.0);
}
