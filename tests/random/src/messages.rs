//! Messages: fields of all types, some of them made for views.

use std::fmt::Write;

use crate::Construct;
use crate::chance::Chance;
use crate::enums::Enum;
use crate::names::Scope;
use crate::xml::{attribute, lifecycle, optional, prose};

/// Bytes of the largest payload.
const MOST_BYTES: u32 = 255;

/// The kinds of a field's type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Unsigned,
    Signed,
    Float,
    Char,
    Version,
}

/// The type of a field, or of its elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Scalar {
    pub(crate) kind: Kind,
    pub(crate) bits: u32,
}

impl Scalar {
    pub(crate) const fn unsigned(bits: u32) -> Self {
        Self { kind: Kind::Unsigned, bits }
    }

    pub(crate) const fn signed(bits: u32) -> Self {
        Self { kind: Kind::Signed, bits }
    }

    pub(crate) fn is_signed(self) -> bool {
        self.kind == Kind::Signed
    }

    pub(crate) fn is_unsigned(self) -> bool {
        self.kind == Kind::Unsigned
    }

    pub(crate) fn is_integer(self) -> bool {
        self.is_signed() || self.is_unsigned()
    }

    /// The largest value of an integer.
    pub(crate) fn most(self) -> u64 {
        (u64::MAX >> (64 - self.bits)) >> u32::from(self.is_signed())
    }

    fn spelled(self) -> String {
        match self.kind {
            Kind::Unsigned => format!("uint{}_t", self.bits),
            Kind::Signed => format!("int{}_t", self.bits),
            Kind::Float => (if self.bits == 32 { "float" } else { "double" }).to_owned(),
            Kind::Char => "char".to_owned(),
            Kind::Version => "uint8_t_mavlink_version".to_owned(),
        }
    }
}

/// A field.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    pub(crate) name: String,
    pub(crate) scalar: Scalar,
    pub(crate) array: Option<u8>,
    pub(crate) values: Option<usize>,
}

impl Field {
    fn bytes(&self) -> u32 {
        self.scalar.bits / 8 * u32::from(self.array.unwrap_or(1))
    }
}

/// A message.
pub(crate) struct Message {
    pub(crate) name: String,
    pub(crate) file: usize,
    pub(crate) fields: Vec<Field>,
}

/// What the fields of a message are for.
#[derive(Clone, Copy)]
enum Purpose {
    Anything,
    Slots(u8),
    Words,
}

/// A message and its text; `visible` are the enums that it may name.
pub(crate) fn make(
    chance: &mut Chance,
    name: String,
    (id, file): (u32, usize),
    enums: &mut [Enum],
    visible: &[usize],
) -> (Message, String) {
    let purpose = match chance.below(5) {
        0 | 1 => Purpose::Slots(chance.between(1, 5) as u8),
        2 => Purpose::Words,
        _ => Purpose::Anything,
    };
    let (life, deprecated) = lifecycle(chance, 9);
    if deprecated {
        chance.say(Construct::DeprecatedMessage);
    }
    let mut text = format!("<message id=\"{id}\"{}>{life}", attribute("name", &name));
    _ = writeln!(text, "<description>{}</description>", prose(chance));
    let (mut fields, mut scope, mut room) = (Vec::<Field>::new(), Scope::default(), MOST_BYTES);
    let count = chance.between(1, 9);
    let mut extended = false;
    let extensions = if chance.one_in(4) { chance.between(1, count) } else { count };
    for nth in 0..count {
        let field = one(chance, purpose, nth, &mut scope, (&*enums, visible));
        if field.bytes() > room {
            continue;
        }
        room -= field.bytes();
        if nth >= extensions && !extended {
            extended = true;
            chance.say(Construct::Extensions);
            text.push_str("<extensions/>\n");
        }
        text.push_str(&written(chance, &field, enums));
        if let Some(of) = field.values.and_then(|of| enums.get_mut(of)) {
            of.uses.push((file, field.scalar));
        }
        fields.push(field);
    }
    text.push_str("</message>\n");
    (Message { name, file, fields }, text)
}

fn one(
    chance: &mut Chance,
    purpose: Purpose,
    nth: usize,
    scope: &mut Scope,
    (enums, visible): (&[Enum], &[usize]),
) -> Field {
    if nth == 3 && chance.maybe(6, Construct::Targets) && scope.take("target_system") && scope.take("target_component")
    {
        let name = ["target_system", "target_component"][chance.below(2)].to_owned();
        return Field { name, scalar: Scalar::unsigned(8), array: None, values: None };
    }
    let name = scope.lower(chance, Construct::OddFieldName);
    let array = match purpose {
        Purpose::Anything if chance.one_in(4) => Some(chance.between(1, 6) as u8),
        Purpose::Words if chance.one_in(4) => Some(chance.between(1, 3) as u8),
        Purpose::Slots(length) if nth > 0 && !chance.one_in(4) => Some(length),
        _ => None,
    };
    let scalar = scalar(chance, purpose, array);
    let carries = matches!(purpose, Purpose::Anything) && chance.one_in(2) || chance.one_in(3);
    let values = if scalar.is_integer() && carries { carried(chance, scalar, (enums, visible)) } else { None };
    if values.is_some() && array.is_some() {
        chance.say(Construct::EnumArray);
    }
    Field { name, scalar, array, values }
}

