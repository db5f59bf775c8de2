//! What changed between two states of a dialect: on the wire, in its enums, and in the Rust that is generated from it.
//!
//! A change is *breaking* if what was built for the old state no longer works with the new one. On the wire that is a frame that
//! is refused or misunderstood, in the enums a value that lost or changed its meaning, and in Rust code that no longer compiles
//! (Cargo book, "SemVer Compatibility"). A new message, entry or constant breaks nothing; neither does an extension at the end of
//! its message on the wire, but it is a new field of an exhaustive struct in Rust.
//!
//! Descriptions are not compared. What else a definition says, units, ranges, stages of life and so on, is the last group.
//!
//! What is called differently, and is the same otherwise, is one change and not two: a message of the same id and layout, a field
//! of the same type and place, an entry of the same value, an enum of the same entries.

mod api;
mod change;
mod enums;
mod metadata;
mod order;
mod pairs;
mod renamed;
mod state;
mod surface;
mod wire;

#[cfg(test)]
mod tests;

pub use change::{Change, Frame, Group, Kind};

use crate::builder::Failure;
use crate::ir::Dialect;
use crate::select::Selection;
use pairs::Pairs;
use state::State;

/// The changes from `old` to `new`, group by group, in each by message or enum; nothing if they are the same but for their prose.
///
/// Both are whole dialects. With `messages`, only those are compared, and what they need, as
/// [`Builder::messages`](crate::Builder::messages) cuts a dialect.
///
/// The dialects may be called differently, like `acme_1.xml` and `acme_2.xml`: what that alone changes in Rust is not listed.
///
/// # Errors
/// [`Failure::Usage`] if one of `messages` means no message of either state: one that was added or removed is only in one of
/// them. [`Failure::Model`] for one that is not legal, because somebody changed it after it was resolved.
pub fn compare(old: &Dialect, new: &Dialect, messages: Option<&[String]>) -> Result<Vec<Change>, Failure> {
    let selection = messages.map(|names| Selection::new(names.iter().map(String::as_str)));
    let selection = selection.transpose().map_err(Failure::Usage)?;
    if let Some(selection) = &selection {
        selection.check(&[old, new]).map_err(Failure::Usage)?;
    }
    let (old, new) = (State::of(old, selection.as_ref()), State::of(new, selection.as_ref()));
    let pairs = Pairs::of(&old.dialect, &new.dialect);
    let mut changes = wire::changes(&pairs);
    changes.extend(enums::changes(&pairs));
    changes.extend(api::changes(&old, &new, &pairs)?);
    changes.extend(metadata::changes(&old.dialect, &new.dialect, &pairs));
    Ok(changes)
}
