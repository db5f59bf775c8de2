//! Links that wait by blocking.

mod receive;
mod send;
#[cfg(feature = "serial")]
mod serial;
mod stream;
mod udp;

pub use receive::ReceiveHalf;
pub use send::SendHalf;
#[cfg(feature = "tokio")]
pub(super) use send::{is_sent, of_sending};
#[cfg(feature = "tokio-serial")]
pub(super) use serial::of_opening;

use std::net::SocketAddr;
use std::string::String;
use std::sync::{Arc, Mutex};
use std::time::Instant;
use std::vec::Vec;

use super::forward::forward_to_halves;
use super::line::{Hearing, Line};
use super::open::Transport;
use super::{LinkError, LinkStatistics, Options, Peer, Pending};
#[cfg(feature = "signing")]
use crate::signing::Verifier;
use crate::{ComponentId, Encode, Frame, Losses, Sender, SystemId};
use send::Way;
use stream::SHORTEST;

/// Sends frames to an address and receives them.
///
/// A link has two halves. [`split`](Self::split) returns them, for two threads. [`sending`](Self::sending) returns another handle
/// of the half that sends.
#[derive(Debug)]
pub struct Link {
    receiving: ReceiveHalf,
    sending: SendHalf,
}

impl Link {
    /// Opens a link to this address, as [`Address`](super::Address) describes it.
    ///
    /// # Errors
    ///
    /// The address is wrong or in use, or nobody is there. The first attempt has to succeed; afterwards the link reconnects by
    /// itself.
    pub fn connect(address: &str, options: Options) -> Result<Self, LinkError> {
        let (transport, shared) = Transport::at(&address.parse()?, &options)?;
        let inbox = options.inbox(&shared.peers, transport.is_stream());
        let (line, receiving, sending) = match transport {
            Transport::Datagrams(socket) => {
                let twin = socket.try_clone().map_err(LinkError::Io)?;
                twin.set_write_timeout(Some(shared.send_timeout.max(SHORTEST))).map_err(LinkError::Io)?;
                shared.counters.count_connection();
                let receiving = receive::Carrier::Datagrams(udp::Receiving::new(socket));
                (None, receiving, send::Carrier::Datagrams { socket: twin })
            }
            Transport::Connection(opener) => {
                let line = Arc::new(Line::open(opener, options.reconnects, &shared)?);
                let receiving = receive::Carrier::Line(Hearing::new(line.clone()));
                (Some(line), receiving, send::Carrier::Line { end: None })
            }
            Transport::Recording(recording) => {
                shared.counters.count_connection();
                (None, receive::Carrier::of_recording(recording, options.table), send::Carrier::Nothing)
            }
        };
        let way = Way { outbox: options.outbox(&shared.peers), carrier: sending, pending: Pending::default() };
        let shared = Arc::new(shared);
        Ok(Self {
            receiving: ReceiveHalf { shared: shared.clone(), inbox, carrier: receiving, losses: Losses::new() },
            sending: SendHalf { shared, line, way: Arc::new(Mutex::new(way)) },
        })
    }

    /// See [`ReceiveHalf::losses`].
    #[must_use]
    pub const fn losses(&self) -> &Losses {
        self.receiving.losses()
    }

    /// Splits the link into both halves, for two threads.
    #[must_use]
    pub fn split(self) -> (ReceiveHalf, SendHalf) {
        (self.receiving, self.sending)
    }

    /// Another handle of the half that sends, for another thread.
    #[must_use]
    pub fn sending(&self) -> SendHalf {
        self.sending.clone()
    }
}

forward_to_halves! {}
