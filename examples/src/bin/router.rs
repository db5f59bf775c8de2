//! Carries frames between links: `router udpin:0.0.0.0:14550 serial:/dev/ttyUSB0:57600`, and more of them if you like.

use std::error::Error;
use std::process::ExitCode;
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Instant;

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::link::{Link, LinkError, Options, ReceiveHalf, SendHalf};
use mavlink_autoquad::wire::{Dialect, Routes, Sender};

fn main() -> ExitCode {
    let addresses: Vec<String> = std::env::args().skip(1).collect();
    let Err(error) = route(&addresses) else { return ExitCode::SUCCESS };
    eprintln!("router: {error}");
    ExitCode::FAILURE
}

fn route(addresses: &[String]) -> Result<(), Box<dyn Error>> {
    if addresses.len() < 2 {
        return Err("usage: router ADDRESS ADDRESS..., for example udpin:0.0.0.0:14550 tcpout:127.0.0.1:5760".into());
    }
    let options = Options::new(Autoquad::TABLE, Sender::v2(254, 1));
    let links: Vec<Link> = addresses.iter().map(|to| Link::connect(to, options.clone())).collect::<Result<_, _>>()?;
    let (receiving, sending): (Vec<_>, Vec<_>) = links.into_iter().map(Link::split).unzip();
    let routes = Mutex::new(Routes::new(Autoquad::TABLE, (0..=u8::MAX).take(sending.len()).collect()));
    let (began, sending, routes) = (Instant::now(), &sending, &routes);
    thread::scope(|scope| {
        for ((from, address), link) in (0..).zip(addresses).zip(receiving) {
            scope.spawn(move || match carry(link, from, sending, routes, began) {
                LinkError::Ended | LinkError::Closed => {}
                error => eprintln!("router: {address}: {error}"),
            });
        }
    });
    Ok(())
}

/// Carries what comes from this link, until it ends. What another has no room for is lost, as it would be on the way.
fn carry(
    mut link: ReceiveHalf,
    from: u8,
    sending: &[SendHalf],
    routes: &Mutex<Routes<'_>>,
    began: Instant,
) -> LinkError {
    loop {
        let frame = match link.receive() {
            Ok(frame) => frame,
            Err(error) => return error,
        };
        let to = routes.lock().unwrap_or_else(PoisonError::into_inner).route(&frame, from, began.elapsed());
        to.into_iter().filter_map(|to| sending.get(usize::from(to))).for_each(|link| {
            link.send_frame(&frame).ok();
        });
    }
}
