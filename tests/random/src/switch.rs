//! What switches look at, and the values of their cases.

use crate::Construct;
use crate::bits::Material;
use crate::chance::Chance;
use crate::xml::attribute;

/// What a switch looks at.
#[derive(Clone)]
pub(crate) struct Selector {
    /// The name that its getter has.
    pub(crate) name: String,
    /// As it stands in the attribute: `name`, `name[i]`.
    pub(crate) word: String,
    pub(crate) on_bits: bool,
    /// The largest value.
    pub(crate) most: u64,
    /// The enum that it carries.
    pub(crate) values: Option<usize>,
}

impl Selector {
    pub(crate) fn on_bits((name, width, values): &(String, u32, Option<usize>)) -> Self {
        let most = u64::MAX >> (64 - width);
        Self { name: name.clone(), word: name.clone(), on_bits: true, most, values: *values }
    }

    pub(crate) fn attribute(&self) -> String {
        attribute(if self.on_bits { "bits" } else { "field" }, &self.word)
    }
}

/// The values of every case; `None` is the default.
pub(crate) fn cases(chance: &mut Chance, material: &Material<'_>, selector: &Selector) -> Vec<Option<String>> {
    let entries: Vec<(String, u64)> = selector
        .values
        .and_then(|at| material.enums.get(at))
        .map(|one| one.entries.iter().filter(|(_, value)| *value <= selector.most).cloned().collect())
        .unwrap_or_default();
    if entries.is_empty() || chance.one_in(4) {
        by_number(chance, selector.most)
    } else {
        by_name(chance, &entries, selector.most)
    }
}

/// Entries, each in one case, and a default unless they are all values.
fn by_name(chance: &mut Chance, entries: &[(String, u64)], most: u64) -> Vec<Option<String>> {
    let mut cases: Vec<String> = Vec::new();
    for (name, _) in entries {
        match cases.last_mut().filter(|_| chance.one_in(2)) {
            Some(case) => *case += &format!(" {name}"),
            None => cases.push(name.clone()),
        }
    }
    let complete = entries.len() as u128 == u128::from(most) + 1;
    let mut cases: Vec<Option<String>> = cases.into_iter().take(3).map(Some).collect();
    let taken: usize = cases.iter().flatten().map(|case| case.split(' ').count()).sum();
    if !complete || taken < entries.len() {
        chance.say(Construct::Default);
        cases.push(None);
    }
    cases
}

/// Numbers and ranges; the last case is open, or a default.
fn by_number(chance: &mut Chance, most: u64) -> Vec<Option<String>> {
    let count = chance.between(1, 3).min(most as usize);
    let (mut from, mut cases) = (0, Vec::new());
    for left in (0..count as u64).rev() {
        let room = most - from - left;
        let to = from + chance.below(room.min(5) as usize) as u64;
        cases.push(Some(match chance.below(3) {
            _ if to == from => from.to_string(),
            0 if to - from >= 2 => format!("{from} {}..={to}", from + 2),
            _ => format!("{from}..={to}"),
        }));
        from = to + 1;
    }
    // A gap that the first of these leaves is the default's.
    let whole = cases.iter().flatten().all(|case: &String| !case.contains(' '));
    if !whole || chance.one_in(2) {
        chance.say(Construct::Default);
        cases.push(None);
    } else {
        cases.push(Some(if from == most { from.to_string() } else { format!("{from}..") }));
    }
    cases
}
