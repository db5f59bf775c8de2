//! Links by address: UDP, TCP, serial ports and files. Needs the feature `std`; serial ports need `serial`.
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
//! | address | what it does | who receives what you send |
//! |---|---|---|
//! | `udpin:0.0.0.0:14550` | listens for datagrams | each peer: whoever sent a frame in the last 3 s |
//! | `udpout:192.168.0.7:14550` | sends datagrams there | that address |
//! | `udpbcast:192.168.0.255:14550` | broadcasts datagrams to a network | all in that network |
//! | `tcpin:0.0.0.0:5760` | listens for one client at a time | the client |
//! | `tcpout:192.168.0.7:5760` | connects there | the server |
//! | `serial:/dev/ttyUSB0:57600` | opens a serial port | the device at the other end |
//! | `file:flight.tlog` | reads a tlog or a raw stream of frames | nobody |
//!
//! # Receiving
//!
//! A link receives MAVLink 1 and 2. [`Link::receive`] waits without a limit, [`Link::receive_until`] until a deadline.
//! [`Link::receive_from`] also says who sent the frame. Frames may be cut anywhere, even across datagrams, because each peer has
//! its own parser.
//!
//! No received data can make a call miss its deadline, or use more and more memory: at most 16 peers and 16 other senders have a
//! parser; others are forgotten.
//!
//! # Sending
//!
//! [`Link::send`] uses each peer's version of MAVLink: that of the [`Sender`](crate::Sender) at first, and MAVLink 2 once the peer
//! sent it. A link that signs always sends MAVLink 2. If the send buffer stays full for a second, you get [`LinkError::Full`]. If
//! the system took a part of a frame, the next send writes its rest first, so that no frame is torn.
//!
//! Who has several messages to send calls [`Link::queue`] for each and [`Link::flush`] before waiting: over TCP they take one call of the
//! system together. Sending allocates nothing after the first messages.
//!
//! # Reconnecting
//!
//! A link reopens a lost connection or device by itself: first after a tenth of a second, then ever less often, up to every 5
//! seconds. Meanwhile `receive` waits, and `send` returns `Ok(0)`: nobody got the message. [`Link::trouble`] says why. With
//! [`Options::without_reconnecting`], a lost connection is [`LinkError::Closed`].
//!
//! A client of `tcpin` that was silent for 5 seconds is replaced if another one waits.
//!
//! If a server vanishes without closing the connection, as with a cut cable, the system notices only after minutes. Until then
//! `send` returns [`LinkError::Full`] when the buffer is full.
//!
//! # Threads
//!
//! [`Link::split`] returns a half that receives and a half that sends. The sending half can be cloned.

mod address;
mod connection;
mod ends;
mod error;
mod file;
mod forward;
mod inbox;
mod line;
mod open;
mod options;
mod outbox;
mod peer;
mod peers;
mod pending;
mod sending;
mod shared;
mod sources;
mod statistics;
mod tcp;
#[cfg(feature = "tokio")]
pub mod tokio;
mod udp;

pub use address::{Address, AddressError};
pub use connection::{Link, ReceiveHalf, SendHalf};
pub use error::LinkError;
pub use options::Options;
pub use peer::Peer;
pub use statistics::LinkStatistics;

pub(crate) use inbox::{Inbox, MAX_CHUNK};
pub(crate) use outbox::Outbox;
pub(crate) use peers::Peers;
pub(crate) use pending::Pending;
