//! The messages that are not known, and were seen where nothing else could be.

use crate::frame::Facts;

/// How many messages are remembered.
const MESSAGES: usize = 8;

/// The unknown messages that were seen last, the latest first.
#[derive(Clone, Debug)]
pub(super) struct Sightings {
    /// What [`message`] makes of their frames; 0 before there are eight.
    latest: [u32; MESSAGES],
    /// Of each, whether the last two frames had this `crc_extra`.
    alike: [bool; MESSAGES],
}

impl Sightings {
    pub(super) const NONE: Self = Self { latest: [0; MESSAGES], alike: [false; MESSAGES] };

    /// Whether the last two sightings of the message had the `crc_extra` of this frame.
    pub(super) fn are_alike(&self, facts: Facts) -> bool {
        self.latest.iter().zip(&self.alike).any(|(&seen, &alike)| alike && seen == message(facts))
    }

    /// Adds that of this frame; of eight others, that of the message which was not seen for longest is forgotten.
    pub(super) fn add(&mut self, facts: Facts) {
        let message = message(facts);
        let (mut earlier, mut earlier_alike) = (message, false);
        for (place, alike) in self.latest.iter_mut().zip(&mut self.alike) {
            core::mem::swap(place, &mut earlier);
            core::mem::swap(alike, &mut earlier_alike);
            if earlier >> 8 == message >> 8 {
                break;
            }
        }
        let [first, ..] = &mut self.alike;
        *first = earlier == message;
    }
}

/// Id and, in the low byte, `crc_extra`; inverted, so that 0 is of no message: nobody uses the last id.
fn message(facts: Facts) -> u32 {
    !(facts.id << 8 | u32::from(facts.crc_extra))
}
