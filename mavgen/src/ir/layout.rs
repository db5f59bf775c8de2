//! The order of fields on the wire, and the checksum that follows from it.

use crate::collect::CollectVec as _;
use crate::order::sort_by_key;
use std::cmp::Reverse;

use super::FieldType;
use super::crc::Crc;

/// Where the fields of a message lie, before anybody has checked that they can.
pub(crate) struct Layout {
    /// Each field, and whether it is an extension, in the order of the XML.
    fields: Vec<(FieldType, bool)>,
    /// The fields in wire order, by their places in the XML.
    order: Vec<usize>,
    /// The first byte of each field, in the order of the XML.
    pub(crate) offsets: Vec<usize>,
    /// Bytes of the payload without extension fields.
    pub(crate) v1: usize,
    /// Bytes of the payload with them.
    pub(crate) v2: usize,
}

impl Layout {
    /// Places fields, each given by its type and whether it is an extension.
    ///
    /// The larger elements come first, equal ones in the order of the XML; extension fields follow as the XML has them. Nothing
    /// is padded (MAVLink guide, "Field reordering").
    pub(crate) fn of(fields: impl IntoIterator<Item = (FieldType, bool)>) -> Self {
        let fields = fields.into_iter().collect_vec();
        let mut order = fields.iter().enumerate().collect_vec();
        sort_by_key(&mut order, |(_, (ty, extension))| {
            (*extension, Reverse(if *extension { 0 } else { ty.scalar.size() }))
        });
        let mut placed: Vec<(usize, usize)> = Vec::with_capacity(fields.len());
        let (mut v1, mut v2) = (0, 0);
        for (index, (ty, extension)) in &order {
            placed.push((*index, v2));
            v2 += ty.size();
            if !extension {
                v1 = v2;
            }
        }
        sort_by_key(&mut placed, |(index, _)| *index);
        let order = order.into_iter().map(|(index, _)| index).collect_vec();
        Self { order, offsets: placed.into_iter().map(|(_, offset)| offset).collect_vec(), v1, v2, fields }
    }

    /// `CRC_EXTRA` of a message (MAVLink guide, "CRC_EXTRA calculation"): the checksum over its definition, which seeds the
    /// checksum of its frames. `names` are those of the fields; extensions do not count.
    pub(crate) fn crc_extra(&self, message: &str, names: &[&str]) -> u8 {
        let mut crc = Crc::default();
        crc.word(message);
        for &index in &self.order {
            let (Some(name), Some((ty, false))) = (names.get(index), self.fields.get(index)) else { continue };
            crc.word(ty.scalar.wire_name());
            crc.word(name);
            if let Some(length) = ty.array {
                crc.byte(length.get());
            }
        }
        crc.folded()
    }
}
