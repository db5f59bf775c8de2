//! Plans of a vehicle: mission, fence and rally points, and the current item of the mission.
//!
//! A station uses one machine for each operation: [`Upload`], [`Download`], [`Clear`], [`SetCurrent`]. They are
//! [`Operation`](crate::Operation)s, which end. A vehicle has one [`Component`], which keeps the plans in storage of yours ([`Plans`]).
//!
//! All three plans are transferred in the same way; [`Access::plan`] says which one. MAVLink 1 has only the mission.

#![expect(deprecated, reason = "old stations and vehicles know nothing newer")]

mod access;
mod clear;
mod component;
mod current;
mod download;
mod failure;
mod item;
mod plans;
mod position;
mod receiving;
mod store;
mod upload;

pub use access::{Access, Form};
pub use clear::Clear;
pub use component::{Component, ComponentEvent};
pub use current::SetCurrent;
pub use download::{Download, Downloaded, Item};
pub use failure::{Awaited, Failure};
pub use item::MissionItem;
pub use plans::{Plans, Replaced};
pub use store::{Plan, PlanStore};
pub use upload::{Sent, Upload, Uploaded};
