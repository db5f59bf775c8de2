//! On the machine that builds it, with the readers that need an operating system.

use std::hint::black_box;
use std::io::Cursor;
use std::net::UdpSocket;
use std::pin::pin;
use std::process::ExitCode;
use std::task::{Context, Poll, Waker};

use bytes::BytesMut;
use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::tokio_codec::Codec;
use mavlink_autoquad::wire::{Dialect, Frame, Sender, embedded_io_async, io, tlog, udp};
use mavlink_stack::{Measured, everywhere, most_of_bytes};
use tokio_util::codec::Decoder;

fn main() -> ExitCode {
    let mut is_too_much = false;
    let report = &mut |measured: Measured| {
        println!("{:6} of {:6} bytes: {}", measured.bytes, measured.limit, measured.what);
        is_too_much |= measured.is_too_much();
    };
    everywhere(report);
    report(Measured::of_reading("io::FrameReader", io_reader()));
    report(Measured::of_reading("embedded_io_async::FrameReader", embedded_io_async_reader()));
    report(Measured::of_reading("tlog::Reader", tlog_reader()));
    report(Measured::of_reading("tokio_codec::Codec", codec()));
    report(Measured::of_reading("udp::Endpoint", endpoint()));
    if is_too_much { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

fn io_reader() -> usize {
    most_of_bytes(&mut |bytes, used| {
        let mut reader = io::FrameReader::new(bytes, Autoquad::TABLE);
        used(&mut || while black_box(reader.receive()).is_ok_and(|frame| frame.is_some()) {});
    })
}

/// The link always has its bytes, so that one look at the future is enough.
fn embedded_io_async_reader() -> usize {
    most_of_bytes(&mut |bytes, used| {
        let mut reader = embedded_io_async::FrameReader::<_>::new(bytes, Autoquad::TABLE);
        used(&mut || {
            loop {
                let received = pin!(reader.receive()).poll(&mut Context::from_waker(Waker::noop()));
                let Poll::Ready(received) = black_box(received) else { unreachable!("the bytes are there") };
                if !received.is_ok_and(|frame| frame.is_some()) {
                    break;
                }
            }
        });
    })
}

fn tlog_reader() -> usize {
    most_of_bytes(&mut |bytes, used| {
        let (Ok(frame), mut entry) = (Frame::parse(bytes, Autoquad::TABLE), [0; tlog::MAX_ENTRY]) else { return };
        let Some(entry) = tlog::encode(1_700_000_000_000_000, &frame, &mut entry) else { return };
        let mut reader = tlog::Reader::new(Cursor::new(entry), Autoquad::TABLE);
        used(&mut || while black_box(reader.read()).is_ok_and(|entry| entry.is_some()) {});
    })
}

fn codec() -> usize {
    most_of_bytes(&mut |bytes, used| {
        let mut codec = Codec::new(Autoquad::TABLE, Sender::v2(1, 1));
        let mut bytes = BytesMut::from(bytes);
        used(&mut || while black_box(codec.decode(&mut bytes)).is_ok_and(|frame| frame.is_some()) {});
    })
}

fn endpoint() -> usize {
    let socket = UdpSocket::bind("127.0.0.1:0").expect("a socket of this machine");
    let (to, from) = (socket.local_addr().expect("its address"), UdpSocket::bind("127.0.0.1:0").expect("a socket"));
    let mut endpoint = udp::Endpoint::new(socket, Autoquad::TABLE, Sender::v2(1, 1));
    most_of_bytes(&mut |bytes, used| {
        from.send_to(bytes, to).expect("a datagram to this machine");
        used(&mut || {
            black_box(endpoint.receive()).map(|(frame, _)| frame.message_id()).expect("it was sent");
        });
    })
}
