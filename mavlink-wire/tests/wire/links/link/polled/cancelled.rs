//! Futures that are dropped wherever they wait.

use core::future::{Future, poll_fn};
use core::pin::pin;
use core::task::Poll;
use std::net::UdpSocket;

use super::*;

/// Frames that are received.
const COUNT: usize = 12;

/// What comes of a future that may wait so many times; one that waits once more is dropped there.
pub(super) async fn up_to<T>(mut waits: usize, future: impl Future<Output = T>) -> Option<T> {
    let mut future = pin!(future);
    poll_fn(|context| match future.as_mut().poll(context) {
        Poll::Ready(value) => Poll::Ready(Some(value)),
        Poll::Pending if waits == 0 => Poll::Ready(None),
        Poll::Pending => {
            waits -= 1;
            Poll::Pending
        }
    })
    .await
}

/// Receives until it has so many frames, or the end. Every other future is dropped at its first wait, the others later.
pub(super) async fn receive_with_drops(link: &mut Link, count: usize) -> (Vec<(u8, Option<Small>)>, usize) {
    let (mut received, mut dropped) = (vec![], 0);
    for waits in [0, 1, 0, 2, 0, 3].into_iter().cycle() {
        match up_to(waits, link.receive()).await {
            Some(Ok(frame)) => received.push(read(&frame)),
            Some(Err(error)) => {
                assert!(matches!(error, LinkError::Ended), "{error}");
                break;
            }
            None => dropped += 1,
        }
        if received.len() == count {
            break;
        }
        tokio::task::yield_now().await;
    }
    (received, dropped)
}

#[tokio::test]
async fn a_receiver_of_a_stream_loses_no_byte() {
    let mut station = Link::connect("tcpin:127.0.0.1:0", station()).await.unwrap();
    let mut client = tokio::net::TcpStream::connect(station.local_addr().unwrap()).await.unwrap();
    client.set_nodelay(true).unwrap();
    let writer = tokio::spawn(async move {
        for piece in stream(Sender::v2(1, 1), 0..COUNT as u32).chunks(5) {
            tokio::io::AsyncWriteExt::write_all(&mut client, piece).await.unwrap();
            tokio::time::sleep(Duration::from_millis(1)).await;
        }
        client
    });
    let (received, dropped) = receive_with_drops(&mut station, COUNT).await;
    let _client = writer.await.unwrap();
    assert_eq!(received, sent(0..COUNT as u32));
    assert!(dropped > COUNT, "{dropped}");
    assert_eq!(station.statistics().received.skipped_bytes, 0);
}

#[tokio::test]
async fn a_receiver_of_datagrams_loses_no_byte() {
    let mut station = Link::connect("udpin:127.0.0.1:0", station()).await.unwrap();
    let address = station.local_addr().unwrap();
    let writer = tokio::spawn(async move {
        let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
        for piece in stream(Sender::v2(1, 1), 0..COUNT as u32).chunks(7) {
            socket.send_to(piece, address).unwrap();
            tokio::time::sleep(Duration::from_millis(1)).await;
        }
    });
    let (received, dropped) = receive_with_drops(&mut station, COUNT).await;
    writer.await.unwrap();
    assert_eq!(received, sent(0..COUNT as u32));
    assert!(dropped > COUNT, "{dropped}");
}

#[tokio::test]
async fn a_reader_of_a_file_loses_no_byte() {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), stream(Sender::v2(1, 1), 0..250)).unwrap();
    let mut link = Link::connect(&format!("file:{}", file.path().display()), station()).await.unwrap();
    // How often it waits is up to the threads that read.
    let (received, _) = receive_with_drops(&mut link, usize::MAX).await;
    assert_eq!(received, sent(0..250));
}

#[tokio::test]
async fn who_is_dropped_while_connecting_still_connects() {
    let (mut station, mut vehicle) = pair("tcpin", "tcpout").await;
    let address = station.local_addr().unwrap();
    vehicle.send(&message(0)).await.unwrap();
    next(&mut station).await;
    drop(station);
    while vehicle.is_connected() {
        up_to(1, vehicle.receive()).await;
        tokio::task::yield_now().await;
    }
    let _station = Link::connect(&format!("tcpin:{address}"), super::station()).await.unwrap();
    while !vehicle.is_connected() {
        up_to(0, vehicle.receive()).await;
        tokio::time::sleep(Duration::from_millis(1)).await;
    }
}
