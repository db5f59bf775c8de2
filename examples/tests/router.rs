//! Two routers that are joined in a ring carry each frame once, and do not storm.

use std::net::UdpSocket;
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use mavlink_autoquad::autoquad::{Autoquad, Heartbeat};
use mavlink_autoquad::wire::link::{Link, Options};
use mavlink_autoquad::wire::{Dialect, Sender};

/// A router that ends with the test.
struct Router(std::io::Result<Child>);

impl Router {
    fn new(addresses: &[String]) -> Self {
        Self(Command::new(env!("CARGO_BIN_EXE_router")).args(addresses).spawn())
    }
}

impl Drop for Router {
    fn drop(&mut self) {
        if let Ok(router) = &mut self.0 {
            router.kill().and_then(|()| router.wait()).ok();
        }
    }
}

#[test]
fn a_ring_of_two_routers_carries_each_frame_once() {
    // Ports that were free a moment ago.
    let sockets: Vec<_> = (0..4).map(|_| UdpSocket::bind("127.0.0.1:0").unwrap()).collect();
    let ports: Vec<_> = sockets.iter().map(|socket| socket.local_addr().unwrap().port()).collect();
    drop(sockets);
    let to = |scheme: &str, port: usize| format!("{scheme}:127.0.0.1:{}", ports[port]);
    let one = Router::new(&[to("udpin", 0), to("udpin", 2), to("udpin", 3)]);
    let other = Router::new(&[to("udpin", 1), to("udpout", 2), to("udpout", 3)]);
    assert!(one.0.is_ok() && other.0.is_ok());
    let connect =
        |port, system| Link::connect(&to("udpout", port), Options::new(Autoquad::TABLE, Sender::v2(system, 1)));
    let (mut station, mut vehicle) = (connect(0, 255).unwrap(), connect(1, 1).unwrap());
    let beat = Heartbeat::default();

    // Until all have heard of each other.
    let end = Instant::now() + Duration::from_secs(20);
    let soon = || Instant::now() + Duration::from_millis(20);
    let (mut there, mut back) = (false, false);
    while !(there && back) {
        assert!(Instant::now() < end, "{there} {back}");
        station.send(&beat).unwrap();
        vehicle.send(&beat).unwrap();
        there |= vehicle.receive_until(soon()).unwrap().is_some();
        back |= station.receive_until(soon()).unwrap().is_some();
    }
    let quiet = || Instant::now() + Duration::from_millis(300);
    while station.receive_until(quiet()).unwrap().is_some() {}
    while vehicle.receive_until(quiet()).unwrap().is_some() {}
    for _ in 0..50 {
        vehicle.send(&beat).unwrap();
    }
    let mut count = 0;
    while station.receive_until(quiet()).unwrap().is_some() {
        count += 1;
    }
    assert_eq!(count, 50);
    assert!(vehicle.receive_until(soon()).unwrap().is_none(), "nothing comes back");
}
