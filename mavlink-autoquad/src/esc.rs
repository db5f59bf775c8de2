//! The motor controllers of a vehicle, from [`AqEscTelemetry`](crate::autoquad::AqEscTelemetry).
//!
//! [`AqEscTelemetry::escs`](crate::autoquad::AqEscTelemetry::escs) reads one message. Here is what takes several: a
//! [table](EscTable) of up to 16 controllers, the [vehicle's clock](UptimeClock), one type for the [reason](DisarmReason)
//! of both firmware versions, and the messages that ground stations of today [show](Conversion). Nothing allocates, nothing
//! panics.
//!
//! ```
//! use mavlink_autoquad::autoquad::AqEscTelemetry;
//! use mavlink_autoquad::esc::{DisarmReason, EscTable, ONLINE_LIMIT_MS};
//!
//! fn show(table: &mut EscTable, telemetry: &AqEscTelemetry) {
//!     table.update(telemetry);
//!     let now_us = table.uptime_us();
//!     for esc in table.iter() {
//!         let Some(status) = esc.status.filter(|_| esc.is_online(now_us, ONLINE_LIMIT_MS)) else {
//!             println!("{}: silent", esc.id);
//!             continue;
//!         };
//!         println!("{}: {} mV, {} rpm", esc.id, status.voltage_mv(), status.rpm());
//!         if let Some(reason) = DisarmReason::of(status).filter(|reason| reason.is_fault()) {
//!             println!("{}: disarmed, {reason}", esc.id);
//!         }
//!     }
//! }
//!
//! let mut table = EscTable::new();
//! show(&mut table, &AqEscTelemetry { seq: 1, num_motors: 4, num_in_seq: 4, escid: [1, 2, 3, 4], ..AqEscTelemetry::DEFAULT });
//! # use mavlink_autoquad::wire::Message;
//! ```
//!
//! # Controllers with firmware from before 2014-12-09
//!
//! They lay the bits out otherwise, and no version number tells: see
//! [`AqEscTelemetry::legacy_escs`](crate::autoquad::AqEscTelemetry::legacy_escs). What is here reads the layout of the later
//! firmware.
//!
//! # PX4
//!
//! A [`Conversion`] ends at MAVLink. PX4's own `EscStatus` carries 8 controllers in releases up to 1.17 and 12 from March 2026
//! on, in another layout and without a version number: a program that writes it has to know which PX4 reads it.
//!
//! # Definitions of a fork
//!
//! With `MAVLINK_AUTOQUAD_XML` this module is there only if `MAVLINK_AUTOQUAD_OVERLAY` names an overlay for that file. It has
//! to add what `xml/overlay/autoquad.xml` adds; more is fine.

mod clock;
mod convert;
mod disarm;
mod table;

pub use clock::{UptimeClock, true_age_ms};
pub use convert::{Conversion, InfoBits, Silent};
pub use disarm::DisarmReason;
pub use table::{Counts, EscRow, EscTable, MAX_ESCS, ONLINE_LIMIT_MS, Update};
