//! The order of fields on the wire.

use std::cmp::Reverse;

use crate::ir::Field;

/// The lengths of a payload in bytes, before anybody has checked that they can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lengths {
    /// Without extension fields.
    pub(super) v1: usize,
    /// With them.
    pub(super) v2: usize,
}

/// Gives every field its offset and returns the lengths. Offsets beyond 255 are cut: such a payload is refused.
///
/// The larger elements come first, equal ones in the order of the XML; extension fields follow as the XML has them. Nothing is
/// padded (MAVLink guide, "Field reordering").
pub(super) fn place(fields: &mut [Field]) -> Lengths {
    let mut wire: Vec<&mut Field> = fields.iter_mut().collect();
    wire.sort_by_key(|field| {
        let size = if field.extension { 0 } else { field.ty.scalar.size() };
        (field.extension, Reverse(size))
    });
    let mut lengths = Lengths { v1: 0, v2: 0 };
    for field in wire {
        field.offset = u8::try_from(lengths.v2).unwrap_or(u8::MAX);
        lengths.v2 += field.size();
        if !field.extension {
            lengths.v1 = lengths.v2;
        }
    }
    lengths
}
