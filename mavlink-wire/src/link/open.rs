//! From an address to what it stands for.

use std::boxed::Box;
use std::net::UdpSocket;

use super::ends::{Ends, Opener};
use super::file::Recording;
use super::shared::Shared;
use super::{Address, LinkError, Options, tcp, udp};

/// What an address stands for.
pub(super) enum Transport<E> {
    Datagrams(UdpSocket),
    /// A connection or a device, still to be opened.
    Connection(Box<dyn Opener<E>>),
    Recording(Recording),
}

impl<E: Ends> Transport<E> {
    /// What the address stands for, and what the halves share of it. It may have to wait for the name of a host, or for a disk.
    pub(super) fn at(address: &Address, options: &Options) -> Result<(Self, Shared), LinkError> {
        let (many, one) = (|| Shared::new(options.peers(), options), || Shared::new(options.only_peer(), options));
        Ok(match address {
            Address::UdpIn(at) => {
                let socket = udp::listen(at)?;
                let local = socket.local_addr().ok();
                (Self::Datagrams(socket), many().listening(local))
            }
            Address::UdpOut(to) => {
                let to = udp::resolve(to)?;
                (Self::Datagrams(udp::towards(to, false)?), many().towards(to.into()))
            }
            Address::UdpBroadcast(to) => {
                let to = udp::resolve(to)?;
                (Self::Datagrams(udp::towards(to, true)?), many().towards(to.into()).listening(None))
            }
            Address::TcpIn(at) => {
                let (listener, local) = tcp::Listener::new(at)?;
                (Self::Connection(Box::new(listener)), one().listening(Some(local)))
            }
            Address::TcpOut(to) => (Self::Connection(Box::new(tcp::Caller::new(to, E::BLOCKS))), one()),
            Address::Serial { path, baud } => (Self::Connection(E::serial(path, *baud)?), one()),
            Address::File(path) => (Self::Recording(Recording::open(path, options.table)?), one()),
        })
    }

    /// Whether bytes come in one row, and not in datagrams.
    pub(super) fn is_stream(&self) -> bool {
        !matches!(self, Self::Datagrams(_))
    }
}
