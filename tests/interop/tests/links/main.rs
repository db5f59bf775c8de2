//! Other implementations at the other end of our links: every kind of address, each way, in MAVLink 1 and 2 and signed, before and
//! after the other side was killed.

#![cfg(unix)]

mod cable;
mod mavsdk;
mod pymavlink;
mod rust_mavlink;
mod talk;

use std::net::{TcpListener, UdpSocket};
use std::time::{Duration, Instant};

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::link::{Link, LinkError, Options};
use mavlink_autoquad::wire::signing::{Key, Signer, Verifier};
use mavlink_autoquad::wire::{Dialect, Sender, Timestamp, Version};

use cable::Cable;
use talk::Polling;

/// Nothing is lost on one machine: who waits so long waits in vain.
const LONG: Duration = Duration::from_secs(30);

const KEY: [u8; 32] = *b"it opens nothing in this world  ";

/// What the other side speaks.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    V1,
    V2,
    Signed,
}

impl Kind {
    const ALL: [Self; 3] = [Self::V1, Self::V2, Self::Signed];

    fn version(self) -> Version {
        if self == Self::V1 { Version::V1 } else { Version::V2 }
    }

    /// Of a station that speaks MAVLink 2 until it hears something else, and trusts who signs if the other side does.
    fn options(self) -> Options {
        let sender = Sender::v2(255, 190);
        if self != Self::Signed {
            return Options::new(Autoquad::TABLE, sender);
        }
        let signer = Signer::new(Key::new(KEY), 1, Timestamp::ZERO);
        Options::new(Autoquad::TABLE, sender.signed(signer)).with_verifier(Verifier::new(Some(Key::new(KEY))))
    }
}

/// A way between two: its addresses, as each of us writes them.
struct Way {
    ours: String,
    theirs: String,
    /// Keeps two pseudo terminals joined.
    _cable: Option<Cable>,
}

impl Way {
    /// All ways, by the words that begin our address and that of a peer who writes `tcpout` like this.
    fn all(tcpout: &str) -> Vec<Self> {
        let loopback = |ours: &str, theirs: &str| {
            let port = free_port();
            let [ours, theirs] = [ours, theirs].map(|scheme| match scheme {
                "udpbcast" => format!("udpbcast:127.255.255.255:{port}"),
                // A listener for what is sent to the whole network.
                "udpin" if ours == "udpbcast" || theirs == "udpbcast" => format!("udpin:0.0.0.0:{port}"),
                _ => format!("{scheme}:127.0.0.1:{port}"),
            });
            Self { ours, theirs, _cable: None }
        };
        let cable = Cable::new();
        let [ours, theirs] = cable.ends();
        vec![
            loopback("udpin", "udpout"),
            loopback("udpout", "udpin"),
            loopback("udpin", "udpbcast"),
            loopback("udpbcast", "udpin"),
            loopback("tcpin", tcpout),
            loopback("tcpout", "tcpin"),
            Self { ours: format!("serial:{ours}:57600"), theirs, _cable: Some(cable) },
        ]
    }
}

/// One that was free a moment ago, for UDP and TCP.
fn free_port() -> u16 {
    loop {
        let port = TcpListener::bind("0.0.0.0:0").unwrap().local_addr().unwrap().port();
        if UdpSocket::bind(("0.0.0.0", port)).is_ok() {
            return port;
        }
    }
}

/// Connects, as soon as the other side listens.
fn connect<L>(connect: impl Fn() -> Result<L, LinkError>) -> L {
    let end = Instant::now() + LONG;
    loop {
        match connect() {
            Ok(link) => return link,
            Err(error) => assert!(matches!(error, LinkError::Unreachable { .. }) && Instant::now() < end, "{error}"),
        }
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Talks over a way with a peer, blocking and polling; kills the peer, and talks with the next one.
fn over<P>(way: &Way, kind: Kind, start: impl Fn(&str, Kind) -> P) {
    let mut peer = start(&way.theirs, kind);
    let mut link = connect(|| Link::connect(&way.ours, kind.options()));
    talk::with(&mut link, kind, &way.ours);
    drop(peer);
    peer = start(&way.theirs, kind);
    talk::with(&mut link, kind, &format!("{}, again", way.ours));
    drop((link, peer));

    let _peer = start(&way.theirs, kind);
    let mut link = connect(|| Polling::connect(&way.ours, kind.options()));
    talk::with(&mut link, kind, &format!("{}, polling", way.ours));
}
