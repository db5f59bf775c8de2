//! CRC-16/MCRF4XX, which is the checksum of definitions as well as of frames.

/// A checksum so far.
pub(super) struct Crc(u16);

impl Default for Crc {
    fn default() -> Self {
        Self(0xFFFF)
    }
}

impl Crc {
    /// A word and the space after it.
    pub(super) fn word(&mut self, word: &str) {
        word.bytes().for_each(|byte| self.byte(byte));
        self.byte(b' ');
    }

    pub(super) fn byte(&mut self, byte: u8) {
        let [low, _] = self.0.to_le_bytes();
        let mixed = byte ^ low;
        let mixed = u16::from(mixed ^ (mixed << 4));
        self.0 = (self.0 >> 8) ^ (mixed << 8) ^ (mixed << 3) ^ (mixed >> 4);
    }

    /// Its two bytes in one.
    pub(super) fn folded(&self) -> u8 {
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
