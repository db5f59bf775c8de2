//! The scalars of uORB messages, and which of them hold the values of which others.

/// A scalar type of a uORB message.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// `uint8`
    U8,
    /// `int8`
    I8,
    /// `uint16`
    U16,
    /// `int16`
    I16,
    /// `uint32`
    U32,
    /// `int32`
    I32,
    /// `uint64`
    U64,
    /// `int64`
    I64,
    /// `float32`
    F32,
    /// `float64`
    F64,
    /// `bool`: one byte, 0 or 1.
    Bool,
    /// `char`: one byte of text.
    Char,
}

impl Kind {
    /// The type of this name in the format definitions of a log, `uint8_t`; `None` for the name of another message.
    #[must_use]
    pub fn of_log(name: &str) -> Option<Self> {
        Some(match name {
            "uint8_t" => Self::U8,
            "int8_t" => Self::I8,
            "uint16_t" => Self::U16,
            "int16_t" => Self::I16,
            "uint32_t" => Self::U32,
            "int32_t" => Self::I32,
            "uint64_t" => Self::U64,
            "int64_t" => Self::I64,
            "float" => Self::F32,
            "double" => Self::F64,
            "bool" => Self::Bool,
            "char" => Self::Char,
            _ => return None,
        })
    }

    /// Bytes of one value.
    #[must_use]
    pub const fn size(self) -> u32 {
        match self {
            Self::U8 | Self::I8 | Self::Bool | Self::Char => 1,
            Self::U16 | Self::I16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::U64 | Self::I64 | Self::F64 => 8,
        }
    }

    /// The name as `.msg` files have it, `uint8`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::U8 => "uint8",
            Self::I8 => "int8",
            Self::U16 => "uint16",
            Self::I16 => "int16",
            Self::U32 => "uint32",
            Self::I32 => "int32",
            Self::U64 => "uint64",
            Self::I64 => "int64",
            Self::F32 => "float32",
            Self::F64 => "float64",
            Self::Bool => "bool",
            Self::Char => "char",
        }
    }

    /// Whether every value of this type is a value of the other, so that nothing is lost.
    #[must_use]
    pub const fn widens_to(self, wider: Self) -> bool {
        use Kind::{Bool, Char, F32, F64, I8, I16, I32, I64, U8, U16, U32, U64};
        match wider {
            Bool => matches!(self, Bool),
            Char => matches!(self, Char),
            U8 => matches!(self, U8 | Bool),
            I8 => matches!(self, I8 | Bool),
            U16 => matches!(self, U16 | U8 | Bool),
            I16 => matches!(self, I16 | U8 | I8 | Bool),
            U32 => matches!(self, U32 | U16 | U8 | Bool),
            I32 => matches!(self, I32 | U16 | I16 | U8 | I8 | Bool),
            U64 => matches!(self, U64 | U32 | U16 | U8 | Bool),
            I64 => matches!(self, I64 | U32 | I32 | U16 | I16 | U8 | I8 | Bool),
            F32 => matches!(self, F32 | U16 | I16 | U8 | I8),
            F64 => matches!(self, F64 | F32 | U32 | I32 | U16 | I16 | U8 | I8),
        }
    }
}

/// A value that a record can carry: little-endian, of its own type or of a narrower one.
pub trait Value: Copy {
    /// Its type.
    const KIND: Kind;

    /// Reads the first bytes as a value of `kind`; `None` if they are too few, or if the type is one that does not
    /// [widen](Kind::widens_to) to this.
    fn read(bytes: &[u8], kind: Kind) -> Option<Self>;
}

macro_rules! value {
    ($($type:ty: $own:ident $(, $kind:ident $narrower:ty)*;)*) => {$(
        impl Value for $type {
            const KIND: Kind = Kind::$own;

            #[inline]
            fn read(bytes: &[u8], kind: Kind) -> Option<Self> {
                Some(match kind {
                    Kind::$own => Self::from_le_bytes(*bytes.first_chunk()?),
                    $(Kind::$kind => <$narrower>::from_le_bytes(*bytes.first_chunk()?).into(),)*
                    _ => return None,
                })
            }
        }
    )*};
}

