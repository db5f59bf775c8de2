//! Where a log's records have the fields of a topic.

use super::{Kind, Topic, Value};

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

    /// The bytes from element `i` on; `None` if the log or this record has no such element.
    #[inline]
    fn element<'r>(&self, record: &'r [u8], i: u16) -> Option<&'r [u8]> {
        if i >= self.len {
            return None;
        }
        let at = u64::from(self.at) + u64::from(self.stride) * u64::from(i);
        record.get(usize::try_from(at).ok()?..)
    }

    /// The value of the field in a record.
    #[inline]
    #[must_use]
    pub fn get<T: Value>(&self, record: &[u8]) -> Option<T> {
        T::read(self.element(record, 0)?, self.kind)
    }

    /// Puts the values of an array field over those that are there; the others stay.
    #[inline]
    pub fn get_each<T: Value>(&self, record: &[u8], values: &mut [T]) {
        for (i, value) in (0..self.len).zip(values) {
            if let Some(read) = self.element(record, i).and_then(|bytes| T::read(bytes, self.kind)) {
                *value = read;
            }
        }
    }

    /// The bytes of the nested message `i`; `None` if the log has no such message.
    #[inline]
    #[must_use]
    pub fn nested<'r>(&self, record: &'r [u8], i: u16) -> Option<&'r [u8]> {
        self.element(record, i)?.get(..usize::try_from(self.stride).ok()?)
    }

    /// The values of an array field; `unknown` for what the log does not have.
    #[inline]
    #[must_use]
    pub fn array<T: Value, const N: usize>(&self, record: &[u8], unknown: T) -> [T; N] {
        let mut values = [unknown; N];
        self.get_each(record, &mut values);
        values
    }

    /// A nested message, whose fields have these places.
    #[inline]
    #[must_use]
    pub fn message<T: Topic>(&self, record: &[u8], places: &[Self]) -> T {
        self.nested(record, 0).map_or(T::UNKNOWN, |record| T::read(places, record))
    }

    /// Nested messages, whose fields have these places.
    #[inline]
    #[must_use]
    pub fn messages<T: Topic, const N: usize>(&self, record: &[u8], places: &[Self]) -> [T; N] {
        let mut messages = [T::UNKNOWN; N];
        for (i, message) in (0..u16::MAX).zip(&mut messages) {
            let Some(record) = self.nested(record, i) else { break };
            *message = T::read(places, record);
        }
        messages
    }
}
