//! The `message` lines of a vector file: what a message is, as pymavlink understands it.
//!
//! The build script reads them as well, to write code that names every field.

/// A message, from a `message` line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Definition {
    /// Message id.
    pub id: u32,
    /// Name in the XML.
    pub name: String,
    /// The byte that ends the checksum.
    pub crc_extra: u8,
    /// Bytes of the payload with extensions.
    pub len_v2: u8,
    /// Bytes of the payload without extensions.
    pub len_v1: u8,
    /// In the order of the XML.
    pub fields: Vec<Field>,
}

/// A field of a message, `+voltages:uint16_t[4]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Name in the XML.
    pub name: String,
    /// Type of an element, as the XML spells it.
    pub ty: String,
    /// Number of elements, if the field is an array.
    pub array: Option<u8>,
    /// Whether MAVLink 1 leaves it out.
    pub extension: bool,
}

impl Definition {
    /// Reads a line; `None` if it is another kind of line.
    ///
    /// # Panics
    ///
    /// If it is a `message` line that is not written as the format says.
    pub fn read(line: &str) -> Option<Self> {
        let mut words = line.strip_prefix("message ")?.split(' ');
        let mut word = |prefix: &str| {
            let value = words.next().and_then(|word| word.strip_prefix(prefix));
            value.unwrap_or_else(|| panic!("`{prefix}` is missing in: {line}"))
        };
        let (id, name, crc_extra, len_v2, len_v1) =
            (word(""), word(""), word("crc_extra="), word("len_v2="), word("len_v1="));
        Some(Self {
            id: id.parse().unwrap(),
            name: name.to_owned(),
            crc_extra: crc_extra.parse().unwrap(),
            len_v2: len_v2.parse().unwrap(),
            len_v1: len_v1.parse().unwrap(),
            fields: words.map(Field::read).collect(),
        })
    }
}

impl Field {
    fn read(word: &str) -> Self {
        let (extension, word) = word.strip_prefix('+').map_or((false, word), |word| (true, word));
        let (name, ty) = word.split_once(':').unwrap_or_else(|| panic!("no type in: {word}"));
        let (ty, array) = match ty.strip_suffix(']').and_then(|ty| ty.split_once('[')) {
            Some((ty, length)) => (ty, Some(length.parse().unwrap())),
            None => (ty, None),
        };
        Self { name: name.to_owned(), ty: ty.to_owned(), array, extension }
    }

    /// The Rust type of an element that is no enum.
    ///
    /// # Panics
    ///
    /// If MAVLink has no such type.
    pub fn rust_type(&self) -> &'static str {
        match self.ty.as_str() {
            "char" | "uint8_t" | "uint8_t_mavlink_version" => "u8",
            "int8_t" => "i8",
            "uint16_t" => "u16",
            "int16_t" => "i16",
            "uint32_t" => "u32",
            "int32_t" => "i32",
            "uint64_t" => "u64",
            "int64_t" => "i64",
            "float" => "f32",
            "double" => "f64",
            other => panic!("no type of MAVLink: {other}"),
        }
    }
}
