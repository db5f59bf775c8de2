//! MAVSDK, with the C++ library that its Python package brings along. It sends MAVLink 2 and takes both.
//!
//! `PYMAVLINK_PYTHON=venv/bin/python cargo test --locked --test links -- --ignored`

use std::env;
use std::process::{Child, Command, Stdio};

use super::{Kind, Way, over};

/// A process, which is killed with it.
struct Peer(Child);

impl Peer {
    fn start(address: &str, _: Kind) -> Self {
        // As it writes addresses.
        let address = match address.split_once(':') {
            Some((scheme, rest)) => format!("{scheme}://{rest}"),
            None => format!("serial://{address}:57600"),
        };
        let mut command = Command::new(env::var("PYMAVLINK_PYTHON").unwrap_or_else(|_| "python3".to_owned()));
        command.args(["tests/links/mavsdk_peer.py", &address]).stdout(Stdio::null());
        Self(command.spawn().unwrap())
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        self.0.kill().unwrap();
        self.0.wait().unwrap();
    }
}

#[test]
#[ignore = "needs Python with mavsdk"]
fn every_way_goes_and_goes_on_when_the_peer_comes_back() {
    // It sends no broadcasts of its own.
    for way in Way::all("tcpout").iter().filter(|way| !way.theirs.starts_with("udpbcast")) {
        over(way, Kind::V2, Peer::start);
    }
}
