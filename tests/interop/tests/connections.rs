//! Our messages over the connections of `mavlink-core`, against our own parser and sender.

use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream, UdpSocket};
use std::thread;
use std::time::Duration;

use mavlink_autoquad::autoquad::{Autoquad, EscInfo, Heartbeat, MavModeFlag, MavState, ParamSet};
use mavlink_autoquad::wire::interop::{self, CoreDialect};
use mavlink_autoquad::wire::{Dialect, MAX_FRAME, Message, Parser, Sender};
use mavlink_core::error::{EncoderError, MessageWriteError};
use mavlink_core::{
    Connectable, FileConfig, MavConnection, MavHeader, MavlinkVersion, TcpConfig, UdpConfig, UdpMode, connect,
    connect_with_dialect,
};

const AUTOQUAD: CoreDialect<Autoquad> = CoreDialect::new();
const HEADER: MavHeader = MavHeader { system_id: 7, component_id: 8, sequence: 0 };

/// Values that no entry names.
const UNKNOWN: Heartbeat = Heartbeat {
    system_status: MavState(201),
    base_mode: MavModeFlag::from_bits_retain(0xff),
    custom_mode: 0xffff_ffff,
    ..Heartbeat::DEFAULT
};

/// A message of more than 255, one with text, one with values that nothing names.
fn messages() -> [Autoquad; 3] {
    let parameter = ParamSet { param_id: "RATE".try_into().unwrap(), param_value: f32::MIN, ..ParamSet::DEFAULT };
    [UNKNOWN.into(), parameter.into(), EscInfo { count: 4, ..EscInfo::DEFAULT }.into()]
}

/// The messages as our sender makes them, with damage in between.
fn stream() -> Vec<u8> {
    let (mut sender, mut bytes) = (Sender::v2(7, 8), vec![]);
    for message in messages() {
        bytes.extend([0xfd, 0x09, 0x55]);
        bytes.extend(sender.encode(&message, &mut [0; MAX_FRAME]).unwrap());
    }
    bytes
}

/// What our parser finds.
fn parsed(mut bytes: &[u8]) -> Vec<Autoquad> {
    let (mut parser, mut found) = (Parser::new(Autoquad::TABLE), vec![]);
    while let Some(frame) = parser.next(&mut bytes) {
        assert!(frame.system_id() == 7 && frame.component_id() == 8);
        found.extend(frame.message::<Autoquad>());
    }
    found
}

/// A socket to which nothing comes must fail the test, not stall it.
const PATIENCE: Option<Duration> = Some(Duration::from_secs(20));

fn udp_pair() -> (UdpSocket, UdpSocket) {
    let sockets = [(); 2].map(|()| UdpSocket::bind("127.0.0.1:0").unwrap());
    let [ours, theirs] = sockets;
    ours.connect(theirs.local_addr().unwrap()).unwrap();
    for socket in [&ours, &theirs] {
        socket.set_read_timeout(PATIENCE).unwrap();
    }
    (ours, theirs)
}

fn over_udp(connect: impl FnOnce(UdpConfig) -> Box<dyn MavConnection<Autoquad>>) {
    let (ours, theirs) = udp_pair();
    let connection = connect(UdpConfig::from_socket(theirs, UdpMode::Udpin).unwrap());
    let mut sender = Sender::v2(7, 8);
    for message in messages() {
        ours.send(sender.encode(&message, &mut [0; MAX_FRAME]).unwrap()).unwrap();
        let (header, received) = connection.recv().unwrap();
        assert_eq!((header.system_id, header.component_id, received), (7, 8, message));
        connection.send(&HEADER, &message).unwrap();
        let mut datagram = [0; MAX_FRAME];
        let length = ours.recv(&mut datagram).unwrap();
        assert_eq!(parsed(&datagram[..length]), [message]);
    }
}

#[test]
fn udp_carries_our_messages_both_ways() {
    over_udp(|config| Box::new(config.connect_with_dialect(AUTOQUAD).unwrap()));
    over_udp(|config| Box::new(config.connect::<Autoquad>().unwrap()));
}

#[test]
fn a_vehicle_of_either_version_is_heard_and_answered() {
    // Which port is free is known only when nobody has it: another may take it in between.
    let port = UdpSocket::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let connection = interop::connect::<Autoquad>(&format!("udpin:127.0.0.1:{port}")).unwrap();
    let vehicle = UdpSocket::bind("127.0.0.1:0").unwrap();
    vehicle.set_read_timeout(PATIENCE).unwrap();
    for mut sender in [Sender::v1(7, 8), Sender::v2(7, 8), Sender::v1(7, 8)] {
        let frame = sender.encode(&UNKNOWN, &mut [0; MAX_FRAME]).unwrap().to_vec();
        vehicle.send_to(&frame, ("127.0.0.1", port)).unwrap();
        let (header, received) = connection.recv().unwrap();
        assert_eq!((header.system_id, header.component_id, received), (7, 8, UNKNOWN.into()));
        connection.send(&HEADER, &UNKNOWN.into()).unwrap();
        let mut datagram = [0; MAX_FRAME];
        let length = vehicle.recv(&mut datagram).unwrap();
        assert_eq!(parsed(&datagram[..length]), [UNKNOWN.into()]);
    }
}

