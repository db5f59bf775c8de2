//! Parameters: a component's settings, listed, read and set by name.
//!
//! A station uses one machine for each operation: [`List`], [`Read`], [`Write`]. They are [`Operation`](crate::Operation)s, which end.
//! A component has one [`Component`], which answers from a table of yours ([`Parameters`]).
//!
//! Four bytes carry a value, in one of two [`Encoding`]s. A value that does not fit is an error on both sides, never another number.

mod component;
mod encoding;
mod failure;
mod list;
mod number;
mod read;
mod table;
mod value;
mod write;

pub use component::{Component, ComponentOptions, Set};
pub use encoding::Encoding;
pub use failure::{Awaited, Failure};
pub use list::{List, ListProgress, Listed};
pub use read::{Read, Which};
pub use table::Parameters;
pub use value::{ParamValue, ValueError};
pub use write::Write;

use mavlink_wire::{Chars, Frame};

use crate::common::ParamError;
use crate::{Address, Retry, common};

/// Name of a parameter: up to 16 characters. `"RATE_P".try_into()?` makes one.
pub type Name = Chars<16>;

/// A parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Param {
    /// Its name.
    pub name: Name,
    /// Its value.
    pub value: ParamValue,
}

impl Param {
    /// The parameter of this name, which is cut after 16 bytes.
    #[must_use]
    pub fn new(name: &str, value: impl Into<ParamValue>) -> Self {
        Self { name: Name::truncated(name), value: value.into() }
    }
}

/// A parameter as a component sent it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Told {
    /// Its name.
    pub name: Name,
    /// Its value.
    pub value: ParamValue,
    /// Its index in the component's list. ArduPilot does not send it after a set, or after a read by name.
    pub index: Option<u16>,
    /// How many parameters the component has.
    pub count: u16,
}

/// Which station asks which component, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Access {
    /// The station: the ids with which you send its frames.
    pub own: Address,
    /// The component that has the parameters. No id may be zero.
    pub peer: Address,
    /// How that component's values are encoded; [`Encoding::of`] finds out.
    pub encoding: Encoding,
    /// How long an answer may take, and how often to ask.
    pub retry: Retry,
}

impl Access {
    /// With the usual timeout and number of tries ([`Retry::DEFAULT`]).
    #[must_use]
    pub const fn new(own: Address, peer: Address, encoding: Encoding) -> Self {
        Self { own, peer, encoding, retry: Retry::DEFAULT }
    }

    /// The parameter in a frame, if it is one of the peer's.
    fn value(&self, frame: &Frame<'_>) -> Option<common::ParamValue> {
        if self.peer.includes(Address::of(frame)) { frame.decode() } else { None }
    }

    /// Why the peer did not do what was asked, if the frame says that.
    fn error(&self, frame: &Frame<'_>) -> Option<ParamError> {
        if self.peer.includes(Address::of(frame)) { self.own.addressed(frame) } else { None }
    }

    /// What a message says of a parameter.
    fn told(&self, message: &common::ParamValue) -> Result<Told, ValueError> {
        let value = self.encoding.decode(message.param_value, message.param_type)?;
        Ok(Told { name: message.param_id, value, index: index_of(message), count: message.param_count })
    }
}

/// The place in the list that a message tells; 65535 and what lies behind the end is none.
fn index_of(message: &common::ParamValue) -> Option<u16> {
    (message.param_index < message.param_count).then_some(message.param_index)
}

/// Whether two names are the same. What a sender left behind the NUL does not matter.
fn is_same(one: &Name, other: &Name) -> bool {
    one.as_bytes() == other.as_bytes()
}
