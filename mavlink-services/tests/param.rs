//! Parameters: both ends over links that are fine and bad, and stations before components that do not play by the rules.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "a part of tests")]

mod simulated;

use std::ops::ControlFlow;
use std::time::Duration;

use mavlink_services::common::{
    MavParamError, MavParamType, ParamError, ParamRequestList, ParamRequestRead, ParamSet, ParamValue as Message22,
};
use mavlink_services::param::{
    Access, Awaited, Component, ComponentOptions, Encoding, Failure, List, ListProgress, Listed, Name, Param,
    ParamValue, Parameters, Read, Set, Told, ValueError, Which, Write,
};
use mavlink_services::{Instant, Operation, Output, Service, Update};
use mavlink_wire::{Frame, MAX_FRAME, Message, Sender, Targeted};
use simulated::{COMPONENT, STATION, Simulation, Weather, component, give, outputs, station};

const FAST: ComponentOptions = ComponentOptions { pace: Duration::from_millis(2) };
const LONG: Duration = Duration::from_secs(600);

fn access(encoding: Encoding) -> Access {
    Access::new(station(), component(), encoding)
}

/// Parameters of all types that fit four bytes, with values that need every bit of them.
fn table(encoding: Encoding) -> Vec<Param> {
    let wide = if encoding == Encoding::Bytewise { -123_456_789 } else { -16_777_215 };
    let mut table = vec![
        Param::new("A_UINT8", u8::MAX),
        Param::new("AN_INT8", i8::MIN),
        Param::new("A_UINT16", u16::MAX),
        Param::new("AN_INT16", i16::MIN),
        Param::new("A_UINT32", 16_777_216_u32),
        Param::new("AN_INT32", wide),
        Param::new("A_REAL32", -0.1_f32),
        Param::new("SIXTEEN_LETTERS_", f32::MAX),
    ];
    table.extend((0..100_u16).map(|number| Param::new(&format!("P{number}"), number)));
    table
}

/// How an operation ended, if it did, and what it told before.
type End<O> = Result<<O as Operation>::Outcome, <O as Operation>::Failure>;

/// Runs an operation to its end, and gives that and what it told before.
fn finish<O: Operation, P: Parameters>(
    simulation: &mut Simulation,
    operation: &mut O,
    component: &mut Component<P>,
) -> (End<O>, Vec<O::Progress>) {
    let (mut end, mut told) = (None, vec![]);
    let _ = simulation.run(
        (operation, &mut |_, event, _| match event {
            Update::Progress(progress) => {
                told.push(progress);
                ControlFlow::Continue(())
            }
            Update::Done(result) => {
                end = Some(result);
                ControlFlow::Break(())
            }
        }),
        (component, &mut |_, _, _| {}),
        LONG,
    );
    (end.expect("an operation ends in ten minutes"), told)
}

/// What a list told last of each index.
fn params(told: &[ListProgress], count: u16) -> Vec<Param> {
    let mut params = vec![None; count.into()];
    for progress in told {
        if let ListProgress::Value(Listed { name, value: Ok(value), index: Some(index), .. }) = *progress {
            params[usize::from(index)] = Some(Param { name, value });
        }
    }
    params.into_iter().map(|param| param.expect("each index was told")).collect()
}

#[test]
fn a_list_over_a_fine_link_asks_once_and_gets_every_value() {
    for encoding in [Encoding::Bytewise, Encoding::Cast] {
        let mut simulation = Simulation::new(1, Weather::FINE);
        let mut vehicle = Component::new(component(), encoding, table(encoding));
        let mut list = List::new(access(encoding), [0; 16], simulation.now);
        let (end, told) = finish(&mut simulation, &mut list, &mut vehicle);
        assert_eq!((end, params(&told, 108)), (Ok(108), table(encoding)));
        assert_eq!(simulation.sent::<ParamRequestList>().len(), 1);
        assert_eq!(simulation.sent::<ParamRequestRead>().len(), 0);
        let sent = simulation.sent::<Message22>();
        assert!(sent.windows(2).all(|pair| pair[1].0 - pair[0].0 >= Duration::from_millis(10)), "not paced");
    }
}

