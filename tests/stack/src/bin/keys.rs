//! Looks for a signing key where it should be gone: on the stack that was used, and in what has sent or received it.

use std::hint::black_box;
use std::io::sink;
use std::process::ExitCode;

use mavlink_autoquad::autoquad::{Autoquad, Heartbeat};
use mavlink_autoquad::wire::signing::{Key, Setup, Signer, Verifier};
use mavlink_autoquad::wire::{Dialect, Frame, FrameBuf, MAX_FRAME, Message, Parser, Sender, Timestamp, io};
use mavlink_stack::{copy_of, copy_used, lies_in};

fn main() -> ExitCode {
    let secret: Box<[u8; 32]> = Box::new(core::array::from_fn(|at| (7 * at + 0x61) as u8));
    let mut failed = false;
    let mut report = |what: &str, found: bool, expected: bool| {
        println!("{}: {what}", if found { "found" } else { "gone" });
        failed |= found != expected;
    };
    // What does not find this finds nothing.
    report("a copy that nobody wiped", left(&secret, &mut || leave(&secret)), true);
    report("a copy with the words turned round", left(&secret, &mut || leave(&turned(&secret))), true);

    let signer = || Signer::new(Key::new(*secret), 1, Timestamp::new(1000));
    let mut sender = Box::new(Sender::v2(1, 1).signed(signer()));
    let mut buffer = Box::new([0; MAX_FRAME]);
    let signed = sender.encode(&Heartbeat::DEFAULT, &mut buffer).expect("a frame").to_vec();
    let frame = Frame::parse(&signed, Autoquad::TABLE).expect("the frame");
    let mut verifier = Box::new(Verifier::<16>::new(Some(Key::new(*secret))));
    let check = &mut || _ = black_box(verifier.check(&frame, Timestamp::ZERO));
    report("Verifier::check of a genuine frame", left(&secret, check), false);
    report("Verifier::check of a replay", left(&secret, check), false);
    let encode = &mut || _ = black_box(sender.encode(&Heartbeat::DEFAULT, &mut buffer));
    report("Sender::encode with a signature", left(&secret, encode), false);
    let renumber = &mut || _ = black_box(sender.renumber(&frame));
    report("Sender::renumber with a signature", left(&secret, renumber), false);
    let (mut buf, mut signer) = (Box::new(FrameBuf::from(frame)), Box::new(signer()));
    report(
        "FrameBuf::sign",
        left(&secret, &mut || {
            let _ = black_box(buf.sign(&mut signer));
        }),
        false,
    );

    let setup = Box::new(Setup::new(1, 1, Key::new(*secret), Timestamp::new(1)).expect("it is named"));
    let mut writer = made(|| io::FrameWriter::new(sink(), Sender::v2(255, 190)));
    let send = &mut || _ = black_box(writer.send(&*setup));
    report("the stack of FrameWriter::send", left(&secret, send), false);
    report("FrameWriter", kept(&secret, &*writer), false);
    let mut refusing = made(|| io::FrameWriter::new(sink(), Sender::v1(255, 190)));
    drop(black_box(refusing.send(&*setup)));
    report("FrameWriter that cannot carry it", kept(&secret, &*refusing), false);

    let bytes = Sender::v2(255, 190).encode(&*setup, &mut buffer).expect("a frame").to_vec();
    let mut parser = made(|| Parser::new(Autoquad::TABLE));
    for mut chunk in bytes.chunks(20).chain([&[][..]]) {
        while parser.next(&mut chunk).is_some() {}
    }
    report("Parser", kept(&secret, &*parser), false);
    let mut reader = made(|| io::FrameReader::new(Pieces(&bytes), Autoquad::TABLE));
    while reader.receive().expect("no error").is_some() {}
    report("FrameReader", kept(&secret, &*reader), false);
    if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

/// Whether a part of the secret is left on the stack that this took.
fn left(secret: &[u8; 32], work: &mut dyn FnMut()) -> bool {
    let mut stack = vec![0; 64_000];
    copy_used(work, &mut stack);
    lies_in(secret, &stack)
}

/// Whether a part of the secret lies in a value.
fn kept<T>(secret: &[u8; 32], value: &T) -> bool {
    let mut bytes = vec![0; size_of::<T>()];
    copy_of(value, &mut bytes);
    lies_in(secret, &bytes)
}

/// A value without what lay on the stack before: what a value leaves unused of its memory is copied along with it.
fn made<T>(make: impl Fn() -> T) -> Box<T> {
    let mut made = None;
    copy_used(&mut || made = Some(Box::new(make())), &mut []);
    made.expect("it was made")
}

/// Leaves a copy on the stack.
#[inline(never)]
fn leave(secret: &[u8; 32]) {
    let mut deep = [0_u8; 2048];
    deep[512..544].copy_from_slice(secret);
    black_box(&mut deep);
}

/// As a hash has it in registers of 32 bits.
fn turned(secret: &[u8; 32]) -> [u8; 32] {
    let mut turned = *secret;
    turned.chunks_exact_mut(4).for_each(<[u8]>::reverse);
    turned
}

/// Gives up to 30 bytes at a time: frames are cut.
struct Pieces<'b>(&'b [u8]);

impl std::io::Read for Pieces<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let length = buffer.len().min(30).min(self.0.len());
        let (now, later) = self.0.split_at(length);
        buffer[..length].copy_from_slice(now);
        self.0 = later;
        Ok(length)
    }
}
