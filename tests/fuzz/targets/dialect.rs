//! Any text as a dialect: refused with a place, or it becomes Rust that parses.

#![no_main]

libfuzzer_sys::fuzz_target!(|text: &str| mavlink_fuzz::compile(text, None));
