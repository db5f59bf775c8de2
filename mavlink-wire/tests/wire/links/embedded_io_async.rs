//! `embedded-io-async`.

use embedded_io_adapters::tokio_1::FromTokio;
use futures_util::FutureExt;
use mavlink_wire::embedded_io_async::{FrameReader, FrameWriter, SendError};
use mavlink_wire::{Dialect, Sender};
use tokio::io::duplex;
use tokio::net::{TcpListener, TcpStream};

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
        while let Some(frame) = reader.read().await.unwrap() {
            writer.forward(&frame).await.unwrap();
        }
        writer.flush().await.unwrap();
    });
    let (rx, tx) = TcpStream::connect(address).await.unwrap().into_split();
    let mut writer = FrameWriter::new(FromTokio::new(tx), Sender::v1(1, 1));
    let mut reader = FrameReader::<_, 7>::with_buffer(FromTokio::new(rx), Small::TABLE);
    let mut received = vec![];
    for number in 0..100 {
        writer.send(&message(number)).await.unwrap();
        received.push(read(&reader.read().await.unwrap().unwrap()));
    }
    drop(writer);
    assert_eq!(reader.read().await.unwrap(), None);
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
    assert!(reader.read().now_or_never().is_none());
    tokio::io::AsyncWriteExt::write_all(&mut far, &bytes[9..]).await.unwrap();
    for expected in sent(0..2) {
        assert_eq!(read(&reader.read().await.unwrap().unwrap()), expected);
    }
}

#[tokio::test]
async fn errors_have_their_reasons() {
    let (near, far) = duplex(10);
    drop(far);
    let mut writer = FrameWriter::new(FromTokio::new(near), Sender::v1(1, 1));
    assert!(matches!(writer.send(&TooLarge).await, Err(SendError::Encode(_))));
    assert!(matches!(writer.send(&message(0)).await, Err(SendError::Link(_))));
}
