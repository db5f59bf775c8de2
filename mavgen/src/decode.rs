//! Messages read by the model, at run time: what generated code does, without generating or compiling anything.
//!
//! [`Tables`] are what the runtime needs to find frames and to reflect messages. [`views`] reads packed bits as overlays
//! describe them, and [`bindings`] the enums that they bind to fields. [`contents`] puts all of it into one tree, for
//! those who only want to show it: `mavgen decode` is written on that.
//!
//! ```no_run
//! use mavgen::decode::{Tables, contents};
//! use mavlink_wire::Parser;
//!
//! let dialect = mavgen::Builder::new("xml/acme.xml").overlay("xml/overlay/acme.xml").resolve()?.dialect;
//! let tables = Tables::leak(&dialect);
//! let mut parser = Parser::new(tables.table());
//! let mut chunk: &[u8] = &std::fs::read("flight.bin").unwrap();
//! while let Some(frame) = parser.next(&mut chunk) {
//!     if let Some(reflected) = tables.reflect(&frame) {
//!         println!("{reflected}");
//!         println!("{:?}", contents(&dialect, &tables, &reflected));
//!     }
//! }
//! # Ok::<(), mavgen::Failure>(())
//! ```
//!
//! It is behind the feature `decode`, out of a build script's way.

mod bits;
mod node;
mod parameter;
mod ratio;
mod tables;
mod tree;
mod view;

pub use bits::{Bits, Value};
pub use node::{Entry, Node};
pub use parameter::parameter_readings;
pub use ratio::Ratio;
pub use tables::Tables;
pub use tree::{Contents, contents};
pub use view::{Content, KeyValue, Reading, Slot, bindings, views};
