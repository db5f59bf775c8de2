//! Payloads that rosbags made of known values, for two definitions.

use mavlink_wire::uorb::cdr::CdrError;
use mavlink_wire::uorb::{Topic, TopicByLength};

use crate::golden::{MAIN, V1_14, read};
use crate::topic::EscStatus;

/// The payload in one of the files, which are hexadecimal.
fn payload(text: &str) -> Vec<u8> {
    let digits: Vec<u8> = text.trim().bytes().map(|digit| char::from(digit).to_digit(16).unwrap() as u8).collect();
    digits.as_chunks().0.iter().map(|[high, low]| high << 4 | low).collect()
}

fn golden() -> [(Vec<u8>, EscStatus); 4] {
    let logged = |log, i: usize| read(log)[i].1;
    [
        (payload(include_str!("cdr/main_autoquad.hex")), logged(MAIN, 0)),
        (payload(include_str!("cdr/main_edge.hex")), logged(MAIN, 1)),
        (payload(include_str!("cdr/v1_14_autoquad.hex")), logged(V1_14, 0)),
        (payload(include_str!("cdr/v1_14_edge.hex")), logged(V1_14, 1)),
    ]
}

/// NaN is not equal to itself; its text is.
fn same(a: &EscStatus, b: &EscStatus) -> bool {
    format!("{a:?}") == format!("{b:?}")
}

#[test]
fn payloads_say_what_logs_say() {
    for (payload, logged) in golden() {
        let read = EscStatus::from_cdr(&payload).unwrap();
        assert!(same(&read, &logged), "{read:?}\n{logged:?}");
    }
}

#[test]
fn what_was_read_is_written_as_it_was() {
    for (i, (payload, _)) in golden().iter().enumerate() {
        let definition = if i < 2 { EscStatus::MAIN } else { EscStatus::V1_14 };
        let status = EscStatus::from_cdr_as(&definition, payload).unwrap();
        assert_eq!(status.to_cdr(&definition, &mut [0xff; 512]).unwrap(), payload);
    }
}

#[test]
fn padding_to_four_bytes_is_taken_and_no_other_length() {
    let (mut payload, logged) = golden()[0].clone();
    payload.push(0);
    assert!(same(&EscStatus::from_cdr(&payload).unwrap(), &logged));
    payload.push(0);
    let error = EscStatus::from_cdr(&payload).unwrap_err();
    assert_eq!(error.to_string(), "a body of 493 bytes; known are 491 (main), 331 (v1_14)");
    let error = EscStatus::from_cdr_as(&EscStatus::V1_14, &golden()[0].0).unwrap_err();
    assert_eq!(error.to_string(), "a body of 491 bytes; known are 331 (v1_14)");
}

#[test]
fn other_encodings_are_refused() {
    let (mut payload, _) = golden()[0].clone();
    for high_low in [[0, 0], [0, 3], [0, 7], [1, 1]] {
        payload[..2].copy_from_slice(&high_low);
        assert_eq!(EscStatus::from_cdr(&payload), Err(CdrError::Encoding(high_low)));
    }
    assert_eq!(EscStatus::from_cdr(&payload[..3]), Err(CdrError::NoHeader));
}

#[test]
fn what_does_not_fit_is_refused() {
    let status = EscStatus { esc_online_flags: 0x100, ..EscStatus::UNKNOWN };
    assert_eq!(
        status.to_cdr(&EscStatus::V1_14, &mut [0; 512]),
        Err(CdrError::DoesNotFit { field: "esc_online_flags" })
    );
    assert!(status.to_cdr(&EscStatus::MAIN, &mut [0; 512]).is_ok());
    assert_eq!(status.to_cdr(&EscStatus::MAIN, &mut [0; 494]), Err(CdrError::NoRoom { needed: 495 }));
}

#[test]
fn the_key_of_zenoh_has_the_hash_of_the_type() {
    assert_eq!(
        EscStatus::MAIN.zenoh_key(0, "/fmu/out/esc_status").to_string(),
        "0/fmu/out/esc_status/px4_msgs::msg::dds_::EscStatus_/\
         RIHS01_85dc04703b64002f2a39e5909078ae7b7301da32ef14a04329f4ca9e40e635a2"
    );
}
