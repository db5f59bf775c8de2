//! The checksum over a message's definition, which seeds the checksum of its frames.

use crate::ir::Field;

/// `CRC_EXTRA` of a message (MAVLink guide, "CRC_EXTRA calculation").
///
/// `wire_order` are its fields as they stand on the wire; those after `<extensions/>` do not count.
pub(super) fn crc_extra<'f>(message: &str, wire_order: impl IntoIterator<Item = &'f Field>) -> u8 {
    let mut crc = Crc::default();
    crc.word(message);
    for field in wire_order.into_iter().filter(|field| !field.extension) {
        crc.word(field.ty.scalar.wire_name());
        crc.word(&field.name.text);
        if let Some(length) = field.ty.array {
            crc.byte(length.get());
        }
    }
    let [low, high] = crc.0.to_le_bytes();
    low ^ high
}

/// CRC-16/MCRF4XX.
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
