//! Where the fields of a message lie, worked out from the rule alone (MAVLink guide, "Field reordering").

use crate::definition::{Definition, Field};

impl Field {
    /// Bytes of one element.
    pub fn element_size(&self) -> usize {
        match self.rust_type() {
            "u8" | "i8" => 1,
            "u16" | "i16" => 2,
            "u32" | "i32" | "f32" => 4,
            _ => 8,
        }
    }

    /// Number of elements; one if the field is no array.
    pub fn elements(&self) -> usize {
        self.array.map_or(1, usize::from)
    }
}

impl Definition {
    /// The offset of each field, in the order of the XML: large elements first, equal ones in the order of the XML, and
    /// extensions behind all others in the order of the XML.
    pub fn offsets(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.fields.len()).collect();
        order.sort_by_key(|&at| {
            let field = &self.fields[at];
            (field.extension, if field.extension { 0 } else { 8 - field.element_size() })
        });
        let (mut offsets, mut next) = (vec![0; order.len()], 0);
        for at in order {
            offsets[at] = next;
            next += self.fields[at].elements() * self.fields[at].element_size();
        }
        offsets
    }
}
