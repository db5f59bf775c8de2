//! What is known of frames, in text and in bytes.

use mavlink_wire::serde::{Envelope, Header};
use mavlink_wire::{
    ComponentId, Dialect, Frame, FrameBuf, Losses, Message, Parser, Received, Sender, Statistics, SystemId, Timestamp,
    Version,
};
use serde_core::{Serialize, de::DeserializeOwned};

use crate::small::{Heartbeat, Small};
use crate::streams::pieces::{encoded, with_checksum};

/// Writes and reads a value in JSON and in postcard; gives the JSON.
fn there_and_back<T: Serialize + DeserializeOwned + PartialEq + std::fmt::Debug>(value: &T) -> String {
    let json = serde_json::to_string(value).unwrap();
    assert_eq!(&serde_json::from_str::<T>(&json).unwrap(), value, "{json}");
    let mut buffer = [0; 300];
    let bytes = postcard::to_slice(value, &mut buffer).unwrap();
    assert_eq!(&postcard::from_bytes::<T>(bytes).unwrap(), value, "{json}");
    json
}

fn beat() -> Vec<u8> {
    encoded(Sender::v2(1, 2), 7, &Heartbeat::DEFAULT.into())
}

#[test]
fn ids_times_and_versions_are_numbers() {
    assert_eq!(there_and_back(&SystemId::from(255)), "255");
    assert_eq!(there_and_back(&ComponentId::from(1)), "1");
    assert_eq!(there_and_back(&Timestamp::MAX), "281474976710655");
    assert_eq!([Version::V1, Version::V2].map(|version| there_and_back(&version)), ["1", "2"]);
    let refused = [
        serde_json::from_str::<SystemId>("256").map(drop),
        serde_json::from_str::<ComponentId>("-1").map(drop),
        serde_json::from_str::<Timestamp>("281474976710656").map(drop),
        serde_json::from_str::<Version>("3").map(drop),
    ];
    assert!(refused.iter().all(Result::is_err), "{refused:?}");
    assert!(refused[0].as_ref().unwrap_err().to_string().contains("`256`, expected an id up to 255"));
}

#[test]
fn counters_are_structs() {
    let (bytes, mut parser, mut losses) = (beat(), Parser::new(Small::TABLE), Losses::<1>::new());
    losses.count(&parser.next(&mut &bytes[..]).unwrap());
    let json = there_and_back::<Statistics>(&parser.statistics());
    assert_eq!(json, r#"{"frames":1,"unverified":0,"bad_checksums":0,"skipped_bytes":0}"#);
    let json = there_and_back::<Received>(&losses.of(1, 2).unwrap());
    assert!(json.starts_with(r#"{"system_id":1,"component_id":2,"received":1,"#), "{json}");
    // Any order, and fields of a later version.
    let json = r#"{"skipped_bytes":4,"later":[{}],"frames":1,"bad_checksums":3,"unverified":2}"#;
    let read: Statistics = serde_json::from_str(json).unwrap();
    assert_eq!((read.frames, read.unverified, read.bad_checksums, read.skipped_bytes), (1, 2, 3, 4));
    let error = serde_json::from_str::<Statistics>(r#"{"frames":1}"#).unwrap_err().to_string();
    assert!(error.contains("missing field `unverified`"), "{error}");
}

#[cfg(feature = "signing")]
#[test]
fn streams_can_be_saved() {
    use mavlink_wire::signing::Stream;
    let stream = Stream::new(3, 1.into(), 2.into(), Timestamp::new(9));
    assert_eq!(there_and_back(&stream), r#"{"link_id":3,"system_id":1,"component_id":2,"timestamp":9}"#);
}

#[test]
fn a_frame_has_its_header_and_its_bytes() {
    let bytes = beat();
    let frame = Frame::parse(&bytes, Small::TABLE).unwrap();
    let hexadecimal: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
    let expected = format!(
        r#"{{"version":2,"system_id":1,"component_id":2,"sequence":7,"message_id":0,"bytes":"{hexadecimal}"}}"#
    );
    assert_eq!(serde_json::to_string(&frame).unwrap(), expected);
    assert_eq!(serde_json::to_string(&FrameBuf::from(frame)).unwrap(), expected);
    let mut buffer = [0; 300];
    let written = postcard::to_slice(&frame, &mut buffer).unwrap();
    assert_eq!(&written[1..], bytes, "behind the length");
}

#[test]
fn a_frame_that_carries_a_key_is_not_written() {
    let key = with_checksum([&[0xFD, 1, 0, 0, 0, 1, 1, 0, 1, 0][..], &[7]].concat(), 71);
    let frame = Frame::parse(&key, Small::TABLE).unwrap();
    assert!(serde_json::to_string(&frame).unwrap_err().to_string().starts_with("SETUP_SIGNING carries a secret key"));
    assert!(postcard::to_slice(&FrameBuf::from(frame), &mut [0; 300]).is_err());
}

#[test]
fn a_message_can_carry_its_header() {
    let bytes = beat();
    let frame = Frame::parse(&bytes, Small::TABLE).unwrap();
    let envelope = Envelope::<Small>::of(&frame).unwrap();
    let json = there_and_back(&envelope);
    let start = r#"{"header":{"system_id":1,"component_id":2,"sequence":7},"message":{"type":"HEARTBEAT","#;
    assert!(json.starts_with(start), "{json}");
    let alone = Envelope::new(Header::of(&frame), Heartbeat::DEFAULT);
    assert!(there_and_back(&alone).contains(r#""message":{"mavtype":"#));
    assert!(
        Envelope::<Small>::of(&Frame::parse(&with_checksum(vec![0xFE, 1, 0, 1, 1, 200, 7], 3), Small::TABLE).unwrap())
            .is_none()
    );
}
