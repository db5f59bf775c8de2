//! `defmt::Format` of messages, enums, flags, text and frames (feature `defmt`).
//!
//! A message is logged as [its text](crate::reflect#the-text), through the field tables and by one function for all
//! messages. What is never logged costs no flash. The first message that is logged brings that function; each message, the
//! names of its fields and of their enums' entries, which are sent as text.

use ::defmt::write;
pub use ::defmt::{Format, Formatter};

use crate::flags::Contained;
use crate::message::record::{Several, plain_name};
use crate::reflect::{Element, Field, Number, Reflected, Value};
use crate::{Chars, Dialect, Encode, Enum, EnumInfo, Frame, FrameBuf, MAX_PAYLOAD, Message, Repr, Version};

/// Implements the trait by one of the functions below.
#[doc(hidden)]
#[macro_export]
macro_rules! __defmt {
    ($name:ident, $format:ident) => {
        impl $crate::generated::defmt::Format for $name {
            fn format(&self, f: $crate::generated::defmt::Formatter<'_>) {
                $crate::generated::defmt::$format(self, f)
            }
        }
    };
}

/// Implements the trait for a view: what is in its bits.
#[doc(hidden)]
#[macro_export]
macro_rules! __defmt_view {
    ($name:ident [$($member:ident $([$count:literal])?),*]) => {
        impl $crate::generated::defmt::Format for $name {
            fn format(&self, f: $crate::generated::defmt::Formatter<'_>) {
                let view = self;
                $crate::generated::defmt::begin(::core::stringify!($name), f);
                $($crate::generated::defmt::member(
                    ::core::stringify!($member),
                    &$crate::__member!(view $member $($count)?),
                    f,
                );)*
                $crate::generated::defmt::end(f);
            }
        }
    };
}

/// Implements the trait for a struct.
#[doc(hidden)]
#[macro_export]
macro_rules! __defmt_record {
    ($name:ident { $($field:ident),* }) => {
        impl $crate::generated::defmt::Format for $name {
            fn format(&self, f: $crate::generated::defmt::Formatter<'_>) {
                $crate::generated::defmt::begin(::core::stringify!($name), f);
                $($crate::generated::defmt::member(::core::stringify!($field), &self.$field, f);)*
                $crate::generated::defmt::end(f);
            }
        }
    };
}

/// Implements the trait for an enum over structs: that of the struct.
#[doc(hidden)]
#[macro_export]
macro_rules! __defmt_topics {
    ($name:ident { $($topic:ident),* }) => {
        impl $crate::generated::defmt::Format for $name {
            fn format(&self, f: $crate::generated::defmt::Formatter<'_>) {
                match self {
                    $(Self::$topic(topic) => $crate::generated::defmt::Format::format(topic, f),)*
                }
            }
        }
    };
}

/// Implements the trait for an enum.
#[doc(hidden)]
#[macro_export]
macro_rules! __defmt_variants {
    ($name:ident { $($variant:ident),* } $($other:ident)?) => {
        impl $crate::generated::defmt::Format for $name {
            fn format(&self, f: $crate::generated::defmt::Formatter<'_>) {
                match self {
                    $(Self::$variant => $crate::generated::defmt::variant(::core::stringify!($variant), f),)*
                    $(Self::$other(number) => $crate::generated::defmt::other(::core::stringify!($other), number, f),)?
                }
            }
        }
    };
}

/// Begins a struct.
pub fn begin(name: &str, f: Formatter<'_>) {
    write!(f, "{=str} {{ ", name);
}

/// A field of a struct.
pub fn member<T: Format>(name: &'static str, value: &T, f: Formatter<'_>) {
    write!(f, "{=str}: {}, ", plain_name(name), value);
}

/// Ends a struct.
pub fn end(f: Formatter<'_>) {
    write!(f, "}}");
}

/// A variant without a value.
pub fn variant(name: &str, f: Formatter<'_>) {
    write!(f, "{=str}", name);
}

/// A variant with a number.
pub fn other<T: Format>(name: &str, number: &T, f: Formatter<'_>) {
    write!(f, "{=str}({})", name, number);
}

impl<T: Format, F: Fn(usize) -> Option<T>> Format for Several<F> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "[");
        for value in self.values() {
            write!(f, "{}, ", value);
        }
        write!(f, "]");
    }
}

/// A message.
pub fn message<M: Message>(message: &M, f: Formatter<'_>) {
    let mut payload = [0; MAX_PAYLOAD];
    message.write(&mut payload);
    Reflected::new(M::INFO, M::FIELDS, &payload).format(f);
}

