//! The stack that decoding a frame and finding one need: the most for any message of a dialect.

#![no_std]

mod paint;

use core::convert::Infallible;
use core::hint::black_box;

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::embedded_io::FrameReader;
use mavlink_autoquad::wire::{Dialect, Encode, Frame, MAX_FRAME, MAX_PAYLOAD, MessageInfo, Sender};

pub use paint::{copy_of, copy_used, lies_in, used};

/// The most that decoding may take, in bytes.
const DECODING: usize = if cfg!(debug_assertions) { 6 * 1024 } else { 1536 };

/// The most that a reader may take.
const READING: usize = DECODING + 1024;

/// What was measured.
pub struct Measured {
    pub what: &'static str,
    pub bytes: usize,
    pub limit: usize,
}

impl Measured {
    pub fn is_too_much(&self) -> bool {
        self.bytes > self.limit
    }

    pub fn of_decoding(what: &'static str, bytes: usize) -> Self {
        Self { what, bytes, limit: DECODING }
    }

    pub fn of_reading(what: &'static str, bytes: usize) -> Self {
        Self { what, bytes, limit: READING }
    }
}

/// What can be measured on every machine.
pub fn everywhere(report: &mut dyn FnMut(Measured)) {
    let mut message = Autoquad::DEFAULT;
    let into = most(&mut |frame| {
        black_box(frame.decode_into(black_box(&mut message)));
    });
    report(Measured::of_decoding("Frame::decode_into", into));
    let by_value = most(&mut |frame| {
        black_box(frame.message::<Autoquad>());
    });
    report(Measured::of_decoding("Frame::message", by_value));
    let read = most_of_bytes(&mut |bytes, used| {
        let mut reader = FrameReader::new(Bytes(bytes), Autoquad::TABLE);
        used(&mut || while black_box(reader.receive()).is_ok_and(|frame| frame.is_some()) {});
    });
    report(Measured::of_reading("embedded_io::FrameReader", read));
}

/// The most stack that this takes with the frame of any message, whole and cut.
pub fn most(work: &mut dyn FnMut(&Frame<'_>)) -> usize {
    most_of_bytes(&mut |bytes, used| {
        if let Ok(frame) = Frame::parse(bytes, Autoquad::TABLE) {
            used(&mut || work(&frame));
        }
    })
}

/// The most stack that what is handed to `used` takes, with the frames of any message as bytes.
pub fn most_of_bytes(work: &mut dyn FnMut(&[u8], &mut dyn FnMut(&mut dyn FnMut()))) -> usize {
    let (mut sender, mut buffer, mut most) = (Sender::v2(1, 1), [0; MAX_FRAME], 0);
    for info in Autoquad::TABLE.iter() {
        // Zeros at the end are not sent: the payload is short then.
        for length in [0, info.len_v2] {
            let Ok(bytes) = sender.encode(&Filled { info, length }, &mut buffer) else { continue };
            work(bytes, &mut |measured| most = most.max(used(measured)));
        }
    }
    most
}

/// A payload of which so many bytes are not zero.
struct Filled {
    info: &'static MessageInfo,
    length: u8,
}

impl Encode for Filled {
    fn info(&self) -> &'static MessageInfo {
        self.info
    }

    fn write(&self, payload: &mut [u8; MAX_PAYLOAD]) {
        payload.fill(0);
        payload[..self.length.into()].fill(0x33);
    }
}

/// A link that gives these bytes.
struct Bytes<'b>(&'b [u8]);

impl embedded_io::ErrorType for Bytes<'_> {
    type Error = Infallible;
}

impl embedded_io::Read for Bytes<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Infallible> {
        let length = buffer.len().min(self.0.len());
        let (now, later) = self.0.split_at(length);
        buffer[..length].copy_from_slice(now);
        self.0 = later;
        Ok(length)
    }
}
