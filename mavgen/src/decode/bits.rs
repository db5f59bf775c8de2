//! The packed bits of a view, and what their members hold.

use super::Ratio;
use crate::ir::{EnumId, Meaning, Member, Presence, SwitchOn, View};

/// The bits of a view, read from a message: what the type that is generated for the view holds.
#[derive(Clone, Copy, Debug)]
pub struct Bits<'d> {
    view: &'d View,
    bits: u128,
    /// The value that selects the layout, if a field carries it.
    layout: Option<u64>,
}

/// What a member holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value {
    /// One bit: yes or no.
    Flag(bool),
    /// A value of an enum.
    Entry(EnumId, u64),
    /// A whole number of an unsigned member.
    Unsigned(u128),
    /// A whole number of a signed member.
    Signed(i128),
    /// A number that the bits stand for.
    Scaled(Ratio),
}

impl<'d> Bits<'d> {
    /// The view of these bits; `layout` is the value of the field that its switch looks at.
    #[must_use]
    pub fn new(view: &'d View, bits: u128, layout: Option<u64>) -> Self {
        Self { view, bits, layout }
    }

    /// The view.
    #[must_use]
    pub fn view(&self) -> &'d View {
        self.view
    }

    /// The joined words.
    #[must_use]
    pub fn bits(&self) -> u128 {
        self.bits
    }

    /// Whether the member is in the layout that the bits have.
    #[must_use]
    pub fn has(&self, member: &Member) -> bool {
        let Presence::When(ranges) = &member.presence else { return true };
        let selected = self.selected();
        ranges.iter().any(|range| selected.is_some_and(|value| range.contains(&value)))
    }

    /// What a member holds, number `index` of several alike; `None` where the layout lacks it, or there is no such one.
    #[must_use]
    pub fn value(&self, member: &Member, index: u8) -> Option<Value> {
        let (count, stride) = member.repeat.map_or((1, 0), |repeat| (repeat.count, repeat.stride));
        if index >= count || !self.has(member) {
            return None;
        }
        let at = u32::from(member.at) + u32::from(index) * u32::from(stride);
        let raw = extract(self.bits, at, member.width.into());
        Some(match &member.meaning {
            Meaning::Flag => Value::Flag(raw != 0),
            // An enum has at most 64 bits.
            Meaning::Values(id) => Value::Entry(*id, raw as u64),
            Meaning::Number { .. } if member.signed => Value::Signed(extend(raw, member.width.into())),
            Meaning::Number { .. } => Value::Unsigned(raw),
            Meaning::Scaled(scaled) => {
                // Scaled members have at most 64 bits, so that they are no other number when unsigned.
                let raw = if member.signed { extend(raw, member.width.into()) } else { raw as i128 };
                Value::Scaled(Ratio::of(raw, scaled))
            }
        })
    }

    /// The value that selects the layout.
    fn selected(&self) -> Option<u64> {
        match self.view.switch.as_ref()?.on {
            SwitchOn::Field(..) => self.layout,
            SwitchOn::Bits { at, width } => u64::try_from(extract(self.bits, at.into(), width.into())).ok(),
        }
    }
}

/// `width` bits from bit `at` on.
fn extract(bits: u128, at: u32, width: u32) -> u128 {
    let mask = u128::MAX.checked_shr(128_u32.saturating_sub(width)).unwrap_or_default();
    bits.checked_shr(at).unwrap_or_default() & mask
}

/// Two's complement of so many bits.
fn extend(raw: u128, width: u32) -> i128 {
    let spare = 128_u32.saturating_sub(width);
    // The sign bit goes to the top, and comes back with its copies.
    (raw.checked_shl(spare).unwrap_or_default() as i128).checked_shr(spare).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_cut_out() {
        assert_eq!(extract(0xabcd, 4, 8), 0xbc);
        assert_eq!(extract(u128::MAX, 0, 128), u128::MAX);
        assert_eq!(extract(u128::MAX, 127, 1), 1);
        assert_eq!(extract(u128::MAX, 127, 2), 1, "what is not there is zero");
        assert_eq!((extract(u128::MAX, 128, 1), extract(u128::MAX, 3, 0)), (0, 0));
    }

    #[test]
    fn signs_are_extended() {
        for (raw, width, value) in [(0b111, 3, -1), (0b100, 3, -4), (0b011, 3, 3), (0x1000, 13, -4096), (1, 128, 1)] {
            assert_eq!(extend(raw, width), value, "{raw:#b} of {width} bits");
        }
        assert_eq!((extend(u128::MAX, 128), extend(0, 0)), (-1, 0));
    }
}
