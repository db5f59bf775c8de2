//! Errors of the system by which nothing has failed.

use std::io::{Error, ErrorKind, Result};

/// Calls until no signal comes in between. Only for what has no deadline: signals may come again and again.
pub(crate) fn uninterrupted<T>(mut call: impl FnMut() -> Result<T>) -> Result<T> {
    loop {
        match call() {
            Err(error) if is_interrupted(&error) => {}
            result => return result,
        }
    }
}

/// A signal came in between: call again.
pub(crate) fn is_interrupted(error: &Error) -> bool {
    error.kind() == ErrorKind::Interrupted
}

/// There is nothing to read, or no room to write.
pub(crate) fn is_not_now(error: &Error) -> bool {
    matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut)
}

/// What came; `None` if there was nothing in time.
pub(crate) fn in_time<T>(came: Result<T>) -> Option<Result<T>> {
    match came {
        Err(error) if is_not_now(&error) => None,
        came => Some(came),
    }
}

/// Of a socket for datagrams: go on receiving. Windows gives the news that a datagram reached nobody to the receiver.
pub(crate) fn is_passing(error: &Error) -> bool {
    is_interrupted(error) || matches!(error.kind(), ErrorKind::ConnectionReset | ErrorKind::ConnectionRefused)
}
