//! What can go wrong with a link.

use core::fmt;
use std::io;
use std::string::String;

use super::AddressError;
use crate::EncodeError;

/// Why a link cannot be opened, or why an operation failed. The text says what to do.
#[derive(Debug)]
#[non_exhaustive]
pub enum LinkError {
    /// The address is wrong; [`AddressError::right`] suggests a right one.
    Address(AddressError),
    /// Another program listens there, or has the device.
    InUse {
        /// The address, or the device.
        address: String,
    },
    /// There is no such device.
    NoDevice {
        /// As it was given.
        path: String,
    },
    /// The device does not open as a serial port, or not with that baud rate.
    NoSerialPort {
        /// As it was given.
        path: String,
        /// The error of the system.
        reason: io::Error,
    },
    /// There is no such file.
    NoFile {
        /// As it was given.
        path: String,
    },
    /// This user lacks the permission.
    NoPermission {
        /// The address, the device or the file.
        address: String,
    },
    /// Nobody is there: connection refused, no route, no such host, or no answer.
    Unreachable {
        /// The address.
        address: String,
        /// The error of the system.
        reason: io::Error,
    },
    /// The crate was built without the feature that the address needs.
    Feature {
        /// The feature of this crate.
        name: &'static str,
    },
    /// Cannot listen there: this machine does not have the address.
    NotHere {
        /// The address.
        address: String,
    },
    /// The message cannot be encoded for this peer, or may not be sent to everybody.
    Encode(EncodeError),
    /// The other side, or the system, takes no more bytes now. The message was not sent and used no sequence number.
    Full,
    /// The end of the file.
    Ended,
    /// The link was closed here, or its connection was lost and it does not reconnect.
    Closed,
    /// Any other error of the system.
    Io(io::Error),
}

impl fmt::Display for LinkError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Address(error) => error.fmt(f),
            Self::InUse { address } => {
                write!(f, "{address} is in use: end the other program that has it, or take another one")
            }
            Self::NoDevice { path } => {
                write!(f, "there is no device {path}: plug it in, and look under which name the system has it")
            }
            Self::NoSerialPort { path, reason } => write!(
                f,
                "{path} does not open as a serial port ({reason}): check the name of the device, and the baud rate"
            ),
            Self::NoFile { path } => write!(f, "there is no file {path}: check the path"),
            Self::NoPermission { address } => write!(
                f,
                "this user may not open {address}: for a serial port, join the group that owns it (often `dialout`); \
                 for a port below 1024, take one above; to broadcast, use `udpbcast`"
            ),
            Self::Unreachable { address, reason } => {
                write!(f, "nobody answers at {address} ({reason}): start the other side first, or check host and port")
            }
            Self::NotHere { address } => {
                write!(f, "this machine has no address {address} to listen at: take one of its own, or 0.0.0.0 for all")
            }
            Self::Feature { name } => {
                write!(f, "this is built without the feature `{name}` of mavlink-wire: turn it on")
            }
            Self::Encode(error) => error.fmt(f),
            Self::Full => f.write_str("the send buffer is full: send this again later, and less often"),
            Self::Ended => f.write_str("the file has no more frames"),
            Self::Closed => f.write_str("the link is closed: connect again"),
            Self::Io(error) => write!(f, "the link has failed: {error}"),
        }
    }
}

impl core::error::Error for LinkError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Unreachable { reason: error, .. } | Self::NoSerialPort { reason: error, .. } | Self::Io(error) => {
                Some(error)
            }
            _ => None,
        }
    }
}

impl From<AddressError> for LinkError {
    fn from(error: AddressError) -> Self {
        Self::Address(error)
    }
}

impl From<EncodeError> for LinkError {
    fn from(error: EncodeError) -> Self {
        Self::Encode(error)
    }
}

impl LinkError {
    /// Why nothing listens there.
    pub(super) fn of_listening(error: io::Error, address: &str) -> Self {
        let address = address.into();
        match error.kind() {
            io::ErrorKind::AddrInUse => Self::InUse { address },
            io::ErrorKind::AddrNotAvailable => Self::NotHere { address },
            io::ErrorKind::PermissionDenied => Self::NoPermission { address },
            _ => Self::Unreachable { address, reason: error },
        }
    }

    /// Why a file cannot be read.
    pub(super) fn of_file(error: io::Error, path: &str) -> Self {
        match error.kind() {
            io::ErrorKind::NotFound => Self::NoFile { path: path.into() },
            io::ErrorKind::PermissionDenied => Self::NoPermission { address: path.into() },
            _ => Self::Io(error),
        }
    }
}

/// Of the kind that the reason has, around the error.
impl From<LinkError> for io::Error {
    fn from(error: LinkError) -> Self {
        let kind = match &error {
            LinkError::Io(error)
            | LinkError::Unreachable { reason: error, .. }
            | LinkError::NoSerialPort { reason: error, .. } => error.kind(),
            LinkError::Address(_) | LinkError::Encode(_) => io::ErrorKind::InvalidInput,
            LinkError::InUse { .. } => io::ErrorKind::AddrInUse,
            LinkError::NotHere { .. } => io::ErrorKind::AddrNotAvailable,
            LinkError::NoDevice { .. } | LinkError::NoFile { .. } => io::ErrorKind::NotFound,
            LinkError::NoPermission { .. } => io::ErrorKind::PermissionDenied,
            LinkError::Feature { .. } => io::ErrorKind::Unsupported,
            LinkError::Full => io::ErrorKind::WouldBlock,
            LinkError::Ended => io::ErrorKind::UnexpectedEof,
            LinkError::Closed => io::ErrorKind::NotConnected,
        };
        Self::new(kind, error)
    }
}