#[test]
fn a_list_over_a_bad_link_is_whole_and_the_same_seed_gives_the_same_run() {
    for seed in 0..50 {
        let run = |encoding| {
            let mut simulation = Simulation::new(seed, Weather::BAD);
            let mut vehicle = Component::new(component(), encoding, table(encoding)).with_options(FAST);
            let mut list = List::new(access(encoding), vec![0; 16], simulation.now);
            let (end, told) = finish(&mut simulation, &mut list, &mut vehicle);
            assert_eq!((end, params(&told, 108)), (Ok(108), table(encoding)), "seed {seed}");
            simulation.trace
        };
        assert_eq!(run(Encoding::Bytewise), run(Encoding::Bytewise), "seed {seed}");
        run(Encoding::Cast);
    }
}

#[test]
fn values_are_set_and_read_over_a_bad_link() {
    for (seed, encoding) in (0..50).zip([Encoding::Bytewise, Encoding::Cast].into_iter().cycle()) {
        let mut simulation = Simulation::new(seed, Weather::BAD);
        let mut vehicle = Component::new(component(), encoding, table(encoding));
        for (name, value) in [("A_UINT8", 7_i64), ("AN_INT8", -7), ("A_REAL32", 3), ("AN_INT32", -8_388_609)] {
            let name = Name::truncated(name);
            let mut write = Write::new(access(encoding), name, value, simulation.now);
            let written = match finish(&mut simulation, &mut write, &mut vehicle).0 {
                Ok(told) => told,
                // One question in 450 is lost six times.
                Err(Failure::Timeout { asked: 6, .. }) => continue,
                Err(failure) => panic!("seed {seed}: {failure}"),
            };
            assert_eq!(vehicle.parameters().iter().find(|param| param.name == name).unwrap().value, written.value);
            assert_eq!(written.value.to_kind(MavParamType::INT64), Ok(value.into()), "seed {seed}");
            // What was told before may still be under way, and nothing shows its age.
            let mut nothing = |_: &mut Write, _, _| ControlFlow::Continue(());
            let _ =
                simulation.run((&mut write, &mut nothing), (&mut vehicle, &mut |_, _, _| {}), Duration::from_secs(1));
            let mut read = Read::new(access(encoding), Which::Index(written.index.unwrap()), simulation.now);
            match finish(&mut simulation, &mut read, &mut vehicle).0 {
                Ok(told) => assert_eq!((told.name, told.value), (name, written.value), "seed {seed}"),
                Err(failure) => assert!(matches!(failure, Failure::Timeout { asked: 6, .. }), "seed {seed}"),
            }
        }
    }
}

/// What a component does with one request of a station.
fn asked(
    vehicle: &mut Component<Vec<Param>>,
    request: &dyn mavlink_wire::Encode,
) -> (Vec<Message22>, Vec<ParamError>, Vec<Set>) {
    give(vehicle, STATION, request, Instant::ZERO);
    let (sent, events) = outputs(vehicle, Instant::ZERO);
    let values = sent.iter().filter_map(|sent| sent.decode()).collect();
    (values, sent.iter().filter_map(|sent| sent.decode()).collect(), events)
}

fn set(name: &str, field: f32, kind: MavParamType) -> ParamSet {
    let set = ParamSet { param_id: Name::truncated(name), param_value: field, param_type: kind, ..ParamSet::DEFAULT };
    set.to(COMPONENT.0, COMPONENT.1)
}

