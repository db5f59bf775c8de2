//! Receiving datagrams.

use std::net::UdpSocket;
use std::time::{Duration, Instant};

use super::stream::Timeout;
use crate::adapters::pause::in_time;
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
        let came = in_time(self.socket.recv_from(inbox.space()));
        inbox.take_datagram(came, began.elapsed()).map_err(LinkError::Io)
    }
}
