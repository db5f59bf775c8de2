//! What a check found wrong.

use std::collections::BTreeSet;
use std::fmt;

/// Which check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Check {
    /// The dialect has exactly the messages of the vectors, also in its table.
    Messages,
    /// `Message::INFO`: id, name, lengths, crc_extra.
    Info,
    /// `Message::FIELDS`: names, types, arrays, extensions, offsets.
    Fields,
    /// A sender makes the frame.
    Encode,
    /// A sender makes the frame from the message of the dialect.
    EncodeInDialect,
    /// MAVLink 1 refuses what it cannot carry.
    IdTooLarge,
    /// A parser finds the frame, and everything in its header.
    Parse,
    /// The frame decodes to the values.
    Decode,
    /// The frame decodes to the message of the dialect with the values.
    DecodeInDialect,
    /// What was decoded encodes to the same payload.
    Reencode,
    /// The signed frame is the unsigned one, with a flag, another checksum and a signature.
    Signed,
    /// The signature is that of the key.
    Signature,
    /// A sender with the key makes the signed frame, and a router makes it from the unsigned one.
    Sign,
    /// Without its signature, the signed frame is the unsigned one.
    Strip,
    /// A verifier with the key believes the signed frame, once.
    Verify,
    /// The constants of an enum, their number and names.
    Constants,
    /// The table of an enum.
    EnumInfo,
    /// Text from an enum's value and back.
    EnumText,
}

/// Something wrong: a check, where, and what.
#[derive(Clone, Debug)]
pub struct Fault {
    /// The check.
    pub check: Check,
    /// Message and case, or enum.
    pub place: String,
    /// What was there, and what should have been.
    pub text: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}: {}: {}", self.check, self.place, self.text)
    }
}

/// What was checked, and what is wrong.
#[derive(Debug, Default)]
pub struct Findings {
    /// Messages checked.
    pub messages: usize,
    /// Cases checked.
    pub cases: usize,
    /// Frames checked.
    pub frames: usize,
    /// Everything wrong.
    pub faults: Vec<Fault>,
}

impl Findings {
    /// Notes a fault unless the two are equal.
    pub fn equal<T: PartialEq + fmt::Debug>(&mut self, check: Check, place: &str, found: T, expected: T) {
        if found != expected {
            let text = format!("found {found:02x?}, expected {expected:02x?}");
            self.faults.push(Fault { check, place: place.to_owned(), text });
        }
    }

    /// The kinds of fault that there are.
    pub fn kinds(&self) -> BTreeSet<Check> {
        self.faults.iter().map(|fault| fault.check).collect()
    }

    /// Fails if anything is wrong.
    ///
    /// # Panics
    ///
    /// With the first faults.
    pub fn expect_none(&self) {
        let shown: Vec<String> = self.faults.iter().take(10).map(Fault::to_string).collect();
        assert!(self.faults.is_empty(), "{} faults:\n{}", self.faults.len(), shown.join("\n"));
    }
}
