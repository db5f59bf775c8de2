//! TCP, from both sides.

use std::boxed::Box;
use std::io::{ErrorKind, Read, Result, Write};
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream, ToSocketAddrs};
use std::string::String;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread;
use std::time::Duration;

use super::stream::{Attempt, Opener, Stream};
use crate::link::LinkError;

/// How long an attempt to connect may take.
const ATTEMPT: Duration = Duration::from_secs(5);

/// Zero would mean to wait for ever.
const SHORTEST: Duration = Duration::from_millis(1);

impl Stream for TcpStream {
    fn read_within(&mut self, buffer: &mut [u8], limit: Duration) -> Result<usize> {
        self.set_read_timeout(Some(limit.max(SHORTEST)))?;
        self.read(buffer)
    }

    fn write_within(&mut self, bytes: &[u8], limit: Duration) -> Result<usize> {
        self.set_write_timeout(Some(limit.max(SHORTEST)))?;
        self.write(bytes)
    }

    fn twin(&self) -> Result<Box<dyn Stream>> {
        Ok(Box::new(self.try_clone()?))
    }

    fn shut(&self) {
        // One that is closed already needs no closing.
        let _ = self.shutdown(Shutdown::Both);
    }
}

/// Frames go out at once: a heartbeat that waits for company is late.
fn ready(stream: TcpStream) -> Result<TcpStream> {
    stream.set_nonblocking(false)?;
    stream.set_nodelay(true)?;
    Ok(stream)
}

/// Connects to an address. After the first time, in a thread of its own, so that nobody waits longer than he wants to.
pub(super) struct Caller {
    address: String,
    first: bool,
    attempt: Option<Receiver<core::result::Result<TcpStream, LinkError>>>,
}

impl Caller {
    pub(super) fn new(address: &str) -> Self {
        Self { address: address.into(), first: true, attempt: None }
    }
}

impl Opener for Caller {
    fn attempt(&mut self) -> Attempt {
        if core::mem::take(&mut self.first) {
            return with_peer(connect(&self.address)?);
        }
        let Some(attempt) = &self.attempt else {
            let (tell, told) = channel();
            let address = self.address.clone();
            let thread = thread::Builder::new().name("mavlink connect".into());
            // Nobody listens any more when the link was dropped meanwhile.
            thread.spawn(move || drop(tell.send(connect(&address)))).map_err(LinkError::Io)?;
            self.attempt = Some(told);
            return Ok(None);
        };
        let made = match attempt.try_recv() {
            Err(TryRecvError::Empty) => return Ok(None),
            Err(TryRecvError::Disconnected) => Ok(None),
            Ok(made) => made.and_then(with_peer),
        };
        self.attempt = None;
        made
    }
}

fn with_peer(stream: TcpStream) -> Attempt {
    let peer = stream.peer_addr().map_err(LinkError::Io)?;
    Ok(Some((Box::new(stream), peer.into())))
}

/// Tries all addresses that a name has.
fn connect(address: &str) -> core::result::Result<TcpStream, LinkError> {
    let unreachable = |reason| LinkError::Unreachable { address: address.into(), reason };
    let mut last = ErrorKind::NotFound.into();
    for to in address.to_socket_addrs().map_err(unreachable)? {
        match TcpStream::connect_timeout(&to, ATTEMPT).and_then(ready) {
            Ok(stream) => return Ok(stream),
            Err(error) => last = error,
        }
    }
    Err(unreachable(last))
}

/// Listens for a client, one at a time.
pub(super) struct Listener(TcpListener);

impl Listener {
    /// A listener, and where it listens.
    pub(super) fn new(address: &str) -> core::result::Result<(Self, SocketAddr), LinkError> {
        let listen = || {
            let listener = TcpListener::bind(address)?;
            listener.set_nonblocking(true)?;
            let local = listener.local_addr()?;
            Ok((Self(listener), local))
        };
        listen().map_err(|error| LinkError::of_listening(error, address))
    }
}

impl Opener for Listener {
    fn attempt(&mut self) -> Attempt {
        match self.0.accept() {
            Ok((stream, from)) => Ok(Some((Box::new(ready(stream).map_err(LinkError::Io)?), from.into()))),
            // Of one that has gone again before it was accepted, too.
            Err(error)
                if matches!(
                    error.kind(),
                    ErrorKind::WouldBlock | ErrorKind::Interrupted | ErrorKind::ConnectionAborted
                ) =>
            {
                Ok(None)
            }
            Err(error) => Err(LinkError::Io(error)),
        }
    }

    fn is_listener(&self) -> bool {
        true
    }
}
