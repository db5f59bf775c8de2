//! rust-mavlink as a second, independent decoder and encoder.

use std::collections::BTreeMap;

use mavlink::dialects::common::MavMessage;
use mavlink::error::{MessageReadError, ParserError};
use mavlink::{MavHeader, MavlinkReader, MavlinkVersion};
use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::{Dialect, Encode, Frame, Invalid, MAX_FRAME, MAX_PAYLOAD, Sender, Sentinel, Version};
use mavlink_interop::golden_frames;
use serde_json::Value;

/// What their decoder makes of one frame.
enum Theirs {
    Message(MavHeader, MavMessage),
    /// Its `common` does not have the message, or has another definition of it.
    Unknown,
    /// It refuses the value of an enum.
    Refused,
}

fn theirs(frame: &[u8]) -> Theirs {
    match MavlinkReader::new(frame).read_any_message::<MavMessage>() {
        Ok((header, message)) => Theirs::Message(header, message),
        Err(MessageReadError::Parse(ParserError::InvalidEnum { .. })) => Theirs::Refused,
        Err(MessageReadError::Io(_)) => Theirs::Unknown,
        Err(error) => panic!("{error} over {frame:02x?}"),
    }
}

/// The frame as our sender makes it.
fn encoded(frame: &Frame<'_>) -> (Autoquad, Vec<u8>) {
    let message: Autoquad = frame.message().unwrap();
    let mut sender = match frame.version() {
        Version::V1 => Sender::v1(frame.system_id(), frame.component_id()),
        Version::V2 => Sender::v2(frame.system_id(), frame.component_id()),
    };
    sender.set_sequence(frame.sequence());
    (message, sender.encode(&message, &mut [0; MAX_FRAME]).unwrap().to_vec())
}

fn payload(message: &Autoquad) -> Vec<u8> {
    message.payload(Version::V2, &mut [0; MAX_PAYLOAD]).to_vec()
}

#[test]
fn rust_mavlink_decodes_what_we_encode_and_the_reverse() {
    let mut counts = BTreeMap::new();
    for golden in golden_frames() {
        let frame = Frame::parse(&golden, Autoquad::TABLE).unwrap();
        let (ours, bytes) = encoded(&frame);
        let outcome = match theirs(&bytes) {
            Theirs::Unknown => "unknown",
            Theirs::Refused => "refused",
            Theirs::Message(header, message) => {
                let expected = (frame.system_id().to_u32(), frame.component_id().to_u32(), frame.sequence());
                assert_eq!((header.system_id, u32::from(header.component_id), header.sequence), expected);
                same_values(&ours, &message);
                same_frame(&ours, frame.version(), header, &message);
                "same"
            }
        };
        *counts.entry(outcome).or_insert(0) += 1;
    }
    println!("{counts:?}");
    assert!(counts["same"] >= 3672, "{counts:?}");
}

/// What they encode, we decode.
fn same_frame(ours: &Autoquad, version: Version, header: MavHeader, message: &MavMessage) {
    let version = match version {
        Version::V1 => MavlinkVersion::V1,
        Version::V2 => MavlinkVersion::V2,
    };
    let mut bytes = Vec::new();
    mavlink::write_versioned_msg(&mut bytes, version, header, message).unwrap();
    let frame = Frame::parse(&bytes, Autoquad::TABLE).unwrap();
    let back: Autoquad = frame.message().unwrap();
    assert_eq!(payload(&back), payload(ours), "{ours:?} from {bytes:02x?}");
}

/// Their JSON has the same fields, and read by us the same values, where it has everything.
fn same_values(message: &Autoquad, theirs: &MavMessage) {
    // Text that is not UTF-8 is an error there.
    let Ok(theirs) = serde_json::to_value(theirs) else { return };
    let read: Autoquad = serde_json::from_value(theirs.clone()).unwrap();
    let [ours, read] = [message, &read].map(|message| serde_json::to_value(message).unwrap());
    let (ours, read, theirs) = (ours.as_object().unwrap(), read.as_object().unwrap(), theirs.as_object().unwrap());
    assert_eq!(ours.len(), theirs.len());
    for (key, value) in theirs {
        let (Some(ours), Some(read)) = (ours.get(key), read.get(key)) else { panic!("{key} of {theirs:?}") };
        let bytes_behind_nul = value.is_string() && ours.is_array();
        assert!(bytes_behind_nul || is_same(unknown(message, key), ours, read, value), "{key}: {ours} and {value}");
    }
}

/// Whether the value that was read is ours. What JSON has no number for is `null` there; we read that as NaN or, in a field that
/// has one, as the number that stands for "not known".
fn is_same(unknown: Option<f64>, ours: &Value, read: &Value, theirs: &Value) -> bool {
    match (ours, read, theirs) {
        (Value::String(_), Value::String(read), Value::Null) => read == "NaN",
        (Value::String(_), Value::Number(read), Value::Null) => unknown.is_some() && read.as_f64() == unknown,
        (Value::Array(ours), Value::Array(read), Value::Array(theirs)) => {
            let all = ours.iter().zip(read).zip(theirs);
            ours.len() == read.len()
                && all.into_iter().all(|((ours, read), theirs)| is_same(unknown, ours, read, theirs))
        }
        _ => ours == read,
    }
}

/// The number that says "not known" in a field of floats.
fn unknown(message: &Autoquad, field: &str) -> Option<f64> {
    let fields = Autoquad::fields(message.info().id)?;
    match fields.iter().find(|info| info.name == field)?.invalid? {
        Invalid::Each(Sentinel::Float(number)) => Some(number),
        _ => None,
    }
}
