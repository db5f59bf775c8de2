//! The library from outside, in one program: it is linked once. Each module is a subject.
//!
//! `cargo test -p mavgen --test library ui::` runs those of one module.

mod golden;
mod imports;
mod known_values;
mod limits;
mod malformed;
mod model;
mod mutations;
mod pages;
mod spellings;
mod ui;
