//! What goes wrong is an error that says what to do.

use std::io::ErrorKind;

use mavlink_wire::EncodeError;

use super::super::TooLarge;
use super::*;

fn error(address: &str) -> LinkError {
    Link::connect(address, station()).unwrap_err()
}

#[test]
fn each_has_its_kind_and_says_what_to_do() {
    let udp = std::net::UdpSocket::bind("127.0.0.1:0").unwrap();
    let tcp = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let free = {
        let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
        listener.local_addr().unwrap()
    };
    let (udp, tcp) = (udp.local_addr().unwrap(), tcp.local_addr().unwrap());
    for (address, kind, does) in [
        ("udp:0.0.0.0:1".to_string(), ErrorKind::InvalidInput, "udpin:0.0.0.0:1"),
        (format!("udpin:{udp}"), ErrorKind::AddrInUse, "end the other program"),
        (format!("tcpin:{tcp}"), ErrorKind::AddrInUse, "end the other program"),
        (format!("tcpout:{free}"), ErrorKind::ConnectionRefused, "start the other side first"),
        ("file:/no/such/file".into(), ErrorKind::NotFound, "check the path"),
    ] {
        let error = error(&address);
        let text = error.to_string();
        assert!(text.contains(does), "{address}: {text}");
        assert_eq!(std::io::Error::from(error).kind(), kind, "{address}");
    }
    assert!(matches!(error("file:/"), LinkError::Io(_)));
    assert!(matches!(error("udpin:192.0.2.1:0"), LinkError::NotHere { .. }));
    assert!(matches!(error("udpout:no.such.host.invalid:1"), LinkError::Unreachable { .. }));
}

#[cfg(not(feature = "serial"))]
#[test]
fn what_was_left_out_is_named() {
    assert!(error("serial:/dev/ttyUSB0:57600").to_string().contains("`serial`"));
}

#[test]
fn what_a_version_cannot_carry_is_told_and_takes_no_number() {
    let options = Options::new(Small::TABLE, Sender::v1(1, 1));
    let link = Link::connect("udpout:127.0.0.1:9", options).unwrap();
    let refused = link.send(&TooLarge);
    assert!(matches!(refused, Err(LinkError::Encode(EncodeError::IdTooLarge { .. }))), "{refused:?}");
    assert_eq!(link.with_sender(|sender| sender.sequence()), 0);
}
