//! Getters and setters beside the plain fields of a message: for sentinels ("not known"), and for enums in fields of another
//! width or sign.

use super::{EnumType, Int, Literal};
use crate::ir::Scope;

/// A field that may be unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sentinel<'d> {
    pub(crate) field: &'d str,
    pub(crate) unknown: Unknown<'d>,
    pub(crate) extent: Extent,
}

/// The value that means "not known".
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Unknown<'d> {
    /// This one.
    Is(Literal<'d>),
    /// Any NaN of `f32`.
    NanF32,
    /// Any NaN of `f64`.
    NanF64,
}

/// What of a field it makes unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extent {
    /// The scalar.
    Scalar,
    /// Each element that is it.
    Each,
    /// The first element, if that is it.
    First,
    /// The whole array of this length, if the first element is it.
    Whole(u16),
}

impl Extent {
    /// Whether each element is a value of its own.
    pub(crate) fn is_indexed(self) -> bool {
        matches!(self, Self::Each | Self::First)
    }

    /// Of a sentinel in a scalar, or in an array of this length.
    pub(crate) fn of(scope: Scope, len: Option<u16>) -> Self {
        match (scope, len) {
            (_, None) => Self::Scalar,
            (Scope::Each, Some(_)) => Self::Each,
            (Scope::First, Some(_)) => Self::First,
            (Scope::Whole, Some(len)) => Self::Whole(len),
        }
    }
}

/// A field that carries an enum of another width or sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Convert<'d> {
    pub(crate) field: &'d str,
    /// The integer of the field.
    pub(crate) int: Int,
    pub(crate) to: EnumType<'d>,
    pub(crate) unknown: Option<Unknown<'d>>,
    /// Whether it is an array, of which one element is meant.
    pub(crate) element: bool,
}

impl Convert<'_> {
    /// Whether every number of the field is one of the enum's integer.
    pub(crate) fn always_gets(&self) -> bool {
        self.int.is_within(self.to.int)
    }

    /// Whether every number of the enum's integer is one of the field.
    pub(crate) fn always_sets(&self) -> bool {
        self.to.int.is_within(self.int)
    }

    /// Whether there may be no value.
    pub(crate) fn is_optional(&self) -> bool {
        self.element || self.unknown.is_some() || !self.always_gets()
    }
}