fn scalar(chance: &mut Chance, purpose: Purpose, array: Option<u8>) -> Scalar {
    let bits = [8, 8, 16, 16, 32, 64][chance.below(6)];
    let unsigned = match purpose {
        Purpose::Anything => 3,
        Purpose::Slots(_) | Purpose::Words => 7,
    };
    match chance.below(unsigned + 4) {
        0 => Scalar::signed(bits),
        1 => Scalar { kind: Kind::Float, bits: if bits == 64 { 64 } else { 32 } },
        2 => {
            if array.is_some() {
                chance.say(Construct::Text);
            }
            Scalar { kind: Kind::Char, bits: 8 }
        }
        3 if array.is_none() && chance.maybe(4, Construct::Version) => Scalar { kind: Kind::Version, bits: 8 },
        _ => Scalar::unsigned(bits),
    }
}

/// An enum for a field of this type: mostly one that is made for it.
fn carried(chance: &mut Chance, scalar: Scalar, (enums, visible): (&[Enum], &[usize])) -> Option<usize> {
    let made_for: Vec<usize> =
        visible.iter().copied().filter(|at| enums.get(*at).is_some_and(|one| one.scalar == scalar)).collect();
    let list = if made_for.is_empty() || chance.one_in(5) { visible } else { &made_for };
    let picked = chance.pick(list).copied()?;
    let one = enums.get(picked)?;
    if one.scalar != scalar {
        chance.say(Construct::ConvertedEnum);
    }
    if one.scalar.bits > scalar.bits {
        chance.say(Construct::WideEnum);
    }
    Some(picked)
}

/// The element of a field.
fn written(chance: &mut Chance, field: &Field, enums: &[Enum]) -> String {
    let carried = field.values.and_then(|of| enums.get(of));
    let array = field.array.map(|length| format!("[{length}]")).unwrap_or_default();
    let units = if chance.one_in(5) {
        attribute("units", chance.word(&["m", "cm/s", "degC", "%", "V", "us"]))
    } else {
        String::new()
    };
    let display = if carried.is_some_and(|one| one.bitmask) && chance.one_in(2) { " display=\"bitmask\"" } else { "" };
    format!(
        "<field type=\"{}{array}\"{}{}{units}{display}{}>{}</field>\n",
        field.scalar.spelled(),
        attribute("name", &field.name),
        optional("enum", carried.map(|one| one.name.as_str())),
        optional("invalid", invalid(chance, field, carried).as_deref()),
        prose(chance)
    )
}

/// A value that means "not known"; mostly none.
fn invalid(chance: &mut Chance, field: &Field, carried: Option<&Enum>) -> Option<String> {
    if !chance.one_in(4) {
        return None;
    }
    let value = match field.scalar.kind {
        Kind::Char => "0".to_owned(),
        _ => sentinel(chance, field.scalar, carried)?,
    };
    chance.say(match field.scalar.kind {
        _ if field.array.is_some() => Construct::InvalidArray,
        Kind::Float => Construct::InvalidNan,
        _ if carried.is_some() => Construct::InvalidEnum,
        _ => Construct::InvalidNumber,
    });
    if field.array.is_none() {
        return Some(value);
    }
    Some([format!("[{value}]"), format!("[{value}:]"), format!("[{value},]"), value.clone()][chance.below(4)].clone())
}

/// A value of that type which may be a sentinel.
pub(crate) fn sentinel(chance: &mut Chance, scalar: Scalar, carried: Option<&Enum>) -> Option<String> {
    let entry = carried.and_then(|one| chance.pick(&one.entries)).filter(|(_, value)| *value <= scalar.most());
    let bits = scalar.bits;
    let sign = if scalar.is_signed() { "" } else { "U" };
    Some(match scalar.kind {
        Kind::Float => chance.word(&["NaN", "0", "-1"]).to_owned(),
        Kind::Char | Kind::Version => return None,
        _ if entry.is_some() && !chance.one_in(3) => entry?.0.clone(),
        Kind::Signed if chance.one_in(3) => "-1".to_owned(),
        _ if chance.one_in(2) => format!("{sign}INT{bits}_MAX"),
        _ => chance.below(100).to_string(),
    })
}
