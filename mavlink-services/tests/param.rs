//! Parameters: both ends over links that are fine and bad, and what a component answers.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "a part of tests")]

mod simulated;

use mavlink_services::common::{
    MavParamError, MavParamType, ParamError, ParamRequestList, ParamRequestRead, ParamSet, ParamValue as Message22,
};
use mavlink_services::param::{
    Access, Component, ComponentOptions, Encoding, Failure, List, ListProgress, Listed, Name, Param, ParamValue, Read,
    Set, ValueError, Which, Write,
};
use mavlink_services::{Instant, Service};
use mavlink_wire::{Frame, MAX_FRAME, Message, Sender, Targeted};
use simulated::{COMPONENT, STATION, Simulation, Weather, component, finish, give, outputs, station};
use std::ops::ControlFlow;
use std::time::Duration;

const FAST: ComponentOptions = ComponentOptions { pace: Duration::from_millis(2) };

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
        let (end, told, _) = finish(&mut simulation, &mut list, &mut vehicle);
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
            let (end, told, _) = finish(&mut simulation, &mut list, &mut vehicle);
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
    let (end, told, _) = finish(&mut simulation, &mut list, &mut vehicle);
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

#[test]
fn two_parameters_of_one_name_are_both_listed() {
    let params = vec![Param::new("TWIN", 1.0_f32), Param::new("TWIN", 2.0_f32)];
    let mut simulation = Simulation::new(1, Weather::FINE);
    let mut vehicle = Component::new(component(), Encoding::Cast, params.clone());
    let mut list = List::new(access(Encoding::Cast), [0; 1], simulation.now);
    let (end, told, _) = finish(&mut simulation, &mut list, &mut vehicle);
    assert_eq!((end, self::params(&told, 2)), (Ok(2), params));
}

#[test]
fn one_answer_is_enough_for_a_question_that_is_doubled() {
    let mut vehicle = Component::new(component(), Encoding::Bytewise, table(Encoding::Bytewise));
    let request = ParamRequestRead { param_index: 3, ..ParamRequestRead::DEFAULT };
    give(&mut vehicle, STATION, &request, Instant::ZERO);
    assert_eq!(asked(&mut vehicle, &request).0.len(), 1);
    assert_eq!(asked(&mut vehicle, &request).0.len(), 1, "one that is asked for later is told again");
}

#[test]
fn a_late_list_catches_up_a_little() {
    let mut vehicle = Component::new(component(), Encoding::Bytewise, table(Encoding::Bytewise));
    give(&mut vehicle, STATION, &ParamRequestList::DEFAULT, Instant::ZERO);
    let at = |millis| Instant::from_millis(millis);
    assert_eq!(outputs(&mut vehicle, at(0)).0.len(), 1);
    assert_eq!(vehicle.deadline(), Some(at(10)));
    assert_eq!(outputs(&mut vehicle, at(45)).0.len(), 4, "10, 20, 30 and 40 ms");
    assert_eq!(outputs(&mut vehicle, at(50)).0.len(), 1);
    let burst = outputs(&mut vehicle, at(700)).0.len();
    assert!((2..=10).contains(&burst), "{burst} at once");
    let next = vehicle.deadline().unwrap();
    assert!(next > at(700) && next <= at(710), "{next:?}");
    assert_eq!(outputs(&mut vehicle, next).0.len(), 1, "and the pace goes on");
}
