//! Enums of definitions and overlays.

use std::collections::BTreeSet;
use std::fmt::Write;

use crate::Construct;
use crate::chance::Chance;
use crate::messages::Scalar;
use crate::names;
use crate::xml::{attribute, lifecycle, prose};

/// An enum, with what decides on its width.
pub(crate) struct Enum {
    pub(crate) name: String,
    /// The file that defines it; overlays come after the definitions.
    pub(crate) file: usize,
    pub(crate) bitmask: bool,
    pub(crate) deprecated: bool,
    /// Whether an overlay refines it.
    pub(crate) refined: bool,
    pub(crate) entries: Vec<(String, u64)>,
    /// The integer that it is made for.
    pub(crate) scalar: Scalar,
    /// The fields that carry it, by file.
    pub(crate) uses: Vec<(usize, Scalar)>,
}

impl Enum {
    pub(crate) fn largest(&self) -> u64 {
        self.entries.iter().map(|(_, value)| *value).max().unwrap_or_default()
    }

    /// The integer that mavgen takes for it, as far as that can be told here.
    pub(crate) fn integer(&self) -> Scalar {
        let own = self.uses.iter().filter(|(file, _)| *file == self.file).map(|(_, scalar)| *scalar);
        let widest = own.max_by_key(|scalar| (scalar.bits, !scalar.is_signed())).unwrap_or(Scalar::unsigned(8));
        let wider = [8, 16, 32, 64].map(|bits| Scalar { bits, ..widest });
        let mut fitting =
            wider.into_iter().filter(|scalar| scalar.bits >= widest.bits && scalar.most() >= self.largest());
        fitting.next().unwrap_or(Scalar::unsigned(64))
    }

    /// Whether bits of this width can carry it.
    pub(crate) fn fits(&self, width: u32) -> bool {
        width <= 64 && self.largest() <= u64::MAX >> (64 - width) && self.integer().most() >= u64::MAX >> (64 - width)
    }
}

/// An enum and its text.
pub(crate) fn make(chance: &mut Chance, name: String, file: usize) -> (Enum, String) {
    let bitmask = chance.maybe(3, Construct::Bitmask);
    let scalar = integer(chance);
    let (life, deprecated) = lifecycle(chance, 5);
    if deprecated {
        chance.say(Construct::DeprecatedEnum);
    }
    let mut made =
        Enum { name, file, bitmask, deprecated, refined: false, entries: Vec::new(), scalar, uses: Vec::new() };
    let count = chance.between(1, 6);
    let mut entries = String::new();
    while made.entries.is_empty() {
        entries = add(chance, &mut made, count);
    }
    let mask = if bitmask { " bitmask=\"true\"" } else { "" };
    let text = format!(
        "<enum{}{mask}>{life}<description>{}</description>{entries}</enum>\n",
        attribute("name", &made.name),
        prose(chance)
    );
    (made, text)
}

/// Integers that enums are made for.
fn integer(chance: &mut Chance) -> Scalar {
    let bits = [8, 8, 8, 16, 16, 32, 64][chance.below(7)];
    if bits < 64 && chance.maybe(6, Construct::SignedEnum) { Scalar::signed(bits) } else { Scalar::unsigned(bits) }
}

/// Adds entries to an enum; gives their text.
pub(crate) fn add(chance: &mut Chance, to: &mut Enum, count: usize) -> String {
    let mut text = String::new();
    let mut scope = names::Scope::default();
    to.entries.iter().for_each(|(name, _)| _ = scope.take(name));
    let mut taken: BTreeSet<u64> = to.entries.iter().map(|(_, value)| *value).collect();
    for nth in 0..count {
        let (name, value) = (names::entry(chance, &to.name, nth), value(chance, to, nth));
        if !taken.insert(value) || !scope.take(&name) {
            continue;
        }
        let automatic = !to.bitmask
            && to.entries.last().is_some_and(|(_, last)| last.checked_add(1) == Some(value))
            && to.entries.iter().all(|(_, before)| *before < value)
            && chance.maybe(3, Construct::AutomaticValue);
        let spelled = if chance.one_in(4) { format!("{value:#x}") } else { value.to_string() };
        let spelled = if automatic { String::new() } else { attribute("value", &spelled) };
        let (life, deprecated) = lifecycle(chance, 12);
        if deprecated {
            chance.say(Construct::DeprecatedEntry);
        }
        let named = attribute("name", &name);
        _ = writeln!(text, "<entry{spelled}{named}>{life}<description>{}</description></entry>", prose(chance));
        to.entries.push((name, value));
    }
    text
}

fn value(chance: &mut Chance, of: &Enum, nth: usize) -> u64 {
    let most = of.scalar.most();
    let bits = 64 - most.leading_zeros();
    match (of.bitmask, chance.below(12)) {
        (true, 0) => 0,
        (true, 1) => 3,
        (true, 2) => 1 << (bits - 1),
        (true, _) => 1 << chance.below(bits.min(20) as usize),
        (false, 0) => most,
        (false, 1) => most / 2 + 1,
        (false, 2) => chance.number() & most,
        (false, _) => nth as u64,
    }
}
