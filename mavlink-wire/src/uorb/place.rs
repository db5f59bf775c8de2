//! Where a log's records have the fields of a topic.

use super::{Kind, Value};

/// Where a record has a field: made by [`Binding::of`](super::ulog::Binding::of), read by generated code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    at: u32,
    stride: u32,
    len: u16,
    kind: Kind,
}

impl Place {
    /// The place of a field that the log does not have.
    pub const ABSENT: Self = Self { at: 0, stride: 0, len: 0, kind: Kind::U8 };

    pub(crate) const fn scalars(at: u32, kind: Kind, len: u16) -> Self {
        Self { at, stride: kind.size(), len, kind }
    }

    pub(crate) const fn nested_messages(at: u32, stride: u32, len: u16) -> Self {
        Self { at, stride, len, kind: Kind::U8 }
    }

    /// Whether the log has the field.
    #[must_use]
    pub const fn is_bound(&self) -> bool {
        self.len != 0
    }

    /// Elements that the log has.
    #[inline]
    pub(super) const fn len(&self) -> u16 {
        self.len
    }

    /// The bytes from element `i` on; `None` if the log or this record has no such element.
    #[inline]
    fn element<'r>(&self, record: &'r [u8], i: u16) -> Option<&'r [u8]> {
        if i >= self.len {
            return None;
        }
        let at = u64::from(self.at) + u64::from(self.stride) * u64::from(i);
        record.get(usize::try_from(at).ok()?..)
    }

    /// The value of element `i`; `None` if the log or this record has no such element, or if it is no such value.
    #[inline]
    #[must_use]
    pub fn value<T: Value>(&self, record: &[u8], i: u16) -> Option<T> {
        T::read(self.element(record, i)?, self.kind)
    }

    /// The bytes of the nested message `i`; `None` if the log has no such message.
    #[inline]
    #[must_use]
    pub fn nested<'r>(&self, record: &'r [u8], i: u16) -> Option<&'r [u8]> {
        self.element(record, i)?.get(..usize::try_from(self.stride).ok()?)
    }
}
