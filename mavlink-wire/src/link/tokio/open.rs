//! Opening links.

use std::boxed::Box;
use std::io::ErrorKind;
use std::net::SocketAddr;
use std::sync::Arc;
use std::time::Duration;

use ::tokio::net::{UdpSocket, lookup_host};
use ::tokio::sync::Notify;
use ::tokio::task::spawn_blocking;
use ::tokio::time::sleep;

use super::ends::Opened;
#[cfg(feature = "tokio-serial")]
use super::ends::serial;
use super::{Common, ReceiveHalf, SendHalf, receive, send};
use crate::link::connection::udp;
use crate::link::ends::Opener;
use crate::link::file::Recording;
use crate::link::line::Line;
use crate::link::shared::Shared;
use crate::link::statistics::Counters;
use crate::link::{Address, LinkError, Options, tcp};

/// So often somebody who waits for a first connection looks whether it is there.
const POLL: Duration = Duration::from_millis(5);

type Halves = (ReceiveHalf, SendHalf);

pub(super) async fn open(address: &Address, options: &Options) -> Result<Halves, LinkError> {
    let counters = Arc::new(Counters::default());
    match address {
        Address::UdpIn(at) => {
            let shared = Shared::new(options.peers(), counters, options);
            let socket = udp::listen(at)?;
            let local = socket.local_addr().ok();
            datagrams(socket, shared.listening(local), options)
        }
        Address::UdpOut(to) => {
            let (to, shared) = (resolve(to).await?, Shared::new(options.peers(), counters, options));
            shared.peers.name(Some(to.into()));
            datagrams(udp::towards(to, false)?, shared, options)
        }
        Address::UdpBroadcast(to) => {
            let (to, shared) = (resolve(to).await?, Shared::new(options.peers(), counters, options));
            shared.peers.name(Some(to.into()));
            datagrams(udp::towards(to, true)?, shared.listening(None), options)
        }
        Address::TcpIn(at) => {
            let (listener, local) = tcp::Listener::new(at)?;
            let shared = Shared::new(options.only_peer(), counters, options).listening(Some(local));
            connection(Box::new(listener), shared, options)
        }
        Address::TcpOut(to) => {
            let shared = Shared::new(options.only_peer(), counters, options);
            let halves = connection(Box::new(tcp::Caller::new(to, false)), shared, options)?;
            wait_for_first(&halves.1).await?;
            Ok(halves)
        }
        #[cfg(feature = "tokio-serial")]
        Address::Serial { path, baud } => {
            let shared = Shared::new(options.only_peer(), counters, options);
            connection(Box::new(serial::Device::new(path, *baud)), shared, options)
        }
        #[cfg(not(feature = "tokio-serial"))]
        Address::Serial { .. } => Err(LinkError::Feature { name: "tokio-serial" }),
        Address::File(path) => {
            let (path, table) = (path.clone(), options.table);
            let opened = spawn_blocking(move || Recording::open(&path, table)).await;
            let recording = opened.map_err(|error| LinkError::Io(error.into()))??;
            counters.count_connection();
            let shared = Shared::new(options.only_peer(), counters, options);
            let receiving = receive::Carrier::of_recording(recording, table);
            Ok(halves(shared, None, (receiving, send::Carrier::Nothing), options, true))
        }
    }
}

async fn resolve(address: &str) -> Result<SocketAddr, LinkError> {
    let unreachable = |reason| LinkError::Unreachable { address: address.into(), reason };
    let first = lookup_host(address).await.map_err(unreachable)?.next();
    first.ok_or_else(|| unreachable(ErrorKind::NotFound.into()))
}

/// A link of datagrams.
fn datagrams(socket: std::net::UdpSocket, shared: Shared, options: &Options) -> Result<Halves, LinkError> {
    socket.set_nonblocking(true).map_err(LinkError::Io)?;
    let socket = Arc::new(UdpSocket::from_std(socket).map_err(LinkError::Io)?);
    shared.counters.count_connection();
    let carriers = (receive::Carrier::Datagrams(socket.clone()), send::Carrier::Datagrams(socket));
    Ok(halves(shared, None, carriers, options, false))
}

/// A link that is a connection, or a device.
fn connection(opener: Box<dyn Opener<Opened>>, shared: Shared, options: &Options) -> Result<Halves, LinkError> {
    let line = Line::open(opener, options.reconnects, shared.peers.clone(), shared.counters.clone())?;
    let line = Arc::new(line);
    let carriers = (receive::Carrier::line(line.clone()), send::Carrier::Line { end: None });
    Ok(halves(shared, Some(line), carriers, options, true))
}

/// Waits for the first attempt to connect.
async fn wait_for_first(sending: &SendHalf) -> Result<(), LinkError> {
    while !sending.try_first()? {
        sleep(POLL).await;
    }
    Ok(())
}

fn halves(
    shared: Shared,
    line: Option<Arc<Line<Opened>>>,
    (receiving, sending): (receive::Carrier, send::Carrier),
    options: &Options,
    is_stream: bool,
) -> Halves {
    let (inbox, outbox) = (options.inbox(&shared.peers, is_stream), options.outbox(&shared.peers));
    let common = Arc::new(Common { shared, closing: Notify::new() });
    (ReceiveHalf::new(common.clone(), inbox, receiving), SendHalf::new(common, line, outbox, sending))
}
