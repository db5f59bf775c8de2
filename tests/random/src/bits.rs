//! One `<bits>`: its width, its meaning, its text.

use crate::Construct;
use crate::chance::Chance;
use crate::enums::Enum;
use crate::names::Scope;
use crate::xml::{attribute, prose};

/// Scales, with units in which every value is whole.
const SCALES: [(&str, &str); 7] = [
    (" scale=\"1/100\" units=\"V\"", " exact=\"mV\""),
    (" scale=\"0.25\" units=\"degC\"", " exact=\"cdegC\""),
    (" scale=\"1/4\" bias=\"-32\" units=\"degC\"", " exact=\"mdegC\""),
    (" scale=\"-0.5\" bias=\"7\" units=\"m\"", " exact=\"dm\""),
    (" scale=\"100/255\" units=\"%\"", ""),
    (" bias=\"-1/3\"", ""),
    (" scale=\"-1e-3\" units=\"s\"", " exact=\"us\""),
];

/// Bits of one kind somewhere, with the text that stands in an element.
#[derive(Clone)]
pub(crate) struct Piece {
    /// The text; `at` and more is in it.
    pub(crate) text: String,
    /// The name of plain bits, which a switch can look at, with their width and enum.
    pub(crate) plain: Option<(String, u32, Option<usize>)>,
}

/// What pieces are made from.
pub(crate) struct Material<'a> {
    pub(crate) enums: &'a [Enum],
    /// The enums that may be named.
    pub(crate) visible: &'a [usize],
    /// `partial="true"`.
    pub(crate) partial: bool,
}

/// A piece of at most `room` bits from `at` on; `None` leaves them out. Gives the bits that it takes.
pub(crate) fn piece(
    chance: &mut Chance,
    material: &Material<'_>,
    scope: &mut Scope,
    (at, room): (u32, u32),
) -> (Vec<Piece>, u32) {
    let width = match chance.below(6) {
        0 => 1,
        1 => chance.between(1, room as usize) as u32,
        _ => chance.between(1, 12) as u32,
    }
    .min(room);
    match chance.below(9) {
        0 if material.partial => (Vec::new(), width),
        0 => (vec![reserved(at, width)], width),
        1 if room >= 4 => repeated(chance, material, scope, (at, room)),
        _ => {
            let name = scope.lower(chance, Construct::OddGetterName);
            let Meaning { text, carried, plain } = meaning(chance, material, width, false);
            let plain = plain.then(|| (name.clone(), width, carried));
            (vec![Piece { text: written(chance, &name, (at, width), &text), plain }], width)
        }
    }
}

fn written(chance: &mut Chance, name: &str, (at, width): (u32, u32), more: &str) -> String {
    let prose = prose(chance);
    format!("<bits{} at=\"{at}\" width=\"{width}\"{more}>{prose}</bits>\n", attribute("name", name))
}

pub(crate) fn reserved(at: u32, width: u32) -> Piece {
    Piece { text: format!("<reserved at=\"{at}\" width=\"{width}\"/>\n"), plain: None }
}

/// Several alike, with reserved bits between them where there is a stride.
fn repeated(
    chance: &mut Chance,
    material: &Material<'_>,
    scope: &mut Scope,
    (at, room): (u32, u32),
) -> (Vec<Piece>, u32) {
    let width = chance.between(1, (room as usize / 2).min(9)) as u32;
    let stride = if chance.one_in(2) { chance.between(width as usize, room as usize / 2) as u32 } else { width };
    let count = chance.between(2, ((room / stride) as usize).min(6)) as u32;
    chance.say(Construct::Repeat);
    let name = scope.lower(chance, Construct::OddGetterName);
    let Meaning { mut text, carried, plain } = meaning(chance, material, width, true);
    if carried.is_some() || !plain {
        chance.say(Construct::RepeatMeaning);
    }
    text += &attribute("repeat", &count.to_string());
    let mut pieces = Vec::new();
    if stride > width {
        chance.say(Construct::Stride);
        text += &attribute("stride", &stride.to_string());
        if !material.partial {
            pieces.extend((0..count).map(|nth| reserved(at + nth * stride + width, stride - width)));
        }
    }
    pieces.push(Piece { text: written(chance, &name, (at, width), &text), plain: None });
    (pieces, count * stride)
}

struct Meaning {
    text: String,
    carried: Option<usize>,
    /// Whether a switch can look at it.
    plain: bool,
}

impl Meaning {
    fn of(text: impl Into<String>, plain: bool) -> Self {
        Self { text: text.into(), carried: None, plain }
    }
}

fn meaning(chance: &mut Chance, material: &Material<'_>, width: u32, repeated: bool) -> Meaning {
    let fitting = |at: &&usize| material.enums.get(**at).is_some_and(|one| one.fits(width));
    let fitting: Vec<usize> = material.visible.iter().filter(fitting).copied().collect();
    if !fitting.is_empty() && chance.one_in(2) {
        let carried = chance.pick(&fitting).copied();
        return carries(chance, material, carried);
    }
    if width == 1 && !chance.one_in(4) {
        chance.say(Construct::Flag);
        return Meaning::of("", true);
    }
    let signed = width > 1 && chance.maybe(4, Construct::Signed);
    let sign = if signed { " signed=\"true\"" } else { "" };
    if width <= 32 && chance.one_in(3) {
        return Meaning::of(scaled(chance, signed) + sign, false);
    }
    if width > 64 {
        chance.say(Construct::WideNumber);
    }
    chance.say(Construct::Number);
    let units = if chance.maybe(4, Construct::Units) {
        attribute("units", chance.word(&["ms", "rpm", "%"]))
    } else {
        String::new()
    };
    Meaning::of(units + sign, !signed && !repeated && width <= 64)
}

fn carries(chance: &mut Chance, material: &Material<'_>, carried: Option<usize>) -> Meaning {
    let Some(one) = carried.and_then(|at| material.enums.get(at)) else { return Meaning::of("", true) };
    chance.say(if one.bitmask { Construct::FlagsBits } else { Construct::EnumBits });
    if one.deprecated {
        chance.say(Construct::DeprecatedBits);
    }
    Meaning { text: attribute("enum", &one.name), carried, plain: true }
}

fn scaled(chance: &mut Chance, signed: bool) -> String {
    let (scale, exact) = SCALES[chance.below(SCALES.len())];
    chance.say(Construct::Scale);
    if signed {
        chance.say(Construct::SignedScale);
    }
    if scale.contains("\"-") {
        chance.say(Construct::NegativeScale);
    }
    let mut text = scale.to_owned();
    if !exact.is_empty() && chance.maybe(2, Construct::Exact) {
        text += exact;
    }
    text
}
