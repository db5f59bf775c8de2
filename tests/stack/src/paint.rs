//! Painting the stack that nobody uses yet, and looking how far the paint is gone.

use core::hint::black_box;

/// Bytes that are painted.
const AREA: usize = 200_000;

/// What lies between the painter and its paint: its own frame, and what it calls.
const MARGIN: usize = 512;

const PAINT: u8 = 0xa5;

/// The bytes of stack that this takes. Where it takes fewer than the painter does, it is that: some 600 bytes.
#[inline(never)]
pub fn used(work: &mut dyn FnMut()) -> usize {
    let anchor = 0_u8;
    let top = black_box(&raw const anchor) as usize;
    let bottom = paint();
    black_box(work)();
    top - lowest(bottom)
}

/// Paints what lies below its own frame, and returns where that begins.
#[inline(never)]
fn paint() -> usize {
    let anchor = 0_u8;
    let top = black_box(&raw const anchor) as usize - MARGIN;
    let mut at = top - AREA;
    while at < top {
        // SAFETY: it is stack that no frame has yet; the main thread's has 8 MB, and that of the firmware 4.
        unsafe { (at as *mut u8).write_volatile(PAINT) };
        at += 1;
    }
    top - AREA
}

/// The lowest byte from here on that is not painted any more.
#[inline(never)]
fn lowest(bottom: usize) -> usize {
    let mut at = bottom;
    // SAFETY: it was painted, and ends where frames are.
    while unsafe { (at as *const u8).read_volatile() } == PAINT {
        at += 1;
    }
    assert!(at > bottom, "more stack is used than was painted");
    at
}
