//! Which frames never arrived, as far as their numbers tell.

use core::fmt;

use crate::{ComponentId, Frame, SystemId};

/// So far back a number is a late frame, not a gap that goes almost all the way round.
const LATE: u8 = 16;

/// So long a gap that ends at zero is the start of a sender: losses make no such gap, or all counts are guesses.
const RESTART: u8 = 128;

/// The radio that SiK firmware makes up on both sides of its link (`3D`), which numbers its frames by no rule.
const SIK_RADIO: (SystemId, ComponentId) = (SystemId::from_u8(b'3'), ComponentId::from_u8(b'D'));

/// Counts received and lost frames of each component, by their sequence numbers; up to `N` components.
///
/// Give it every frame, also of messages that are not known: all of them are numbered. The rules, for a frame whose number is
/// `n` where `e` was expected, all modulo 256:
///
/// - `n = e`: nothing is lost.
/// - `n = e − 1`: a duplicate, as over two paths to the same system.
/// - `n` up to 16 before `e`: late. It was counted as lost before, and is taken back.
/// - `n = 0`, 128 or more behind `e`: the sender has started again; nothing is counted as lost. A sender that starts again
///   further on in its numbers cannot be told from a gap, and is counted as one.
/// - All else: `n − e` frames are lost. Of a gap of 240 or more only the rest by 256 shows, or nothing at all.
///
/// pymavlink's `mav_loss` takes every difference for a loss; what is in order counts alike. Like there, frames of SiK radios
/// (system 51, component 68) are left out. Frames that are not verified count for a component that a verified one introduced:
/// damage introduces none.
///
/// When a further component appears, the one that was not heard for longest is forgotten.
///
/// ```
/// use mavlink_wire::{Frame, Losses, MessageInfo, Table};
///
/// # const HEARTBEAT: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
/// # let table = &Table::of(&[HEARTBEAT]);
/// # let bytes = [0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
/// # let frame = Frame::parse(&bytes, table).unwrap();
/// let mut losses: Losses<4> = Losses::new();
/// losses.count(&frame);
/// for sender in losses.iter() {
///     println!("{}/{}: {} received, {} lost", sender.system_id, sender.component_id, sender.received, sender.lost);
/// }
/// # assert_eq!(losses.total().received, 1);
/// ```
#[derive(Clone, Debug)]
pub struct Losses<const N: usize = 16> {
    senders: [Sequence; N],
    /// Frames counted so far: when a sender was heard last.
    counted: u64,
}

/// What one component sent, and what of it was lost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub struct Received {
    /// Id of the sending system.
    pub system_id: SystemId,
    /// Id of the sending component of that system.
    pub component_id: ComponentId,
    /// Frames received, late ones and duplicates among them.
    pub received: u64,
    /// Frames that never arrived.
    pub lost: u64,
    /// Frames that arrived behind later ones.
    pub late: u64,
    /// Frames that arrived right after themselves.
    pub duplicates: u64,
    /// How often the sender started again.
    pub restarts: u64,
}

/// What the number of a frame tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub enum Arrival {
    /// The first frame of this component.
    First,
    /// The expected frame.
    Next,
    /// So many before it were lost.
    Gap(u8),
    /// It came before, right now.
    Duplicate,
    /// It comes behind later frames.
    Late,
    /// The component has started again.
    Restart,
    /// Not counted: a SiK radio's, or an unverified frame of a component that no verified one introduced.
    Ignored,
}

/// `next`, `gap of 3`, `duplicate`.
impl fmt::Display for Arrival {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::First => "first",
            Self::Next => "next",
            Self::Gap(lost) => return write!(f, "gap of {lost}"),
            Self::Duplicate => "duplicate",
            Self::Late => "late",
            Self::Restart => "restart",
            Self::Ignored => "ignored",
        })
    }
}

/// The numbers of one component.
#[derive(Clone, Copy, Debug)]
struct Sequence {
    received: Received,
    expected: u8,
    /// Count of all frames when it was heard last; 0 in a place that nobody has.
    heard: u64,
}

