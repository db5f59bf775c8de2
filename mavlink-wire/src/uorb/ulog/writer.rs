//! Writes logs.

use std::io::{self, ErrorKind, Write};
use std::string::{String, ToString};
use std::vec::Vec;
use std::{format, vec};

use crate::uorb::Topic;

/// A log that is begun: what it says of itself, and what topics it has, before any data.
///
/// ```no_run
/// # use mavlink_wire::uorb::{Topic, ulog::Writer};
/// # fn write<T: Topic>(samples: &[T]) -> std::io::Result<()> {
/// let file = std::io::BufWriter::new(std::fs::File::create("flight.ulg")?);
/// let mut log = Writer::new(file, 0).info("sys_name", "AutoQuad").topic::<T>().begin()?;
/// for sample in samples {
///     log.write(0, sample)?;
/// }
/// log.finish()?;
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Writer<W> {
    to: W,
    start: u64,
    infos: Vec<(String, String)>,
    topics: Vec<LoggedTopic>,
}

/// What is written of a topic.
#[derive(Clone, Copy, Debug)]
struct LoggedTopic {
    name: &'static str,
    formats: &'static [&'static str],
}

impl<W: Write> Writer<W> {
    /// A log that starts at this time, in microseconds of the clock that its timestamps are of.
    pub fn new(to: W, start: u64) -> Self {
        Self { to, start, infos: vec![], topics: vec![] }
    }

    /// Adds a text about the vehicle or the log: `sys_name`, `ver_sw`.
    #[must_use]
    pub fn info(mut self, name: &str, text: &str) -> Self {
        self.infos.push((name.to_string(), text.to_string()));
        self
    }

    /// Adds a topic, of its newest definition.
    #[must_use]
    pub fn topic<T: Topic>(mut self) -> Self {
        if let (Some(name), Some(newest)) = (T::TOPICS.first(), T::DEFINITIONS.first()) {
            self.topics.push(LoggedTopic { name, formats: newest.formats });
        }
        self
    }

    /// Writes what stands before the data.
    ///
    /// # Errors
    ///
    /// Of what is written to; and a name and text that are longer than a record.
    pub fn begin(mut self) -> io::Result<DataWriter<W>> {
        self.to.write_all(b"ULog\x01\x12\x35\x01")?;
        self.to.write_all(&self.start.to_le_bytes())?;
        record(&mut self.to, b'B', &[&[0; 40]])?;
        let mut written: Vec<&str> = vec![];
        for format in self.topics.iter().flat_map(|topic| topic.formats) {
            if !written.contains(format) {
                record(&mut self.to, b'F', &[format.as_bytes()])?;
                written.push(format);
            }
        }
        for (name, text) in &self.infos {
            let key = format!("char[{}] {name}", text.len());
            let length = u8::try_from(key.len()).map_err(|_| too_long())?;
            record(&mut self.to, b'I', &[&[length], key.as_bytes(), text.as_bytes()])?;
        }
        let mut log = DataWriter { to: self.to, topics: self.topics, subscriptions: vec![], record: vec![] };
        for i in 0..log.topics.len() {
            log.subscribe(i, 0)?;
        }
        Ok(log)
    }
}

/// A log that takes data.
#[derive(Debug)]
pub struct DataWriter<W> {
    to: W,
    topics: Vec<LoggedTopic>,
    /// Topic and instance of each message id.
    subscriptions: Vec<(usize, u8)>,
    record: Vec<u8>,
}

impl<W: Write> DataWriter<W> {
    /// Writes a message of an instance of its topic, 0 for the first.
    ///
    /// # Errors
    ///
    /// Of what is written to; `InvalidInput` for a topic that [`Writer::topic`] did not add, and for a field that holds what the
    /// newest definition cannot.
    pub fn write<T: Topic>(&mut self, instance: u8, message: &T) -> io::Result<()> {
        let (topic, length) = self.topic::<T>().ok_or_else(|| {
            io::Error::new(ErrorKind::InvalidInput, format!("{} is none of the topics of this log", T::NAME))
        })?;
        let known = self.subscriptions.iter().position(|known| *known == (topic, instance));
        let id = match known {
            Some(id) => id,
            None => self.subscribe(topic, instance)?,
        };
        self.record.clear();
        self.record.resize(length, 0);
        message.store_record(&mut self.record).map_err(|error| io::Error::new(ErrorKind::InvalidInput, error))?;
        record(&mut self.to, b'D', &[&message_id(id)?, &self.record])
    }

    /// Writes what is buffered, and gives back what was written to.
    ///
    /// # Errors
    ///
    /// Of what is written to.
    pub fn finish(mut self) -> io::Result<W> {
        self.to.flush()?;
        Ok(self.to)
    }

    fn topic<T: Topic>(&self) -> Option<(usize, usize)> {
        let name = T::TOPICS.first()?;
        let topic = self.topics.iter().position(|topic| topic.name == *name)?;
        Some((topic, usize::try_from(T::DEFINITIONS.first()?.record_len).ok()?))
    }

    fn subscribe(&mut self, topic: usize, instance: u8) -> io::Result<usize> {
        let id = self.subscriptions.len();
        let name = self.topics.get(topic).map_or("", |topic| topic.name);
        record(&mut self.to, b'A', &[&[instance], &message_id(id)?, name.as_bytes()])?;
        self.subscriptions.push((topic, instance));
        Ok(id)
    }
}

fn message_id(id: usize) -> io::Result<[u8; 2]> {
    u16::try_from(id)
        .map(u16::to_le_bytes)
        .map_err(|_| io::Error::new(ErrorKind::InvalidInput, "more topics than a log can have"))
}

fn too_long() -> io::Error {
    io::Error::new(ErrorKind::InvalidInput, "longer than a record of a log can be")
}

fn record(to: &mut impl Write, kind: u8, parts: &[&[u8]]) -> io::Result<()> {
    let length: usize = parts.iter().map(|part| part.len()).sum();
    let [low, high] = u16::try_from(length).map_err(|_| too_long())?.to_le_bytes();
    to.write_all(&[low, high, kind])?;
    parts.iter().try_for_each(|part| to.write_all(part))
}
