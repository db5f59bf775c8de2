//! TCP, from both sides.

use std::io::{self, ErrorKind};
use std::net::{SocketAddr, TcpListener, TcpStream, ToSocketAddrs};
use std::string::String;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread;
use std::time::Duration;

use super::LinkError;
use super::ends::{Attempt, Ends, Opener};
use crate::adapters::pause::{is_interrupted, is_not_now};

/// How long an attempt to connect may take.
const ATTEMPT: Duration = Duration::from_secs(5);

/// Frames go out at once: a heartbeat that waits for company is late.
fn ready(stream: TcpStream) -> io::Result<TcpStream> {
    stream.set_nonblocking(false)?;
    stream.set_nodelay(true)?;
    Ok(stream)
}

/// Connects to an address: in a thread of its own, but for a first time, so that nobody waits longer than he wants to.
pub(super) struct Caller {
    address: String,
    blocks: bool,
    attempt: Option<Receiver<Result<TcpStream, LinkError>>>,
}

impl Caller {
    /// `blocks`: whether the first attempt is made at once.
    pub(super) fn new(address: &str, blocks: bool) -> Self {
        Self { address: address.into(), blocks, attempt: None }
    }
}

impl<E: Ends> Opener<E> for Caller {
    fn attempt(&mut self) -> Attempt<E> {
        if core::mem::take(&mut self.blocks) {
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

fn with_peer<E: Ends>(stream: TcpStream) -> Attempt<E> {
    let with_peer = || {
        let peer = stream.peer_addr()?;
        Ok((E::of_tcp(stream)?, peer.into()))
    };
    with_peer().map(Some).map_err(LinkError::Io)
}

/// Tries all addresses that a name has.
fn connect(address: &str) -> Result<TcpStream, LinkError> {
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
    pub(super) fn new(address: &str) -> Result<(Self, SocketAddr), LinkError> {
        let listen = || {
            let listener = TcpListener::bind(address)?;
            listener.set_nonblocking(true)?;
            let local = listener.local_addr()?;
            Ok((Self(listener), local))
        };
        listen().map_err(|error| LinkError::of_listening(error, address))
    }
}

impl<E: Ends> Opener<E> for Listener {
    fn attempt(&mut self) -> Attempt<E> {
        match self.0.accept() {
            Ok((stream, _)) => ready(stream).map_err(LinkError::Io).and_then(with_peer),
            // One that has gone again before it was accepted.
            Err(error) if error.kind() == ErrorKind::ConnectionAborted => Ok(None),
            Err(error) if is_interrupted(&error) || is_not_now(&error) => Ok(None),
            Err(error) => Err(LinkError::Io(error)),
        }
    }

    fn is_listener(&self) -> bool {
        true
    }
}