value! {
    u8: U8, Bool u8;
    u16: U16, U8 u8, Bool u8;
    u32: U32, U16 u16, U8 u8, Bool u8;
    u64: U64, U32 u32, U16 u16, U8 u8, Bool u8;
    i16: I16, U8 u8, I8 i8, Bool u8;
    i32: I32, U16 u16, I16 i16, U8 u8, I8 i8, Bool u8;
    i64: I64, U32 u32, I32 i32, U16 u16, I16 i16, U8 u8, I8 i8, Bool u8;
    f32: F32, U16 u16, I16 i16, U8 u8, I8 i8;
    f64: F64, F32 f32, U32 u32, I32 i32, U16 u16, I16 i16, U8 u8, I8 i8;
}

impl Value for i8 {
    const KIND: Kind = Kind::I8;

    #[inline]
    fn read(bytes: &[u8], kind: Kind) -> Option<Self> {
        let byte = *bytes.first()?;
        match kind {
            Kind::I8 => Some(byte.cast_signed()),
            Kind::Bool => Self::try_from(byte).ok(),
            _ => None,
        }
    }
}

impl Value for bool {
    const KIND: Kind = Kind::Bool;

    #[inline]
    fn read(bytes: &[u8], kind: Kind) -> Option<Self> {
        match (kind, bytes.first()?) {
            (Kind::Bool, 0) => Some(false),
            (Kind::Bool, 1) => Some(true),
            _ => None,
        }
    }
}

/// One byte of text, for [`Chars`](crate::Chars): a `char` widens to nothing else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Char(pub(super) u8);

impl Value for Char {
    const KIND: Kind = Kind::Char;

    #[inline]
    fn read(bytes: &[u8], kind: Kind) -> Option<Self> {
        if kind == Kind::Char { bytes.first().copied().map(Self) } else { None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Kind; 12] = [
        Kind::U8,
        Kind::I8,
        Kind::U16,
        Kind::I16,
        Kind::U32,
        Kind::I32,
        Kind::U64,
        Kind::I64,
        Kind::F32,
        Kind::F64,
        Kind::Bool,
        Kind::Char,
    ];

    /// What a type can be read as is what widens to it, and nothing else.
    fn reads_what_widens<T: Value>() {
        for kind in ALL {
            assert_eq!(T::read(&[0; 8], kind).is_some(), kind.widens_to(T::KIND), "{kind:?} as {:?}", T::KIND);
        }
    }

    #[test]
    fn a_type_is_read_from_exactly_what_widens_to_it() {
        reads_what_widens::<u8>();
        reads_what_widens::<i8>();
        reads_what_widens::<u16>();
        reads_what_widens::<i16>();
        reads_what_widens::<u32>();
        reads_what_widens::<i32>();
        reads_what_widens::<u64>();
        reads_what_widens::<i64>();
        reads_what_widens::<f32>();
        reads_what_widens::<f64>();
        reads_what_widens::<bool>();
        reads_what_widens::<Char>();
    }

    #[test]
    fn widening_keeps_the_value() {
        assert_eq!(i32::read(&[0xfe, 0xff], Kind::I16), Some(-2));
        assert_eq!(u16::read(&[0xfe], Kind::U8), Some(254));
        assert_eq!(f32::read(&[0xff, 0xff], Kind::U16), Some(65_535.0));
        assert_eq!(u16::read(&[1], Kind::U16), None, "a byte is missing");
        assert_eq!(bool::read(&[2], Kind::Bool), None);
    }

    #[test]
    fn names_and_sizes_of_logs() {
        for (name, kind, size) in [("uint8_t", Kind::U8, 1), ("int64_t", Kind::I64, 8), ("float", Kind::F32, 4)] {
            assert_eq!((Kind::of_log(name), kind.size()), (Some(kind), size));
        }
        assert_eq!(Kind::of_log("esc_report"), None);
    }
}
