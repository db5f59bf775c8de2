//! What a connection or a device is to those who block and to those who poll, and how it is opened.

use std::boxed::Box;
use std::io;
use std::net::TcpStream;

use super::{LinkError, Peer};

/// An open connection or device, to be taken apart.
pub(super) trait Ends: Send + Sized {
    /// Reads from it.
    type Reader: Send;
    /// Writes to it.
    type Writer: Send;

    /// Whether a first attempt to connect may block.
    const BLOCKS: bool;

    /// Of an open connection.
    fn of_tcp(stream: TcpStream) -> io::Result<Self>;

    /// What opens a serial port.
    ///
    /// # Errors
    ///
    /// The feature for serial ports is off.
    fn serial(path: &str, baud: u32) -> Serial<Self>;

    /// Takes it apart.
    fn split(self) -> io::Result<Parts<Self::Reader, Self::Writer>>;
}

/// Both ends, and what shuts them.
pub(super) struct Parts<R, W> {
    pub(super) reader: R,
    pub(super) writer: W,
    pub(super) kept: Box<dyn Shut>,
}

/// Ends a connection for all that have a hand on it.
pub(super) trait Shut: Send {
    /// Ends it; one that has ended stays as it is.
    fn shut(&self);
}

/// Opens connections or devices, again and again.
pub(super) trait Opener<E>: Send {
    /// Goes on with opening, without waiting.
    ///
    /// # Errors
    ///
    /// Why this attempt has failed. The next one may not.
    fn attempt(&mut self) -> Attempt<E>;

    /// Whether others may come while there is a connection.
    fn is_listener(&self) -> bool {
        false
    }
}

/// What opens a serial port.
pub(super) type Serial<E> = Result<Box<dyn Opener<E>>, LinkError>;

/// What has come of opening: something open and who is at its other end, or nothing yet.
pub(super) type Attempt<E> = Result<Option<(E, Peer)>, LinkError>;
