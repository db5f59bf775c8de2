//! The time of the system.

use std::time::{SystemTime, UNIX_EPOCH};

use crate::Timestamp;

/// The time for signatures; [`Timestamp::ZERO`], which says that there is no clock, if the system's is before 2015.
pub(crate) fn now() -> Timestamp {
    let since_1970 = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
    Timestamp::from_unix_micros(u64::try_from(since_1970.as_micros()).unwrap_or(u64::MAX))
}
