//! Fields of a payload, set by their metadata.

use super::Number;
use crate::message::wire::put;
use crate::{FieldInfo, Kind, MAX_PAYLOAD, OutOfRange};

impl FieldInfo {
    /// Puts a number into this field of a payload: into element `index` of an array, 0 for a field that is none.
    ///
    /// A float field takes any number, rounded to the nearest that it can hold; NaNs keep their bits where the types are
    /// the same. An integer field takes integers that fit.
    ///
    /// ```
    /// use mavlink_wire::reflect::{Number, Reflected};
    /// use mavlink_wire::{FieldInfo, Kind, MAX_PAYLOAD};
    ///
    /// const LEVELS: FieldInfo = FieldInfo::array("levels", Kind::I16, 2, 4).units("cm");
    /// let mut payload = [0; MAX_PAYLOAD];
    /// LEVELS.set(&mut payload, 1, Number::I64(-3))?;
    /// assert_eq!(payload[6..8], [0xfd, 0xff]);
    /// assert!(LEVELS.set(&mut payload, 1, Number::U64(40_000)).is_err());
    /// # Ok::<_, mavlink_wire::OutOfRange>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The number does not fit, or there is no such element. Nothing was set then.
    pub fn set(&self, payload: &mut [u8; MAX_PAYLOAD], index: usize, number: Number) -> Result<(), OutOfRange> {
        let offset = usize::from(self.offset) + index.min(255) * self.kind.size();
        if index >= usize::from(self.array.unwrap_or(1)) || offset + self.kind.size() > MAX_PAYLOAD {
            return Err(OutOfRange);
        }
        match self.kind {
            Kind::F32 => put(payload, offset, number.to_f32()?),
            Kind::F64 => put(payload, offset, number.to_f64()),
            Kind::Char | Kind::U8 | Kind::Version => put::<u8>(payload, offset, number.fitting()?),
            Kind::U16 => put::<u16>(payload, offset, number.fitting()?),
            Kind::U32 => put::<u32>(payload, offset, number.fitting()?),
            Kind::U64 => put::<u64>(payload, offset, number.fitting()?),
            Kind::I8 => put::<i8>(payload, offset, number.fitting()?),
            Kind::I16 => put::<i16>(payload, offset, number.fitting()?),
            Kind::I32 => put::<i32>(payload, offset, number.fitting()?),
            Kind::I64 => put::<i64>(payload, offset, number.fitting()?),
        }
        Ok(())
    }

    /// Puts a text into this `char` field of a payload, and zeros behind it.
    ///
    /// # Errors
    ///
    /// The text is longer than the field, or the field is none of `char`. Nothing was set then.
    pub fn set_text(&self, payload: &mut [u8; MAX_PAYLOAD], text: &str) -> Result<(), OutOfRange> {
        let offset = usize::from(self.offset);
        let field = payload.get_mut(offset..offset + self.size()).ok_or(OutOfRange)?;
        if self.kind != Kind::Char || text.len() > field.len() {
            return Err(OutOfRange);
        }
        field.iter_mut().zip(text.bytes().chain(core::iter::repeat(0))).for_each(|(to, from)| *to = from);
        Ok(())
    }
}

impl Number {
    /// As an integer of another type.
    fn fitting<T: TryFrom<i128>>(self) -> Result<T, OutOfRange> {
        self.as_integer().and_then(|value| value.try_into().ok()).ok_or(OutOfRange)
    }

    /// As a `float`: what is too large for one does not become an infinity.
    fn to_f32(self) -> Result<f32, OutOfRange> {
        let value = match self {
            Self::F32(value) => return Ok(value),
            Self::F64(value) => value as f32,
            Self::U64(value) => value as f32,
            Self::I64(value) => value as f32,
        };
        if value.is_infinite() && self.to_f64().is_finite() { Err(OutOfRange) } else { Ok(value) }
    }
}
