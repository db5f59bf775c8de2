//! What a topic was at one time: its hashes and lengths.

use core::fmt;

/// One definition of a topic. The same name has stood for different bytes at different times; these tell them apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub struct Definition {
    /// What the definition is called here: `main`, `v1_14`.
    pub name: &'static str,
    /// Name of the message, `EscStatus`.
    pub message: &'static str,
    /// PX4's message hash, which uXRCE-DDS tells.
    pub message_hash: u32,
    /// ROS 2's type hash, `RIHS01_` and 64 hexadecimal digits.
    pub type_hash: &'static str,
    /// Bytes of the body as CDR, without its header of four bytes.
    pub cdr_len: u32,
    /// Bytes of a record in a log, without message id.
    pub record_len: u32,
    /// The formats of a log, the topic's own first: `esc_status:uint64_t timestamp;…`.
    pub formats: &'static [&'static str],
}

impl Definition {
    /// A definition without facts; the other functions add them.
    #[must_use]
    pub const fn new(message: &'static str, name: &'static str) -> Self {
        Self { name, message, message_hash: 0, type_hash: "", cdr_len: 0, record_len: 0, formats: &[] }
    }

    /// The same with these hashes.
    #[must_use]
    pub const fn hashes(self, message_hash: u32, type_hash: &'static str) -> Self {
        Self { message_hash, type_hash, ..self }
    }

    /// The same with these lengths, in bytes.
    #[must_use]
    pub const fn lengths(self, cdr_len: u32, record_len: u32) -> Self {
        Self { cdr_len, record_len, ..self }
    }

    /// The same with these formats of a log.
    #[must_use]
    pub const fn formats(self, formats: &'static [&'static str]) -> Self {
        Self { formats, ..self }
    }

    /// The key under which zenoh carries a topic of this definition: `0/fmu/out/esc_status/px4_msgs::msg::dds_::…/RIHS01_…`.
    /// A key of another definition is another key, so what does not fit never arrives.
    #[must_use]
    pub const fn zenoh_key<'t>(&self, domain: u32, topic: &'t str) -> ZenohKey<'t> {
        ZenohKey { domain, topic, message: self.message, type_hash: self.type_hash }
    }
}

/// The key of a topic in zenoh: to be displayed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ZenohKey<'t> {
    domain: u32,
    topic: &'t str,
    message: &'static str,
    type_hash: &'static str,
}

impl fmt::Display for ZenohKey<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let topic = self.topic.trim_start_matches('/');
        write!(f, "{}/{topic}/px4_msgs::msg::dds_::{}_/{}", self.domain, self.message, self.type_hash)
    }
}
