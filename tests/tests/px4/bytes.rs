//! `EscStatus` as bytes: the vectors of rosbags, both ways, and whatever else has the right length.

use std::fmt::Debug;

use mavlink_autoquad::px4::EscStatus;
use mavlink_wire::uorb::ulog::Binding;
use mavlink_wire::uorb::{CdrError, Definition, Topic, TopicByLength};
use proptest::prelude::*;

use super::vectors::{ESC_STATUS, vectors};

/// NaN is not equal to itself; its text is.
fn text(topic: &impl Debug) -> String {
    format!("{topic:?}")
}

fn definition(name: &str) -> &'static Definition {
    EscStatus::DEFINITIONS.iter().find(|definition| definition.name == name).unwrap()
}

/// How a record of this definition is read.
fn binding(definition: &Definition) -> Binding<EscStatus> {
    let formats =
        |name: &str| definition.formats.iter().find_map(|format| format.strip_prefix(name)?.strip_prefix(':'));
    Binding::of("esc_status", formats).unwrap()
}

#[test]
fn payloads_and_records_are_those_of_others() {
    let mut compared = 0;
    for vectors in vectors(ESC_STATUS) {
        let definition = definition(vectors.definition);
        let binding = binding(definition);
        for (name, payload, record) in &vectors.values {
            let name = format!("{name} of {}", definition.name);
            let read = EscStatus::from_cdr_as(definition, payload).unwrap();
            assert_eq!(text(&read), text(&EscStatus::from_cdr(payload).unwrap()), "{name}");
            assert_eq!(text(&read), text(&binding.read(record).unwrap()), "{name}");
            assert_eq!(read.to_cdr(definition, &mut [0xff; 512]).unwrap(), payload, "{name}");
            if definition.name == EscStatus::MAIN.name {
                let mut stored = vec![0; record.len()];
                read.store_record(&mut stored).unwrap();
                assert_eq!(&stored, record, "{name}");
            }
            for other in EscStatus::DEFINITIONS.iter().filter(|other| *other != definition) {
                let refused = EscStatus::from_cdr_as(other, payload).unwrap_err();
                assert!(matches!(refused, CdrError::Length { .. }), "{name}: {refused}");
            }
            compared += 1;
        }
    }
    assert_eq!(compared, 66);
}

#[test]
fn definitions_are_those_of_the_vectors() {
    for vectors in vectors(ESC_STATUS) {
        let definition = definition(vectors.definition);
        let lengths = [definition.cdr_len, definition.record_len];
        assert_eq!((definition.type_hash, lengths), (vectors.type_hash, [vectors.lengths[0], vectors.lengths[2]]));
        assert_eq!(definition.formats, vectors.formats);
    }
    let hashes = EscStatus::DEFINITIONS.iter().map(|definition| definition.message_hash);
    assert_eq!(hashes.collect::<Vec<_>>(), [0x4d8f_7be2, 0x89ab_3c8a, 0xabbd_16f2]);
}

/// A payload with this body, which is made longer or cut.
fn payload(definition: &Definition, body: &[u8]) -> Vec<u8> {
    let mut payload = [&[0, 1, 0, 0], body].concat();
    payload.resize(4 + definition.cdr_len as usize, 0);
    payload
}

/// The bytes of a payload that are not padding: those that are not zero after all ones were read and written.
fn mask(definition: &Definition) -> Vec<u8> {
    let ones = EscStatus::from_cdr_as(definition, &payload(definition, &[0xff; 491])).unwrap();
    let mut mask = ones.to_cdr(definition, &mut [0; 512]).unwrap().to_vec();
    mask[..4].fill(0xff);
    mask
}

fn any_definition() -> impl Strategy<Value = &'static Definition> {
    (0..EscStatus::DEFINITIONS.len()).prop_map(|i| &EscStatus::DEFINITIONS[i])
}

proptest! {
    /// Whatever the bytes: what is read is written as it was, but for padding.
    #[test]
    fn bytes_are_what_they_were(definition in any_definition(), body in prop::collection::vec(any::<u8>(), 491)) {
        let payload = payload(definition, &body);
        let mut buffer = [0; 512];
        let written = EscStatus::from_cdr_as(definition, &payload).unwrap().to_cdr(definition, &mut buffer).unwrap();
        let masked: Vec<u8> = payload.iter().zip(mask(definition)).map(|(byte, mask)| byte & mask).collect();
        prop_assert_eq!(written, masked);
    }

    /// Values of one definition are the same after another, or are refused with the field that does not fit.
    #[test]
    fn values_fit_another_definition_or_are_refused(
        (from, to) in (any_definition(), any_definition()),
        body in prop::collection::vec(any::<u8>(), 491),
        is_small in any::<bool>(),
    ) {
        let mut status = EscStatus::from_cdr_as(from, &payload(from, &body)).unwrap();
        if is_small {
            status.esc_online_flags &= 0xff;
            status.esc_armed_flags &= 0xff;
            status.esc[8..].fill(mavlink_autoquad::px4::EscReport::UNKNOWN);
        }
        let is_narrow = to.name != EscStatus::MAIN.name && from.name == EscStatus::MAIN.name;
        match status.to_cdr(to, &mut [0; 512]) {
            Err(CdrError::DoesNotFit { .. }) => prop_assert!(is_narrow && !is_small),
            Err(other) => prop_assert!(false, "{}", other),
            Ok(payload) => {
                let again = EscStatus::from_cdr_as(to, payload).unwrap();
                prop_assert_eq!(again.esc_online_flags, status.esc_online_flags);
                prop_assert_eq!(again.esc[0].failures, status.esc[0].failures);
                prop_assert_eq!(again.esc.map(|esc| esc.esc_rpm), status.esc.map(|esc| esc.esc_rpm));
            }
        }
    }

    /// Whatever the bytes and their number: an error, or a value; no panic.
    #[test]
    fn any_payload_is_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..520)) {
        let by_length = EscStatus::from_cdr(&bytes);
        for definition in EscStatus::DEFINITIONS {
            prop_assert!(by_length.is_ok() || EscStatus::from_cdr_as(definition, &bytes).is_err());
        }
    }
}
