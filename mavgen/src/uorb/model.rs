//! uORB messages, resolved: what the bytes are, in both forms that leave a PX4.

use super::scalar::Scalar;
use crate::ir::{Invalid, Name, Repr};
use crate::source::{FileId, Span};

/// Messages of one folder of `.msg` files: those that were asked for, and what they nest.
#[derive(Clone, Debug, Default)]
pub struct Package {
    /// The messages; what a message nests stands before it.
    pub messages: Vec<Message>,
    /// The enums and flags that their fields carry.
    pub enums: Vec<Enum>,
}

impl Package {
    /// The message behind an index of this package.
    pub fn message(&self, index: MessageIndex) -> Option<&Message> {
        self.messages.get(index.0)
    }

    /// The enum behind an index of this package.
    pub fn enum_(&self, index: EnumIndex) -> Option<&Enum> {
        self.enums.get(index.0)
    }
}

/// Index of an enum in [`Package::enums`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EnumIndex(pub usize);

/// Constants that are the values of a field or, with [`Enum::flags`], its bits.
#[derive(Clone, Debug)]
pub struct Enum {
    /// Its name: as an overlay says, or that of the message and the prefix of the constants: `EscReportFailure`. No other enum
    /// of the package has it.
    pub name: Name,
    /// The message whose constants they are.
    pub message: MessageIndex,
    /// Whether values are combined bit by bit; then the type is unsigned.
    pub flags: bool,
    /// The type of the fields that carry it.
    pub repr: Repr,
    /// The entries, in the order of the file. Two may have one value: then the later is another name for it.
    pub entries: Vec<Entry>,
}

/// An entry of an enum.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The name of the constant without what all of them begin with, `OVER_RPM`; no other entry of the enum has it.
    pub label: String,
    /// The value, which fits the type of the enum. Of a constant that is the number of a bit, that bit: 8 for bit 3.
    pub value: i128,
    /// The constant.
    pub constant: Constant,
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
    /// Its other constants that no enum has, in the order of the file.
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
    /// Its offset in the CDR body of the message, where that is not nested in another.
    pub cdr_offset: u32,
    /// The enum that it carries.
    pub enum_: Option<EnumIndex>,
    /// Which value means "not known".
    pub invalid: Option<Invalid>,
    /// Its name in older definitions.
    pub was: Option<String>,
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

impl Element {
    /// The scalar, if it is one.
    pub(crate) fn scalar(self) -> Option<Scalar> {
        match self {
            Self::Scalar(scalar) => Some(scalar),
            Self::Message(_) => None,
        }
    }

    /// The message, if it is one, among those of its package.
    pub(crate) fn message(self, messages: &[Message]) -> Option<&Message> {
        match self {
            Self::Scalar(_) => None,
            Self::Message(index) => messages.get(index.0),
        }
    }

    /// What a `.msg` file calls it.
    pub(crate) fn name(self, messages: &[Message]) -> &str {
        match self {
            Self::Scalar(scalar) => scalar.name(),
            Self::Message(index) => messages.get(index.0).map_or("", |message| &message.name),
        }
    }
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
    /// `[m/s]`, or what an overlay says.
    pub units: Option<String>,
    /// `[@enum P Q]`: the prefixes of the constants that the field takes.
    pub constants: Vec<String>,
    /// `[@range a, b]`, as it is written.
    pub range: Option<(String, String)>,
    /// `[@invalid V text]`, as it is written: the value that says "not known", and what is said of it.
    pub invalid: Option<String>,
    /// `[@frame F]`: the frame of reference.
    pub frame: Option<String>,
}
