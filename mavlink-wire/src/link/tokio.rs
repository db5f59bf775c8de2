//! The links of [`link`](super) for async tasks. Needs the feature `tokio`; serial ports need `tokio-serial`.
//!
//! ```
//! # use mavlink_wire::{Encode, MessageInfo, Table};
//! # const INFO: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
//! # struct Heartbeat;
//! # impl Encode for Heartbeat {
//! #     fn info(&self) -> &'static MessageInfo { INFO }
//! #     fn write(&self, payload: &mut [u8; 255]) { payload[..9].copy_from_slice(&[0, 0, 0, 0, 6, 8, 0, 4, 3]); }
//! # }
//! # static TABLE: Table<'static> = Table::of(&[INFO]);
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # tokio::runtime::Builder::new_current_thread().enable_all().build()?.block_on(async {
//! use mavlink_wire::Sender;
//! use mavlink_wire::link::{Options, tokio::Link};
//!
//! let mut link = Link::connect("udpin:127.0.0.1:0", Options::new(&TABLE, Sender::v2(255, 190))).await?;
//! # let address = format!("udpout:{}", link.local_addr().unwrap());
//! # let vehicle = Link::connect(&address, Options::new(&TABLE, Sender::v2(1, 1))).await?;
//! # vehicle.send(&Heartbeat).await?;
//! # let mut frames = 1..;
//! loop {
//!     let frame = link.receive().await?;
//!     println!("{}/{} sends message {}", frame.system_id(), frame.component_id(), frame.message_id());
//!     link.send(&Heartbeat).await?;
//! #   if frames.next() == Some(1) { break; }
//! }
//! # Ok::<(), mavlink_wire::link::LinkError>(())
//! # })?;
//! # Ok(())
//! # }
//! ```
//!
//! Addresses, [`Options`], errors and behaviour are those of [`link`](super).
//!
//! # Cancel safety
//!
//! Every future may be dropped before it is ready, as `select!` and `timeout` do: no byte is lost and no frame torn. If you drop a
//! `receive`, it received nothing, and the next one goes on from there. If you drop a `send`, either nothing was sent and no
//! sequence number used, or the frame is kept and goes out before the next one.
//!
//! # Runtime
//!
//! The runtime needs its drivers for io and time: `enable_all`. A link reconnects only while one of its futures is polled; then it
//! tries every 20 ms whether the connection is ready.

mod ends;
mod open;
mod receive;
mod send;

pub use receive::ReceiveHalf;
pub use send::SendHalf;

use core::future::{Future, poll_fn};
use core::pin::pin;
use core::task::Poll;
use std::net::SocketAddr;
use std::string::String;
use std::time::Instant;
use std::vec::Vec;

use ::tokio::sync::Notify;

use super::shared::Shared;
use super::{LinkError, LinkStatistics, Options, Peer};
#[cfg(feature = "signing")]
use crate::signing::Verifier;
use crate::{ComponentId, Encode, Frame, Losses, Sender, SystemId};

/// Sends frames to an address and receives them, for async tasks.
///
/// A link has two halves. [`split`](Self::split) returns them, for two tasks. [`sending`](Self::sending) returns another handle of
/// the half that sends.
#[derive(Debug)]
pub struct Link {
    receiving: ReceiveHalf,
    sending: SendHalf,
}

/// What the halves share, and what wakes them when the link is closed.
#[derive(Debug)]
struct Common {
    shared: Shared,
    closing: Notify,
}

impl Common {
    fn close(&self) {
        self.shared.close();
        self.closing.notify_waiters();
    }

    /// Waits for a future, unless the link is closed meanwhile.
    async fn unless_closed<T>(&self, future: impl Future<Output = T>) -> Result<T, LinkError> {
        let mut closed = pin!(self.closing.notified());
        // From here on it misses nothing: first register, then look.
        closed.as_mut().enable();
        self.shared.check()?;
        let mut future = pin!(future);
        poll_fn(|context| match future.as_mut().poll(context) {
            Poll::Ready(value) => Poll::Ready(Ok(value)),
            Poll::Pending => closed.as_mut().poll(context).map(|()| Err(LinkError::Closed)),
        })
        .await
    }
}

impl Link {
    /// Opens a link to this address, as [`Address`](super::Address) describes it. Call it in a tokio runtime.
    ///
    /// # Errors
    ///
    /// The address is wrong or in use, or nobody is there. The first attempt has to succeed; afterwards the link reconnects by
    /// itself.
    pub async fn connect(address: &str, options: Options) -> Result<Self, LinkError> {
        let (receiving, sending) = open::open(&address.parse()?, &options).await?;
        Ok(Self { receiving, sending })
    }

    /// Splits the link into both halves, for two tasks.
    #[must_use]
    pub fn split(self) -> (ReceiveHalf, SendHalf) {
        (self.receiving, self.sending)
    }

