//! PX4's log files, ULog: typed records of a log that lies in memory, without an allocator; and logs written, with `std`.
//!
//! A memory map serves as well as a file that was read. Format: <https://docs.px4.io/main/en/dev_log/ulog_file_format>.

mod binding;
mod error;
mod fit;
mod format;
mod log;
mod messages;
mod records;
mod samples;
mod sections;
#[cfg(feature = "std")]
mod writer;

pub use binding::Binding;
pub use error::LogError;
pub use fit::Fit;
pub use log::Log;
pub use messages::{Logged, Messages};
pub use records::{End, Record, Records};
pub use samples::Samples;
#[cfg(feature = "std")]
pub use writer::{DataWriter, Writer};
