//! uORB messages as mavgen makes them of `.msg` files: as CDR, as records of a log, and of several definitions.

use mavlink_conformance::golden::definitions::{Quiet, Sensor, TankStatus};
use mavlink_conformance::golden::topics::{Pump, PumpFaults, PumpStatus, PumpStatusMode, PumpStatusTrend, Topics};
use mavlink_wire::Chars;
use mavlink_wire::uorb::ulog::{Binding, Log};
use mavlink_wire::uorb::{CdrError, Definition, Topic, TopicByLength, Topics as _};

fn pump(on: bool, rpm: u16) -> Pump {
    Pump { on, timestamp: u64::from(rpm) << 40, rpm }
}

fn station() -> PumpStatus {
    PumpStatus {
        timestamp: 0x0102,
        mode: PumpStatusMode::FILL,
        trend: PumpStatusTrend::FALLING,
        faults: PumpFaults::HOT | PumpFaults::from_bits_retain(64),
        level: 1.0,
        flow: [2.0, -1.0],
        latitude: -1.0,
        pressure: 101,
        open: true,
        running: [true, false, true],
        name: Chars::truncated("north"),
        r#type: 7,
        modes: [PumpStatusMode(0), PumpStatusMode(1), PumpStatusMode(2), PumpStatusMode(9)],
        pumps: [pump(true, 1), pump(false, 2), pump(true, 3)],
        spare: pump(true, 4),
    }
}

fn cdr<T: Topic>(topic: &T, definition: &Definition) -> Result<Vec<u8>, CdrError> {
    topic.to_cdr(definition, &mut [0; 256]).map(<[u8]>::to_vec)
}

/// Written out by hand: each scalar at a multiple of its size, the first pump without a gap before it.
#[test]
fn a_body_is_what_cdr_says() {
    let pump = |gap: usize, on: u8, rpm: u8| {
        [&vec![0; gap][..], &[on], &vec![0; [2, 5, 5, 5][usize::from(rpm) - 1]], &[0, 0, 0, 0, 0, rpm, 0, 0, rpm, 0]]
            .concat()
    };
    let expected = [
        &[0, 1, 0, 0][..],
        &[2, 1, 0, 0, 0, 0, 0, 0, 1, 255, 72, 0, 0, 0, 128, 63, 0, 0, 0, 64, 0, 0, 128, 191],
        &[0, 0, 0, 0, 0, 0, 240, 191, 101, 0, 1, 1, 0, 1],
        b"north\0\0\0\0\0",
        &[7, 0, 1, 2, 9],
        &pump(0, 1, 1),
        &pump(0, 0, 2),
        &pump(0, 1, 3),
        &pump(0, 1, 4),
    ]
    .concat();
    assert_eq!(cdr(&station(), &PumpStatus::MAIN).unwrap(), expected);
    assert_eq!(PumpStatus::from_cdr(&expected), Ok(station()));
    let mut padded = expected.clone();
    padded.extend([0, 0]);
    assert_eq!(PumpStatus::from_cdr(&padded), Ok(station()), "DDS pads to four bytes");
}

#[test]
fn what_is_no_message_is_an_error() {
    let body = cdr(&station(), &PumpStatus::MAIN).unwrap();
    let short = PumpStatus::from_cdr(&body[..100]);
    assert_eq!(short, Err(CdrError::Length { found: 96, known: PumpStatus::DEFINITIONS }));
    let mut odd = body.clone();
    odd[4 + 34] = 2;
    assert_eq!(PumpStatus::from_cdr(&odd), Err(CdrError::Bool { field: "open", value: 2 }));
    odd[4 + 34] = 1;
    odd[4 + 66 + 11] = 7;
    assert!(PumpStatus::from_cdr(&odd).is_ok(), "padding");
    assert_eq!(station().to_cdr(&PumpStatus::MAIN, &mut [0; 100]), Err(CdrError::NoRoom { needed: 118 }));
    assert_eq!(station().to_cdr(&Quiet::MAIN, &mut [0; 100]), Err(CdrError::Definition));
}

