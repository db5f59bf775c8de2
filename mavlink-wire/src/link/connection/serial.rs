//! Serial ports.

use std::boxed::Box;
use std::io::{ErrorKind, IoSlice, Read, Result, Write};
use std::path::Path;
use std::string::String;
use std::time::Duration;

#[cfg(windows)]
use serialport::COMPort as Port;
use serialport::SerialPort;
#[cfg(unix)]
use serialport::TTYPort as Port;

use super::stream::Stream;
use crate::link::ends::{Attempt, Opener, Shut};
use crate::link::{LinkError, Peer};

impl Stream for Port {
    fn read_within(&mut self, buffer: &mut [u8], limit: Duration) -> Result<usize> {
        self.set_timeout(limit)?;
        self.read(buffer)
    }

    fn write_within(&mut self, frames: &[IoSlice<'_>], limit: Duration) -> Result<usize> {
        self.set_timeout(limit)?;
        self.write_vectored(frames)
    }

    fn twin(&self) -> Result<Box<dyn Stream>> {
        Ok(Box::new(self.try_clone_native()?))
    }
}

/// Nothing wakes who waits: he waits for a slice of time alone.
impl Shut for Port {
    fn shut(&self) {}
}

/// Opens a device.
pub(super) struct Device {
    path: String,
    baud: u32,
}

impl Device {
    pub(super) fn new(path: &str, baud: u32) -> Self {
        Self { path: path.into(), baud }
    }
}

impl Opener<Box<dyn Stream>> for Device {
    fn attempt(&mut self) -> Attempt<Box<dyn Stream>> {
        let open = || {
            let port = serialport::new(&self.path, self.baud).open_native()?;
            take_in_parts(&port)?;
            Ok(port)
        };
        match open() {
            Ok(port) => Ok(Some((Box::new(port), Peer::NEARBY))),
            Err(error) => Err(of_opening(error, &self.path)),
        }
    }
}

/// Lets the port take what it has room for of a frame, instead of waiting for room for all of it, however long that takes.
/// What is set holds for every hand on the port.
#[cfg(unix)]
fn take_in_parts(port: &Port) -> serialport::Result<()> {
    mio_serial::SerialStream::try_from(port.try_clone_native()?).map(drop)
}

/// The driver does so by itself.
#[cfg(windows)]
fn take_in_parts(_: &Port) -> serialport::Result<()> {
    Ok(())
}

/// Why a device does not open.
pub(in crate::link) fn of_opening(error: serialport::Error, path: &str) -> LinkError {
    let exists = cfg!(unix) && Path::new(path).exists();
    match error.kind() {
        // So the crate says both "locked by somebody else" and, on Windows, "not there".
        serialport::ErrorKind::NoDevice if exists => LinkError::InUse { address: path.into() },
        serialport::ErrorKind::NoDevice | serialport::ErrorKind::Io(ErrorKind::NotFound) => {
            LinkError::NoDevice { path: path.into() }
        }
        serialport::ErrorKind::Io(ErrorKind::PermissionDenied) => LinkError::NoPermission { address: path.into() },
        _ => LinkError::NoSerialPort { path: path.into(), reason: error.into() },
    }
}
