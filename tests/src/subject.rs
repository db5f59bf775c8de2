//! A message type under test, without its type: what the build script makes one of for every message.

use mavlink_wire::{Dialect, Encode, FieldInfo, Frame, Message, MessageInfo};

use crate::values::{Reader, Values, Writer};

/// A message whose fields are all named in the test, by code that the build script writes.
pub trait Golden: Message {
    /// Makes the struct, field by field.
    fn build(values: &mut Reader<'_>) -> Self;

    /// Takes the struct apart, field by field.
    fn take_apart(&self, values: &mut Writer);
}

/// What a payload was decoded to.
pub struct Decoded {
    /// The values of the struct.
    pub values: Values,
    /// The struct, to be encoded again.
    pub message: Box<dyn Encode>,
}

/// A message type of the dialect `D`.
pub struct Subject<D> {
    /// `Message::ID`
    pub id: u32,
    /// `Message::INFO`
    pub info: &'static MessageInfo,
    /// `Message::FIELDS`
    pub fields: &'static [FieldInfo],
    /// A message with these values.
    pub build: fn(&Values) -> Box<dyn Encode>,
    /// The same as a message of the dialect.
    pub build_in_dialect: fn(&Values) -> D,
    /// `Message::decode`
    pub decode: fn(&[u8]) -> Decoded,
    /// `Frame::decode`
    pub decode_frame: fn(&Frame<'_>) -> Option<Decoded>,
    /// The values of a message of the dialect, if it is one of this type.
    pub values_in_dialect: fn(D) -> Option<Values>,
}

impl<D: Dialect> Subject<D> {
    /// The subject of a message type.
    pub const fn of<M: Golden + Into<D> + TryFrom<D>>() -> Self {
        Self {
            id: M::ID,
            info: M::INFO,
            fields: M::FIELDS,
            build: |values| Box::new(M::build(&mut Reader::new(values))),
            build_in_dialect: |values| M::build(&mut Reader::new(values)).into(),
            decode: |payload| decoded(M::decode(payload)),
            decode_frame: |frame| frame.decode::<M>().map(decoded),
            values_in_dialect: |message| M::try_from(message).ok().map(|message| values(&message)),
        }
    }
}

fn values<M: Golden>(message: &M) -> Values {
    let mut writer = Writer::default();
    message.take_apart(&mut writer);
    writer.into_values()
}

fn decoded<M: Golden>(message: M) -> Decoded {
    Decoded { values: values(&message), message: Box::new(message) }
}
