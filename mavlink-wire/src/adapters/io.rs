//! Frames over [`std::io`]: serial ports, TCP streams, pipes, files. Needs the feature `std`.
//!
//! ```
//! # use mavlink_wire::{Encode, MessageInfo, Sender, Table};
//! # const INFO: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
//! # struct Heartbeat;
//! # impl Encode for Heartbeat {
//! #     fn info(&self) -> &'static MessageInfo { INFO }
//! #     fn write(&self, payload: &mut [u8; 255]) { payload[..9].copy_from_slice(&[0, 0, 0, 0, 6, 8, 0, 4, 3]); }
//! # }
//! # static TABLE: Table<'static> = Table::of(&[INFO]);
//! # let vehicle = std::net::TcpListener::bind("127.0.0.1:0")?;
//! # let address = vehicle.local_addr()?;
//! # std::thread::spawn(move || {
//! #     let (mut stream, mut heartbeat) = (vehicle.accept()?.0, [0; 21]);
//! #     std::io::Read::read_exact(&mut stream, &mut heartbeat)?;
//! #     std::io::Write::write_all(&mut stream, &heartbeat)
//! # });
//! use mavlink_wire::io::{FrameReader, FrameWriter};
//! use std::net::TcpStream;
//!
//! let stream = TcpStream::connect(address)?;
//! let mut writer = FrameWriter::new(stream.try_clone()?, Sender::v2(255, 190));
//! let mut reader = FrameReader::new(stream, &TABLE);
//! writer.send(&Heartbeat)?;
//! while let Some(frame) = reader.receive()? {
//!     println!("{}/{}: message {}", frame.system_id(), frame.component_id(), frame.message_id());
//! }
//! # assert_eq!(reader.statistics().frames, 1);
//! # Ok::<(), std::io::Error>(())
//! ```
//!
//! # Timeouts, and links that do not block
//!
//! [`ErrorKind::WouldBlock`](std::io::ErrorKind::WouldBlock) and [`TimedOut`](std::io::ErrorKind::TimedOut) are handed on and
//! lose nothing: read again later. A writer keeps what such a link does not take of a frame, and writes it first
//! the next time, so that no frame is torn. [`Interrupted`](std::io::ErrorKind::Interrupted) is tried again at once.
//!
//! A timeout is that of the link, for the next byte. While bytes come that make no frame, as at a wrong baud rate, a reader
//! goes on reading, but no further than 64 KiB: then it says [`WouldBlock`](std::io::ErrorKind::WouldBlock), so that its caller
//! can look at the clock.

mod reader;
mod writer;

pub use reader::FrameReader;
pub use writer::FrameWriter;
