//! `std::io`.

use std::io::{ErrorKind, Write, pipe};
use std::net::{TcpListener, TcpStream};
use std::thread;
use std::time::Duration;

use mavlink_wire::io::{FrameReader, FrameWriter};
use mavlink_wire::{Dialect, EncodeError, Frame, Sender, Table};
use proptest::prelude::*;

use super::scripted::{Scripted, Step};
use super::{key, message, read, sent, stream};
use crate::small::Small;
use crate::streams::pieces::{cut, pieces};
use crate::streams::reference::scanned;

fn connected() -> (TcpStream, TcpStream) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let near = TcpStream::connect(listener.local_addr().unwrap()).unwrap();
    (near, listener.accept().unwrap().0)
}

fn all<R: std::io::Read>(reader: &mut FrameReader<'_, R>) -> Vec<(u8, Option<Small>)> {
    let mut frames = vec![];
    while let Some(frame) = reader.receive().unwrap() {
        frames.push(read(&frame));
    }
    frames
}

#[test]
fn messages_cross_a_tcp_stream_both_ways() {
    let (near, far) = connected();
    let echo = thread::spawn(move || {
        let mut reader = FrameReader::new(far.try_clone().unwrap(), Small::TABLE);
        let mut writer = FrameWriter::new(far, Sender::v2(9, 9));
        while let Some(frame) = reader.receive().unwrap() {
            writer.send_frame(&frame).unwrap();
        }
    });
    let mut writer = FrameWriter::new(near.try_clone().unwrap(), Sender::v1(1, 1));
    for number in 0..200 {
        writer.send(&message(number)).unwrap();
    }
    near.shutdown(std::net::Shutdown::Write).unwrap();
    assert_eq!(all(&mut FrameReader::new(near, Small::TABLE)), sent(0..200));
    echo.join().unwrap();
}

/// A wrong baud rate, and no end of it.
#[test]
fn a_call_returns_after_64_kib_without_a_frame() {
    use std::io::Read;
    let (noise, frame) = (std::io::repeat(0xFE), stream(Sender::v2(1, 1), 0..1));
    let mut reader = FrameReader::new(noise.take(200_000).chain(&frame[..]), Small::TABLE);
    for call in 1..=3 {
        assert_eq!(reader.receive().map_err(|error| error.kind()), Err(ErrorKind::WouldBlock));
        let left = reader.get_ref().get_ref().0.limit();
        assert_eq!(left, 200_000 - call * 65_536);
    }
    assert_eq!(all(&mut reader), sent(0..1));
}

#[test]
fn a_link_that_does_not_block_tears_no_frame() {
    let (near, far) = connected();
    near.set_nonblocking(true).unwrap();
    let mut writer = FrameWriter::new(near, Sender::v2(1, 1));
    let mut accepted = 0;
    // Until the system takes no more.
    let refused = loop {
        match writer.send(&message(accepted)) {
            Ok(()) => accepted += 1,
            Err(error) => break error,
        }
    };
    assert_eq!(refused.kind(), ErrorKind::WouldBlock);
    assert!(writer.is_pending());
    let received = thread::spawn(move || {
        let mut reader = FrameReader::new(far, Small::TABLE);
        (all(&mut reader), reader.statistics())
    });
    while writer.flush().is_err() {
        thread::yield_now();
    }
    while writer.send(&message(accepted)).is_err() {
        thread::yield_now();
    }
    while writer.flush().is_err() {
        thread::yield_now();
    }
    drop(writer);
    let (frames, statistics) = received.join().unwrap();
    assert_eq!(frames, sent(0..accepted + 1));
    assert_eq!(statistics.skipped_bytes, 0);
}

#[test]
fn a_timeout_loses_nothing() {
    let (mut near, far) = connected();
    far.set_read_timeout(Some(Duration::from_millis(1))).unwrap();
    let (mut reader, bytes) = (FrameReader::new(far, Small::TABLE), stream(Sender::v2(1, 1), 0..2));
    near.write_all(&bytes[..9]).unwrap();
    let error = reader.receive().unwrap_err();
    assert!(matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut), "{error}");
    near.write_all(&bytes[9..]).unwrap();
    drop(near);
    reader.get_mut().set_read_timeout(None).unwrap();
    assert_eq!(all(&mut reader), sent(0..2));
}

#[test]
fn at_the_end_of_a_pipe_an_unfinished_frame_is_given_up() {
    let (far, mut near) = pipe().unwrap();
    // The start of a long frame that does not come, and then frames.
    near.write_all(&[&[0xFD, 255, 0, 0][..], &stream(Sender::v1(1, 1), 0..3)].concat()).unwrap();
    drop(near);
    let mut reader = FrameReader::new(far, Small::TABLE);
    assert_eq!(all(&mut reader), sent(0..3));
    assert_eq!(reader.statistics().skipped_bytes, 4);
}

#[test]
fn a_file_that_grows_is_read_on() {
    let bytes = stream(Sender::v1(1, 1), 0..3);
    let mut reader = FrameReader::new(Scripted::new([], &bytes), Small::TABLE);
    assert_eq!(all(&mut reader), sent(0..3));
    reader.get_mut().input.extend(&bytes);
    assert_eq!(all(&mut reader), sent(0..3));
}