    /// Another handle of the half that sends, for another task.
    #[must_use]
    pub fn sending(&self) -> SendHalf {
        self.sending.clone()
    }
}

/// What the half that receives does.
impl Link {
    /// See [`ReceiveHalf::receive`].
    ///
    /// # Errors
    ///
    /// See there.
    pub async fn receive(&mut self) -> Result<Frame<'_>, LinkError> {
        self.receiving.receive().await
    }

    /// See [`ReceiveHalf::receive_until`].
    ///
    /// # Errors
    ///
    /// See there.
    pub async fn receive_until(&mut self, deadline: Instant) -> Result<Option<Frame<'_>>, LinkError> {
        self.receiving.receive_until(deadline).await
    }

    /// See [`ReceiveHalf::receive_from`].
    ///
    /// # Errors
    ///
    /// See there.
    pub async fn receive_from(&mut self, deadline: Instant) -> Result<Option<(Frame<'_>, Peer)>, LinkError> {
        self.receiving.receive_from(deadline).await
    }

    /// What was received and sent so far.
    #[must_use]
    pub fn statistics(&self) -> LinkStatistics {
        self.receiving.statistics()
    }

    /// See [`ReceiveHalf::losses`].
    #[must_use]
    pub const fn losses(&self) -> &Losses {
        self.receiving.losses()
    }

    /// See [`ReceiveHalf::verifier`].
    #[cfg(feature = "signing")]
    pub fn verifier(&mut self) -> Option<&mut Verifier> {
        self.receiving.verifier()
    }

    /// See [`ReceiveHalf::set_verifier`].
    #[cfg(feature = "signing")]
    pub fn set_verifier(&mut self, verifier: Option<Verifier>) {
        self.receiving.set_verifier(verifier);
    }
}

/// What the half that sends does.
impl Link {
    /// See [`SendHalf::send`].
    ///
    /// # Errors
    ///
    /// See there.
    pub async fn send(&self, message: &(impl Encode + ?Sized)) -> Result<usize, LinkError> {
        self.sending.send(message).await
    }

    /// See [`SendHalf::queue`].
    ///
    /// # Errors
    ///
    /// See there.
    pub async fn queue(&self, message: &(impl Encode + ?Sized)) -> Result<usize, LinkError> {
        self.sending.queue(message).await
    }

    /// See [`SendHalf::flush`].
    ///
    /// # Errors
    ///
    /// See there.
    pub async fn flush(&self) -> Result<(), LinkError> {
        self.sending.flush().await
    }

    /// See [`SendHalf::send_to`].
    ///
    /// # Errors
    ///
    /// See there.
    pub async fn send_to(&self, message: &(impl Encode + ?Sized), peer: Peer) -> Result<(), LinkError> {
        self.sending.send_to(message, peer).await
    }

    /// See [`SendHalf::send_frame`].
    ///
    /// # Errors
    ///
    /// See there.
    pub async fn send_frame(&self, frame: &Frame<'_>) -> Result<usize, LinkError> {
        self.sending.send_frame(frame).await
    }

    /// See [`SendHalf::send_frame_to`].
    ///
    /// # Errors
    ///
    /// See there.
    pub async fn send_frame_to(&self, frame: &Frame<'_>, peer: Peer) -> Result<(), LinkError> {
        self.sending.send_frame_to(frame, peer).await
    }

    /// Which system sends.
    #[must_use]
    pub fn system_id(&self) -> SystemId {
        self.sending.system_id()
    }

    /// Which component of it sends.
    #[must_use]
    pub fn component_id(&self) -> ComponentId {
        self.sending.component_id()
    }

    /// See [`SendHalf::with_sender`].
    pub fn with_sender<R>(&self, change: impl FnOnce(&mut Sender) -> R) -> R {
        self.sending.with_sender(change)
    }

    /// See [`SendHalf::peers`].
    #[must_use]
    pub fn peers(&self) -> Vec<Peer> {
        self.sending.peers()
    }

    /// See [`SendHalf::remove_peer`].
    pub fn remove_peer(&self, peer: Peer) -> bool {
        self.sending.remove_peer(peer)
    }

    /// See [`SendHalf::is_connected`].
    #[must_use]
    pub fn is_connected(&self) -> bool {
        self.sending.is_connected()
    }

    /// See [`SendHalf::trouble`].
    #[must_use]
    pub fn trouble(&self) -> Option<String> {
        self.sending.trouble()
    }

    /// See [`SendHalf::local_addr`].
    #[must_use]
    pub fn local_addr(&self) -> Option<SocketAddr> {
        self.sending.local_addr()
    }

    /// See [`SendHalf::close`].
    pub fn close(&self) {
        self.sending.close();
    }
}
