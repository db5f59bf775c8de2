//! The order of fields on the wire, and the checksum that follows from it.

use std::cmp::Reverse;

use super::FieldType;
use crate::collect::CollectVec as _;
use crate::order::sort_by_key;

/// Where the fields of a message lie, before anybody has checked that they can.
pub(crate) struct Layout {
    /// The first byte of each field, in the order of the XML.
    pub(crate) offsets: Vec<usize>,
    /// Bytes of the payload without extension fields.
    pub(crate) v1: usize,
    /// Bytes of the payload with them.
    pub(crate) v2: usize,
    /// The checksum over the definition, which seeds the checksum of frames (MAVLink guide, "CRC_EXTRA calculation").
    pub(crate) crc_extra: u8,
}

impl Layout {
    /// Places the fields of a message, each given by its name, its type and whether it is an extension.
    ///
    /// The larger elements come first, equal ones in the order of the XML; extension fields follow as the XML has them. Nothing
    /// is padded (MAVLink guide, "Field reordering").
    pub(crate) fn of(message: &str, fields: &[(&str, FieldType, bool)]) -> Self {
        let mut order = fields.iter().enumerate().collect_vec();
        sort_by_key(&mut order, |(_, (_, ty, extension))| {
            (*extension, Reverse(if *extension { 0 } else { ty.scalar.size() }))
        });
        let mut layout = Self { offsets: vec![0; fields.len()], v1: 0, v2: 0, crc_extra: 0 };
        let mut crc = Crc::default();
        crc.word(message);
        for (index, (name, ty, extension)) in order {
            layout.offsets.get_mut(index).into_iter().for_each(|offset| *offset = layout.v2);
            layout.v2 += ty.size();
            if !extension {
                layout.v1 = layout.v2;
                crc.word(ty.scalar.wire_name());
                crc.word(name);
                ty.array.into_iter().for_each(|length| crc.byte(length.get()));
            }
        }
        layout.crc_extra = crc.folded();
        layout
    }
}

/// CRC-16/MCRF4XX so far, which is the checksum of definitions as well as of frames.
struct Crc(u16);

impl Default for Crc {
    fn default() -> Self {
        Self(0xFFFF)
    }
}

impl Crc {
    /// A word and the space after it.
    fn word(&mut self, word: &str) {
        word.bytes().for_each(|byte| self.byte(byte));
        self.byte(b' ');
    }

    fn byte(&mut self, byte: u8) {
        let [low, _] = self.0.to_le_bytes();
        let mixed = byte ^ low;
        let mixed = u16::from(mixed ^ (mixed << 4));
        self.0 = (self.0 >> 8) ^ (mixed << 8) ^ (mixed << 3) ^ (mixed >> 4);
    }

    /// Its two bytes in one.
    fn folded(&self) -> u8 {
        let [low, high] = self.0.to_le_bytes();
        low ^ high
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn check_value() {
        let mut crc = Crc::default();
        b"123456789".iter().for_each(|&byte| crc.byte(byte));
        assert_eq!(crc.0, 0x6F91);
    }
}
