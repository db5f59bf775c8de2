//! Addresses of links, as people write them.

mod parse;

use core::fmt;
use std::string::String;

/// The address of a link, as [`Link::connect`](super::Link::connect) takes it; `parse` makes one.
///
/// Addresses have the form of rust-mavlink. The form of MAVSDK, `udpin://0.0.0.0:14550`, works as well.
///
/// ```
/// use mavlink_wire::link::Address;
///
/// assert_eq!("udpin:0.0.0.0:14550".parse(), Ok(Address::UdpIn("0.0.0.0:14550".into())));
/// assert_eq!("udpin://:14550".parse::<Address>()?.to_string(), "udpin:0.0.0.0:14550");
/// let wrong = "udp:192.168.0.7:14550".parse::<Address>().unwrap_err();
/// assert_eq!(wrong.right(), "udpout:192.168.0.7:14550");
/// # Ok::<(), mavlink_wire::link::AddressError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Address {
    /// `udpin:0.0.0.0:14550`: listens there, and sends to every peer that it heard.
    UdpIn(String),
    /// `udpout:192.168.0.7:14550`: sends there. A host may have a name.
    UdpOut(String),
    /// `udpbcast:192.168.0.255:14550`: broadcasts to that network.
    UdpBroadcast(String),
    /// `tcpin:0.0.0.0:5760`: listens for a client, one at a time.
    TcpIn(String),
    /// `tcpout:192.168.0.7:5760`: connects there.
    TcpOut(String),
    /// `serial:/dev/ttyUSB0:57600`: a serial port. Needs the feature `serial`.
    Serial {
        /// The port, as the system names it: `/dev/ttyUSB0`, `COM3`.
        path: String,
        /// Bits per second.
        baud: u32,
    },
    /// `file:flight.tlog`: reads a tlog or a raw stream of frames. Reading from a named pipe may take longer than the deadline.
    File(String),
}

/// As [`Link::connect`](super::Link::connect) reads it.
impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UdpIn(at) => write!(f, "udpin:{at}"),
            Self::UdpOut(to) => write!(f, "udpout:{to}"),
            Self::UdpBroadcast(to) => write!(f, "udpbcast:{to}"),
            Self::TcpIn(at) => write!(f, "tcpin:{at}"),
            Self::TcpOut(to) => write!(f, "tcpout:{to}"),
            Self::Serial { path, baud } => write!(f, "serial:{path}:{baud}"),
            Self::File(path) => write!(f, "file:{path}"),
        }
    }
}

/// A text that is no address of a link.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AddressError {
    given: String,
    problem: Problem,
    right: String,
}

/// What is wrong with an address.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Problem {
    Scheme,
    Direction,
    Host,
    Port,
    Baud,
    Path,
}

impl AddressError {
    /// The text that was given.
    #[must_use]
    pub fn given(&self) -> &str {
        &self.given
    }

    /// The best guess of what was meant.
    #[must_use]
    pub fn right(&self) -> &str {
        &self.right
    }
}

impl fmt::Display for AddressError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let problem = match self.problem {
            Problem::Scheme => "it has to begin with udpin, udpout, udpbcast, tcpin, tcpout, serial or file",
            Problem::Direction => "it does not say whether to listen (udpin, tcpin) or to send there (udpout, tcpout)",
            Problem::Host => "HOST:PORT has to follow, an address of IPv6 in brackets",
            Problem::Port => "it has to end with a port from 0 to 65535",
            Problem::Baud => "it has to end with a baud rate",
            Problem::Path => "it names no file or device",
        };
        write!(f, "`{}` is no address of a link: {problem}; for example `{}`", self.given, self.right)
    }
}

impl core::error::Error for AddressError {}
