//! Any text as a `.msg` file and as an overlay of it: refused with a place, or it has a layout that holds together.

#![no_main]

libfuzzer_sys::fuzz_target!(|text: &str| mavlink_fuzz::resolve_message(text));
