//! What carries bytes both ways for those who block.

use std::boxed::Box;
use std::io::{Read, Result, Write};
use std::net::{Shutdown, TcpStream};
use std::time::Duration;

use crate::link::ends::{Ends, Parts, Shut};

/// Zero would mean to wait for ever.
pub(super) const SHORTEST: Duration = Duration::from_millis(1);

/// An open connection or device.
pub(in crate::link) trait Stream: Shut {
    /// Reads what there is; waits so long for it. Nothing, without an error, is the end.
    fn read_within(&mut self, buffer: &mut [u8], limit: Duration) -> Result<usize>;

    /// Writes what there is room for; waits so long for it.
    fn write_within(&mut self, bytes: &[u8], limit: Duration) -> Result<usize>;

    /// Another hand on the same.
    fn twin(&self) -> Result<Box<dyn Stream>>;
}

impl Ends for Box<dyn Stream> {
    type Reader = Self;
    type Writer = Self;

    fn of_tcp(stream: TcpStream) -> Result<Self> {
        Ok(Box::new(stream))
    }

    fn split(self) -> Result<Parts<Self, Self>> {
        Ok(Parts { reader: self.twin()?, writer: self.twin()?, kept: self })
    }
}

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
}

impl Shut for TcpStream {
    fn shut(&self) {
        // One that is closed already needs no closing.
        let _ = self.shutdown(Shutdown::Both);
    }
}
