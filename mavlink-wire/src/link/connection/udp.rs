//! Sockets for datagrams.

use std::io::ErrorKind;
use std::net::{SocketAddr, ToSocketAddrs, UdpSocket};
use std::time::{Duration, Instant};

use super::stream::Timeout;
use crate::adapters::pause::{is_not_now, is_passing};
use crate::link::{Inbox, LinkError};

/// A socket that receives.
pub(super) struct Receiving {
    socket: UdpSocket,
    timeout: Timeout,
}

impl Receiving {
    pub(super) fn new(socket: UdpSocket) -> Self {
        Self { socket, timeout: Timeout::default() }
    }

    /// Waits so long for a datagram.
    pub(super) fn wait(&mut self, inbox: &mut Inbox<'_>, limit: Duration) -> Result<(), LinkError> {
        self.timeout.change(limit, |limit| self.socket.set_read_timeout(limit)).map_err(LinkError::Io)?;
        let began = Instant::now();
        match self.socket.recv_from(inbox.space()) {
            Ok((length, from)) => inbox.fill(length, from.into(), began.elapsed()),
            Err(error) if is_passing(&error) => {}
            Err(error) if is_not_now(&error) => drop(inbox.give_up()),
            Err(error) => return Err(LinkError::Io(error)),
        }
        Ok(())
    }
}

/// A socket that listens there.
pub(in crate::link) fn listen(address: &str) -> Result<UdpSocket, LinkError> {
    UdpSocket::bind(address).map_err(|error| LinkError::of_listening(error, address))
}

/// A socket to send there.
pub(in crate::link) fn towards(to: SocketAddr, broadcasts: bool) -> Result<UdpSocket, LinkError> {
    let any = if to.is_ipv4() { "0.0.0.0:0" } else { "[::]:0" };
    let socket = UdpSocket::bind(any).map_err(LinkError::Io)?;
    socket.set_broadcast(broadcasts).map_err(LinkError::Io)?;
    Ok(socket)
}

/// The first address that a name has.
pub(super) fn resolve(address: &str) -> Result<SocketAddr, LinkError> {
    let unreachable = |reason| LinkError::Unreachable { address: address.into(), reason };
    let first = address.to_socket_addrs().map_err(unreachable)?.next();
    first.ok_or_else(|| unreachable(ErrorKind::NotFound.into()))
}
