//! What carries bytes both ways for those who poll.

use core::task::{Context, Poll, ready};
use std::boxed::Box;
use std::io::{ErrorKind, IoSlice, Result};
use std::sync::Arc;

use ::tokio::net::TcpStream;

#[cfg(not(feature = "tokio-serial"))]
use crate::link::LinkError;
use crate::link::ends::{Ends, Parts, Serial, Shut};

/// An open connection or device. One task may read and one may write.
pub(super) trait Polled: Send + Sync {
    /// Reads what there is. Nothing, without an error, is the end.
    fn poll_read(&self, context: &mut Context<'_>, buffer: &mut [u8]) -> Poll<Result<usize>>;

    /// Writes what there is room for of these, one after the other.
    fn poll_write(&self, context: &mut Context<'_>, frames: &[IoSlice<'_>]) -> Poll<Result<usize>>;
}

/// One hand on it.
pub(super) type Hand = Arc<dyn Polled>;

/// What was opened.
pub(super) enum Opened {
    Tcp(std::net::TcpStream),
    #[cfg(feature = "tokio-serial")]
    Serial(tokio_serial::SerialStream),
}

impl Ends for Opened {
    type Reader = Hand;
    type Writer = Hand;

    const BLOCKS: bool = false;

    fn of_tcp(stream: std::net::TcpStream) -> Result<Self> {
        Ok(Self::Tcp(stream))
    }

    #[cfg(feature = "tokio-serial")]
    fn serial(path: &str, baud: u32) -> Serial<Self> {
        Ok(Box::new(serial::Device::new(path, baud)))
    }

    #[cfg(not(feature = "tokio-serial"))]
    fn serial(_: &str, _: u32) -> Serial<Self> {
        Err(LinkError::Feature { name: "tokio-serial" })
    }

    fn split(self) -> Result<Parts<Hand, Hand>> {
        let (hand, kept): (Hand, Box<dyn Shut>) = match self {
            Self::Tcp(stream) => {
                stream.set_nonblocking(true)?;
                let kept = stream.try_clone()?;
                (Arc::new(TcpStream::from_std(stream)?), Box::new(kept))
            }
            #[cfg(feature = "tokio-serial")]
            Self::Serial(stream) => (Arc::new(serial::Port::new(stream)), Box::new(serial::Nothing)),
        };
        Ok(Parts { reader: hand.clone(), writer: hand, kept })
    }
}

impl Polled for TcpStream {
    fn poll_read(&self, context: &mut Context<'_>, buffer: &mut [u8]) -> Poll<Result<usize>> {
        loop {
            ready!(self.poll_read_ready(context))?;
            match self.try_read(buffer) {
                Err(error) if error.kind() == ErrorKind::WouldBlock => {}
                read => return Poll::Ready(read),
            }
        }
    }

    fn poll_write(&self, context: &mut Context<'_>, frames: &[IoSlice<'_>]) -> Poll<Result<usize>> {
        loop {
            ready!(self.poll_write_ready(context))?;
            match self.try_write_vectored(frames) {
                Err(error) if error.kind() == ErrorKind::WouldBlock => {}
                written => return Poll::Ready(written),
            }
        }
    }
}

#[cfg(feature = "tokio-serial")]
pub(super) mod serial {
    //! Serial ports.

    use core::pin::Pin;
    use core::task::{Context, Poll};
    use std::io::{IoSlice, Result};
    use std::string::String;
    use std::sync::{Mutex, PoisonError};

    use ::tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
    use tokio_serial::SerialStream;

    use super::{Opened, Polled};
    use crate::link::Peer;
    use crate::link::connection::of_opening;
    use crate::link::ends::{Attempt, Opener, Shut};

    /// An open port, held only while something is read or written, never while somebody waits.
    pub(super) struct Port(Mutex<SerialStream>);

    impl Port {
        pub(super) fn new(stream: SerialStream) -> Self {
            Self(Mutex::new(stream))
        }
    }

    impl Polled for Port {
        fn poll_read(&self, context: &mut Context<'_>, buffer: &mut [u8]) -> Poll<Result<usize>> {
            let mut port = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            let mut buffer = ReadBuf::new(buffer);
            Pin::new(&mut *port).poll_read(context, &mut buffer).map_ok(|()| buffer.filled().len())
        }

        fn poll_write(&self, context: &mut Context<'_>, frames: &[IoSlice<'_>]) -> Poll<Result<usize>> {
            let mut port = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            Pin::new(&mut *port).poll_write_vectored(context, frames)
        }
    }

    /// A port needs no shutting: who waits is woken otherwise.
    pub(super) struct Nothing;

    impl Shut for Nothing {
        fn shut(&self) {}
    }

    /// Opens a device.
    pub(in crate::link::tokio) struct Device {
        path: String,
        baud: u32,
    }

    impl Device {
        pub(in crate::link::tokio) fn new(path: &str, baud: u32) -> Self {
            Self { path: path.into(), baud }
        }
    }

    impl Opener<Opened> for Device {
        fn attempt(&mut self) -> Attempt<Opened> {
            match SerialStream::open(&serialport::new(&self.path, self.baud)) {
                Ok(stream) => Ok(Some((Opened::Serial(stream), Peer::NEARBY))),
                Err(error) => Err(of_opening(error, &self.path)),
            }
        }
    }
}