fn over_tcp(connect: impl FnOnce(TcpConfig) -> Box<dyn MavConnection<Autoquad>>) {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap();
    let peer = thread::spawn(move || {
        let mut stream = TcpStream::connect(address).unwrap();
        stream.set_read_timeout(PATIENCE).unwrap();
        stream.write_all(&self::stream()).unwrap();
        let mut bytes = vec![];
        stream.read_to_end(&mut bytes).unwrap();
        parsed(&bytes)
    });
    let connection = connect(TcpConfig::from_listener(listener).unwrap());
    for message in messages() {
        assert_eq!(connection.recv().unwrap().1, message);
    }
    for message in messages() {
        connection.send(&HEADER, &message).unwrap();
    }
    drop(connection);
    assert_eq!(peer.join().unwrap(), messages());
}

#[test]
fn tcp_carries_our_messages_both_ways() {
    over_tcp(|config| Box::new(config.connect_with_dialect(AUTOQUAD).unwrap()));
    over_tcp(|config| Box::new(config.connect::<Autoquad>().unwrap()));
}

/// Over a pseudo terminal.
#[cfg(unix)]
#[test]
fn a_serial_port_carries_our_messages_both_ways() {
    use serialport::{SerialPort, TTYPort};
    use std::time::Instant;

    let (mut line, port) = TTYPort::pair().unwrap();
    line.set_timeout(PATIENCE.unwrap()).unwrap();
    let address = format!("serial:{}:57600", port.name().unwrap());
    drop(port); // or its lock would keep the connection out
    let connection = interop::connect::<Autoquad>(&address).unwrap();
    line.write_all(&stream()).unwrap();
    let start = Instant::now();
    for message in messages() {
        // `recv` would wait for ever.
        let received = loop {
            match connection.try_recv() {
                Ok((_, received)) => break received,
                Err(error) => assert!(start.elapsed() < PATIENCE.unwrap(), "{error}"),
            }
        };
        assert_eq!(received, message);
    }
    for message in messages() {
        connection.send(&HEADER, &message).unwrap();
        let (mut bytes, mut buffer) = (vec![], [0; MAX_FRAME]);
        while parsed(&bytes).is_empty() {
            let count = line.read(&mut buffer).unwrap();
            bytes.extend(&buffer[..count]);
        }
        assert_eq!(parsed(&bytes), [message]);
    }
}

#[test]
fn a_file_is_read() {
    let mut file = tempfile::NamedTempFile::new().unwrap();
    file.write_all(&stream()).unwrap();
    let address = format!("file:{}", file.path().display());
    let connections: [Box<dyn MavConnection<Autoquad>>; 4] = [
        Box::new(interop::connect::<Autoquad>(&address).unwrap()),
        Box::new(connect_with_dialect(&address, AUTOQUAD).unwrap()),
        Box::new(connect::<Autoquad>(&address).unwrap()),
        Box::new(FileConfig::new(file.path().into()).connect_with_dialect(AUTOQUAD).unwrap()),
    ];
    for connection in connections {
        for message in messages() {
            assert_eq!(connection.recv().unwrap().1, message);
        }
        assert!(connection.recv().is_err(), "the file is at its end");
    }
}

#[test]
fn what_they_write_to_a_file_we_read() {
    let mut bytes = vec![];
    for version in [MavlinkVersion::V1, MavlinkVersion::V2] {
        for message in &messages()[..2] {
            mavlink_core::write_versioned_msg_with_dialect(&mut bytes, version, HEADER, &AUTOQUAD, message).unwrap();
            mavlink_core::write_versioned_msg(&mut bytes, version, HEADER, message).unwrap();
        }
    }
    let [beat, parameter, _] = messages();
    assert_eq!(parsed(&bytes), [beat, beat, parameter, parameter, beat, beat, parameter, parameter]);
}

/// Sends in MAVLink 1 over UDP: a message that it has no id for, then one that it has.
fn in_mavlink_1<C: MavConnection<Autoquad>>(connect: impl FnOnce(&str) -> std::io::Result<C>) {
    let ours = UdpSocket::bind("127.0.0.1:0").unwrap();
    ours.set_read_timeout(PATIENCE).unwrap();
    let mut connection = connect(&format!("udpout:{}", ours.local_addr().unwrap())).unwrap();
    connection.set_protocol_version(MavlinkVersion::V1);
    let [beat, _, large] = messages();
    let error = connection.send(&HEADER, &large).unwrap_err();
    assert!(matches!(error, MessageWriteError::Encode(EncoderError::UnknownMessage { id: 290 })), "{error}");
    connection.send(&HEADER, &beat).unwrap();
    let mut datagram = [0; MAX_FRAME];
    let length = ours.recv(&mut datagram).unwrap();
    assert_eq!((datagram[0], parsed(&datagram[..length])), (0xfe, vec![beat]));
}

#[test]
fn an_id_over_255_in_mavlink_1_is_an_error_and_the_connection_goes_on() {
    in_mavlink_1(interop::connect::<Autoquad>);
    in_mavlink_1(|address| connect_with_dialect(address, AUTOQUAD));
}

/// Why [`interop::connect`] exists. Where this no longer panics, its docs may say less.
#[test]
#[should_panic(expected = "TryFromIntError")]
fn the_connect_of_mavlink_core_panics_over_it() {
    in_mavlink_1(connect::<Autoquad>);
}

#[test]
fn a_message_of_no_dialect_is_passed_over() {
    let (ours, theirs) = udp_pair();
    let connection = UdpConfig::from_socket(theirs, UdpMode::Udpin).unwrap().connect_with_dialect(AUTOQUAD).unwrap();
    let mut unknown = stream();
    unknown[3 + 7] = 0x77; // another id: the checksum is wrong, too
    ours.send(&unknown[3..]).unwrap();
    assert_eq!(connection.recv().unwrap().1, messages()[1]);
}
