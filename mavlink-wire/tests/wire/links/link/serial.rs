//! Serial ports: pseudo terminals, whose other end is the vehicle.

use std::io::{Read, Write};
use std::time::Duration;

use serialport::{SerialPort, TTYPort};

use super::*;

/// A vehicle's end of a cable, and the address of ours.
fn cable() -> (TTYPort, String) {
    let (mut vehicle, ours) = TTYPort::pair().unwrap();
    vehicle.set_timeout(LONG).unwrap();
    let address = format!("serial:{}:57600", ours.name().unwrap());
    (vehicle, address)
}

#[test]
fn both_sides_talk() {
    let (mut vehicle, address) = cable();
    let mut link = Link::connect(&address, station()).unwrap();
    let mut heard = vec![0; stream(Sender::v2(255, 190), 0..20).len()];
    for _ in 0..2 {
        vehicle.write_all(&stream(Sender::v1(1, 1), 0..3)).unwrap();
        let received: Vec<_> = (0..3).map(|_| next(&mut link)).collect();
        assert_eq!(received, sent(0..3));
    }
    for number in 0..20 {
        assert_eq!(link.send(&message(number)).unwrap(), 1);
    }
    // It has spoken MAVLink 1, so it is answered in MAVLink 1.
    let expected = stream(Sender::v1(255, 190), 0..20);
    heard.resize(expected.len(), 0);
    vehicle.read_exact(&mut heard).unwrap();
    assert_eq!(heard, expected);
    assert!(link.is_connected() && link.local_addr().is_none());
}

#[test]
fn a_cut_cable_is_told_and_another_one_goes_on() {
    let (mut vehicle, address) = cable();
    // The name under which the system finds whatever is plugged in.
    let folder = tempfile::tempdir().unwrap();
    let name = folder.path().join("radio");
    let plug = |address: &str| {
        let _ = std::fs::remove_file(&name);
        std::os::unix::fs::symlink(address.split(':').nth(1).unwrap(), &name).unwrap();
    };
    plug(&address);
    let mut link = Link::connect(&format!("serial:{}:57600", name.display()), station()).unwrap();
    let bytes = stream(Sender::v2(1, 1), 0..2);
    vehicle.write_all(&bytes[..bytes.len() - 4]).unwrap();
    assert_eq!(next(&mut link), sent(0..1)[0]);
    drop(vehicle);
    let pause = || std::time::Instant::now() + Duration::from_millis(300);
    assert!(link.receive_until(pause()).unwrap().is_none());
    assert!(!link.is_connected() && link.trouble().is_some());
    assert_eq!(link.send(&message(0)).unwrap(), 0);
    let (mut vehicle, address) = cable();
    plug(&address);
    while !link.is_connected() {
        assert!(link.receive_until(pause()).unwrap().is_none());
    }
    vehicle.write_all(&stream(Sender::v2(1, 1), 0..2)).unwrap();
    assert_eq!(next(&mut link), sent(0..1)[0]);
    send_surely(&link, 0);
    assert_eq!(link.statistics().connections, 2);
}

#[test]
fn without_reconnecting_a_cut_cable_is_the_end() {
    let (mut vehicle, address) = cable();
    let mut link = Link::connect(&address, station().without_reconnecting()).unwrap();
    vehicle.write_all(&stream(Sender::v2(1, 1), 0..1)).unwrap();
    next(&mut link);
    drop(vehicle);
    assert!(matches!(link.receive(), Err(LinkError::Closed)));
    assert!(matches!(link.send(&message(0)), Err(LinkError::Closed)));
}

#[test]
fn a_full_buffer_is_told_and_tears_no_frame() {
    let (mut vehicle, address) = cable();
    let link = Link::connect(&address, station().with_send_timeout(Duration::from_millis(5))).unwrap();
    let mut count = 0;
    while link.send(&message(count)).is_ok() {
        count += 1;
        assert!(count < 100_000, "nothing takes so much");
    }
    let expected = stream(Sender::v2(255, 190), 0..count + 1);
    let mut bytes = vec![0; expected.len()];
    let reader = std::thread::spawn(move || {
        vehicle.read_exact(&mut bytes).unwrap();
        (bytes, vehicle)
    });
    while link.send(&message(count)).is_err() {}
    let (bytes, _vehicle) = reader.join().unwrap();
    assert!(bytes == expected, "{} bytes", bytes.len());
}

#[test]
fn a_device_that_is_not_there_or_taken_is_told() {
    let missing = Link::connect("serial:/dev/no_such_port:57600", station()).unwrap_err();
    assert!(matches!(missing, LinkError::NoDevice { .. }), "{missing:?}");
    let (_vehicle, address) = cable();
    let _first = Link::connect(&address, station()).unwrap();
    let taken = Link::connect(&address, station()).unwrap_err();
    assert!(matches!(taken, LinkError::InUse { .. }), "{taken:?}");
    let file = tempfile::NamedTempFile::new().unwrap();
    let no_port = Link::connect(&format!("serial:{}:57600", file.path().display()), station()).unwrap_err();
    assert!(matches!(no_port, LinkError::NoSerialPort { .. }), "{no_port:?}");
}