#[test]
fn interruptions_are_tried_again_and_other_errors_lose_nothing() {
    let bytes = stream(Sender::v2(1, 1), 0..2);
    let steps = [Step::Fail(ErrorKind::Interrupted), Step::Take(5), Step::Fail(ErrorKind::BrokenPipe)];
    let mut reader = FrameReader::new(Scripted::new(steps, &bytes), Small::TABLE);
    assert_eq!(reader.receive().unwrap_err().kind(), ErrorKind::BrokenPipe);
    assert_eq!(all(&mut reader), sent(0..2));

    let steps = [Step::Fail(ErrorKind::Interrupted), Step::Take(5), Step::Fail(ErrorKind::Interrupted)];
    let mut writer = FrameWriter::new(Scripted::new(steps, &[]), Sender::v2(1, 1));
    writer.send(&message(0)).unwrap();
    writer.send(&message(1)).unwrap();
    assert_eq!(writer.into_inner().output, bytes);
}

#[test]
fn a_pausing_link_gives_up_what_does_not_come() {
    let bytes = [&[0xFD, 255, 0, 0][..], &stream(Sender::v1(1, 1), 0..2)].concat();
    let mut link = Scripted::new([Step::Take(1000), Step::Fail(ErrorKind::TimedOut)], &bytes);
    link.steps.push_back(Step::Take(0));
    let mut reader = FrameReader::new(link, Small::TABLE);
    assert_eq!(reader.receive().unwrap_err().kind(), ErrorKind::TimedOut);
    assert_eq!(reader.finish().map(|frame| read(&frame)), sent(0..1).pop());
    assert_eq!(reader.finish().map(|frame| read(&frame)), sent(1..2).pop());
    assert_eq!(reader.finish(), None);
}

#[test]
fn what_was_read_comes_before_what_is_given_up() {
    let bytes = [&stream(Sender::v1(1, 1), 0..3)[..], &[0xFD, 200, 0]].concat();
    let mut reader = FrameReader::new(&bytes[..], Small::TABLE);
    assert_eq!(reader.receive().unwrap().map(|frame| read(&frame)), Some(sent(0..3)[0]));
    let finished: Vec<_> = std::iter::from_fn(|| reader.finish().map(|frame| read(&frame))).collect();
    assert_eq!(finished, sent(1..3));
    assert_eq!(reader.statistics().skipped_bytes, 3);
}

#[test]
fn a_refused_message_takes_no_number() {
    let steps = [Step::Take(3), Step::Fail(ErrorKind::WouldBlock), Step::Fail(ErrorKind::WouldBlock)];
    let mut writer = FrameWriter::new(Scripted::new(steps, &[]), Sender::v2(1, 1));
    writer.send(&message(0)).unwrap();
    assert!(writer.is_pending());
    assert_eq!(writer.send(&message(1)).unwrap_err().kind(), ErrorKind::WouldBlock);
    writer.send(&message(1)).unwrap();
    assert_eq!(writer.into_inner().output, stream(Sender::v2(1, 1), 0..2));
}

#[test]
fn what_cannot_be_sent_is_an_error_with_its_reason() {
    let link = || Scripted::new([Step::Take(0)], &[]);
    let mut writer = FrameWriter::new(link(), Sender::v2(1, 1));
    assert_eq!(writer.send(&message(0)).unwrap_err().kind(), ErrorKind::WriteZero);

    let mut writer = FrameWriter::new(link(), Sender::v1(1, 1));
    let error = writer.send(&crate::links::TooLarge).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::InvalidInput);
    assert!(matches!(
        error.get_ref().and_then(|reason| reason.downcast_ref()),
        Some(EncodeError::IdTooLarge { message_id: 70_000 })
    ));
    assert_eq!(writer.sender().sequence(), 0);
    let key = key();
    let error = writer.send_frame(&Frame::parse(&key, Small::TABLE).unwrap()).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::InvalidInput);
}

proptest! {
    #[test]
    fn however_it_is_read_the_frames_are_those_of_the_stream(
        pieces in pieces(),
        cuts in proptest::collection::vec(any::<prop::sample::Index>(), 0..20),
    ) {
        let bytes = pieces.concat();
        let steps: Vec<Step> = cut(&bytes, &cuts).iter().filter(|chunk| !chunk.is_empty()).map(|chunk| Step::Take(chunk.len())).collect();
        let mut reader = FrameReader::new(Scripted::new(steps, &bytes), Small::TABLE);
        let mut found = vec![];
        while let Some(frame) = reader.receive().unwrap() {
            found.push(frame.bytes().to_vec());
        }
        let expected: Vec<Vec<u8>> =
            scanned(Small::TABLE, &bytes).iter().map(|place| bytes[place.start..place.end].to_vec()).collect();
        prop_assert_eq!(found, expected);
    }

    #[test]
    fn however_it_is_written_no_frame_is_torn(
        steps in proptest::collection::vec(prop_oneof![
            (1..30_usize).prop_map(Step::Take),
            Just(Step::Fail(ErrorKind::WouldBlock)),
            Just(Step::Fail(ErrorKind::TimedOut)),
            Just(Step::Fail(ErrorKind::Interrupted)),
        ], 0..40),
    ) {
        let mut writer = FrameWriter::new(Scripted::new(steps, &[]), Sender::v2(1, 1));
        let tunnel = stream(Sender::v1(7, 7), 5..6);
        let tunnel = Frame::parse(&tunnel, const { &Table::of(&[]) }).unwrap();
        for number in 0..4 {
            while writer.send(&message(number)).is_err() {}
        }
        while writer.send_frame(&tunnel).is_err() {}
        while writer.flush().is_err() {}
        prop_assert_eq!(writer.into_inner().output, [&stream(Sender::v2(1, 1), 0..4)[..], tunnel.bytes()].concat());
    }
}
