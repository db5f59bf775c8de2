//! What carries bytes both ways, and how it is opened.

use std::boxed::Box;
use std::io::Result;
use std::time::Duration;

use crate::link::{LinkError, Peer};

/// An open connection or device.
pub(super) trait Stream: Send {
    /// Reads what there is; waits so long for it. Nothing, without an error, is the end.
    fn read_within(&mut self, buffer: &mut [u8], limit: Duration) -> Result<usize>;

    /// Writes what there is room for; waits so long for it.
    fn write_within(&mut self, bytes: &[u8], limit: Duration) -> Result<usize>;

    /// Another hand on the same.
    fn twin(&self) -> Result<Box<dyn Stream>>;

    /// Ends it, for all that have a hand on it.
    fn shut(&self);
}

/// What has come of opening: a stream and who is at its other end, or nothing yet.
pub(super) type Attempt = core::result::Result<Option<(Box<dyn Stream>, Peer)>, LinkError>;

/// Opens connections or devices, again and again.
pub(super) trait Opener: Send {
    /// Goes on with opening, without waiting. `None`: not yet.
    fn attempt(&mut self) -> Attempt;

    /// Whether to try again at once after an attempt that ended in "not yet".
    fn is_listener(&self) -> bool {
        false
    }
}
