//! Messages of the model.

use super::super::enums::Enums;
use super::super::field::DraftField;
use super::super::invalid::{self, Entries};
use super::super::message::Draft;
use super::super::notes::{Notes, Whole};
use super::super::origin::non_empty;
use super::super::overlay::Added;
use super::super::width::Width;
use super::super::{spelling, uses};
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::ir::{Field, Message, Values};

/// What messages refer to, and what is said of them elsewhere.
pub(in crate::resolve) struct Links<'l, 'a> {
    /// The enums.
    pub(in crate::resolve) enums: &'l Enums<'a>,
    /// Of the enums.
    pub(in crate::resolve) widths: &'l [Width],
    /// Of the enums.
    pub(in crate::resolve) entries: &'l Entries<'a>,
    /// What overlays say of the items.
    pub(in crate::resolve) notes: &'l Notes<'a>,
}

/// The model of a message, with what overlays add to it.
pub(in crate::resolve) fn build(
    draft: Draft<'_>,
    added: Added,
    links: &Links<'_, '_>,
    diagnostics: &mut Diagnostics,
) -> Message {
    let name = draft.syntax.name.value.as_str();
    let mut origin = draft.origin;
    links.notes.add_to(&mut origin, (Whole::Message, name, None));
    let fields = draft.fields.into_iter().zip(draft.wire.offsets);
    let fields = fields.map(|(field, offset)| build_field(name, field, offset, links, diagnostics)).collect_vec();
    Message {
        id: draft.id,
        name: spelling::name(&draft.syntax.name),
        crc_extra: draft.wire.crc_extra,
        len_v1: draft.wire.len_v1,
        len_v2: draft.wire.len_v2,
        fields,
        views: added.views,
        bindings: added.bindings,
        origin,
    }
}

fn build_field(
    message: &str,
    field: DraftField<'_>,
    offset: u8,
    links: &Links<'_, '_>,
    diagnostics: &mut Diagnostics,
) -> Field {
    let invalid = invalid::of_field(&field, links.entries, diagnostics);
    let values = values(&field, links);
    let DraftField { syntax, ty, extension, limits, display_bitmask, instance, mut origin } = field;
    links.notes.add_to(&mut origin, (Whole::Message, message, Some(&syntax.name.value)));
    Field {
        name: spelling::name(&syntax.name),
        ty,
        offset,
        extension,
        values,
        units: non_empty(&syntax.units),
        invalid,
        limits,
        multiplier: non_empty(&syntax.multiplier),
        default: non_empty(&syntax.default),
        print_format: non_empty(&syntax.print_format),
        display_bitmask,
        instance,
        origin,
    }
}

/// What a field carries, now that every enum has its integer.
fn values(field: &DraftField<'_>, links: &Links<'_, '_>) -> Option<Values> {
    let id = links.enums.id(&uses::named(field.syntax)?.value)?;
    let own = field.ty.scalar.repr()?;
    let width = links.widths.get(id.0)?;
    Some(if width.repr == own { Values::Typed(id) } else { Values::Converted(id) })
}
