//! Layouts: bits that cover words, and a switch between several ways to do so.

use crate::Construct;
use crate::bits::{Material, Piece, piece};
use crate::chance::Chance;
use crate::names::Scope;
use crate::switch::{self, Selector};

/// The parts of a view of so many bits, as text; `fields` are what a switch can look at.
pub(crate) fn make(chance: &mut Chance, material: &Material<'_>, width: u32, fields: &[Selector]) -> String {
    let mut scope = Scope::default();
    if width < 4 || !chance.one_in(2) {
        return text(&cover(chance, material, &mut scope, (0, width)));
    }
    let split = chance.between(1, width as usize - 2) as u32;
    let common = cover(chance, material, &mut scope, (0, split));
    let Some(selector) = selector(chance, fields, &common) else {
        return text(&common) + &text(&cover(chance, material, &mut scope, (split, width)));
    };
    scope.take(&selector.name);
    let switch = cases(chance, material, (&mut scope, &selector), (split, width));
    if chance.one_in(4) && !selector.on_bits { switch + &text(&common) } else { text(&common) + &switch }
}

fn text(pieces: &[Piece]) -> String {
    pieces.iter().map(|piece| piece.text.as_str()).collect()
}

/// Pieces for all bits from `from` to before `end`.
fn cover(chance: &mut Chance, material: &Material<'_>, scope: &mut Scope, (from, end): (u32, u32)) -> Vec<Piece> {
    let (mut at, mut pieces) = (from, Vec::new());
    while at < end {
        let (more, width) = piece(chance, material, scope, (at, end - at));
        pieces.extend(more);
        at += width;
    }
    pieces
}

/// A field or bits of the common part.
fn selector(chance: &mut Chance, fields: &[Selector], common: &[Piece]) -> Option<Selector> {
    let bits = common.iter().filter_map(|piece| piece.plain.as_ref());
    let bits: Vec<Selector> = bits.map(Selector::on_bits).collect();
    let on_field = bits.is_empty() || chance.one_in(2);
    let selector = chance.pick(if on_field { fields } else { &bits })?.clone();
    chance.say(match (selector.on_bits, selector.values.is_some()) {
        (true, true) => Construct::SwitchEnumBits,
        (true, false) => Construct::SwitchBits,
        (false, true) => Construct::SwitchEnum,
        (false, false) => Construct::SwitchField,
    });
    if selector.word.ends_with("[i]") {
        chance.say(Construct::SwitchElement);
    }
    Some(selector)
}

/// A switch whose cases cover the rest in ways of their own, with some bits alike.
fn cases(
    chance: &mut Chance,
    material: &Material<'_>,
    (scope, selector): (&mut Scope, &Selector),
    (split, width): (u32, u32),
) -> String {
    let cases = switch::cases(chance, material, selector);
    let end = chance.between(split as usize + 1, width as usize) as u32;
    let shared = cover(chance, material, scope, (split, end));
    let by_all = chance.one_in(2);
    let mut text = format!("<switch {}>\n", selector.attribute());
    for (nth, case) in cases.iter().enumerate() {
        let is_shared = by_all || nth == 0 || chance.one_in(2);
        let own = if is_shared { shared.clone() } else { cover(chance, material, scope, (split, end)) };
        chance.say(if by_all { Construct::SharedByAll } else { Construct::SharedBySome });
        let rest = cover(chance, material, scope, (end, width));
        let parts: String = own.iter().chain(&rest).map(|piece| piece.text.as_str()).collect();
        text += &match case {
            Some(values) => format!("<case value=\"{values}\">{parts}</case>\n"),
            None => format!("<default>{parts}</default>\n"),
        };
    }
    text + "</switch>\n"
}