impl<const N: usize> Losses<N> {
    /// Nothing counted.
    #[must_use]
    pub const fn new() -> Self {
        let received = Received::of(SystemId::BROADCAST, ComponentId::BROADCAST);
        Self { senders: [Sequence { received, expected: 0, heard: 0 }; N], counted: 0 }
    }

    /// Counts a frame.
    pub fn count(&mut self, frame: &Frame<'_>) -> Arrival {
        let (system_id, component_id) = (frame.system_id(), frame.component_id());
        if (system_id, component_id) == SIK_RADIO {
            return Arrival::Ignored;
        }
        let known = self.senders.iter_mut().find(|sender| sender.is(system_id, component_id));
        let (sequence, arrival) = match known {
            Some(sequence) => {
                let arrival = sequence.arrival(frame.sequence());
                (sequence, arrival)
            }
            None if !frame.is_verified() => return Arrival::Ignored,
            None => {
                let Some(sequence) = self.senders.iter_mut().min_by_key(|sender| sender.heard) else {
                    return Arrival::Ignored;
                };
                sequence.received = Received::of(system_id, component_id);
                (sequence, Arrival::First)
            }
        };
        self.counted += 1;
        sequence.heard = self.counted;
        sequence.take(arrival, frame.sequence());
        arrival
    }

    /// What this component sent, if any of it was counted.
    #[must_use]
    pub fn of(&self, system_id: impl Into<SystemId>, component_id: impl Into<ComponentId>) -> Option<Received> {
        let ids = (system_id.into(), component_id.into());
        self.iter().find(|received| (received.system_id, received.component_id) == ids)
    }

    /// What each component sent, in no order.
    pub fn iter(&self) -> impl Iterator<Item = Received> {
        self.senders.iter().filter(|sender| sender.heard > 0).map(|sender| sender.received)
    }

    /// The sum over the components that are not forgotten; its ids are 0.
    #[must_use]
    pub fn total(&self) -> Received {
        self.iter().fold(Received::default(), |sum, one| Received {
            received: sum.received + one.received,
            lost: sum.lost + one.lost,
            late: sum.late + one.late,
            duplicates: sum.duplicates + one.duplicates,
            restarts: sum.restarts + one.restarts,
            ..sum
        })
    }
}

impl<const N: usize> Default for Losses<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl Received {
    /// Nothing of this component.
    const fn of(system_id: SystemId, component_id: ComponentId) -> Self {
        Self { system_id, component_id, received: 0, lost: 0, late: 0, duplicates: 0, restarts: 0 }
    }

    /// What share of the frames was lost, 0 to 1; 0 if there were none.
    #[must_use]
    pub fn loss(&self) -> f32 {
        let sent = (self.received + self.lost).max(1);
        self.lost as f32 / sent as f32
    }
}

impl Sequence {
    fn is(&self, system_id: SystemId, component_id: ComponentId) -> bool {
        self.heard > 0 && (self.received.system_id, self.received.component_id) == (system_id, component_id)
    }

    /// What this number tells.
    fn arrival(&self, number: u8) -> Arrival {
        match number.wrapping_sub(self.expected) {
            0 => Arrival::Next,
            255 => Arrival::Duplicate,
            gap if gap >= LATE.wrapping_neg() => Arrival::Late,
            gap if number == 0 && gap >= RESTART => Arrival::Restart,
            gap => Arrival::Gap(gap),
        }
    }

    /// Counts a frame that has arrived like this.
    fn take(&mut self, arrival: Arrival, number: u8) {
        let received = &mut self.received;
        received.received += 1;
        match arrival {
            Arrival::Duplicate => received.duplicates += 1,
            Arrival::Late => {
                received.late += 1;
                received.lost = received.lost.saturating_sub(1);
            }
            Arrival::Restart => received.restarts += 1,
            Arrival::Gap(gap) => received.lost += u64::from(gap),
            Arrival::First | Arrival::Next | Arrival::Ignored => {}
        }
        if !matches!(arrival, Arrival::Duplicate | Arrival::Late) {
            self.expected = number.wrapping_add(1);
        }
    }
}
