//! Enums and flags: constants of a file that are the values, or the bits, of a field.

use super::model::{Constant, Entry, Enum, EnumIndex, MessageIndex};
use crate::collect::CollectVec as _;
use crate::ir::{Name, Repr};
use crate::source::Span;

/// The constants that a field takes, and the type that they become.
pub(super) struct Claim<'c> {
    /// The name of the enum.
    pub(super) name: Name,
    /// Whether values are combined bit by bit.
    pub(super) flags: bool,
    /// Whether the constants are numbers of bits, not values.
    pub(super) bits: bool,
    /// The type of the field.
    pub(super) repr: Repr,
    /// The constants, in the order of the file, each with the beginning of its name that entries do not have.
    pub(super) constants: Vec<(&'c Constant, &'c str)>,
}

impl Claim<'_> {
    /// The value of an entry; `None` if the field cannot have it.
    pub(super) fn value(&self, constant: &Constant) -> Option<i128> {
        if self.bits {
            let bit = u32::try_from(constant.value).ok().filter(|bit| *bit < 8 * self.repr.size() as u32)?;
            return Some(1_i128 << bit);
        }
        let highest = i128::from(self.repr.highest());
        let lowest = if self.repr.is_signed() { -highest - 1 } else { 0 };
        (lowest..=highest).contains(&constant.value).then_some(constant.value)
    }

    /// The enum of all constants that fit.
    pub(super) fn into_enum(self, message: MessageIndex) -> Enum {
        let labels = self.constants.iter().map(|(constant, stem)| label(&constant.name, stem)).collect_vec();
        let entry = |(i, (constant, _)): (usize, &(&Constant, &str))| {
            let value = self.value(constant)?;
            let label = labels.get(i).copied()?;
            let is_unique = labels.iter().filter(|other| **other == label).count() == 1;
            let label = if is_unique { label } else { &constant.name }.to_owned();
            Some(Entry { label, value, constant: (*constant).clone() })
        };
        let entries = self.constants.iter().enumerate().filter_map(entry).collect_vec();
        Enum { name: self.name.clone(), message, flags: self.flags, repr: self.repr, entries }
    }
}

/// The name of a constant without its beginning. What would begin with a digit keeps one word more.
fn label<'n>(name: &'n str, stem: &str) -> &'n str {
    let rest = name.strip_prefix(stem).unwrap_or(name);
    if rest.starts_with(|first: char| first.is_ascii_alphabetic()) {
        return rest;
    }
    let shorter = stem.trim_end_matches('_').rsplit_once('_').map_or(0, |(before, _)| before.len() + 1);
    name.get(shorter..).unwrap_or(name)
}

/// Why an enum cannot come into the package: another has its name.
pub(super) struct NameTaken {
    /// Where the other was named.
    pub(super) first: Span,
    /// Whether the two differ in their type alone.
    pub(super) type_alone: bool,
}

/// Puts an enum among those of the package. One that two fields describe alike is one.
pub(super) fn add(made: Enum, enums: &mut Vec<Enum>) -> Result<EnumIndex, NameTaken> {
    let Some(index) = enums.iter().position(|known| known.name == made.name) else {
        enums.push(made);
        return Ok(EnumIndex(enums.len() - 1));
    };
    let Some(known) = enums.get(index) else { return Ok(EnumIndex(index)) };
    let names = |one: &Enum| one.entries.iter().map(|entry| entry.constant.name.clone()).collect_vec();
    let alike = known.message == made.message && known.flags == made.flags && names(known) == names(&made);
    if alike && known.repr == made.repr {
        return Ok(EnumIndex(index));
    }
    Err(NameTaken { first: known.name.span, type_alone: alike })
}

/// The name of the enum that `[@enum P]` makes: the message, and P without the words that both have in common.
pub(super) fn name_of(message: &str, prefix: &str) -> String {
    let words = super::topic_name(message).split('_').map(str::to_owned).collect_vec();
    let own = prefix.split('_').filter(|word| !word.is_empty()).map(str::to_ascii_lowercase).collect_vec();
    let leading = words.iter().zip(&own).take_while(|(word, own)| word == own).count();
    let trailing =
        (1..=own.len().min(words.len())).rev().find(|count| words.get(words.len() - count..) == own.get(..*count));
    let common = if leading > 0 { leading } else { trailing.unwrap_or(0) };
    let kept = own.get(common.min(own.len().saturating_sub(1))..).unwrap_or_default();
    let mut name = message.to_owned();
    for word in kept {
        let mut letters = word.chars();
        name.extend(letters.next().map(|first| first.to_ascii_uppercase()));
        name.push_str(letters.as_str());
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_enums() {
        for (message, prefix, expected) in [
            ("EscReport", "FAILURE", "EscReportFailure"),
            ("EscReport", "ESC_FAILURE", "EscReportFailure"),
            ("EscStatus", "ESC_CONNECTION_TYPE", "EscStatusConnectionType"),
            ("GeneratorStatus", "STATUS_FLAG", "GeneratorStatusFlag"),
            ("GotoSetpoint", "GOTO_SETPOINT", "GotoSetpointSetpoint"),
            ("Airspeed", "SOURCE", "AirspeedSource"),
            ("A", "B__C", "ABC"),
        ] {
            assert_eq!(name_of(message, prefix), expected, "{message} {prefix}");
        }
    }

    #[test]
    fn labels_begin_with_a_letter() {
        for (name, stem, expected) in [
            ("FAILURE_OVER_RPM", "FAILURE_", "OVER_RPM"),
            ("FIX_TYPE_3D", "FIX_TYPE_", "TYPE_3D"),
            ("FIX_3D", "FIX_", "FIX_3D"),
            ("FIX__X", "FIX_", "FIX__X"),
            ("OTHER", "OTHER", "OTHER"),
        ] {
            assert_eq!(label(name, stem), expected, "{name}");
        }
    }
}
