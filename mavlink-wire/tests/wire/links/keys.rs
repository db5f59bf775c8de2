//! Links that carry a key: what they hold is not shown.

use std::io::{ErrorKind, Read, Result, Write};

use mavlink_wire::io::{FrameReader, FrameWriter};
use mavlink_wire::signing::{Key, Setup};
use mavlink_wire::{Dialect, MAX_FRAME, Sender, Timestamp};

use crate::small::Small;

/// 0xA7, 167.
const BYTE: u8 = 0xA7;

fn is_shown(text: &str) -> bool {
    text.contains("167") || text.to_lowercase().contains("a7")
}

/// A link that takes nothing, and gives what it has.
struct Stuck(Vec<u8>);

impl Write for Stuck {
    fn write(&mut self, _: &[u8]) -> Result<usize> {
        Err(ErrorKind::WouldBlock.into())
    }

    fn flush(&mut self) -> Result<()> {
        Ok(())
    }
}

impl Read for Stuck {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        self.0.as_slice().read(buffer)
    }
}

impl std::fmt::Debug for Stuck {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Stuck")
    }
}

#[test]
fn a_key_that_waits_to_be_sent_is_not_shown() {
    let setup = Setup::new(1, 1, Key::new([BYTE; 32]), Timestamp::new(1)).unwrap();
    let mut writer = FrameWriter::new(Stuck(vec![]), Sender::v2(1, 1));
    writer.send(&setup).unwrap();
    assert!(writer.is_pending() && !is_shown(&format!("{writer:?}")), "{writer:?}");
}

#[test]
fn a_key_that_was_received_is_not_shown() {
    let setup = Setup::new(1, 1, Key::new([BYTE; 32]), Timestamp::new(1)).unwrap();
    let bytes = Sender::v2(1, 1).encode(&setup, &mut [0; MAX_FRAME]).unwrap().to_vec();
    let mut reader = FrameReader::new(Stuck(bytes), Small::TABLE);
    assert!(reader.receive().unwrap().is_some_and(|frame| frame.carries_key()));
    assert!(!is_shown(&format!("{reader:?}")), "{reader:?}");
}
