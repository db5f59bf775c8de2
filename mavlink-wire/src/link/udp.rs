//! Sockets for datagrams.

use std::io::ErrorKind;
use std::net::{SocketAddr, ToSocketAddrs, UdpSocket};

use super::LinkError;

/// A socket that listens there.
pub(super) fn listen(address: &str) -> Result<UdpSocket, LinkError> {
    UdpSocket::bind(address).map_err(|error| LinkError::of_listening(error, address))
}

/// A socket to send there.
pub(super) fn towards(to: SocketAddr, broadcasts: bool) -> Result<UdpSocket, LinkError> {
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
