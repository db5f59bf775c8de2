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

use super::forward::forward_to_halves;
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
        open::open(address.parse()?, options).await
    }

    /// See [`ReceiveHalf::losses`].
    #[must_use]
    pub const fn losses(&self) -> &Losses {
        self.receiving.losses()
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

forward_to_halves! { async await }
