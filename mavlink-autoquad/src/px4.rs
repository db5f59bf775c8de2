//! PX4's `EscStatus`, typed: from CDR and logs of three eras, from AutoQuad's telemetry, and to MAVLink.
//!
//! The types are generated from `msg/`, as `mavgen` does with [any message of PX4](https://docs.px4.io/main/en/msg_docs/).
//!
//! ```
//! use mavlink_autoquad::px4::EscStatus;
//! use mavlink_autoquad::wire::uorb::ulog::{Log, LogError};
//!
//! fn show(log: &[u8]) -> Result<(), LogError> {
//!     let mut statuses = Log::new(log)?.read::<EscStatus>();
//!     for (instance, status) in &mut statuses {
//!         for motor in status.motors() {
//!             println!("{instance} {:?}: {} rpm, {} V", motor.number, motor.report.esc_rpm, motor.report.esc_voltage);
//!         }
//!     }
//!     println!("{} unreadable, end: {:?}, {}", statuses.unreadable(), statuses.end(), statuses.fit());
//!     Ok(())
//! }
//! # show(include_bytes!("../../mavlink-wire/tests/uorb/logs/main.ulg")).unwrap();
//! ```
//!
//! # From AutoQuad, and to MAVLink
//!
//! [`EscTable::to_px4`](crate::esc::EscTable::to_px4) makes an `EscStatus` of the controllers of an AutoQuad, which goes out as CDR for
//! a PX4 of any of the three eras, or into a log. [`EscStatus::to_esc_info`] and [`EscStatus::to_esc_status`] make the messages that
//! ground stations show of any PX4's:
//!
//! ```
//! use mavlink_autoquad::esc::{Conversion, EscTable};
//! use mavlink_autoquad::px4::{EscStatus, ToMavlink};
//! use mavlink_autoquad::wire::uorb::{Topic, TopicByLength};
//!
//! # fn main() -> Result<(), mavlink_autoquad::wire::uorb::CdrError> {
//! # let table = EscTable::new();
//! let status: EscStatus = table.to_px4(table.uptime_us(), &Conversion::DEFAULT);
//! let mut buffer = [0; 512];
//! let payload = status.to_cdr(&EscStatus::V1_14, &mut buffer)?; // for PX4 1.14 to 1.17
//! let received = EscStatus::from_cdr(payload)?; // the length says which era it is of
//! for batch in 0..3 {
//!     if let Some(info) = received.to_esc_info(batch, &ToMavlink::DEFAULT) {
//!         println!("{info:?}");
//!     }
//! }
//! # Ok(())
//! # }
//! ```
//!
//! # What is not converted
//!
//! Temperatures of DroneCAN controllers in logs of PX4 1.9 are kelvin. What a controller's `esc_state` means is up to its maker.

#[cfg(not(without_esc))]
mod autoquad;
#[cfg(not(without_esc))]
mod mavlink;
mod motors;

#[cfg(feature = "generate")]
crate::wire::include_dialect!("px4_msgs");

/// PX4's messages about motor controllers, of the definitions `main`, `v2026_02` and `v1_14`.
#[cfg(not(feature = "generate"))]
#[rustfmt::skip]
#[path = "generated_px4/mod.rs"]
pub mod px4_msgs;

#[cfg(not(without_esc))]
pub use autoquad::MAX_ESCS;
#[cfg(not(without_esc))]
pub use mavlink::{Order, ToMavlink};
pub use motors::Motor;
pub use px4_msgs::{EscConnectionType, EscFailures, EscReport, EscStatus};