#[test]
fn facts_of_a_topic() {
    assert_eq!((PumpStatus::VERSION, PumpStatus::QUEUE, Pump::VERSION, Pump::QUEUE), (Some(2), 4, None, 1));
    assert_eq!(PumpStatus::TOPICS, ["pump_status", "pump_status_groundtruth"]);
    assert_eq!((PumpStatus::MAX_PUMPS, PumpStatus::UNKNOWN_), (3, -1));
    assert_eq!((PumpStatus::default().level(), PumpStatus::UNKNOWN.pressure()), (None, None));
    assert_eq!((station().flow(0), station().flow(1), station().flow(2)), (Some(2.0), None, None));
    assert_eq!(PumpStatusTrend::FALLING.to_string(), "TREND_FALLING");
    assert_eq!("TREND_FALLING".parse(), Ok(PumpStatusTrend::FALLING));
    assert_eq!(station().faults.to_string(), "FAULT_HOT | 0x40");
}

/// Reads a record by the formats of a definition.
fn bound<T: Topic>(definition: &Definition, record: &[u8]) -> Option<T> {
    let formats = |name: &str| definition.formats.iter().find_map(|one| one.strip_prefix(name)?.strip_prefix(':'));
    Binding::<T>::of(T::TOPICS[0], formats)?.read(record)
}

#[test]
fn a_record_is_read_by_its_own_format() {
    let mut record = vec![0; PumpStatus::MAIN.record_len as usize];
    station().store_record(&mut record).unwrap();
    assert_eq!(bound(&PumpStatus::MAIN, &record), Some(station()));
    assert_eq!(bound::<PumpStatus>(&PumpStatus::MAIN, &record[1..]), None);
    assert!(station().store_record(&mut record[1..]).is_err());
}

fn tank() -> TankStatus {
    let sensor = |value, address| Sensor { timestamp: 1, value, address, ..Sensor::UNKNOWN };
    TankStatus {
        timestamp: 5,
        valves: 1,
        temperature: 20.0,
        levels: [10, 20, 0, 0],
        label: Chars::truncated("rain"),
        height: 80,
        sensors: [sensor(1.5, 8), sensor(2.5, 9), Sensor::UNKNOWN, Sensor::UNKNOWN],
        ..TankStatus::UNKNOWN
    }
}

#[test]
fn each_definition_keeps_what_it_has() {
    let again = |definition: &Definition| {
        TankStatus::from_cdr_as(definition, &cdr(&tank(), definition).unwrap()).map(|read| format!("{read:?}"))
    };
    let shown = |tank: TankStatus| Ok(format!("{tank:?}"));
    let newest = |mut sensor: Sensor| {
        sensor.address = 0;
        sensor
    };
    let all = tank();
    assert_eq!(again(&TankStatus::MAIN), shown(TankStatus { height: 0, sensors: all.sensors.map(newest), ..all }));
    assert_eq!(again(&TankStatus::V2), shown(all));
    assert_eq!(again(&TankStatus::V1), shown(TankStatus { height: 0, ..all }));
}

#[test]
fn what_does_not_fit_into_a_definition_is_refused() {
    let refused = |tank: TankStatus, definition: &Definition| match cdr(&tank, definition) {
        Err(CdrError::DoesNotFit { field }) => field,
        other => panic!("{other:?}"),
    };
    assert_eq!(refused(TankStatus { valves: 256, ..tank() }, &TankStatus::V2), "valves");
    assert_eq!(refused(TankStatus { valves: 2, ..tank() }, &TankStatus::V1), "valves");
    assert_eq!(refused(TankStatus { temperature: 20.5, ..tank() }, &TankStatus::V1), "temperature");
    assert_eq!(refused(TankStatus { levels: [0, 0, 1, 0], ..tank() }, &TankStatus::V1), "levels");
    assert_eq!(refused(TankStatus { levels: [256; 4], ..tank() }, &TankStatus::V2), "levels");
    assert_eq!(refused(TankStatus { label: Chars::truncated("rainwater"), ..tank() }, &TankStatus::V1), "label");
    let mut many = tank();
    many.sensors[3].value = 0.0;
    assert!(cdr(&many, &TankStatus::MAIN).is_ok(), "zeros say nothing");
    many.sensors[3].errors = 1;
    assert_eq!(refused(many, &TankStatus::MAIN), "sensors");
    assert!(many.store_record(&mut [0; 88]).is_err());
}

#[test]
fn definitions_that_are_one() {
    assert_eq!((Quiet::DEFINITIONS.len(), Quiet::V2, Quiet::STEPS), (1, Quiet::MAIN, 4));
    let names: Vec<&str> = TankStatus::DEFINITIONS.iter().map(|definition| definition.name).collect();
    assert_eq!(names, ["main", "v2", "v1"]);
}

/// Bytes, the same for each run.
fn random(seed: &mut u64) -> u8 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 56) as u8
}

