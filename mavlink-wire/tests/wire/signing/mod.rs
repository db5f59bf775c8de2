//! Signatures: the frames that a holder of the key makes, and which ones are believed.

mod clock;
mod forgery;
mod key;
mod resigning;
mod sending;
mod setup;
mod streams;
mod unsigned;

use crate::small::{Heartbeat, MavState, Small};
use mavlink_wire::signing::{Key, Signer, SigningError, Stream, Trust, Verifier};
use mavlink_wire::{Dialect, Encode, Frame, MAX_FRAME, Message, Sender, Timestamp};

/// One minute.
const MINUTE: u64 = 6_000_000;

const HEARTBEAT: Heartbeat =
    Heartbeat { r#type: 6, autopilot: 8, system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT };

/// The key of the vectors: 00 01 02 … 1f.
fn key() -> Key {
    Key::new(std::array::from_fn(|at| at as u8))
}

fn at(units: u64) -> Timestamp {
    Timestamp::new(units)
}

fn stream(link_id: u8, system: u8, component: u8, timestamp: u64) -> Stream {
    Stream::new(link_id, system.into(), component.into(), at(timestamp))
}

/// What a sender makes.
fn made(sender: &mut Sender, message: &dyn Encode) -> Vec<u8> {
    sender.encode(message, &mut [0xA5; MAX_FRAME]).unwrap().to_vec()
}

/// A signed heartbeat of this stream.
fn frame_of(stream: Stream) -> Vec<u8> {
    let signer = Signer::new(key(), stream.link_id, stream.timestamp);
    made(&mut Sender::v2(stream.system_id, stream.component_id).signed(signer), &HEARTBEAT)
}

/// A signed heartbeat of the stream 1/1 on link 3.
fn frame_at(timestamp: u64) -> Vec<u8> {
    frame_of(stream(3, 1, 1, timestamp))
}

/// What a verifier says of these bytes, without a clock.
fn checked<const N: usize>(verifier: &mut Verifier<N>, bytes: &[u8]) -> Result<Trust, SigningError> {
    verifier.check(&Frame::parse(bytes, Small::TABLE).unwrap(), Timestamp::ZERO)
}
