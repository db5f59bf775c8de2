//! PX4's [`EscStatus`], which came from AutoQuad's telemetry: of three definitions, as CDR and in logs.
//!
//! ```
//! use mavlink_autoquad::px4::EscStatus;
//! use mavlink_autoquad::wire::uorb::{CdrError, Topic, TopicByLength};
//!
//! fn main() -> Result<(), CdrError> {
//!     let status = EscStatus { timestamp: 123_456_000, esc_count: 4, ..EscStatus::UNKNOWN };
//!     let mut buffer = [0; 512];
//!     let payload = status.to_cdr(&EscStatus::V1_14, &mut buffer)?; // for PX4 1.14 to 1.17
//!     assert_eq!(payload.len(), 335);
//!     assert_eq!(EscStatus::from_cdr(payload)?.esc_count, 4); // of whichever definition it is
//!     Ok(())
//! }
//! ```

#[cfg(feature = "generate")]
crate::wire::include_dialect!("px4_msgs");

/// PX4's messages about motor controllers, of the definitions `main`, `v2026_02` and `v1_14`.
#[cfg(not(feature = "generate"))]
#[rustfmt::skip]
#[path = "generated_px4/mod.rs"]
pub mod px4_msgs;

pub use px4_msgs::{EscConnectionType, EscFailures, EscReport, EscStatus};