/// Reads bodies of a definition and writes them again: what comes out is what went in, padding aside.
fn gives_back<T: Topic>(definition: &Definition, limit: u8) {
    let length = definition.cdr_len as usize;
    let body = |bytes: Vec<u8>| [vec![0, 1, 0, 0], bytes].concat();
    let again = |bytes: &[u8]| cdr(&T::from_cdr_as(definition, bytes).unwrap(), definition).unwrap();
    let is_data = again(&body(vec![1; length]));
    assert!(is_data.len() == length + 4 && is_data.iter().filter(|&&byte| byte == 0).count() < length);
    let mut seed = 1;
    for _ in 0..2_000 {
        let mut bytes = body((0..length).map(|_| random(&mut seed) % limit).collect());
        let written = again(&bytes);
        bytes.iter_mut().zip(&is_data).skip(4).for_each(|(byte, data)| *byte *= data);
        assert_eq!(written, bytes, "{} of {}", definition.name, T::NAME);
    }
}

#[test]
fn bytes_become_the_same_bytes() {
    gives_back::<PumpStatus>(&PumpStatus::MAIN, 2);
    gives_back::<TankStatus>(&TankStatus::MAIN, 255);
    gives_back::<TankStatus>(&TankStatus::V2, 255);
    gives_back::<TankStatus>(&TankStatus::V1, 2);
    gives_back::<Sensor>(&Sensor::MAIN, 255);
    gives_back::<Quiet>(&Quiet::V2, 255);
}

/// A log of an older definition is read by names: renamed fields, narrower types and shorter arrays, too.
#[test]
fn a_record_of_an_older_definition() {
    let mut record = vec![0; TankStatus::V1.record_len as usize];
    // levels at 8, valves at 12, temp at 13, label at 14, sensors at 24 with 16 bytes each.
    record[0] = 5;
    (record[8], record[10], record[12], record[13]) = (10, 20, 1, 20);
    record[14..18].copy_from_slice(b"rain");
    for (at, value, address) in [(24, 1.5_f32, 8), (40, 2.5, 9)] {
        record[at] = 1;
        record[at + 8..at + 12].copy_from_slice(&value.to_le_bytes());
        record[at + 12] = address;
    }
    let read: TankStatus = bound(&TankStatus::V1, &record).unwrap();
    let mut expected = TankStatus { height: 0, ..tank() };
    for sensor in &mut expected.sensors[2..] {
        *sensor = Sensor { timestamp: 0, value: 0.0, ..Sensor::UNKNOWN };
    }
    assert_eq!(read, expected);
}

/// The enum of the package gives the topics as the log has them, those of one message under each of its names.
#[test]
fn a_log_is_a_stream_of_all_topics() {
    let mut log = b"ULog\x01\x12\x35\x01\0\0\0\0\0\0\0\0".to_vec();
    let mut put = |kind: u8, payload: &[&[u8]]| {
        let payload = payload.concat();
        log.extend(u16::try_from(payload.len()).unwrap().to_le_bytes());
        log.push(kind);
        log.extend(payload);
    };
    for format in PumpStatus::MAIN.formats {
        put(b'F', &[format.as_bytes()]);
    }
    for (id, instance, topic) in [(0, 0, "pump"), (1, 2, "pump_status"), (2, 1, "pump")] {
        put(b'A', &[&[instance, id, 0], topic.as_bytes()]);
    }
    put(b'D', &[&[0, 0], &record(&pump(true, 1))]);
    put(b'D', &[&[1, 0], &record(&station())]);
    put(b'D', &[&[2, 0], &record(&pump(false, 2))]);
    let seen = |log: &[u8]| -> Vec<_> {
        let messages = Log::new(log).unwrap().messages::<Topics>();
        messages.map(|logged| (logged.topic, logged.instance, logged.message.name(), logged.message)).collect()
    };
    let (first, second, third) = (pump(true, 1).into(), station().into(), pump(false, 2).into());
    let expected = [("pump", 0, "Pump", first), ("pump_status", 2, "PumpStatus", second), ("pump", 1, "Pump", third)];
    assert_eq!(seen(&log), expected);
    assert_eq!((Pump::try_from(first), PumpStatus::try_from(first)), (Ok(pump(true, 1)), Err(first)));
}

fn record<T: Topic>(topic: &T) -> Vec<u8> {
    let mut record = vec![0; T::DEFINITIONS[0].record_len as usize];
    topic.store_record(&mut record).unwrap();
    record
}
