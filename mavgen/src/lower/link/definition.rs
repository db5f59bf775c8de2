//! Whether two messages are one: what the definitions say of the bytes and their meaning, apart from prose.

use crate::ir::{Field, Message};

/// Whether two messages are defined alike. Their enums are those of the union already.
pub(super) fn same(a: &Message, b: &Message) -> bool {
    let alike = (a.id, &a.name, a.fields.len()) == (b.id, &b.name, b.fields.len());
    alike && a.fields.iter().zip(&b.fields).all(|(a, b)| same_field(a, b))
}

fn same_field(a: &Field, b: &Field) -> bool {
    let wire = |field: &Field| (field.ty, field.offset, field.extension, field.values, field.instance);
    wire(a) == wire(b)
        && a.name == b.name
        && a.invalid == b.invalid
        && (a.origin.span == b.origin.span || same_meaning(a, b))
}

/// What two elements say beyond the wire; one element says the same as itself.
fn same_meaning(a: &Field, b: &Field) -> bool {
    a.units == b.units
        && a.multiplier == b.multiplier
        && a.limits == b.limits
        && a.default == b.default
        && a.print_format == b.print_format
        && a.display_bitmask == b.display_bitmask
}
