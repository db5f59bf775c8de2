//! `embedded-io`.

use std::io::ErrorKind;
use std::net::{Shutdown, TcpListener, TcpStream};
use std::thread;

use embedded_io_adapters::std::FromStd;
use mavlink_wire::embedded_io::{FrameReader, FrameWriter, ReceiveError, SendError};
use mavlink_wire::{Dialect, EncodeError, Frame, Sender};

use super::scripted::{Scripted, Step};
use super::{TooLarge, key, message, read, sent, stream};
use crate::small::Small;

#[test]
fn messages_cross_a_tcp_stream_both_ways() {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let near = TcpStream::connect(listener.local_addr().unwrap()).unwrap();
    let echo = thread::spawn(move || {
        let far = listener.accept().unwrap().0;
        let mut reader = FrameReader::new(FromStd::new(far.try_clone().unwrap()), Small::TABLE);
        let mut writer = FrameWriter::new(FromStd::new(far), Sender::v2(9, 9));
        while let Some(frame) = reader.receive().unwrap() {
            writer.send_frame(&frame).unwrap();
        }
        writer.flush().unwrap();
    });
    let mut writer = FrameWriter::new(FromStd::new(near.try_clone().unwrap()), Sender::v1(1, 1));
    for number in 0..100 {
        writer.send(&message(number)).unwrap();
    }
    near.shutdown(Shutdown::Write).unwrap();
    let (mut reader, mut received) = (FrameReader::<_, 7>::with_read_size(FromStd::new(near), Small::TABLE), vec![]);
    while let Some(frame) = reader.receive().unwrap() {
        received.push(read(&frame));
    }
    assert_eq!(received, sent(0..100));
    assert_eq!(reader.statistics().skipped_bytes, 0);
    echo.join().unwrap();
}

/// A wrong baud rate, and no end of it.
#[test]
fn a_call_returns_after_64_kib_without_a_frame() {
    let (noise, frame) = ([0xFE; 200_000], stream(Sender::v2(1, 1), 0..1));
    let bytes = [&noise, &frame[..]].concat();
    let mut reader = FrameReader::new(&bytes[..], Small::TABLE);
    for call in 1..=3 {
        let error = reader.receive().unwrap_err();
        assert_eq!(error, ReceiveError::NothingYet);
        assert_eq!(embedded_io::Error::kind(&error), embedded_io::ErrorKind::TimedOut, "to be tried again");
        assert_eq!(bytes.len() - reader.get_ref().len(), call * 65_536);
    }
    assert_eq!(reader.receive().unwrap().map(|frame| read(&frame)), sent(0..1).pop());
    assert_eq!(reader.receive().unwrap(), None);
}

#[test]
fn an_unfinished_frame_is_given_up_at_the_end_or_when_asked() {
    let bytes = [&[0xFD, 255, 0, 0][..], &stream(Sender::v1(1, 1), 0..1)].concat();
    let mut reader = FrameReader::new(&bytes[..], Small::TABLE);
    assert_eq!(reader.receive().unwrap().map(|frame| read(&frame)), sent(0..1).pop());
    assert_eq!(reader.receive().unwrap(), None);

    let steps = [Step::Take(1000), Step::Fail(ErrorKind::TimedOut)];
    let link = FromStd::new(Scripted::new(steps, &bytes));
    let mut reader = FrameReader::<_, 200>::with_read_size(link, Small::TABLE);
    assert!(reader.receive().is_err());
    assert_eq!(reader.finish().map(|frame| read(&frame)), sent(0..1).pop());
}

#[test]
fn what_the_link_did_not_take_goes_out_before_the_next_frame() {
    let steps = [Step::Take(4), Step::Fail(ErrorKind::BrokenPipe)];
    let mut writer = FrameWriter::new(FromStd::new(Scripted::new(steps, &[])), Sender::v2(1, 1));
    assert!(matches!(writer.send(&message(0)), Err(SendError::Link(_))));
    assert!(writer.is_pending());
    writer.send(&message(1)).unwrap();
    assert_eq!(writer.into_inner().into_inner().output, stream(Sender::v2(1, 1), 0..2));
}

#[test]
fn interruptions_are_tried_again_and_other_errors_lose_nothing() {
    let bytes = stream(Sender::v2(1, 1), 0..2);
    let steps = [Step::Fail(ErrorKind::Interrupted), Step::Take(5), Step::Fail(ErrorKind::BrokenPipe)];
    let mut reader = FrameReader::new(FromStd::new(Scripted::new(steps, &bytes)), Small::TABLE);
    let failed = reader.receive().unwrap_err();
    assert!(matches!(failed, ReceiveError::Link(error) if error.kind() == ErrorKind::BrokenPipe));
    for expected in sent(0..2) {
        assert_eq!(reader.receive().unwrap().map(|frame| read(&frame)), Some(expected));
    }
    assert_eq!(reader.receive().unwrap(), None);
    reader.get_mut().inner_mut().input.extend(&bytes);
    assert_eq!(reader.receive().unwrap().map(|frame| read(&frame)), sent(0..1).pop(), "it has grown");

    let steps = [Step::Fail(ErrorKind::Interrupted), Step::Take(5), Step::Fail(ErrorKind::Interrupted)];
    let mut writer = FrameWriter::new(FromStd::new(Scripted::new(steps, &[])), Sender::v2(1, 1));
    writer.send(&message(0)).unwrap();
    writer.send(&message(1)).unwrap();
    assert_eq!(writer.into_inner().into_inner().output, bytes);
}

#[test]
fn a_message_refused_by_a_timeout_takes_no_number() {
    let steps = [Step::Take(3), Step::Fail(ErrorKind::TimedOut), Step::Fail(ErrorKind::TimedOut)];
    let mut writer = FrameWriter::new(FromStd::new(Scripted::new(steps, &[])), Sender::v2(1, 1));
    writer.send(&message(0)).unwrap();
    assert!(writer.is_pending());
    assert!(matches!(writer.send(&message(1)), Err(SendError::Link(error)) if error.kind() == ErrorKind::TimedOut));
    writer.send(&message(1)).unwrap();
    assert_eq!(writer.get_ref().inner().output, stream(Sender::v2(1, 1), 0..2));
}

/// A link that takes nothing, against the rules.
struct Stalled;

impl embedded_io::ErrorType for Stalled {
    type Error = core::convert::Infallible;
}

impl embedded_io::Write for Stalled {
    fn write(&mut self, _: &[u8]) -> Result<usize, Self::Error> {
        Ok(0)
    }

    fn flush(&mut self) -> Result<(), Self::Error> {
        Ok(())
    }
}

#[test]
fn errors_have_their_reasons() {
    let mut writer = FrameWriter::new(Stalled, Sender::v1(1, 1));
    let refused = writer.send(&TooLarge).unwrap_err();
    assert!(matches!(refused, SendError::Encode(EncodeError::IdTooLarge { message_id: 70_000 })));
    assert!(refused.to_string().contains("Sender::v2"));
    let key = key();
    let refused = writer.send_frame(&Frame::parse(&key, Small::TABLE).unwrap());
    assert!(matches!(refused, Err(SendError::Encode(EncodeError::CarriesKey))));
    assert!(matches!(writer.send(&message(0)), Err(SendError::NothingTaken)));
    assert_eq!(writer.sender().sequence(), 1);
}
