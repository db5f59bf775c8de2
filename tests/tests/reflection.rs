//! What reflection says of a payload is what the message types hold: values against pymavlink's and against every struct,
//! what is not known against the accessors.

use mavlink_autoquad::autoquad::{
    AttitudeQuaternion, AttitudeQuaternionCov, Autoquad, BatteryStatus, CellularStatus, DistanceSensor, EscInfo,
    GimbalDeviceInformation, GpsRawInt, HomePosition, ObstacleDistance, Odometry, OnboardComputerStatus, RcChannels,
};
use mavlink_conformance::autoquad::SUBJECTS;
use mavlink_conformance::payload::Fill;
use mavlink_conformance::random::Random;
use mavlink_conformance::values::Values;
use mavlink_conformance::vectors;
use mavlink_wire::reflect::{Number, Reflected};
use mavlink_wire::{Dialect, FieldInfo, Frame, Invalid, MAX_PAYLOAD, Message, MessageInfo, Sentinel};

/// The values as bit patterns of their own widths.
fn values(message: &Reflected<'_>) -> Values {
    let pattern = |number, size: usize| match number {
        Number::U64(value) => value,
        Number::I64(value) => value as u64 & u64::MAX >> (64 - 8 * size),
        Number::F32(value) => value.to_bits().into(),
        Number::F64(value) => value.to_bits(),
    };
    let field = |field: mavlink_wire::reflect::Field<'_>| {
        field.elements().map(|element| pattern(element.number(), field.info().kind.size())).collect()
    };
    message.fields().map(field).collect()
}

#[test]
fn every_frame_carries_what_pymavlink_was_given() {
    let mut checked = 0;
    for message in vectors::read(vectors::AUTOQUAD) {
        for case in message.cases {
            let extensions = message.definition.fields.iter().map(|field| field.extension);
            let base: Values = case
                .values
                .iter()
                .zip(extensions)
                .map(|(list, extension)| if extension { vec![0; list.len()] } else { list.clone() })
                .collect();
            let frames = [(Some(case.v2), &case.values), (Some(case.signed), &case.values), (case.v1, &base)];
            for (frame, expected) in frames {
                let Some(bytes) = frame.map(|frame| frame.bytes()) else { continue };
                let frame = Frame::parse(&bytes, Autoquad::TABLE).unwrap();
                let reflected = frame.reflect::<Autoquad>().unwrap();
                assert_eq!(reflected.info().name, message.definition.name);
                assert_eq!(&values(&reflected), expected, "{} {}", message.definition.name, case.name);
                checked += 1;
            }
        }
    }
    println!("{checked} frames");
    assert!(checked >= 4_900, "{checked}");
}

#[test]
fn every_payload_has_the_values_of_its_struct() {
    let mut random = Random::new(0x5245_464c);
    for subject in &SUBJECTS {
        let fields = Autoquad::fields(subject.id).unwrap();
        for fill in Fill::ALL {
            for length in (0..=MAX_PAYLOAD).step_by(3) {
                let payload = fill.payload(length, &mut random);
                let reflected = Reflected::new(subject.info, fields, &payload);
                assert_eq!(
                    values(&reflected),
                    (subject.decode)(&payload).values,
                    "{} {payload:02x?}",
                    subject.info.name
                );
            }
        }
    }
}

/// Enums and flags of every message, against the texts of the types.
#[test]
fn every_name_is_one_of_its_enum() {
    let (mut random, mut named) = (Random::new(0x4e41_4d45), 0);
    for subject in &SUBJECTS {
        for _ in 0..20 {
            let payload = Fill::Sparse.payload(MAX_PAYLOAD, &mut random);
            let reflected = Reflected::new(subject.info, subject.fields, &payload);
            for element in reflected.fields().flat_map(|field| field.elements()) {
                let Some((values, value)) = element.entry().filter(|_| !element.is_invalid()) else { continue };
                let text = element.to_string();
                let words = text.split(" | ").map(|word| match word.strip_prefix("0x") {
                    Some(digits) => u64::from_str_radix(digits, 16).unwrap(),
                    None => values.entry_value(word).unwrap_or_else(|| word.parse().unwrap()),
                });
                assert_eq!(words.fold(0, |all, word| all | word), value, "{text}");
                named += usize::from(text.starts_with(char::is_alphabetic));
            }
        }
    }
    assert!(named > 1_000, "{named}");
}

