//! The MAVLink dialect compiler: reads dialect XML exactly as pymavlink does, and writes readable Rust.
//!
//! # In a build script
//!
//! For a dialect of your own, add `mavlink-wire` as a dependency, `mavgen` as a build-dependency, and two lines:
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
//! [`Builder::generate`] writes the same sources into a folder. [`Builder::check`] says whether they are current; call it in a
//! test. The `mavgen` command does both without any Rust: `cargo install mavgen-cli`.
//!
//! [`Builder::messages`] selects messages of a large dialect: only these and what they need are generated.
//!
//! # Bits inside integers
//!
//! MAVLink XML cannot say that several values are packed into one integer. An [`overlay`] can.
//!
//! # Without generating anything
//!
//! The feature `decode` adds the module `decode`, which reads messages and views of packed bits at run time.
//!
//! # PX4's messages
//!
//! With the feature `uorb`, a builder takes PX4's `.msg` files instead of XML, and generates types for ULog files and CDR.
//!
//! # How it works
//!
//! ```text
//! XML text ─read→ syntax ─resolve→ ir ─lower→ Rust model ─emit→ tokens ─format→ files
//! (+ overlay, read by the same reader, joined in resolve)
//! ```
//!
//! [`syntax`] is what one file says, with a [`source::Span`] on every name and number. [`ir`] is what all files mean together:
//! wire order, offsets, checksums, merged enums; you can build other tools on it. `lower` then decides every Rust item, names
//! first, and `emit` prints them. Problems are collected as [`diag::Diagnostic`]s, each with its place. After an error, mavgen
//! still checks names, so that one run reports all errors.

#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
// Templates are read token by token.
#![recursion_limit = "512"]

mod build_script;
mod builder;
mod collect;
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
mod resolve;
mod resolved;
mod roots;
mod rust;
mod select;
pub mod source;
pub mod syntax;
mod threads;
mod tokens;
#[cfg(feature = "uorb")]
pub mod uorb;
#[cfg(feature = "vendor")]
pub mod vendor;

#[cfg(feature = "uorb")]
pub use builder::Topics;
pub use builder::{Builder, Failure};
pub use emit::GeneratedFile;
#[doc(hidden)]
pub use emit::is_identifier;
pub use lower::Commands;
pub use problems::Problems;
pub use resolved::Resolved;
