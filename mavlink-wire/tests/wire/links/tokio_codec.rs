//! `tokio_util::codec`.

use futures_util::{SinkExt, StreamExt};
use mavlink_wire::tokio_codec::Codec;
use mavlink_wire::{Dialect, Encode, Frame, FrameBuf, Sender};
use tokio::net::{TcpListener, TcpStream};
use tokio_util::bytes::BytesMut;
use tokio_util::codec::{Decoder, Encoder, Framed};

use super::{TooLarge, key, message, read, sent, stream};
use crate::small::Small;

fn codec(sender: Sender) -> Codec<'static> {
    Codec::new(Small::TABLE, sender)
}

#[tokio::test]
async fn messages_cross_a_tcp_stream_both_ways() {
    let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let address = listener.local_addr().unwrap();
    let echo = tokio::spawn(async move {
        let mut link = Framed::new(listener.accept().await.unwrap().0, codec(Sender::v2(9, 9)));
        while let Some(frame) = link.next().await {
            link.send(frame.unwrap()).await.unwrap();
        }
    });
    let mut link = Framed::new(TcpStream::connect(address).await.unwrap(), codec(Sender::v1(1, 1)));
    let mut received: Vec<FrameBuf> = vec![];
    for number in 0..100 {
        link.send(&message(number)).await.unwrap();
        received.push(link.next().await.unwrap().unwrap());
    }
    assert_eq!(received.iter().map(|frame| read(&frame.as_frame())).collect::<Vec<_>>(), sent(0..100));
    assert_eq!(link.codec().statistics().frames, 100);
    drop(link);
    echo.await.unwrap();
}

#[test]
fn at_the_end_an_unfinished_frame_is_given_up() {
    let bytes = [&[0xFD, 255, 0, 0][..], &stream(Sender::v1(1, 1), 0..3)].concat();
    let (mut codec, mut bytes) = (codec(Sender::v1(1, 1)), BytesMut::from(&bytes[..]));
    assert_eq!(codec.decode(&mut bytes).unwrap(), None);
    let mut found = vec![];
    while let Some(frame) = codec.decode_eof(&mut bytes).unwrap() {
        found.push(read(&frame.as_frame()));
    }
    assert_eq!(found, sent(0..3));
}

#[test]
fn what_cannot_be_carried_writes_nothing() {
    let (mut codec, mut bytes) = (codec(Sender::v1(1, 1)), BytesMut::new());
    assert_eq!(codec.encode(&TooLarge, &mut bytes).unwrap_err().kind(), std::io::ErrorKind::InvalidInput);
    let key = FrameBuf::from(Frame::parse(&key(), Small::TABLE).unwrap());
    assert_eq!(codec.encode(key, &mut bytes).unwrap_err().kind(), std::io::ErrorKind::InvalidInput);
    let dynamic: &dyn Encode = &message(0);
    codec.encode(dynamic, &mut bytes).unwrap();
    assert_eq!(bytes, &stream(Sender::v1(1, 1), 0..1)[..]);
}