/// A message of a dialect.
pub fn dialect<D: Dialect>(message: &D, f: Formatter<'_>) {
    let (info, mut payload) = (message.info(), [0; MAX_PAYLOAD]);
    message.write(&mut payload);
    Reflected::new(info, D::fields(info.id).unwrap_or_default(), &payload).format(f);
}

/// A value of an enum or a flags type.
pub fn value<E: Enum>(value: &E, f: Formatter<'_>) {
    match Number::read(E::Repr::KIND, &value.repr().bits().to_le_bytes(), 0) {
        Number::U64(bits) => entry(E::INFO, bits, f),
        number => number.format(f),
    }
}

impl Format for Reflected<'_> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "{=str} {{", self.info().name);
        let mut separator = " ";
        for field in self.fields() {
            write!(f, "{=str}{=str}: {}", separator, field.info().name, field);
            separator = ", ";
        }
        write!(f, " }}");
    }
}

impl Format for Field<'_> {
    fn format(&self, f: Formatter<'_>) {
        if self.info().secret {
            return write!(f, "secret");
        }
        if self.is_invalid() {
            return write!(f, "unknown");
        }
        match self.value() {
            Value::Text(bytes) => return text(bytes, f),
            Value::One(element) => element.format(f),
            Value::Array(elements) => {
                let mut separator = "[";
                for element in elements {
                    write!(f, "{=str}{}", separator, element);
                    separator = ", ";
                }
                write!(f, "]");
            }
        }
        if let (Some(units), None) = (self.info().units, self.info().values) {
            write!(f, " {=str}", units);
        }
    }
}

impl Format for Element<'_> {
    fn format(&self, f: Formatter<'_>) {
        match self.entry() {
            _ if self.info().secret => write!(f, "secret"),
            _ if self.is_invalid() => write!(f, "unknown"),
            Some((info, value)) => entry(info, value, f),
            None => self.number().format(f),
        }
    }
}

impl Format for Number {
    fn format(&self, f: Formatter<'_>) {
        match *self {
            Self::U64(value) => write!(f, "{=u64}", value),
            Self::I64(value) => write!(f, "{=i64}", value),
            Self::F32(value) => write!(f, "{=f32}", value),
            Self::F64(value) => write!(f, "{=f64}", value),
        }
    }
}

/// The name of an enum's entry, or the names of flags; what has none is a number.
fn entry(info: &'static EnumInfo, value: u64, f: Formatter<'_>) {
    if !info.bitmask || value == 0 {
        return match info.entry_name(value) {
            Some(name) => write!(f, "{=str}", name),
            None => write!(f, "{=u64}", value),
        };
    }
    let (mut contained, mut separator) = (Contained::new(info, value), "");
    while let Some((_, name)) = contained.next() {
        write!(f, "{=str}{=str}", separator, name);
        separator = " | ";
    }
    match contained.remaining() {
        0 => {}
        rest => write!(f, "{=str}{=u64:#x}", separator, rest),
    }
}

/// The text, or its bytes if it is not UTF-8.
fn text(bytes: &[u8], f: Formatter<'_>) {
    match core::str::from_utf8(bytes) {
        Ok(text) => write!(f, "{=str:?}", text),
        Err(_) => write!(f, "{=[u8]:a}", bytes),
    }
}

impl<const N: usize> Format for Chars<N> {
    fn format(&self, f: Formatter<'_>) {
        text(self.as_bytes(), f);
    }
}

impl Format for Version {
    fn format(&self, f: Formatter<'_>) {
        match self {
            Self::V1 => write!(f, "V1"),
            Self::V2 => write!(f, "V2"),
        }
    }
}

/// The header and the payload; without the payload if that is a [key](Frame::carries_key), as in `Debug`.
impl Format for Frame<'_> {
    fn format(&self, f: Formatter<'_>) {
        write!(
            f,
            "Frame {{ {}, sequence: {=u8}, system_id: {=u8}, component_id: {=u8}, message_id: {=u32}, payload: ",
            self.version(),
            self.sequence(),
            self.system_id().to_u8(),
            self.component_id().to_u8(),
            self.message_id()
        );
        if self.carries_key() {
            write!(f, "secret }}");
        } else {
            write!(f, "{=[u8]:02x} }}", self.payload());
        }
    }
}

impl Format for FrameBuf {
    fn format(&self, f: Formatter<'_>) {
        self.as_frame().format(f);
    }
}
