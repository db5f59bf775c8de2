//! Opening links.

use std::io;
use std::sync::Arc;
use std::time::Duration;

use ::tokio::net::UdpSocket;
use ::tokio::sync::Notify;
use ::tokio::task::spawn_blocking;
use ::tokio::time::sleep;

use super::{Common, Link, ReceiveHalf, SendHalf, receive, send};
use crate::link::line::{Hearing, Line};
use crate::link::open::Transport;
use crate::link::{Address, LinkError, Options};

/// So often somebody who waits for a first connection looks whether it is there.
const POLL: Duration = Duration::from_millis(5);

pub(super) async fn open(address: Address, options: Options) -> Result<Link, LinkError> {
    let waits_for_first = matches!(address, Address::TcpOut(_));
    // Names and disks are waited for by blocking.
    let opening = spawn_blocking(move || Transport::at(&address, &options).map(|opened| (opened, options)));
    let ((transport, shared), options) = opening.await.map_err(|error| LinkError::Io(error.into()))??;
    let (inbox, outbox) = (options.inbox(&shared.peers, transport.is_stream()), options.outbox(&shared.peers));
    let (line, receiving, sending) = match transport {
        Transport::Datagrams(socket) => {
            let socket = Arc::new(polled(socket).map_err(LinkError::Io)?);
            shared.counters.count_connection();
            (None, receive::Carrier::Datagrams(socket.clone()), send::Carrier::Datagrams(socket))
        }
        Transport::Connection(opener) => {
            let line = Arc::new(Line::open(opener, options.reconnects, &shared)?);
            (Some(line.clone()), receive::Carrier::Line(Hearing::new(line)), send::Carrier::Line { end: None })
        }
        Transport::Recording(recording) => {
            shared.counters.count_connection();
            (None, receive::Carrier::of_recording(recording, options.table), send::Carrier::Nothing)
        }
    };
    if let Some(line) = line.as_ref().filter(|_| waits_for_first) {
        while !line.try_first()? {
            sleep(POLL).await;
        }
    }
    let common = Arc::new(Common { shared, closing: Notify::new() });
    let receiving = ReceiveHalf::new(common.clone(), inbox, receiving);
    Ok(Link { receiving, sending: SendHalf::new(common, line, outbox, sending) })
}

fn polled(socket: std::net::UdpSocket) -> io::Result<UdpSocket> {
    socket.set_nonblocking(true)?;
    UdpSocket::from_std(socket)
}
