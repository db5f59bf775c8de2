//! The bodies of methods, by what they are about.

pub(super) mod accessor;
pub(super) mod bits;
pub(super) mod scaled;
pub(super) mod slots;
pub(super) mod source;
