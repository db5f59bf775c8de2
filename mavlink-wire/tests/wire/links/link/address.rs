//! How addresses are written.

use mavlink_wire::link::Address;

#[test]
fn all_spellings_are_read_and_written_as_rust_mavlink_has_them() {
    for (given, expected) in [
        ("udpin:0.0.0.0:14550", "udpin:0.0.0.0:14550"),
        ("udpin://0.0.0.0:14550", "udpin:0.0.0.0:14550"),
        ("udpin://:14550", "udpin:0.0.0.0:14550"),
        ("udpin::14550", "udpin:0.0.0.0:14550"),
        ("udpin:[::]:14550", "udpin:[::]:14550"),
        ("udpout:localhost:0", "udpout:localhost:0"),
        ("udpout://192.168.0.7:65535", "udpout:192.168.0.7:65535"),
        ("udpbcast:192.168.0.255:14550", "udpbcast:192.168.0.255:14550"),
        ("tcpin:127.0.0.1:5760", "tcpin:127.0.0.1:5760"),
        ("tcpout:[::1]:5760", "tcpout:[::1]:5760"),
        ("serial:/dev/ttyUSB0:57600", "serial:/dev/ttyUSB0:57600"),
        ("serial:///dev/ttyACM0:115200", "serial:/dev/ttyACM0:115200"),
        ("serial:/dev/serial/by-id/usb-3D_R:a-if00:57600", "serial:/dev/serial/by-id/usb-3D_R:a-if00:57600"),
        ("serial:COM3:57600", "serial:COM3:57600"),
        ("file:flight.tlog", "file:flight.tlog"),
        ("file:C:\\logs\\flight 1.tlog", "file:C:\\logs\\flight 1.tlog"),
        ("file:///var/log/a:b", "file:/var/log/a:b"),
    ] {
        let address: Address = given.parse().unwrap_or_else(|error| panic!("{given}: {error}"));
        assert_eq!(address.to_string(), expected);
        assert_eq!(expected.parse(), Ok(address));
    }
}

#[test]
fn a_wrong_address_says_what_would_be_right() {
    for (given, right) in [
        ("", "udpin:0.0.0.0:14550"),
        ("14550", "udpin:0.0.0.0:14550"),
        (":14550", "udpin:0.0.0.0:14550"),
        ("127.0.0.1:14550", "udpout:127.0.0.1:14550"),
        ("0.0.0.0:14540", "udpin:0.0.0.0:14540"),
        ("udp:192.168.0.7:14550", "udpout:192.168.0.7:14550"),
        ("udp://:14540", "udpin:0.0.0.0:14540"),
        ("tcp:127.0.0.1:5760", "tcpout:127.0.0.1:5760"),
        ("tcp", "udpin:0.0.0.0:14550"),
        ("UDPIN:0.0.0.0:14550", "udpin:0.0.0.0:14550"),
        ("udpin:0.0.0.0", "udpin:0.0.0.0:14550"),
        ("udpin:", "udpin:0.0.0.0:14550"),
        ("udpin:0.0.0.0:70000", "udpin:0.0.0.0:14550"),
        ("udpin:0.0.0.0:+1", "udpin:0.0.0.0:14550"),
        ("udpout::14550", "udpout:192.168.0.7:14550"),
        ("udpout:::1:14550", "udpout:[::1]:14550"),
        ("udpbcast:14550", "udpbcast:192.168.0.255:14550"),
        ("udpin:14550", "udpin:0.0.0.0:14550"),
        ("udpin:0.0.0.0:14550:1", "udpin:0.0.0.0:14550"),
        ("tcpout:host", "tcpout:host:5760"),
        ("serial:/dev/ttyUSB0", "serial:/dev/ttyUSB0:57600"),
        ("serial:/dev/ttyUSB0:", "serial:/dev/ttyUSB0:57600"),
        ("serial:/dev/ttyUSB0:0", "serial:/dev/ttyUSB0:57600"),
        ("serial:/dev/ttyUSB0:fast", "serial:/dev/ttyUSB0:57600"),
        ("serial:/dev/ttyUSB0,115200", "serial:/dev/ttyUSB0:115200"),
        ("serial:COM3", "serial:COM3:57600"),
        ("serial:", "serial:/dev/ttyUSB0:57600"),
        ("serial::57600", "serial:/dev/ttyUSB0:57600"),
        ("/dev/ttyUSB0", "serial:/dev/ttyUSB0:57600"),
        ("/dev/ttyUSB0,115200", "serial:/dev/ttyUSB0:115200"),
        ("/dev/ttyUSB0:115200", "serial:/dev/ttyUSB0:115200"),
        ("COM3", "serial:COM3:57600"),
        ("flight.tlog", "file:flight.tlog"),
        ("./flight", "file:./flight"),
        ("file:", "file:flight.tlog"),
    ] {
        let error = given.parse::<Address>().expect_err(given);
        assert_eq!((error.given(), error.right()), (given, right), "{error}");
        assert!(error.right().parse::<Address>().is_ok(), "{error}");
        let text = error.to_string();
        assert!(text.contains(given) && text.contains(right), "{text}");
    }
}
