//! `embedded-io-async`.

use std::io::{ErrorKind, Read, Write};

use embedded_io_adapters::tokio_1::FromTokio;
use futures_util::FutureExt;
use mavlink_wire::embedded_io_async::{FrameReader, FrameWriter, ReceiveError, SendError};
use mavlink_wire::{Dialect, Sender};
use tokio::io::duplex;
use tokio::net::{TcpListener, TcpStream};

use super::scripted::{Scripted, Step};
use super::{TooLarge, message, read, sent, stream};
use crate::small::Small;

#[tokio::test]
async fn messages_cross_a_tcp_stream_both_ways() {
    let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let address = listener.local_addr().unwrap();
    let echo = tokio::spawn(async move {
        let (rx, tx) = listener.accept().await.unwrap().0.into_split();
        let mut reader = FrameReader::new(FromTokio::new(rx), Small::TABLE);
        let mut writer = FrameWriter::new(FromTokio::new(tx), Sender::v2(9, 9));
        while let Some(frame) = reader.receive().await.unwrap() {
            writer.send_frame(&frame).await.unwrap();
        }
        writer.flush().await.unwrap();
    });
    let (rx, tx) = TcpStream::connect(address).await.unwrap().into_split();
    let mut writer = FrameWriter::new(FromTokio::new(tx), Sender::v1(1, 1));
    let mut reader = FrameReader::<_, 7>::with_read_size(FromTokio::new(rx), Small::TABLE);
    let mut received = vec![];
    for number in 0..100 {
        writer.send(&message(number)).await.unwrap();
        received.push(read(&reader.receive().await.unwrap().unwrap()));
    }
    drop(writer);
    assert_eq!(reader.receive().await.unwrap(), None);
    assert_eq!(received, sent(0..100));
    assert_eq!(reader.statistics().skipped_bytes, 0);
    echo.await.unwrap();
}

#[tokio::test]
async fn a_dropped_future_tears_no_frame() {
    let (near, far) = duplex(10);
    let mut writer = FrameWriter::new(FromTokio::new(near), Sender::v2(1, 1));
    assert!(writer.send(&message(0)).now_or_never().is_none(), "ten bytes fit, the frame does not");
    assert!(writer.is_pending());
    let expected = stream(Sender::v2(1, 1), 0..2);
    let reading = tokio::spawn(async move {
        let (mut far, mut bytes) = (far, vec![]);
        tokio::io::AsyncReadExt::read_to_end(&mut far, &mut bytes).await.unwrap();
        bytes
    });
    writer.send(&message(1)).await.unwrap();
    drop(writer);
    assert_eq!(reading.await.unwrap(), expected);
}

#[tokio::test]
async fn a_dropped_future_loses_no_byte() {
    let (near, mut far) = duplex(1000);
    let bytes = stream(Sender::v2(1, 1), 0..2);
    let mut reader = FrameReader::new(FromTokio::new(near), Small::TABLE);
    tokio::io::AsyncWriteExt::write_all(&mut far, &bytes[..9]).await.unwrap();
    assert!(reader.receive().now_or_never().is_none());
    tokio::io::AsyncWriteExt::write_all(&mut far, &bytes[9..]).await.unwrap();
    for expected in sent(0..2) {
        assert_eq!(read(&reader.receive().await.unwrap().unwrap()), expected);
    }
}

/// The adapter of a link that does what it is told.
struct Told(Scripted);

impl embedded_io_async::ErrorType for Told {
    type Error = std::io::Error;
}

impl embedded_io_async::Read for Told {
    async fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        self.0.read(buffer)
    }
}

impl embedded_io_async::Write for Told {
    async fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.write(bytes)
    }

    async fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[tokio::test]
