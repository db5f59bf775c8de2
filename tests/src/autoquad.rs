//! The AutoQuad dialect under test.

#![allow(deprecated, reason = "what is deprecated is tested like the rest")]
#![allow(clippy::too_many_lines, reason = "a function over all fields is as long as there are fields")]

include!(concat!(env!("OUT_DIR"), "/autoquad_subjects.rs"));
