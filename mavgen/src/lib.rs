//! The MAVLink dialect compiler: reads dialect XML, understands it exactly as pymavlink does, and writes Rust that a
//! person enjoys reading.
//!
//! # In a build script
//!
//! A dialect of one's own needs `mavlink-wire` as a dependency, `mavgen` as a build-dependency, and two lines.
//!
//! ```no_run
//! // in the `main` of build.rs
//! mavgen::Builder::new("xml/acme.xml").build_script();
//! ```
//!
//! ```text
//! // src/lib.rs
//! mavlink_wire::include_dialect!("acme"); // the module `acme`: acme::Heartbeat, acme::MavState, acme::Acme …
//! ```
//!
//! # In a repository
//!
//! [`Builder::generate`] writes the same sources into a folder, and [`Builder::check`] says whether they are current, so
//! that a test can. The `mavgen` command does both without a line of Rust: `cargo install mavgen-cli`.
//!
//! [`Builder::messages`] keeps a large dialect small: only the messages that a program speaks, and what they need.
//!
//! # Bits inside integers
//!
//! What XML cannot say, that an integer is packed with other values, an [`overlay`] says.
//!
//! # Without generating anything
//!
//! The feature `decode` adds a module of that name: messages and views of packed bits read at run time, by the model.
//!
//! # How it works
//!
//! ```text
//! XML text ─read→ syntax ─resolve→ ir ─lower→ Rust model ─emit→ tokens ─format→ files
//! (+ overlay, read by the same reader, joined in resolve)
//! ```
//!
//! [`syntax`] is what a file says, with a [`source::Span`] on every name and number. [`ir`] is what the files mean together:
//! wire order, offsets, checksums, merged enums; other tools can be written on it. Then every Rust item is decided, first its
//! names, and printed. Problems are collected as [`diag::Diagnostic`]s, each with its place; after an error only names are still
//! looked at, so that one run finds all.

#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod build_script;
mod builder;
#[cfg(feature = "compare")]
pub mod compare;
mod decimal;
#[cfg(feature = "decode")]
pub mod decode;
pub mod diag;
mod docs;
mod emit;
mod format;
mod internal;
pub mod ir;
mod lower;
mod order;
pub mod output;
#[doc = include_str!("overlay.md")]
pub mod overlay {}
mod problems;
mod provenance;
pub mod read;
pub mod resolve;
mod resolved;
mod roots;
mod rust;
mod select;
pub mod source;
pub mod syntax;
#[cfg(feature = "uorb")]
pub mod uorb;
#[cfg(feature = "vendor")]
pub mod vendor;

#[cfg(feature = "uorb")]
pub use builder::Topics;
pub use builder::{Builder, Failure};
pub use emit::GeneratedFile;
pub use problems::Problems;
pub use resolved::Resolved;
