//! The order of fields on the wire, and the checksum that follows from it.

use std::cmp::Reverse;

use super::FieldType;
use crate::collect::CollectVec as _;
use crate::order::sort_by_key;

/// Where the fields of a message lie on the wire.
pub(crate) struct Layout {
    /// The first byte of each field, in the order of the XML.
    pub(crate) offsets: Vec<u8>,
    /// Bytes of the payload without extension fields.
    pub(crate) len_v1: u8,
    /// Bytes of the payload with them.
    pub(crate) len_v2: u8,
    /// The checksum over the definition, which seeds the checksum of frames (MAVLink guide, "CRC_EXTRA calculation").
    pub(crate) crc_extra: u8,
}

impl Layout {
    /// Places the fields of a message, each given by its name, its type and whether it is an extension; the bytes without and
    /// with extension fields are the error, if they are more than a payload can have.
    ///
    /// The larger elements come first, equal ones in the order of the XML; extension fields follow as the XML has them. Nothing
    /// is padded (MAVLink guide, "Field reordering").
    pub(crate) fn of(message: &str, fields: &[(&str, FieldType, bool)]) -> Result<Self, (usize, usize)> {
        let mut order = fields.iter().enumerate().collect_vec();
        sort_by_key(&mut order, |(_, (_, ty, extension))| {
            (*extension, Reverse(if *extension { 0 } else { ty.scalar.size() }))
        });
        let mut placed = Vec::with_capacity(fields.len());
        let (mut v1, mut v2) = (0, 0);
        let mut crc = Crc::START;
        crc.word(message);
        for (index, (name, ty, extension)) in order {
            placed.push((index, v2));
            v2 += ty.size();
            if !extension {
                v1 = v2;
                crc.word(ty.scalar.wire_name());
                crc.word(name);
                ty.array.into_iter().for_each(|length| crc.byte(length.get()));
            }
        }
        sort_by_key(&mut placed, |(index, _)| *index);
        let byte = |bytes: usize| u8::try_from(bytes).map_err(|_| (v1, v2));
        let offsets = placed.into_iter().map(|(_, offset)| byte(offset)).try_collect_vec()?;
        Ok(Self { offsets, len_v1: byte(v1)?, len_v2: byte(v2)?, crc_extra: crc.folded() })
    }
}

/// CRC-16/MCRF4XX so far, which is the checksum of definitions as well as of frames.
struct Crc(u16);

impl Crc {
    const START: Self = Self(0xFFFF);

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
        let mut crc = Crc::START;
        b"123456789".iter().for_each(|&byte| crc.byte(byte));
        assert_eq!(crc.0, 0x6F91);
    }
}
