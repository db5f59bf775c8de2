//! Overwrites what held a key.

use zeroize::Zeroize;

/// Bytes of stack that a hash takes: some 900, built for size or for speed, and more where nothing is optimised.
const STACK: usize = if cfg!(debug_assertions) { 4096 } else { 1024 };

/// Overwrites the stack that the last call of the caller took: what was spilled from registers, and what was moved.
#[inline(never)]
pub(crate) fn wipe_stack() {
    let mut used = [0_usize; STACK / size_of::<usize>()];
    used.zeroize();
}
