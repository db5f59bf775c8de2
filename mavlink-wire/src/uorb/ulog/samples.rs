//! The records of one topic.

use super::{Binding, End, Fit, Records, format};
use crate::uorb::Topic;

/// PX4 has no more instances of a topic.
const INSTANCES: usize = 10;

/// Iterates over what a log has of a topic: the instance, 0 for the first, and the message. Nothing is allocated.
pub struct Samples<'a, T: Topic> {
    records: Records<'a>,
    start: Records<'a>,
    topic: &'a str,
    binding: Option<Binding<T>>,
    /// Message id and instance of each subscription.
    subscriptions: [Option<(u16, u8)>; INSTANCES],
    unreadable: usize,
}

impl<'a, T: Topic> Samples<'a, T> {
    pub(super) fn new(records: Records<'a>, topic: &'a str) -> Self {
        let binding = Binding::of(topic, |name| format::find(&records, name));
        Self { start: records.clone(), records, topic, binding, subscriptions: [None; INSTANCES], unreadable: 0 }
    }

    /// Records of the topic that could not be read so far: too short, of a format that is none, or of an eleventh instance.
    #[must_use]
    pub const fn unreadable(&self) -> usize {
        self.unreadable
    }

    /// How the log ends, as far as it was read: final when the iterator has given `None`.
    #[must_use]
    pub const fn end(&self) -> End {
        self.records.end()
    }

    /// How the fields of the log fit those of the topic.
    #[must_use]
    pub fn fit(&self) -> Fit<'a, T> {
        Fit::new(self.start.clone(), self.topic)
    }

    fn subscribe(&mut self, instance: u8, id: u16) {
        let known = self.subscriptions.iter().position(|slot| slot.is_some_and(|(known, _)| known == id));
        let free = || self.subscriptions.iter().position(Option::is_none);
        match known.or_else(free).and_then(|i| self.subscriptions.get_mut(i)) {
            Some(slot) => *slot = Some((id, instance)),
            None => self.unreadable += 1,
        }
    }

    fn unsubscribe(&mut self, id: u16) {
        for slot in &mut self.subscriptions {
            slot.take_if(|(known, _)| *known == id);
        }
    }

    fn instance(&self, id: u16) -> Option<u8> {
        self.subscriptions.iter().flatten().find(|(known, _)| *known == id).map(|(_, instance)| *instance)
    }
}

impl<T: Topic> Iterator for Samples<'_, T> {
    type Item = (u8, T);

    fn next(&mut self) -> Option<(u8, T)> {
        loop {
            let record = self.records.next()?;
            match (record.kind, record.payload) {
                (b'D', [low, high, data @ ..]) => {
                    let Some(instance) = self.instance(u16::from_le_bytes([*low, *high])) else { continue };
                    match self.binding.as_ref().and_then(|binding| binding.read(data)) {
                        Some(sample) => return Some((instance, sample)),
                        None => self.unreadable += 1,
                    }
                }
                (b'A', [instance, low, high, name @ ..]) if name == self.topic.as_bytes() => {
                    self.subscribe(*instance, u16::from_le_bytes([*low, *high]));
                }
                // The id means another topic from here on.
                (b'A', [_, low, high, ..]) | (b'R', [low, high, ..]) => {
                    self.unsubscribe(u16::from_le_bytes([*low, *high]));
                }
                _ => {}
            }
        }
    }
}
