//! Messages without their types: names, values and units of whatever arrives.
//!
//! A router or a logger need not know a message to show it. The tables that come with every dialect say what lies where in
//! a payload, in which unit, which enum lists its values and which value means "not known"; so do tables that a program
//! makes at run time.
//!
//! ```
//! use mavlink_wire::reflect::Value;
//! use mavlink_wire::{Dialect, EnumInfo, FieldInfo, Frame, Invalid, Kind, MessageInfo, Parser, Sentinel, Table};
//!
//! /// A line for every frame, in any dialect.
//! fn line<D: Dialect>(frame: &Frame<'_>) -> String {
//!     let sender = format!("{}/{} #{}", frame.system_id(), frame.component_id(), frame.sequence());
//!     match frame.reflect::<D>() {
//!         Some(message) => format!("{sender} {message}"),
//!         None => format!("{sender} message {} {:02x?}", frame.message_id(), frame.payload()),
//!     }
//! }
//!
//! // The same without a dialect: tables that were made by hand, or from XML.
//! static TANK: EnumInfo = EnumInfo::new("TANK", &[(4, "TANK_FRONT")]);
//! let info = MessageInfo::new(0, "SPRAYER", 50, 9);
//! let fields = [
//!     FieldInfo::new("tank", Kind::U8, 7).values(&TANK),
//!     FieldInfo::new("pressure", Kind::U32, 0).units("hPa").invalid(Invalid::Each(Sentinel::Unsigned(0))),
//!     FieldInfo::array("levels", Kind::U8, 2, 4).units("cm"),
//! ];
//! let infos = [&info];
//! let table = Table::of(&infos);
//!
//! let mut parser = Parser::new(&table);
//! let mut chunk: &[u8] = &[0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
//! let frame = parser.next(&mut chunk).unwrap();
//! let message = frame.reflect_as(&info, &fields).unwrap();
//! assert_eq!(message.to_string(), "SPRAYER { tank: TANK_FRONT, pressure: unknown, levels: [6, 8] cm }");
//! let levels = message.field("levels").unwrap();
//! assert!(matches!(levels.value(), Value::Array(elements) if elements.len() == 2));
//! ```
//!
//! # The text
//!
//! `Display` of a [`Reflected`] message is one line, made to be searched: the names of the XML, in its order.
//!
//! | | |
//! |---|---|
//! | a number | `alt: 1500 mm` |
//! | an enum | `fix_type: GPS_FIX_TYPE_3D_FIX`; a number where no entry has the value |
//! | flags | `base_mode: MAV_MODE_FLAG_AUTO_ENABLED \| MAV_MODE_FLAG_SAFETY_ARMED \| 0x2` |
//! | an array | `voltages: [4100, 4080, unknown] mV` |
//! | text | `text: "ready"`; `b"\xff"` where it is not UTF-8 |
//! | the value that means so | `eph: unknown` |
//! | a [key](FieldInfo::secret) | `secret_key: secret` |
//! | a float | always with a point or an exponent: `yaw: 1.0 rad`; `NaN`, `inf`; `NaN(0x7fc00001)` for one that is not the usual |
//!
//! `{:#}` puts each field on a line of its own.

mod field;
mod number;
mod store;

use core::fmt;

use crate::{Dialect, Encode, FieldInfo, MAX_PAYLOAD, Message, MessageInfo};

use field::Plain;
pub use field::{Element, Elements, Field, Value};
pub use number::Number;

/// A message: what its tables say of a payload.
///
/// The payload can have any length: what is missing at its end reads as zero, what is too much is ignored, as in
/// [`Message::decode`].
#[derive(Clone, Copy, Debug)]
pub struct Reflected<'a> {
    info: &'a MessageInfo,
    fields: &'a [FieldInfo],
    payload: &'a [u8],
}

impl<'a> Reflected<'a> {
    /// A payload, read by these tables. That they belong together is not checked:
    /// [`Frame::reflect_as`](crate::Frame::reflect_as) does.
    #[must_use]
    pub const fn new(info: &'a MessageInfo, fields: &'a [FieldInfo], payload: &'a [u8]) -> Self {
        Self { info, fields, payload }
    }

    /// Id, name, lengths and checksum byte.
    #[must_use]
    pub const fn info(&self) -> &'a MessageInfo {
        self.info
    }

    /// The payload, as it was received.
    #[must_use]
    pub const fn payload(&self) -> &'a [u8] {
        self.payload
    }

    /// The fields in the order of the XML.
    #[must_use]
    pub fn fields(&self) -> impl ExactSizeIterator<Item = Field<'a>> + Clone + use<'a> {
        let payload = self.payload;
        self.fields.iter().map(move |info| Field::new(info, payload))
    }

    /// The field with this name in the XML.
    #[must_use]
    pub fn field(&self, name: &str) -> Option<Field<'a>> {
        self.fields().find(|field| field.info().name == name)
    }
}

/// One line: see [the text](self#the-text).
impl fmt::Display for Reflected<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct(self.info.name);
        for field in self.fields() {
            shown.field(field.info().name, &format_args!("{field}"));
        }
        shown.finish()
    }
}

/// `Display` of a message.
///
/// # Errors
///
/// Those of the formatter.
#[doc(hidden)]
pub fn fmt_message<M: Message>(message: &M, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    show(message, M::FIELDS, f)
}

/// `Display` of a dialect's enum: that of the message in it.
///
/// # Errors
///
/// Those of the formatter.
#[doc(hidden)]
pub fn fmt_variant<D: Dialect>(message: &D, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    show(message, fields(message), f)
}

/// `Debug` of a message, as if it were derived; but fields have the names of the XML, a value without a name is a number, and a
/// secret key is not shown.
///
/// # Errors
///
/// Those of the formatter.
#[doc(hidden)]
pub fn debug_message<M: Message>(message: &M, name: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    debug(message, name, M::FIELDS, f)
}

/// `Debug` of a dialect's enum, whose variants are called like the messages in them.
///
/// # Errors
///
/// Those of the formatter.
#[doc(hidden)]
pub fn debug_variant<D: Dialect>(message: &D, name: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    f.debug_tuple(name).field(&Inner { message, name, fields: fields(message) }).finish()
}

fn fields<D: Dialect>(message: &D) -> &'static [FieldInfo] {
    D::fields(message.info().id).unwrap_or_default()
}

/// One function for all messages, as [`debug`].
fn show(message: &dyn Encode, fields: &[FieldInfo], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let mut payload = [0; MAX_PAYLOAD];
    message.write(&mut payload);
    fmt::Display::fmt(&Reflected::new(message.info(), fields, &payload), f)
}

/// Derived for each message, it took a tenth of a dialect's compile time.
fn debug(message: &dyn Encode, name: &str, fields: &[FieldInfo], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let mut payload = [0; MAX_PAYLOAD];
    message.write(&mut payload);
    let mut shown = f.debug_struct(name);
    for info in fields {
        shown.field(info.name, &Plain(Field::new(info, &payload)));
    }
    shown.finish()
}

/// The message in a dialect's enum.
struct Inner<'a> {
    message: &'a dyn Encode,
    name: &'a str,
    fields: &'a [FieldInfo],
}

impl fmt::Debug for Inner<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        debug(self.message, self.name, self.fields, f)
    }
}