async fn interruptions_are_tried_again_and_other_errors_lose_nothing() {
    let bytes = stream(Sender::v2(1, 1), 0..2);
    let steps = [Step::Fail(ErrorKind::Interrupted), Step::Take(5), Step::Fail(ErrorKind::BrokenPipe)];
    let mut reader = FrameReader::new(Told(Scripted::new(steps, &bytes)), Small::TABLE);
    let failed = reader.receive().await.unwrap_err();
    assert!(matches!(failed, ReceiveError::Link(error) if error.kind() == ErrorKind::BrokenPipe));
    for expected in sent(0..2) {
        assert_eq!(reader.receive().await.unwrap().map(|frame| read(&frame)), Some(expected));
    }
    assert_eq!(reader.receive().await.unwrap(), None);
    reader.get_mut().0.input.extend(&bytes);
    assert_eq!(reader.receive().await.unwrap().map(|frame| read(&frame)), sent(0..1).pop(), "it has grown");

    let steps = [Step::Fail(ErrorKind::Interrupted), Step::Take(5), Step::Fail(ErrorKind::Interrupted)];
    let mut writer = FrameWriter::new(Told(Scripted::new(steps, &[])), Sender::v2(1, 1));
    writer.send(&message(0)).await.unwrap();
    writer.send(&message(1)).await.unwrap();
    assert_eq!(writer.into_inner().0.output, bytes);
}

#[tokio::test]
async fn a_message_refused_by_a_timeout_takes_no_number() {
    let steps = [Step::Take(3), Step::Fail(ErrorKind::TimedOut), Step::Fail(ErrorKind::TimedOut)];
    let mut writer = FrameWriter::new(Told(Scripted::new(steps, &[])), Sender::v2(1, 1));
    writer.send(&message(0)).await.unwrap();
    assert!(writer.is_pending());
    assert!(
        matches!(writer.send(&message(1)).await, Err(SendError::Link(error)) if error.kind() == ErrorKind::TimedOut)
    );
    writer.send(&message(1)).await.unwrap();
    assert_eq!(writer.get_ref().0.output, stream(Sender::v2(1, 1), 0..2));
}

/// A wrong baud rate, and no end of it.
#[tokio::test]
async fn a_call_returns_after_64_kib_without_a_frame() {
    let (noise, frame) = ([0xFE; 200_000], stream(Sender::v2(1, 1), 0..1));
    let bytes = [&noise, &frame[..]].concat();
    let mut reader = FrameReader::new(&bytes[..], Small::TABLE);
    for call in 1..=3 {
        let error = reader.receive().await.unwrap_err();
        assert_eq!(error, ReceiveError::NothingYet);
        assert_eq!(embedded_io_async::Error::kind(&error), embedded_io_async::ErrorKind::TimedOut, "to be tried again");
        assert_eq!(bytes.len() - reader.get_ref().len(), call * 65_536);
    }
    assert_eq!(reader.receive().await.unwrap().map(|frame| read(&frame)), sent(0..1).pop());
    assert_eq!(reader.receive().await.unwrap(), None);
}

#[tokio::test]
async fn an_unfinished_frame_is_given_up_at_the_end_or_when_asked() {
    let bytes = [&[0xFD, 255, 0, 0][..], &stream(Sender::v1(1, 1), 0..1)].concat();
    let mut reader = FrameReader::new(&bytes[..], Small::TABLE);
    assert_eq!(reader.receive().await.unwrap().map(|frame| read(&frame)), sent(0..1).pop());
    assert_eq!(reader.receive().await.unwrap(), None);

    let steps = [Step::Take(1000), Step::Fail(ErrorKind::TimedOut)];
    let mut reader = FrameReader::<_, 200>::with_read_size(Told(Scripted::new(steps, &bytes)), Small::TABLE);
    assert!(reader.receive().await.is_err());
    assert_eq!(reader.finish().map(|frame| read(&frame)), sent(0..1).pop());
}

#[tokio::test]
async fn a_link_that_takes_nothing_keeps_nobody_waiting() {
    let mut writer = FrameWriter::new(Told(Scripted::new([Step::Take(0)], &[])), Sender::v1(1, 1));
    assert!(matches!(writer.send(&message(0)).await, Err(SendError::NothingTaken)));
    assert!(writer.is_pending());
}

#[tokio::test]
async fn errors_have_their_reasons() {
    let (near, far) = duplex(10);
    drop(far);
    let mut writer = FrameWriter::new(FromTokio::new(near), Sender::v1(1, 1));
    assert!(matches!(writer.send(&TooLarge).await, Err(SendError::Encode(_))));
    assert!(matches!(writer.send(&message(0)).await, Err(SendError::Link(_))));
}
