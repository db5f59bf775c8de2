//! Parameters: a station before components that do not play by the rules.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "a part of tests")]

mod simulated;

use mavlink_services::common::{MavParamError, MavParamType, ParamError, ParamValue as Message22};
use mavlink_services::param::{
    Access, Awaited, Component, Encoding, Failure, List, ListProgress, Listed, Name, Param, ParamValue, Read, Told,
    Which, Write,
};
use mavlink_services::{Instant, Operation, Output, Service, Update};
use mavlink_wire::{Message, Targeted};
use simulated::{COMPONENT, Ended, STATION, Simulation, Weather, component, finish, give, outputs, station};
use std::time::Duration;

fn access(encoding: Encoding) -> Access {
    Access::new(station(), component(), encoding)
}

fn value(name: &str, field: f32, index: u16, count: u16) -> Message22 {
    let (param_id, param_type) = (Name::truncated(name), MavParamType::REAL32);
    Message22 { param_id, param_value: field, param_type, param_count: count, param_index: index }
}

/// What a station's machine tells at some time, and how many questions it has.
fn told<O: Operation>(machine: &mut O, now: Instant) -> (Option<Ended<O>>, Vec<O::Progress>, usize) {
    let (sent, events) = outputs(machine, now);
    let (mut done, mut progress) = (None, vec![]);
    for event in events {
        match event {
            Update::Progress(told) => progress.push(told),
            Update::Done(result) => done = Some(result),
        }
    }
    (done, progress, sent.len())
}

#[test]
fn px4_sends_a_hash_and_ardupilot_no_index() {
    let now = Instant::ZERO;
    let mut list = List::new(access(Encoding::Bytewise), [0; 1], now);
    outputs(&mut list, now);
    give(&mut list, COMPONENT, &value("_HASH_CHECK", f32::from_bits(0xdead_beef), u16::MAX, 2), now);
    assert_eq!(told(&mut list, now).1, [ListProgress::Hash(0xdead_beef)]);
    give(&mut list, COMPONENT, &value("B", 2.0, 1, 2), now);
    assert_eq!(told(&mut list, now).2, 1, "the end came: the gap is asked for");
    // Somebody sets A, and ArduPilot says so without an index: that fills no gap.
    give(&mut list, COMPONENT, &value("A", 1.0, u16::MAX, 2), now);
    let (done, progress, _) = told(&mut list, now);
    assert!(matches!(progress[..], [ListProgress::Value(Listed { index: None, received: 1, count: 2, .. })]));
    assert_eq!(done, None);
    give(&mut list, COMPONENT, &value("A", 1.0, 0, 2), now);
    assert_eq!(told(&mut list, now).0, Some(Ok(2)));
    // And it confirms a value so, too.
    let mut write = Write::of_kind(access(Encoding::Cast), Name::truncated("A"), 5, MavParamType::INT8, now);
    outputs(&mut write, now);
    give(&mut write, COMPONENT, &value("A", 5.0, u16::MAX, 2), now);
    let expected = Told { name: Name::truncated("A"), value: ParamValue::F32(5.0), index: None, count: 2 };
    assert_eq!(told(&mut write, now).0, Some(Ok(expected)));
}

#[test]
fn a_list_begins_anew_when_its_length_changes_and_gives_up_when_it_always_does() {
    let now = Instant::ZERO;
    let mut list = List::new(access(Encoding::Cast), [0; 8], now);
    outputs(&mut list, now);
    for count in 10..13 {
        give(&mut list, COMPONENT, &value("A", 1.0, 0, count), now);
        assert_eq!(told(&mut list, now).1.len(), 1);
        give(&mut list, COMPONENT, &value("A", 1.0, 1, count + 50), now);
        let (done, progress, questions) = told(&mut list, now);
        assert_eq!((done, progress, questions), (None, vec![ListProgress::Restarted], 1));
    }
    give(&mut list, COMPONENT, &value("A", 1.0, 0, 20), now);
    outputs(&mut list, now);
    give(&mut list, COMPONENT, &value("A", 1.0, 0, 21), now);
    assert_eq!(told(&mut list, now).0, Some(Err(Failure::Unsteady)));
    assert_eq!(list.deadline(), None);
}

