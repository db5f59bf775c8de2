//! The runtime's tables, made from a dialect at run time.

use mavlink_wire::reflect::{Number, Reflected};
use mavlink_wire::{EnumInfo, FieldInfo, Frame, Invalid, Kind, MessageInfo, Sentinel, Table};

use crate::ir::{self, Dialect, Enum, EnumId, Field, Message, Repr, Scalar, Scope};

/// What the runtime needs to know of a dialect to find its frames and to reflect its messages.
#[derive(Clone, Debug)]
pub struct Tables {
    table: &'static Table<'static>,
    /// In the order of the table.
    fields: Vec<&'static [FieldInfo]>,
    /// In the order of [`Dialect::enums`].
    enums: Vec<&'static EnumInfo>,
    reprs: Vec<Repr>,
}

impl Tables {
    /// The tables of a dialect. They stay in memory until the program ends: those of generated code are `'static`, and a
    /// lifetime on each of the runtime's types would be a price that every user of it pays. Make them once per dialect.
    #[must_use]
    pub fn leak(dialect: &Dialect) -> Self {
        let enums: Vec<&'static EnumInfo> = dialect.enums.iter().map(enum_info).collect();
        let reprs = dialect.enums.iter().map(|values| values.repr).collect();
        let infos: Vec<&'static MessageInfo> = dialect.messages.iter().map(message_info).collect();
        let fields = dialect.messages.iter().map(|message| {
            let secret = message.secret().map(|field| field.offset);
            let fields = message.fields.iter().map(|field| field_info(field, secret, &enums));
            &*fields.collect::<Vec<FieldInfo>>().leak()
        });
        let fields = fields.collect();
        Self { table: Box::leak(Box::new(Table::of(infos.leak()))), fields, enums, reprs }
    }

    /// For the [`Parser`](mavlink_wire::Parser).
    #[must_use]
    pub fn table(&self) -> &'static Table<'static> {
        self.table
    }

    /// The fields of the message with this id, in the order of the XML.
    #[must_use]
    pub fn fields(&self, id: u32) -> Option<&'static [FieldInfo]> {
        self.fields.get(self.table.position(id)?).copied()
    }

    /// Name and entries of an enum of the dialect.
    #[must_use]
    pub fn values(&self, id: EnumId) -> Option<&'static EnumInfo> {
        self.enums.get(id.0).copied()
    }

    /// The number that the lowest of these bits are in the type of an enum, which can be signed.
    #[must_use]
    pub fn number(&self, id: EnumId, bits: u64) -> Option<Number> {
        let (repr, values) = (self.reprs.get(id.0)?, self.values(id)?);
        let spare = 64_usize.saturating_sub(8 * repr.size());
        let at_the_top = bits.checked_shl(spare as u32).unwrap_or_default();
        Some(if repr.is_signed() && !values.bitmask {
            // The sign bit comes back with its copies.
            Number::I64((at_the_top as i64).checked_shr(spare as u32).unwrap_or_default())
        } else {
            Number::U64(at_the_top.checked_shr(spare as u32).unwrap_or_default())
        })
    }

    /// The message in a frame, if the dialect has it and the sender has the same definition of it.
    #[must_use]
    pub fn reflect<'a>(&self, frame: &Frame<'a>) -> Option<Reflected<'a>> {
        frame.reflect_as(self.table.get(frame.message_id())?, self.fields(frame.message_id())?)
    }
}

fn leaked(text: &str) -> &'static str {
    text.to_owned().leak()
}

fn message_info(message: &Message) -> &'static MessageInfo {
    let name = leaked(&message.name.text);
    let mut info = MessageInfo::new(message.id, name, message.crc_extra, message.len_v2).len_v1(message.len_v1);
    info.target_system = message.target_system().map(|field| field.offset);
    info.target_component = message.target_component().map(|field| field.offset);
    Box::leak(Box::new(info))
}

fn enum_info(values: &Enum) -> &'static EnumInfo {
    let entries: Vec<(u64, &'static str)> =
        values.entries.iter().map(|entry| (entry.value, leaked(&entry.name.text))).collect();
    let (name, entries) = (leaked(&values.name.text), entries.leak());
    Box::leak(Box::new(if values.bitmask { EnumInfo::bitmask(name, entries) } else { EnumInfo::new(name, entries) }))
}

fn field_info(field: &Field, secret: Option<u8>, enums: &[&'static EnumInfo]) -> FieldInfo {
    let (name, kind) = (leaked(&field.name.text), kind(field.ty.scalar));
    let mut info = match field.ty.array {
        Some(length) => FieldInfo::array(name, kind, length.get(), field.offset),
        None => FieldInfo::new(name, kind, field.offset),
    };
    info.extension = field.extension;
    info.units = field.units.as_deref().map(leaked);
    info.values = field.values.and_then(|values| enums.get(values.id().0).copied());
    info.secret = secret == Some(field.offset);
    info.invalid = field.invalid.as_ref().and_then(|invalid| self::invalid(invalid, field.ty.scalar));
    info
}

/// The runtime's name of a type.
pub(super) fn kind(scalar: Scalar) -> Kind {
    match scalar {
        Scalar::Char => Kind::Char,
        Scalar::U8 => Kind::U8,
        Scalar::Version(_) => Kind::Version,
        Scalar::I8 => Kind::I8,
        Scalar::U16 => Kind::U16,
        Scalar::I16 => Kind::I16,
        Scalar::U32 => Kind::U32,
        Scalar::I32 => Kind::I32,
        Scalar::U64 => Kind::U64,
        Scalar::I64 => Kind::I64,
        Scalar::F32 => Kind::F32,
        Scalar::F64 => Kind::F64,
    }
}

fn invalid(invalid: &ir::Invalid, scalar: Scalar) -> Option<Invalid> {
    let signed = matches!(scalar, Scalar::I8 | Scalar::I16 | Scalar::I32 | Scalar::I64);
    let sentinel = match invalid.sentinel {
        ir::Sentinel::Integer(value) if signed => Sentinel::Signed(value.try_into().ok()?),
        ir::Sentinel::Integer(value) => Sentinel::Unsigned(value.try_into().ok()?),
        ir::Sentinel::Float(value) => Sentinel::Float(value),
        ir::Sentinel::NotANumber => Sentinel::NotANumber,
    };
    Some(match invalid.scope {
        Scope::Each => Invalid::Each(sentinel),
        Scope::Whole => Invalid::All(sentinel),
        Scope::First => Invalid::First(sentinel),
    })
}
