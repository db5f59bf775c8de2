//! The adapters, over real sockets and pipes on the loopback interface.

mod bad_checksums;
#[cfg(feature = "signing")]
mod keys;
mod link;
mod scripted;
mod std_io;
mod udp;
#[cfg(feature = "signing")]
mod udp_signed;

#[cfg(feature = "embedded-io")]
mod embedded_io;
#[cfg(feature = "embedded-io-async")]
mod embedded_io_async;
#[cfg(feature = "tokio-codec")]
mod tokio_codec;

use mavlink_wire::{Frame, Message, Sender, Version};

use crate::small::{AqEscTelemetry, Heartbeat, Small};

/// A message for each number.
fn message(number: u32) -> Small {
    match number % 3 {
        0 => AqEscTelemetry { time_boot_ms: number, ..AqEscTelemetry::DEFAULT }.into(),
        _ => Heartbeat { custom_mode: number, ..Heartbeat::DEFAULT }.into(),
    }
}

/// What a sender makes of the messages with these numbers.
fn stream(mut sender: Sender, numbers: core::ops::Range<u32>) -> Vec<u8> {
    let mut buffer = [0; mavlink_wire::MAX_FRAME];
    numbers.flat_map(|number| sender.encode(&message(number), &mut buffer).unwrap().to_vec()).collect()
}

/// Number and message of a frame.
fn read(frame: &Frame<'_>) -> (u8, Option<Small>) {
    (frame.sequence(), frame.message())
}

/// The same as it was sent.
fn sent(numbers: core::ops::Range<u32>) -> Vec<(u8, Option<Small>)> {
    numbers.map(|number| (number as u8, Some(message(number)))).collect()
}

#[test]
fn the_stream_has_both_versions_of_frames() {
    for (sender, version) in [(Sender::v1(1, 1), Version::V1), (Sender::v2(1, 1), Version::V2)] {
        let bytes = stream(sender, 0..1);
        assert_eq!(Frame::parse(&bytes, <Small as mavlink_wire::Dialect>::TABLE).unwrap().version(), version);
    }
}

/// A message that MAVLink 1 cannot carry.
struct TooLarge;

impl mavlink_wire::Encode for TooLarge {
    fn info(&self) -> &'static mavlink_wire::MessageInfo {
        const { &mavlink_wire::MessageInfo::new(70_000, "TOO_LARGE", 1, 1) }
    }

    fn write(&self, _: &mut [u8; 255]) {}
}

/// A `SETUP_SIGNING`, which nobody forwards.
fn key() -> Vec<u8> {
    crate::streams::pieces::with_checksum([&[0xFD, 1, 0, 0, 0, 1, 1, 0, 1, 0][..], &[7]].concat(), 71)
}
