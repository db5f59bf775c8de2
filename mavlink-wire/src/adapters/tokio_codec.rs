//! Frames over [`tokio_util::codec`], and with it over anything that tokio reads and writes. Needs the feature
//! `tokio-codec`.
//!
//! ```
//! # use mavlink_wire::{Encode, MessageInfo, Sender, Table};
//! # const INFO: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
//! # struct Heartbeat;
//! # impl Encode for Heartbeat {
//! #     fn info(&self) -> &'static MessageInfo { INFO }
//! #     fn write(&self, payload: &mut [u8; 255]) { payload[..9].copy_from_slice(&[0, 0, 0, 0, 6, 8, 0, 4, 3]); }
//! # }
//! # static TABLE: Table<'static> = Table::of(&[INFO]);
//! use futures_util::{SinkExt, StreamExt};
//! use mavlink_wire::tokio_codec::Codec;
//! use tokio_util::codec::Framed;
//!
//! # #[tokio::main(flavor = "current_thread")]
//! # async fn main() -> std::io::Result<()> {
//! # let (stream, vehicle) = tokio::io::duplex(64);
//! # let vehicle = tokio::spawn(async move {
//! #     let mut link = Framed::new(vehicle, Codec::new(&TABLE, Sender::v1(1, 1)));
//! #     let request = link.next().await.unwrap().unwrap();
//! #     link.send(request).await
//! # });
//! let mut link = Framed::new(stream, Codec::new(&TABLE, Sender::v2(255, 190)));
//! link.send(&Heartbeat).await?;
//! while let Some(frame) = link.next().await {
//!     let frame = frame?;
//!     println!("message {}", frame.as_frame().message_id());
//! }
//! # assert_eq!(link.codec().statistics().frames, 1);
//! # vehicle.await?
//! # }
//! ```
//!
//! # Bytes without a frame
//!
//! One call of the codec searches the bytes that lie in the buffer, and no more: 8 KiB at most, unless `Framed` was given more.
//! Then `next` reads on for as long as the stream has bytes. What is to end by the clock, as by `tokio::time::timeout`, needs
//! a stream that gives way to other tasks while it has bytes: tokio's sockets do.

use core::fmt;
use std::io::{Error, Result};

use bytes::{Buf, BufMut, BytesMut};
use tokio_util::codec::{Decoder, Encoder};

use crate::frame::key::{SETUP_SIGNING, wipe};
use crate::parser::not_told;
use crate::{Encode, EncodeError, FrameBuf, MAX_FRAME, Parser, Sender, Statistics, Table};

/// Frames out of bytes, messages and frames into bytes.
///
/// Frames come as [`FrameBuf`], which own their bytes. Sent are references to messages, dialect enums or
/// `dyn Encode`, which get the numbers of the codec's [`Sender`], and `FrameBuf`, which go as they came. Damage is no error: what
/// was skipped is in [`statistics`](Self::statistics).
#[derive(Clone)]
pub struct Codec<'t, F = fn(u32)> {
    parser: Parser<'t>,
    sender: Sender,
    bad_checksum: F,
}

impl<'t> Codec<'t> {
    /// A codec that verifies the messages of this table, and sends what this sender makes.
    #[must_use]
    pub const fn new(table: &'t Table<'t>, sender: Sender) -> Self {
        Self { parser: Parser::new(table), sender, bad_checksum: not_told }
    }
}

impl<'t, F> Codec<'t, F> {
    /// The same codec, which tells `bad_checksum` the message of each frame that [`Statistics::bad_checksums`] counts: if it
    /// is often the same one, both sides define it otherwise.
    #[must_use]
    pub fn reporting_bad_checksums<G: FnMut(u32)>(self, bad_checksum: G) -> Codec<'t, G> {
        Codec { parser: self.parser, sender: self.sender, bad_checksum }
    }

    /// What was found so far, and what could not be read.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        self.parser.statistics()
    }

    /// What makes the frames.
    pub fn sender(&mut self) -> &mut Sender {
        &mut self.sender
    }
}

impl<F> fmt::Debug for Codec<'_, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Codec").field("parser", &self.parser).field("sender", &self.sender).finish_non_exhaustive()
    }
}

impl<F: FnMut(u32)> Decoder for Codec<'_, F> {
    type Item = FrameBuf;
    type Error = Error;

    fn decode(&mut self, bytes: &mut BytesMut) -> Result<Option<FrameBuf>> {
        let mut input = &bytes[..];
        let frame = self.parser.next_reporting_bad_checksums(&mut input, &mut self.bad_checksum).map(FrameBuf::from);
        let used = bytes.len() - input.len();
        if frame.is_some_and(|frame| frame.as_frame().carries_key()) {
            wipe(bytes.get_mut(..used).unwrap_or_default());
        }
        bytes.advance(used);
        Ok(frame)
    }

    fn decode_eof(&mut self, bytes: &mut BytesMut) -> Result<Option<FrameBuf>> {
        let frame = self.decode(bytes)?;
        Ok(frame.or_else(|| self.parser.finish_reporting_bad_checksums(&mut self.bad_checksum).map(FrameBuf::from)))
    }
}

impl<M: Encode + ?Sized, F> Encoder<&M> for Codec<'_, F> {
    type Error = Error;

    /// An error of kind [`InvalidInput`](std::io::ErrorKind::InvalidInput) around an [`EncodeError`]: the sender cannot carry
    /// the message.
    fn encode(&mut self, message: &M, bytes: &mut BytesMut) -> Result<()> {
        let mut buffer = [0; MAX_FRAME];
        let frame = self.sender.encode(message, &mut buffer);
        let done = frame.map(|frame| bytes.put_slice(frame));
        if message.info().id == SETUP_SIGNING {
            wipe(&mut buffer);
        }
        Ok(done?)
    }
}

impl<F> Encoder<FrameBuf> for Codec<'_, F> {
    type Error = Error;

    /// The same, where the frame carries a [key](crate::Frame::carries_key).
    fn encode(&mut self, frame: FrameBuf, bytes: &mut BytesMut) -> Result<()> {
        if frame.as_frame().carries_key() {
            return Err(EncodeError::CarriesKey.into());
        }
        bytes.put_slice(frame.bytes());
        Ok(())
    }
}
