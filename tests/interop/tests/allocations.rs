//! What a link allocates once it has run for a while: nothing.

use std::error::Error;
use std::time::{Duration, Instant};

use allocation_counter::measure;
use mavlink_autoquad::autoquad::{Autoquad, Heartbeat};
use mavlink_autoquad::wire::link::{Link, Options};
use mavlink_autoquad::wire::signing::{Key, Signer};
use mavlink_autoquad::wire::{Dialect, Message, Sender, Timestamp};

/// Messages that are sent before anything is counted: all storage has its size then.
const WARM: usize = 200;

fn pair(listener: &str, caller: &str, vehicle: Sender) -> Result<(Link, Link), Box<dyn Error>> {
    let options = |sender| Options::new(Autoquad::TABLE, sender);
    let station = Link::connect(&format!("{listener}:127.0.0.1:0"), options(Sender::v2(255, 190)))?;
    let address = station.local_addr().ok_or("a listener has an address")?;
    Ok((station, Link::connect(&format!("{caller}:{address}"), options(vehicle))?))
}

/// One message there and one back; the last of them queued.
fn exchange(station: &mut Link, vehicle: &mut Link) -> Result<(), Box<dyn Error>> {
    let soon = Instant::now() + Duration::from_secs(20);
    assert_eq!(vehicle.send(&Heartbeat::DEFAULT)?, 1);
    let (frame, peer) = station.receive_from(soon)?.ok_or("the station hears it")?;
    assert_eq!(frame.system_id(), 1);
    station.send_to(&Heartbeat::DEFAULT, peer)?;
    assert!(vehicle.receive_until(soon)?.is_some());
    for _ in 0..3 {
        assert_eq!(station.queue(&Heartbeat::DEFAULT)?, 1);
    }
    station.flush()?;
    for _ in 0..3 {
        let frame = vehicle.receive_until(soon)?.ok_or("the vehicle hears it")?;
        assert_eq!(frame.system_id(), 255);
    }
    Ok(())
}

#[test]
fn sending_and_receiving_allocate_nothing() -> Result<(), Box<dyn Error>> {
    let signed = || Sender::v2(1, 1).signed(Signer::new(Key::of_passphrase("not this one"), 0, Timestamp::ZERO));
    for (listener, caller) in [("udpin", "udpout"), ("tcpin", "tcpout")] {
        for sender in [Sender::v1(1, 1), Sender::v2(1, 1), signed()] {
            let (mut station, mut vehicle) = pair(listener, caller, sender)?;
            for _ in 0..WARM {
                exchange(&mut station, &mut vehicle)?;
            }
            let mut exchanged = Ok(());
            let counted = measure(|| exchanged = (0..100).try_for_each(|_| exchange(&mut station, &mut vehicle)));
            exchanged?;
            assert_eq!((counted.count_total, counted.count_current), (0, 0), "{listener}");
        }
    }
    // It counts.
    assert_eq!(measure(|| drop(std::hint::black_box(Box::new(1)))).count_total, 1);
    Ok(())
}
