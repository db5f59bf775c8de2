//! The quick tests of conformance, in one program: it is linked once. Each module is a subject.
//!
//! `cargo test -p mavlink-conformance --test conformance esc::` runs those of one module. On their own are what takes long
//! (`accepted`), what needs something beside Rust (`peer`, `rebuild`), and what needs the feature `optional`.

mod deprecated;
mod documents;
mod enums;
mod esc;
mod generated;
mod golden;
mod harness;
mod held;
mod hostile;
mod mutations;
mod packed;
mod payloads;
mod px4;
mod reflection;
mod roots;
mod selected;
mod signing;
mod telemetry;
mod topics;
mod typed;
mod vectors;
mod vendored;
mod views_at_run_time;
