//! Files of what was received.

pub mod tlog;
