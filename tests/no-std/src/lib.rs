//! What the programs share: their input, and no way to panic.
//!
//! The panic handler calls a function that does not exist, so that a single reachable panic fails to link. That takes an
//! optimised build: `cargo build --release`.

#![no_std]

use core::panic::PanicInfo;

#[link(name = "c")]
unsafe extern "C" {
    fn read(descriptor: i32, buffer: *mut u8, length: usize) -> isize;
    safe fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    a_panic_is_reachable()
}

/// What came in on standard input; `None` at the end.
pub fn receive(buffer: &mut [u8; 64]) -> Option<&[u8]> {
    // SAFETY: the buffer is valid for its length.
    let received = unsafe { read(0, buffer.as_mut_ptr(), buffer.len()) };
    let received = usize::try_from(received).ok()?;
    buffer.get(..received).filter(|chunk| !chunk.is_empty())
}
