//! Links that wait by blocking.

mod receive;
mod send;
#[cfg(feature = "serial")]
mod serial;
mod stream;
pub(super) mod udp;

pub use receive::ReceiveHalf;
pub use send::SendHalf;
#[cfg(feature = "tokio")]
pub(super) use send::{is_sent, of_sending};
#[cfg(feature = "tokio-serial")]
pub(super) use serial::of_opening;

use std::boxed::Box;
use std::net::SocketAddr;
use std::string::String;
use std::sync::{Arc, Mutex};
use std::time::Instant;
use std::vec::Vec;

use super::ends::Opener;
use super::file::Recording;
use super::forward::forward_to_halves;
use super::line::Line;
use super::shared::Shared;
use super::statistics::Counters;
use super::{Address, LinkError, LinkStatistics, Options, Peer, Pending, tcp};
#[cfg(feature = "signing")]
use crate::signing::Verifier;
use crate::{ComponentId, Encode, Frame, Losses, Sender, SystemId};
use send::Way;
use stream::Stream;

/// Sends frames to an address and receives them.
///
/// A link has two halves. [`split`](Self::split) returns them, for two threads. [`sending`](Self::sending) returns another handle
/// of the half that sends.
#[derive(Debug)]
pub struct Link {
    receiving: ReceiveHalf,
    sending: SendHalf,
}

/// The ways of both halves, and what they share.
struct Opened {
    shared: Shared,
    line: Option<Arc<Line<Box<dyn Stream>>>>,
    receiving: receive::Carrier,
    sending: send::Carrier,
    is_stream: bool,
}

impl Link {
    /// Opens a link to this address, as [`Address`] describes it.
    ///
    /// # Errors
    ///
    /// The address is wrong or in use, or nobody is there. The first attempt has to succeed; afterwards the link reconnects by
    /// itself.
    pub fn connect(address: &str, options: Options) -> Result<Self, LinkError> {
        let Opened { shared, line, receiving, sending, is_stream } = open(&address.parse()?, &options)?;
        let (peers, shared) = (shared.peers.clone(), Arc::new(shared));
        let way = Way { outbox: options.outbox(&peers), carrier: sending, pending: Pending::default() };
        Ok(Self {
            receiving: ReceiveHalf {
                shared: shared.clone(),
                inbox: options.inbox(&peers, is_stream),
                carrier: receiving,
                losses: Losses::new(),
            },
            sending: SendHalf { shared, line, way: Arc::new(Mutex::new(way)) },
        })
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

fn open(address: &Address, options: &Options) -> Result<Opened, LinkError> {
    let counters = Arc::new(Counters::default());
    match address {
        Address::UdpIn(at) => {
            let shared = Shared::new(options.peers(), counters, options);
            let socket = udp::listen(at)?;
            let local = socket.local_addr().ok();
            datagrams(socket, shared.listening(local))
        }
        Address::UdpOut(to) => {
            let (to, shared) = (udp::resolve(to)?, Shared::new(options.peers(), counters, options));
            shared.peers.name(Some(to.into()));
            datagrams(udp::towards(to, false)?, shared)
        }
        Address::UdpBroadcast(to) => {
            let (to, shared) = (udp::resolve(to)?, Shared::new(options.peers(), counters, options));
            shared.peers.name(Some(to.into()));
            datagrams(udp::towards(to, true)?, shared.listening(None))
        }
        Address::TcpIn(at) => {
            let (listener, local) = tcp::Listener::new(at)?;
            let shared = Shared::new(options.only_peer(), counters, options);
            connection(Box::new(listener), shared.listening(Some(local)), options)
        }
        Address::TcpOut(to) => {
            let shared = Shared::new(options.only_peer(), counters, options);
            connection(Box::new(tcp::Caller::new(to, true)), shared, options)
        }
        #[cfg(feature = "serial")]
        Address::Serial { path, baud } => {
            let shared = Shared::new(options.only_peer(), counters, options);
            connection(Box::new(serial::Device::new(path, *baud)), shared, options)
        }
        #[cfg(not(feature = "serial"))]
        Address::Serial { .. } => Err(LinkError::Feature { name: "serial" }),
        Address::File(path) => {
            let recording = Recording::open(path, options.table)?;
            counters.count_connection();
            Ok(Opened {
                shared: Shared::new(options.only_peer(), counters, options),
                line: None,
                receiving: receive::Carrier::of_recording(recording, options.table),
                sending: send::Carrier::Nothing,
                is_stream: true,
            })
        }
    }
}

/// A link of datagrams.
fn datagrams(socket: std::net::UdpSocket, shared: Shared) -> Result<Opened, LinkError> {
    let twin = socket.try_clone().map_err(LinkError::Io)?;
    twin.set_write_timeout(Some(shared.send_timeout.max(core::time::Duration::from_millis(1))))
        .map_err(LinkError::Io)?;
    shared.counters.count_connection();
    let receiving = receive::Carrier::Datagrams(udp::Receiving::new(socket));
    Ok(Opened { shared, line: None, receiving, sending: send::Carrier::Datagrams { socket: twin }, is_stream: false })
}

/// A link that is a connection, or a device.
fn connection(
    opener: Box<dyn Opener<Box<dyn Stream>>>,
    shared: Shared,
    options: &Options,
) -> Result<Opened, LinkError> {
    let line = Line::open(opener, options.reconnects, shared.peers.clone(), shared.counters.clone())?;
    let line = Arc::new(line);
    let receiving = receive::Carrier::Line { line: line.clone(), end: None, heard: Instant::now() };
    let sending = send::Carrier::Line { end: None };
    Ok(Opened { shared, line: Some(line), receiving, sending, is_stream: true })
}

forward_to_halves! {}
