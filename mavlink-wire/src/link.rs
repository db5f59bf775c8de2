//! Links: frames from and to whoever is at an address. Needs the feature `std`; serial ports need `serial`.
//!
//! ```
//! # use mavlink_wire::{Encode, MessageInfo, Table};
//! # const INFO: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
//! # struct Heartbeat;
//! # impl Encode for Heartbeat {
//! #     fn info(&self) -> &'static MessageInfo { INFO }
//! #     fn write(&self, payload: &mut [u8; 255]) { payload[..9].copy_from_slice(&[0, 0, 0, 0, 6, 8, 0, 4, 3]); }
//! # }
//! # static TABLE: Table<'static> = Table::of(&[INFO]);
//! use mavlink_wire::Sender;
//! use mavlink_wire::link::{Link, Options};
//!
//! // A ground station: `udpin:0.0.0.0:14550`, with the table of a dialect.
//! let mut link = Link::connect("udpin:127.0.0.1:0", Options::new(&TABLE, Sender::v2(255, 190)))?;
//! # let address = format!("udpout:{}", link.local_addr().unwrap());
//! # let mut vehicle = Link::connect(&address, Options::new(&TABLE, Sender::v2(1, 1)))?;
//! # vehicle.send(&Heartbeat)?;
//! # let mut frames = 1..;
//! loop {
//!     let frame = link.receive()?;
//!     println!("{}/{} sends message {}", frame.system_id(), frame.component_id(), frame.message_id());
//!     link.send(&Heartbeat)?;
//! #   if frames.next() == Some(1) { break; }
//! }
//! # assert_eq!(vehicle.receive()?.system_id(), 255);
//! # Ok::<(), mavlink_wire::link::LinkError>(())
//! ```
//!
//! | address | what it is | who gets what is sent |
//! |---|---|---|
//! | `udpin:0.0.0.0:14550` | listens for datagrams | each peer: whoever sent a frame in the last 3 s |
//! | `udpout:192.168.0.7:14550` | sends datagrams there | who is there |
//! | `udpbcast:192.168.0.255:14550` | sends datagrams to a whole network | all there |
//! | `tcpin:0.0.0.0:5760` | listens for a connection, one at a time | who has connected |
//! | `tcpout:192.168.0.7:5760` | connects there | who is there |
//! | `serial:/dev/ttyUSB0:57600` | a serial port | who is behind the cable |
//! | `file:flight.tlog` | reads a log, or bytes that were kept | nobody |
//!
//! # Receiving
//!
//! MAVLink 1 and 2 are received always. [`Link::receive`] waits as long as it takes, [`Link::receive_until`] until a deadline,
//! [`Link::receive_from`] says who sent the frame. Frames may be cut anywhere, also into datagrams: each peer has a parser.
//! Nothing that is received can make a call take longer than its deadline, or take more memory: 16 peers and 16 others that
//! sent something have a parser, the others are forgotten.
//!
//! # Sending
//!
//! [`Link::send`] speaks to each peer in its version of MAVLink: in MAVLink 2 once it has sent that, and in that of the
//! [`Sender`](crate::Sender) before. Who signs sends MAVLink 2. A send buffer that stays full for a second is
//! [`LinkError::Full`]; of a frame that was taken in part, the rest goes out first the next time. So no frame is torn.
//!
//! # Peers that die
//!
//! A connection that is lost is made again, a device that is gone is opened again, first after a tenth of a second and then
//! ever less often, up to every 5 seconds. Meanwhile `receive` waits, and `send` gives `Ok(0)`: it went to nobody.
//! [`Link::trouble`] says why. A client of `tcpin` that has been silent for 5 seconds gives its place to one who waits. With
//! [`Options::without_reconnecting`], a loss is [`LinkError::Closed`]. A server that vanishes without a word, as by a cut cable, is lost when
//! the system gives up sending to it, which takes minutes; before, its full buffer is told.
//!
//! # Threads
//!
//! [`Link::split`] gives a half that receives and one that sends. The one that sends can be cloned.

mod address;
mod chunk;
mod connection;
mod ends;
mod error;
mod file;
mod inbox;
mod line;
mod options;
mod outbox;
mod peer;
mod peers;
mod shared;
mod sources;
mod statistics;
mod tcp;
#[cfg(feature = "tokio")]
pub mod tokio;

pub use address::{Address, AddressError};
pub use connection::{Link, ReceiveHalf, SendHalf};
pub use error::LinkError;
pub use options::Options;
pub use peer::Peer;
pub use statistics::LinkStatistics;

pub(crate) use chunk::MAX_CHUNK;
pub(crate) use inbox::Inbox;
pub(crate) use outbox::{Outbox, Parcel};
pub(crate) use peers::Peers;

/// Whether to go on receiving as if nothing had happened: Windows gives the news that a datagram reached nobody to the receiver.
pub(crate) fn is_passing(kind: std::io::ErrorKind) -> bool {
    use std::io::ErrorKind::{ConnectionRefused, ConnectionReset, Interrupted};
    matches!(kind, Interrupted | ConnectionReset | ConnectionRefused)
}
