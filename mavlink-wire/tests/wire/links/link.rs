//! Links by address.

mod address;
mod errors;
mod file;
#[cfg(unix)]
mod permission;
#[cfg(feature = "tokio")]
mod polled;
#[cfg(all(unix, feature = "serial"))]
mod serial;
#[cfg(feature = "signing")]
mod signed;
mod tcp;
mod udp;

use std::time::{Duration, Instant};

use mavlink_wire::link::{Link, LinkError, Options};
use mavlink_wire::{Dialect, Sender};

use super::{message, read, sent, stream};
use crate::small::Small;

/// Nothing is lost on the loopback interface: who waits so long waits in vain.
const LONG: Duration = Duration::from_secs(20);

fn soon() -> Instant {
    Instant::now() + LONG
}

fn vehicle() -> Options {
    Options::new(Small::TABLE, Sender::v2(1, 1))
}

fn station() -> Options {
    Options::new(Small::TABLE, Sender::v2(255, 190))
}

/// Sends until somebody is there.
fn send_surely(link: &Link, number: u32) {
    let end = soon();
    while link.send(&message(number)).unwrap() == 0 {
        assert!(Instant::now() < end, "nobody came: {:?}", link.trouble());
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Number and message of the next frame.
fn next(link: &mut Link) -> (u8, Option<Small>) {
    read(&link.receive_until(soon()).unwrap().unwrap())
}
