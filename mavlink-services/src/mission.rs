//! Plans of a vehicle: its mission, its fence, its rally points; and which item of the mission it is at.
//!
//! A station moves plans with one machine each time: [`Upload`], [`Download`], [`Clear`], [`SetCurrent`]. They are
//! [`Operation`](crate::Operation)s: they end. A vehicle has one [`Component`], which keeps plans in storage of yours ([`Plans`]).
//!
//! The three plans are moved alike and kept apart; [`Access::plan`] says which one is meant. MAVLink 1 has the mission alone.

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