#[test]
fn a_component_refuses_with_a_reason_and_tells_the_value_that_it_keeps() {
    use MavParamError as Error;
    use MavParamType as Kind;
    let int = |value: i32| f32::from_bits(value.cast_unsigned());
    let cases = [
        (Encoding::Bytewise, "A_UINT8", int(5), Kind::UINT8, Ok(ParamValue::U8(5))),
        (Encoding::Bytewise, "A_UINT8", 5.0, Kind::REAL32, Err(Error::TYPE_MISMATCH)),
        (Encoding::Bytewise, "AN_INT32", int(-1), Kind::INT32, Ok(ParamValue::I32(-1))),
        (Encoding::Bytewise, "NOBODY", int(5), Kind::UINT8, Err(Error::DOES_NOT_EXIST)),
        (Encoding::Cast, "A_UINT8", 5.0, Kind::REAL32, Ok(ParamValue::U8(5))),
        (Encoding::Cast, "A_UINT8", 5.0, Kind(99), Ok(ParamValue::U8(5))),
        (Encoding::Cast, "A_UINT8", 256.0, Kind::UINT8, Err(Error::VALUE_OUT_OF_RANGE)),
        (Encoding::Cast, "A_UINT8", 1.5, Kind::UINT8, Err(Error::VALUE_OUT_OF_RANGE)),
        (Encoding::Cast, "A_UINT8", f32::NAN, Kind::UINT8, Err(Error::VALUE_OUT_OF_RANGE)),
        (Encoding::Cast, "AN_INT8", -0.0, Kind::INT8, Ok(ParamValue::I8(0))),
        (Encoding::Cast, "A_REAL32", 1.5, Kind::REAL32, Ok(ParamValue::F32(1.5))),
    ];
    for (encoding, name, field, kind, expected) in cases {
        let mut vehicle = Component::new(component(), encoding, table(encoding));
        let before = vehicle.parameters().iter().find(|param| param.name == name).map(|param| param.value);
        let (values, errors, events) = asked(&mut vehicle, &set(name, field, kind));
        let case = format!("{encoding:?} {name} {field} {kind}");
        assert_eq!(events.first().map(|set| set.param.value), expected.ok(), "{case}");
        assert_eq!(errors.first().map(|error| error.error), expected.err(), "{case}");
        let told = values.first().map(|value| encoding.decode(value.param_value, value.param_type).unwrap());
        assert_eq!(told, expected.ok().or(before), "{case}");
        assert!(errors.iter().all(|error| (error.target_system, error.target_component) == STATION), "{case}");
    }
}

#[test]
fn a_component_answers_reads_by_name_and_index_and_nothing_else() {
    let mut vehicle = Component::new(component(), Encoding::Bytewise, table(Encoding::Bytewise));
    let read = |name: &str, param_index| {
        ParamRequestRead { param_id: Name::truncated(name), param_index, ..ParamRequestRead::DEFAULT }.to(1, 1)
    };
    let (values, errors, _) = asked(&mut vehicle, &read("AN_INT8", -1));
    assert_eq!((values[0].param_index, values[0].param_count, errors.len()), (1, 108, 0));
    assert_eq!(asked(&mut vehicle, &read("", 2)).0[0].param_id, "A_UINT16");
    for (name, index) in [("NOBODY", -1), ("AN_INT8", 108), ("AN_INT8", i16::MIN)] {
        let (values, errors, _) = asked(&mut vehicle, &read(name, index));
        assert_eq!((values.len(), errors[0].error, errors[0].param_index), (0, MavParamError::DOES_NOT_EXIST, index));
    }
    for other in [(1, 2), (2, 1)] {
        assert_eq!(asked(&mut vehicle, &read("AN_INT8", -1).to(other.0, other.1)), (vec![], vec![], vec![]));
    }
    assert_eq!(asked(&mut vehicle, &read("AN_INT8", -1).to(0, 0)).0.len(), 1);
    // MAVLink 1 has no PARAM_ERROR.
    let mut buffer = [0; MAX_FRAME];
    let v1 = Sender::v1(STATION.0, STATION.1).encode(&read("NOBODY", -1), &mut buffer).unwrap().to_vec();
    vehicle.handle(
        &Frame::parse(&v1, <mavlink_services::common::Common as mavlink_wire::Dialect>::TABLE).unwrap(),
        Instant::ZERO,
    );
    assert!(outputs(&mut vehicle, Instant::ZERO).0.is_empty());
}

