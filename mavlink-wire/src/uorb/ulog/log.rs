//! A log in memory.

use super::sections::Sections;
use super::{Binding, LogError, Messages, Records, Samples, format};
use crate::uorb::{Topic, Topics};

/// A ULog file in memory.
#[derive(Clone, Debug)]
pub struct Log<'a> {
    sections: Sections<'a>,
}

impl<'a> Log<'a> {
    /// A log of these bytes: a file that was read, a memory map, or a `static`.
    ///
    /// # Errors
    ///
    /// The bytes do not begin as a ULog does, or it has features that a reader must know and this one does not. Damage
    /// further on is no error: see [`Samples::end`].
    pub fn new(bytes: &'a [u8]) -> Result<Self, LogError> {
        Ok(Self { sections: Sections::of(bytes)? })
    }

    /// When the log was started, in microseconds of the clock that its timestamps are of.
    #[must_use]
    pub fn start(&self) -> u64 {
        self.sections.start()
    }

    /// All records, for what is not typed: parameters, texts, events.
    #[must_use]
    pub fn records(&self) -> Records<'a> {
        Records::new(self.sections.clone())
    }

    /// What the log has of the topic that the message is named after: `esc_status` for `EscStatus`.
    #[must_use]
    pub fn read<T: Topic>(&self) -> Samples<'a, T> {
        self.read_topic(T::TOPICS.first().copied().unwrap_or_default())
    }

    /// How records of this topic are read, for a program that takes them from another reader. The definitions are enough of a
    /// log: the first piece of a file that comes piece by piece. `None` if the log does not define it.
    #[must_use]
    pub fn bind<T: Topic>(&self, topic: &str) -> Option<Binding<T>> {
        let records = self.records();
        Binding::of(topic, |name| format::find(&records, name))
    }

    /// What the log has of another topic of the same message, `vehicle_attitude_groundtruth`.
    #[must_use]
    pub fn read_topic<T: Topic>(&self, topic: &'a str) -> Samples<'a, T> {
        Samples::new(self.records(), topic)
    }

    /// What the log has of all topics of an enum, in the order of the log; what the enum does not have is passed over and counted.
    #[must_use]
    pub fn messages<T: Topics>(&self) -> Messages<'a, T> {
        Messages::new(self.records())
    }
}