/// A payload in which every third value or so is its sentinel.
fn partly_unknown(info: &MessageInfo, fields: &[FieldInfo], random: &mut Random) -> Vec<u8> {
    let mut payload = Fill::Random.payload(info.len_v2.into(), random);
    for field in fields {
        let Some(Invalid::Each(sentinel) | Invalid::All(sentinel) | Invalid::First(sentinel)) = field.invalid else {
            continue;
        };
        let size = field.kind.size();
        let bits = match (sentinel, size) {
            (Sentinel::Unsigned(value), _) => value,
            (Sentinel::Signed(value), _) => value as u64,
            (Sentinel::Float(value), 4) => (value as f32).to_bits().into(),
            (Sentinel::Float(value), _) => value.to_bits(),
            (Sentinel::NotANumber, 4) => (f32::NAN.to_bits() | random.number() as u32 & 0x801f_ffff).into(),
            (Sentinel::NotANumber, _) => f64::NAN.to_bits(),
        };
        for index in 0..usize::from(field.array.unwrap_or(1)) {
            if random.below(3) == 0 {
                let at = usize::from(field.offset) + index * size;
                payload[at..at + size].copy_from_slice(&bits.to_le_bytes()[..size]);
            }
        }
    }
    payload.truncate(random.below(4) * 100);
    payload
}

/// Calls `check` with many messages and what is reflected of them.
fn each<M: Message>(check: impl Fn(&M, &Reflected<'_>)) {
    let mut random = Random::new(M::ID.into());
    for _ in 0..300 {
        let payload = partly_unknown(M::INFO, M::FIELDS, &mut random);
        check(&M::decode(&payload), &Reflected::new(M::INFO, M::FIELDS, &payload));
    }
}

/// Fields whose accessor gives `Option` of the whole.
macro_rules! known {
    ($($message:ident: $($field:ident)*;)*) => {$(
        each::<$message>(|message, reflected| {$(
            let (known, field) = (message.$field().is_some(), reflected.field(stringify!($field)).unwrap());
            assert!(field.info().invalid.is_some());
            assert_eq!(field.is_invalid(), !known, "{} {field}", stringify!($field));
            assert_eq!(field.to_string() == "unknown", !known, "{field}");
        )*});
    )*};
}

/// Arrays whose accessor takes an index.
macro_rules! known_elements {
    ($($message:ident: $($field:ident)*;)*) => {$(
        each::<$message>(|message, reflected| {$(
            let field = reflected.field(stringify!($field)).unwrap();
            for index in 0..=message.$field.len() {
                let known = message.$field(index).is_some();
                let reflected = field.element(index).is_some_and(|element| !element.is_invalid());
                assert_eq!(reflected, known, "{}[{index}] of {field}", stringify!($field));
            }
        )*});
    )*};
}

#[test]
fn what_is_not_known_is_what_the_accessors_say() {
    known! {
        GpsRawInt: eph epv vel cog satellites_visible yaw;
        BatteryStatus: temperature current_battery current_consumed energy_consumed battery_remaining time_remaining;
        GimbalDeviceInformation: uid roll_min roll_max pitch_min pitch_max yaw_min yaw_max gimbal_device_id;
        RcChannels: chan1_raw chan18_raw rssi;
        AttitudeQuaternionCov: covariance;
        Odometry: pose_covariance velocity_covariance;
        CellularStatus: mcc mnc lac;
    }
    known_elements! {
        ObstacleDistance: distances;
        BatteryStatus: voltages voltages_ext;
        EscInfo: temperature;
        AttitudeQuaternion: repr_offset_q;
        DistanceSensor: quaternion;
        HomePosition: q;
        OnboardComputerStatus: cpu_cores gpu_cores fan_speed storage_type link_rx_rate;
    }
}