#[test]
fn a_list_that_is_too_long_is_an_error() {
    let now = Instant::ZERO;
    for (storage, count, capacity) in [(1, 9, 8), (8192, 65_535, 32_768), (1 << 20, 40_000, 32_768), (0, 1, 0)] {
        let mut list = List::new(access(Encoding::Cast), vec![0; storage], now);
        outputs(&mut list, now);
        give(&mut list, COMPONENT, &value("A", 1.0, 0, count), now);
        assert_eq!(told(&mut list, now).0, Some(Err(Failure::TooMany { count, capacity })));
    }
}

#[test]
fn nobody_and_silence_end_with_what_was_waited_for() {
    let timeout = |awaited| Failure::Timeout { awaited, asked: 6 };
    let mut simulation = Simulation::new(1, Weather { loss: 100, ..Weather::FINE });
    let mut vehicle = Component::new(component(), Encoding::Cast, [Param::new("A_UINT8", 1_u8)]);
    let name = Name::truncated("A_UINT8");
    let mut list = List::new(access(Encoding::Cast), [0; 16], simulation.now);
    assert_eq!(finish(&mut simulation, &mut list, &mut vehicle).0, Err(timeout(Awaited::List)));
    let mut read = Read::new(access(Encoding::Cast), Which::Name(name), simulation.now);
    assert_eq!(finish(&mut simulation, &mut read, &mut vehicle).0, Err(timeout(Awaited::Value)));
    let mut write = Write::of_kind(access(Encoding::Cast), name, 1, MavParamType::UINT8, simulation.now);
    assert_eq!(finish(&mut simulation, &mut write, &mut vehicle).0, Err(timeout(Awaited::Confirmation)));
    assert_eq!(simulation.now, Instant::from_millis(18_000));
    // A component that tells one and falls silent.
    let mut list = List::new(access(Encoding::Cast), [0; 8192], Instant::ZERO);
    outputs(&mut list, Instant::ZERO);
    give(&mut list, COMPONENT, &value("A", 1.0, 32_767, 32_768), Instant::ZERO);
    let mut now = Instant::ZERO;
    let end = loop {
        if let (Some(end), ..) = told(&mut list, now) {
            break end;
        }
        now = list.deadline().unwrap();
    };
    assert_eq!((end, now), (Err(timeout(Awaited::Rest { missing: 32_767 })), Instant::from_millis(6000)));
}

#[test]
fn a_component_that_keeps_its_value_is_no_success() {
    let now = Instant::ZERO;
    let name = Name::truncated("A");
    let mut write = Write::of_kind(access(Encoding::Cast), name, 5, MavParamType::REAL32, now);
    assert_eq!(outputs(&mut write, now).0.len(), 1);
    // An old value may have been under way: it is asked once more.
    give(&mut write, COMPONENT, &value("A", 4.0, 0, 1), now);
    assert_eq!(told(&mut write, Instant::from_millis(999)), (None, vec![], 0));
    assert_eq!(told(&mut write, Instant::from_millis(1000)), (None, vec![], 1));
    give(&mut write, COMPONENT, &value("A", 4.0, 0, 1), now);
    assert_eq!(told(&mut write, Instant::from_millis(2000)).0, Some(Err(Failure::Kept(ParamValue::F32(4.0)))));
    // With a reason, it is told at once.
    let mut write = Write::of_kind(access(Encoding::Cast), name, 5, MavParamType::REAL32, now);
    outputs(&mut write, now);
    let refusal =
        ParamError { param_id: name, param_index: -1, error: MavParamError::READ_ONLY, ..ParamError::DEFAULT };
    give(&mut write, COMPONENT, &refusal.to(STATION.0, 9), now);
    assert_eq!(told(&mut write, now).0, None, "the answer of another station");
    give(&mut write, COMPONENT, &refusal.to(STATION.0, STATION.1), now);
    assert_eq!(told(&mut write, now).0, Some(Err(Failure::Refused(MavParamError::READ_ONLY))));
}

