//! Reads addresses, and finds out what was meant by wrong ones.

use core::net::Ipv6Addr;
use core::str::FromStr;
use std::format;
use std::string::{String, ToString};

use super::{Address, AddressError, Problem};

/// Where ground stations listen.
const UDP_PORT: &str = "14550";
/// Where simulators listen.
const TCP_PORT: &str = "5760";
/// What telemetry radios run at.
const BAUD: &str = "57600";

/// # Errors
///
/// [`AddressError`] says what would be right.
impl FromStr for Address {
    type Err = AddressError;

    fn from_str(given: &str) -> Result<Self, AddressError> {
        let error = |problem, right: String| AddressError { given: given.to_string(), problem, right };
        let Some((scheme, rest)) = given.split_once(':') else { return Err(error(Problem::Scheme, meant(given))) };
        let rest = rest.strip_prefix("//").unwrap_or(rest);
        let (make, port, listens): (fn(String) -> Self, _, _) = match scheme {
            "udpin" => (Self::UdpIn, UDP_PORT, true),
            "udpout" => (Self::UdpOut, UDP_PORT, false),
            "udpbcast" => (Self::UdpBroadcast, UDP_PORT, false),
            "tcpin" => (Self::TcpIn, TCP_PORT, true),
            "tcpout" => (Self::TcpOut, TCP_PORT, false),
            "serial" => return serial(rest).map_err(|(problem, right)| error(problem, right)),
            "file" if rest.is_empty() => return Err(error(Problem::Path, "file:flight.tlog".into())),
            "file" => return Ok(Self::File(rest.into())),
            "udp" | "tcp" => return Err(error(Problem::Direction, directed(scheme, rest))),
            _ => return Err(error(Problem::Scheme, meant(given))),
        };
        match authority(rest, listens) {
            Ok(authority) => Ok(make(authority)),
            Err(problem) => {
                let (host, port) =
                    (likely_host(rest).unwrap_or(placeholder(scheme).into()), likely_port(rest).unwrap_or(port));
                Err(error(problem, format!("{scheme}:{host}:{port}")))
            }
        }
    }
}

/// `HOST:PORT`; all of this machine's addresses, if a listener names none.
fn authority(rest: &str, listens: bool) -> Result<String, Problem> {
    let port = port_of(rest).ok_or(if is_port(rest) { Problem::Host } else { Problem::Port })?;
    match host_of(rest) {
        None => Err(Problem::Host),
        Some("") if listens => Ok(format!("0.0.0.0:{port}")),
        Some("") => Err(Problem::Host),
        Some(host) => Ok(format!("{host}:{port}")),
    }
}

/// What stands in front of the port. An address of IPv6 has to stand in brackets.
fn host_of(rest: &str) -> Option<&str> {
    let host = rest.rsplit_once(':').map_or(rest, |(host, _)| host);
    let is_bracketed = host.starts_with('[') && host.ends_with(']');
    (is_bracketed || !host.contains([':', '/', ' '])).then_some(host)
}

fn port_of(rest: &str) -> Option<&str> {
    rest.rsplit_once(':').map(|(_, port)| port).filter(|port| is_port(port))
}

fn is_port(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit()) && text.parse::<u16>().is_ok()
}

/// The host of what is not `HOST:PORT`.
fn likely_host(rest: &str) -> Option<String> {
    match rest.rsplit_once(':').map(|(host, _)| host) {
        Some(host) if host.parse::<Ipv6Addr>().is_ok() => Some(format!("[{host}]")),
        _ => rest.split([':', '/']).map(str::trim).find(|part| !part.is_empty() && !is_port(part)).map(String::from),
    }
}

/// The port of what is not `HOST:PORT`.
fn likely_port(rest: &str) -> Option<&str> {
    port_of(rest)
        .filter(|_| likely_host(rest).is_some_and(|host| host.starts_with('[')))
        .or_else(|| rest.split([':', '/']).find(|part| is_port(part)))
}

/// `PATH:BAUD`.
fn serial(rest: &str) -> Result<Address, (Problem, String)> {
    let (path, baud) = rest.rsplit_once([':', ',']).unwrap_or((rest, ""));
    if path.is_empty() {
        return Err((Problem::Path, format!("serial:/dev/ttyUSB0:{BAUD}")));
    }
    let is_comma = rest.ends_with(&format!(",{baud}"));
    match baud.parse() {
        Ok(baud) if baud > 0 && !is_comma => Ok(Address::Serial { path: path.into(), baud }),
        Ok(baud) if baud > 0 => Err((Problem::Baud, format!("serial:{path}:{baud}"))),
        _ => Err((Problem::Baud, format!("serial:{path}:{BAUD}"))),
    }
}

/// A host to show where none was given.
fn placeholder(scheme: &str) -> &'static str {
    match scheme {
        "udpin" | "tcpin" => "0.0.0.0",
        "udpbcast" => "192.168.0.255",
        _ => "192.168.0.7",
    }
}

/// `udp` and `tcp` with a direction: who names no host, or all of his own, listens.
fn directed(scheme: &str, rest: &str) -> String {
    let host = host_of(rest).filter(|host| !matches!(*host, "" | "0.0.0.0" | "[::]"));
    let port = port_of(rest).unwrap_or(if scheme == "tcp" { TCP_PORT } else { UDP_PORT });
    match host {
        Some(host) => format!("{scheme}out:{host}:{port}"),
        None => format!("{scheme}in:0.0.0.0:{port}"),
    }
}

/// What was meant by an address that begins with none of the right words.
fn meant(given: &str) -> String {
    let lower = given.to_ascii_lowercase();
    let (path, baud) = given.split_once([',', ':']).unwrap_or((given, ""));
    let baud = if baud.parse::<u32>().is_ok() { baud } else { BAUD };
    if lower.starts_with("/dev/") || lower.starts_with("com") && lower.len() < 12 {
        format!("serial:{path}:{baud}")
    } else if lower.ends_with("log")
        || lower.ends_with(".raw")
        || lower.ends_with(".bin")
        || given.starts_with(['/', '.'])
    {
        format!("file:{given}")
    } else if let (Some(host), Some(port)) = (host_of(given), port_of(given)) {
        match host {
            "" | "0.0.0.0" | "[::]" => format!("udpin:0.0.0.0:{port}"),
            host => format!("udpout:{host}:{port}"),
        }
    } else {
        format!("udpin:0.0.0.0:{UDP_PORT}")
    }
}
