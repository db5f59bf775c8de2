//! The records of all topics that an enum has, in the order of the log.

use core::fmt;

use super::{End, Records, format};
use crate::uorb::Topics;
use crate::uorb::any::Reader;

/// Subscriptions that are remembered: PX4's logger has no more than 255.
const SUBSCRIPTIONS: usize = 256;

/// A message of a log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Logged<T> {
    /// The topic that carried it: `vehicle_attitude_groundtruth` is one of several of `VehicleAttitude`.
    pub topic: &'static str,
    /// The instance, 0 for the first.
    pub instance: u8,
    /// The message.
    pub message: T,
}

/// Iterates over the messages of a log that an enum has, in the order of the log. Nothing is allocated: it is as large as what it
/// remembers of the topics.
pub struct Messages<'a, T: Topics> {
    records: Records<'a>,
    start: Records<'a>,
    bindings: T::Bindings,
    subscriptions: [Slot<T>; SUBSCRIPTIONS],
    unreadable: usize,
    unknown: usize,
}

/// A message id, and what it stands for.
enum Slot<T: Topics> {
    Free,
    /// A topic that the enum does not have, or none any more.
    Other(u16),
    Known(u16, u8, Reader<T>),
}

impl<T: Topics> Slot<T> {
    fn id(&self) -> Option<u16> {
        match self {
            Self::Free => None,
            Self::Other(id) | Self::Known(id, ..) => Some(*id),
        }
    }
}

impl<'a, T: Topics> Messages<'a, T> {
    pub(super) fn new(records: Records<'a>) -> Self {
        let subscriptions = [const { Slot::Free }; SUBSCRIPTIONS];
        Self { start: records.clone(), records, bindings: T::UNBOUND, subscriptions, unreadable: 0, unknown: 0 }
    }

    /// Records of the enum's topics that could not be read so far: too short, or of a format that is none.
    #[must_use]
    pub const fn unreadable(&self) -> usize {
        self.unreadable
    }

    /// Records of data so far that are of topics that the enum does not have, or of a 257th subscription.
    #[must_use]
    pub const fn unknown(&self) -> usize {
        self.unknown
    }

    /// How the log ends, as far as it was read: final when the iterator has given `None`.
    #[must_use]
    pub const fn end(&self) -> End {
        self.records.end()
    }

    /// The slot of a message id, or where it would be.
    fn slot(&mut self, id: u16) -> Option<&mut Slot<T>> {
        let is_own = |slot: &Slot<T>| slot.id().is_none_or(|own| own == id);
        let begin = usize::from(id) % SUBSCRIPTIONS;
        let (before, behind) = self.subscriptions.split_at_mut_checked(begin)?;
        behind.iter_mut().chain(before).find(|slot| is_own(slot))
    }

    fn subscribe(&mut self, id: u16, instance: u8, topic: &[u8]) {
        let start = &self.start;
        let topic = core::str::from_utf8(topic).unwrap_or_default();
        let reader = T::bind(&mut self.bindings, topic, &|name| format::find(start, name));
        if let Some(slot) = self.slot(id) {
            *slot = reader.map_or(Slot::Other(id), |reader| Slot::Known(id, instance, reader));
        }
    }

    fn read(&mut self, id: u16, record: &[u8]) -> Option<Logged<T>> {
        let Some(&mut Slot::Known(_, instance, reader)) = self.slot(id) else {
            self.unknown += 1;
            return None;
        };
        let message = reader.read(&self.bindings, record);
        self.unreadable += usize::from(message.is_none());
        Some(Logged { topic: reader.topic, instance, message: message? })
    }
}

impl<T: Topics> fmt::Debug for Messages<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { records, unreadable, unknown, .. } = self;
        let mut all = f.debug_struct("Messages");
        all.field("records", records).field("unreadable", unreadable).field("unknown", unknown).finish_non_exhaustive()
    }
}

impl<T: Topics> Iterator for Messages<'_, T> {
    type Item = Logged<T>;

    fn next(&mut self) -> Option<Logged<T>> {
        loop {
            let record = self.records.next()?;
            match (record.kind, record.payload) {
                (b'D', [low, high, data @ ..]) => {
                    if let Some(logged) = self.read(u16::from_le_bytes([*low, *high]), data) {
                        return Some(logged);
                    }
                }
                (b'A', [instance, low, high, topic @ ..]) => {
                    self.subscribe(u16::from_le_bytes([*low, *high]), *instance, topic);
                }
                (b'R', [low, high, ..]) => {
                    let id = u16::from_le_bytes([*low, *high]);
                    if let Some(slot @ Slot::Known(..)) = self.slot(id) {
                        *slot = Slot::Other(id);
                    }
                }
                _ => {}
            }
        }
    }
}
