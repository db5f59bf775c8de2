//! uORB messages, resolved: what the bytes are, in both forms that leave a PX4.

use super::scalar::Scalar;
use crate::source::{FileId, Span};

/// Messages of one folder of `.msg` files: those that were asked for, and what they nest.
#[derive(Clone, Debug, Default)]
pub struct Package {
    /// The messages; what a message nests stands before it.
    pub messages: Vec<Message>,
}

/// Index of a message in [`Package::messages`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MessageIndex(pub usize);

/// A message.
#[derive(Clone, Debug)]
pub struct Message {
    /// Its name, that of the file: `EscStatus`.
    pub name: String,
    /// The file.
    pub file: FileId,
    /// What the comment at the beginning of the file says, line by line.
    pub about: Vec<String>,
    /// The topics that carry it.
    pub topics: Vec<String>,
    /// `MESSAGE_VERSION`
    pub version: Option<u32>,
    /// `ORB_QUEUE_LENGTH`
    pub queue: Option<u32>,
    /// Its fields, in the order of the file.
    pub fields: Vec<Field>,
    /// Its other constants, in the order of the file.
    pub constants: Vec<Constant>,
    /// FNV-1a over types and names, what is nested included: what PX4 calls the message hash.
    pub hash: u32,
    /// SHA-256 of the type's description: ROS 2's type hash, `RIHS01_` and 64 digits.
    pub type_hash: String,
    /// Bytes of the body as CDR, without the header of four bytes and without padding at its end.
    pub cdr_len: u32,
    /// Bytes as a C struct, padding at its end included.
    pub struct_len: u32,
    /// Of these, padding at the end: a log leaves it out.
    pub struct_padding: u32,
}

/// A field of a message.
#[derive(Clone, Debug)]
pub struct Field {
    /// Its name.
    pub name: String,
    /// Where the name stands.
    pub span: Span,
    /// The type of its elements.
    pub element: Element,
    /// The length of an array.
    pub array: Option<u16>,
    /// Its offset in the C struct.
    pub struct_offset: u32,
    /// What the comments say.
    pub docs: Docs,
}

impl Field {
    /// Elements: 1 for what is no array.
    pub fn elements(&self) -> u32 {
        self.array.unwrap_or(1).into()
    }
}

/// The type of a field's elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// A scalar.
    Scalar(Scalar),
    /// Another message.
    Message(MessageIndex),
}

/// A constant.
#[derive(Clone, Debug)]
pub struct Constant {
    /// Its name.
    pub name: String,
    /// Where the name stands.
    pub span: Span,
    /// Its type, an integer.
    pub scalar: Scalar,
    /// Its value, which fits into the type.
    pub value: i128,
    /// What the comments say.
    pub docs: Docs,
}

/// What comments say of a field or constant.
#[derive(Clone, Debug, Default)]
pub struct Docs {
    /// Prose, line by line.
    pub lines: Vec<String>,
    /// `[m/s]`
    pub units: Option<String>,
    /// `[@enum P Q]`: the prefixes of the constants that the field takes.
    pub constants: Vec<String>,
    /// `[@range a, b]`, as it is written.
    pub range: Option<(String, String)>,
    /// `[@invalid V]`: the value that says "not known", as it is written.
    pub invalid: Option<String>,
    /// `[@frame F]`: the frame of reference.
    pub frame: Option<String>,
}
