//! Whether two messages are one: what the definitions say of the bytes and their meaning, apart from prose.

use crate::ir::{Field, Message};

/// Whether two messages are defined alike. Their enums are those of the union already.
pub(super) fn same(a: &Message, b: &Message) -> bool {
    // Lengths and the checksum follow from the fields; what overlays add is joined.
    let Message { id, name, fields, crc_extra: _, len_v1: _, len_v2: _, views: _, bindings: _, origin: _ } = a;
    (*id, name, fields.len()) == (b.id, &b.name, b.fields.len())
        && fields.iter().zip(&b.fields).all(|(a, b)| same_field(a, b))
}

fn same_field(a: &Field, b: &Field) -> bool {
    let Field {
        name,
        ty,
        offset,
        extension,
        values,
        instance,
        invalid,
        units,
        multiplier,
        limits,
        default,
        print_format,
        display_bitmask,
        origin,
    } = a;
    let wire = (*ty, *offset, *extension, *values, *instance) == (b.ty, b.offset, b.extension, b.values, b.instance);
    // What elements say beyond the wire; one element says the same as itself.
    let meaning = || {
        (units, multiplier, limits) == (&b.units, &b.multiplier, &b.limits)
            && (default, print_format, *display_bitmask) == (&b.default, &b.print_format, b.display_bitmask)
    };
    wire && (name, invalid) == (&b.name, &b.invalid) && (origin.span == b.origin.span || meaning())
}