#[test]
fn what_others_say_and_answers_to_other_questions_change_nothing() {
    let now = Instant::ZERO;
    let (mut list, mut read) = (
        List::new(access(Encoding::Cast), [0; 1], now),
        Read::new(access(Encoding::Cast), Which::Name(Name::truncated("A")), now),
    );
    let mut write = Write::of_kind(access(Encoding::Cast), Name::truncated("A"), 1.0, MavParamType::REAL32, now);
    outputs(&mut list, now);
    outputs(&mut read, now);
    outputs(&mut write, now);
    for other in [(2, 1), (1, 2), STATION] {
        give(&mut list, other, &value("A", 1.0, 0, 1), now);
        give(&mut read, other, &value("A", 1.0, 0, 1), now);
        give(&mut write, other, &value("A", 1.0, 0, 1), now);
    }
    give(&mut read, COMPONENT, &value("B", 1.0, 0, 2), now);
    give(&mut write, COMPONENT, &value("B", 1.0, 0, 2), now);
    assert!(outputs(&mut list, now).1.is_empty() && outputs(&mut read, now).1.is_empty());
    assert!(outputs(&mut write, now).1.is_empty());
}

#[test]
fn any_traffic_ends_in_bounded_time() {
    for seed in 0..60 {
        let mut random = simulated::Random::new(seed);
        let (mut now, mut turns) = (Instant::ZERO, 0);
        let mut list = List::new(access(Encoding::Bytewise), [0; 64], now);
        let end = loop {
            let counts = [0, 1, 2, 500, 500, 500, 512, u16::MAX];
            let count =
                counts[random.below(if seed % 4 == 0 { 8 } else { 1 }) as usize + if seed % 4 == 0 { 0 } else { 3 }];
            let index = if random.below(4) == 0 { random.next() as u16 } else { random.below(520) as u16 };
            let names = ["A", "_HASH_CHECK", ""];
            let mut message =
                value(names[random.below(3) as usize], f32::from_bits(random.next() as u32), index, count);
            message.param_type = MavParamType(random.below(12) as u8);
            give(&mut list, COMPONENT, &message, now);
            if let (Some(end), ..) = told(&mut list, now) {
                break end;
            }
            now += Duration::from_millis(random.below(30));
            turns += 1;
            assert!(turns < 100_000, "seed {seed} does not end");
        };
        assert!(now < Instant::from_millis(64 * 8 * 7 * 1000), "seed {seed}: {end:?} at {now:?}");
    }
}

#[test]
fn an_operation_tells_its_end_once() {
    let mut read = Read::new(access(Encoding::Cast), Which::Index(40_000), Instant::ZERO);
    assert!(matches!(read.poll(Instant::ZERO), Some(Output::Event(Update::Done(Err(Failure::Refused(_)))))));
    assert!(read.poll(Instant::from_millis(1_000_000)).is_none());
    assert_eq!(read.deadline(), None);
}

#[test]
fn what_comes_before_the_last_was_told_is_not_lost_unnoticed() {
    let now = Instant::ZERO;
    let mut list = List::new(access(Encoding::Cast), [0; 1], now);
    outputs(&mut list, now);
    give(&mut list, COMPONENT, &value("A", 1.0, 0, 2), now);
    give(&mut list, COMPONENT, &value("B", 2.0, 1, 2), now);
    let (done, progress, _) = told(&mut list, now);
    assert!(matches!(progress[..], [ListProgress::Value(Listed { index: Some(0), received: 1, .. })]));
    assert_eq!(done, None, "nobody was told of the second one");
    // It counts as lost, and is asked for.
    let overdue = list.deadline().unwrap();
    assert_eq!(told(&mut list, overdue).2, 1);
    give(&mut list, COMPONENT, &value("B", 2.0, 1, 2), now);
    assert_eq!(told(&mut list, now).0, Some(Ok(2)));
}
