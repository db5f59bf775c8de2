//! A message: its struct, and the frame that carries it.

use super::{Docs, Element, EnumType, Method, Shape};
use crate::collect::CollectVec as _;
use crate::ir;
use crate::order;

#[derive(Clone, Debug)]
pub(crate) struct Struct<'d> {
    pub(crate) ident: &'d str,
    /// The spelling of the XML, where it is another.
    pub(crate) alias: Option<&'d str>,
    pub(crate) docs: Docs<'d>,
    /// Why it is not to be used.
    pub(crate) deprecated: Option<String>,
    /// In the order of the XML.
    pub(crate) fields: Vec<Field<'d>>,
    pub(crate) methods: Vec<Method<'d>>,
    /// The getters of what overlays see in it, and what they give: first the enums that are bound to fields.
    pub(crate) seen: Vec<(&'d str, Gives)>,
    pub(crate) frame: Frame<'d>,
}

impl<'d> Struct<'d> {
    /// The fields by offset.
    pub(crate) fn wire_order(&self) -> Vec<&Field<'d>> {
        let mut fields = self.fields.iter().collect_vec();
        order::sort_by_key(&mut fields, |field| field.wire.offset);
        fields
    }
}

/// What the getter of a view or of a bound enum gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Gives {
    /// A value, or `None` where it is not known.
    One,
    /// Nothing where a condition does not hold.
    Maybe,
    /// Every slot in use.
    Each,
}

/// A public field.
#[derive(Clone, Debug)]
pub(crate) struct Field<'d> {
    pub(crate) ident: &'d str,
    pub(crate) element: Element<'d>,
    pub(crate) shape: Shape,
    /// The version of the file that defines the message, if that is its value in `DEFAULT`; others are zero there.
    pub(crate) version: Option<u8>,
    pub(crate) docs: Docs<'d>,
    /// Whether no text may show it.
    pub(crate) secret: bool,
    /// The enum that it carries, as its type or not.
    pub(crate) carries: Option<EnumType<'d>>,
    pub(crate) wire: &'d ir::Field,
}

/// What the frames of a message say of it.
#[derive(Clone, Debug)]
pub(crate) struct Frame<'d> {
    pub(crate) wire: &'d ir::Message,
    /// The fields that say whom it is for, and where each lies in the payload.
    pub(crate) target_system: Option<(&'d str, u8)>,
    pub(crate) target_component: Option<(&'d str, u8)>,
}
