//! What carries bytes both ways for those who block.

use std::boxed::Box;
use std::io::{IoSlice, Read, Result, Write};
use std::net::{Shutdown, TcpStream};
use std::time::Duration;

#[cfg(not(feature = "serial"))]
use crate::link::LinkError;
use crate::link::ends::{Ends, Parts, Serial, Shut};

/// Zero would mean to wait for ever.
pub(super) const SHORTEST: Duration = Duration::from_millis(1);

/// The timeout that a socket has: the system is told only when it changes.
#[derive(Debug, Default)]
pub(super) struct Timeout(Option<Duration>);

impl Timeout {
    /// Waits so long from now on.
    pub(super) fn change(&mut self, limit: Duration, tell: impl FnOnce(Option<Duration>) -> Result<()>) -> Result<()> {
        let limit = Some(limit.max(SHORTEST));
        if self.0 != limit {
            tell(limit)?;
            self.0 = limit;
        }
        Ok(())
    }
}

/// An open connection or device.
pub(in crate::link) trait Stream: Shut {
    /// Reads what there is; waits so long for it. Nothing, without an error, is the end.
    fn read_within(&mut self, buffer: &mut [u8], limit: Duration) -> Result<usize>;

    /// Writes what there is room for of these, one after the other; waits so long for it.
    fn write_within(&mut self, frames: &[IoSlice<'_>], limit: Duration) -> Result<usize>;

    /// Another hand on the same.
    fn twin(&self) -> Result<Box<dyn Stream>>;
}

impl Ends for Box<dyn Stream> {
    type Reader = Self;
    type Writer = Self;

    const BLOCKS: bool = true;

    fn of_tcp(stream: TcpStream) -> Result<Self> {
        Ok(Box::new(Tcp::new(stream)))
    }

    #[cfg(feature = "serial")]
    fn serial(path: &str, baud: u32) -> Serial<Self> {
        Ok(Box::new(super::serial::Device::new(path, baud)))
    }

    #[cfg(not(feature = "serial"))]
    fn serial(_: &str, _: u32) -> Serial<Self> {
        Err(LinkError::Feature { name: "serial" })
    }

    fn split(self) -> Result<Parts<Self, Self>> {
        Ok(Parts { reader: self.twin()?, writer: self.twin()?, kept: self })
    }
}

/// A hand on a TCP connection. All hands share the timeouts, but only one reads, and only one writes.
struct Tcp {
    stream: TcpStream,
    reading: Timeout,
    writing: Timeout,
}

impl Tcp {
    fn new(stream: TcpStream) -> Self {
        Self { stream, reading: Timeout::default(), writing: Timeout::default() }
    }
}

impl Stream for Tcp {
    fn read_within(&mut self, buffer: &mut [u8], limit: Duration) -> Result<usize> {
        self.reading.change(limit, |limit| self.stream.set_read_timeout(limit))?;
        self.stream.read(buffer)
    }

    fn write_within(&mut self, frames: &[IoSlice<'_>], limit: Duration) -> Result<usize> {
        self.writing.change(limit, |limit| self.stream.set_write_timeout(limit))?;
        match frames {
            // A cheaper call of the system.
            [frame] => self.stream.write(frame),
            _ => self.stream.write_vectored(frames),
        }
    }

    fn twin(&self) -> Result<Box<dyn Stream>> {
        Ok(Box::new(Self::new(self.stream.try_clone()?)))
    }
}

impl Shut for Tcp {
    fn shut(&self) {
        self.stream.shut();
    }
}

impl Shut for TcpStream {
    fn shut(&self) {
        // One that is closed already needs no closing.
        let _ = self.shutdown(Shutdown::Both);
    }
}