#[test]
fn a_flood_of_requests_is_answered_in_part_and_stops_nobodys_list() {
    let mut vehicle = Component::new(component(), Encoding::Bytewise, table(Encoding::Bytewise));
    for index in 0..100 {
        give(
            &mut vehicle,
            STATION,
            &ParamRequestRead { param_index: index, ..ParamRequestRead::DEFAULT },
            Instant::ZERO,
        );
    }
    assert_eq!(outputs(&mut vehicle, Instant::ZERO).0.len(), 8);
    let mut seen = std::collections::HashSet::new();
    for step in 0..120 {
        // Somebody else asks for the list all the time.
        give(&mut vehicle, (7, 7), &ParamRequestList::DEFAULT, Instant::from_millis(step * 10));
        let (sent, _) = outputs(&mut vehicle, Instant::from_millis(step * 10));
        seen.extend(sent.iter().filter_map(|sent| Some(sent.decode::<Message22>()?.param_index)));
    }
    assert_eq!(seen.len(), 108);
}

#[test]
fn a_value_that_cannot_be_sent_is_an_error_and_the_list_ends_all_the_same() {
    let params = vec![Param::new("FITS", 5_i32), Param::new("TOO_LONG", -123_456_789_i32)];
    let mut simulation = Simulation::new(1, Weather::FINE);
    let mut vehicle = Component::new(component(), Encoding::Cast, params);
    let mut list = List::new(access(Encoding::Cast), [0; 1], simulation.now);
    let (end, told) = finish(&mut simulation, &mut list, &mut vehicle);
    let last = told
        .last()
        .and_then(|progress| if let ListProgress::Value(listed) = progress { Some(listed.value) } else { None });
    assert_eq!((end, last), (Ok(2), Some(Err(Failure::Refused(MavParamError::TYPE_UNSUPPORTED)))));
    let mut write = Write::of_kind(
        access(Encoding::Cast),
        Name::truncated("FITS"),
        16_777_217,
        MavParamType::INT32,
        simulation.now,
    );
    assert_eq!(finish(&mut simulation, &mut write, &mut vehicle).0, Err(Failure::Value(ValueError::Inexact)));
    let mut write = Write::new(access(Encoding::Cast), Name::truncated("FITS"), 0.5, simulation.now);
    assert_eq!(finish(&mut simulation, &mut write, &mut vehicle).0, Err(Failure::Value(ValueError::NotAnInteger)));
    assert_eq!(vehicle.parameters()[0].value, ParamValue::I32(5));
}

fn value(name: &str, field: f32, index: u16, count: u16) -> Message22 {
    let (param_id, param_type) = (Name::truncated(name), MavParamType::REAL32);
    Message22 { param_id, param_value: field, param_type, param_count: count, param_index: index }
}

/// What a station's machine tells at some time, and how many questions it has.
fn told<O: Operation>(machine: &mut O, now: Instant) -> (Option<End<O>>, Vec<O::Progress>, usize) {
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
fn two_parameters_of_one_name_are_both_listed() {
    let params = vec![Param::new("TWIN", 1.0_f32), Param::new("TWIN", 2.0_f32)];
    let mut simulation = Simulation::new(1, Weather::FINE);
    let mut vehicle = Component::new(component(), Encoding::Cast, params.clone());
    let mut list = List::new(access(Encoding::Cast), [0; 1], simulation.now);
    let (end, told) = finish(&mut simulation, &mut list, &mut vehicle);
    assert_eq!((end, self::params(&told, 2)), (Ok(2), params));
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
    let mut vehicle = Component::new(component(), Encoding::Cast, table(Encoding::Cast));
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
    for seed in 0..200 {
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
