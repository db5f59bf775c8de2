//! Making and verifying signatures, beside the hash that they are: `cargo run --release --features signing --bin signing`.

use std::array;
use std::error::Error;
use std::hint::black_box;

use mavlink_autoquad::autoquad::{AqEscTelemetry, Autoquad, FileTransferProtocol, Heartbeat};
use mavlink_autoquad::wire::signing::{Key, Signer, Verifier};
use mavlink_autoquad::wire::{Dialect, Encode, Frame, MAX_FRAME, Message, Sender, Timestamp};
use mavlink_bench::rounds::{Contender, compare};
use sha2::{Digest, Sha256};

/// A round has this many frames.
const FRAMES: usize = 20_000;
/// Bytes of the hash that are sent.
const HASH: usize = 6;

fn main() -> Result<(), Box<dyn Error>> {
    let beat = Heartbeat { custom_mode: 7, ..Heartbeat::DEFAULT };
    let telemetry = AqEscTelemetry { data_version: [3; 4], ..AqEscTelemetry::DEFAULT };
    let file = FileTransferProtocol { payload: [7; 251], ..FileTransferProtocol::DEFAULT };
    measure(&beat)?;
    measure(&telemetry)?;
    measure(&file)
}

fn measure(message: &impl Encode) -> Result<(), Box<dyn Error>> {
    let (mut plain, mut signing, mut buffer) = (Sender::v2(1, 1), signed(), [0; MAX_FRAME]);
    let stream = (0..FRAMES).map(|_| signing.encode(message, &mut buffer).map(<[u8]>::to_vec));
    let stream: Vec<Vec<u8>> = stream.collect::<Result<_, _>>()?;
    let frames: Vec<Frame<'_>> =
        stream.iter().map(|bytes| Frame::parse(bytes, Autoquad::TABLE)).collect::<Result<_, _>>()?;
    let length = frames.first().map_or(0, |frame| frame.payload().len());
    println!("{}: payload of {length} bytes; the ratios are to the hash alone", message.info().name);
    compare(
        message.info().name,
        vec![
            Contender::new("encode, unsigned", || encode(&mut plain, message)),
            Contender::new("encode, signed", || encode(&mut signing, message)),
            Contender::new("verify", || verify(&frames)),
            Contender::new("SHA-256 alone", || hash(&stream)),
        ],
    );
    Ok(())
}

fn secret() -> [u8; 32] {
    array::from_fn(|at| at as u8)
}

fn signed() -> Sender {
    Sender::v2(1, 1).signed(Signer::new(Key::new(secret()), 0, Timestamp::new(1)))
}

fn encode(sender: &mut Sender, message: &impl Encode) -> usize {
    let mut buffer = [0; MAX_FRAME];
    let made = (0..FRAMES)
        .map(|_| sender.encode(black_box(message), &mut buffer).is_ok_and(|frame| !black_box(frame).is_empty()));
    made.filter(|made| *made).count()
}

/// A new receiver each time, which accepts every frame.
fn verify(frames: &[Frame<'_>]) -> usize {
    let mut verifier = Verifier::new(Some(Key::new(secret())));
    frames.iter().filter(|frame| verifier.check(frame, Timestamp::ZERO).is_ok()).count()
}

/// What every signature costs at least.
fn hash(stream: &[Vec<u8>]) -> usize {
    for frame in stream {
        let hashed = frame.get(..frame.len() - HASH).unwrap_or_default();
        black_box(Sha256::new().chain_update(secret()).chain_update(hashed).finalize());
    }
    stream.len()
}
