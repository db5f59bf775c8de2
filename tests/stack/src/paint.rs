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

/// Copies the stack that this takes, for [`lies_in`]. `copy` has as many bytes as are to be looked at.
#[inline(never)]
pub fn copy_used(work: &mut dyn FnMut(), copy: &mut [u8]) {
    let anchor = 0_u8;
    let top = black_box(&raw const anchor) as usize;
    paint();
    deeper(work);
    let (mut at, length) = (0, copy.len().min(AREA));
    while at < length {
        // SAFETY: it was painted.
        copy[at] = unsafe { ((top - length + at) as *const u8).read_volatile() };
        at += 1;
    }
}

/// Does it further down, where no frame comes that only looks.
#[inline(never)]
fn deeper(work: &mut dyn FnMut()) {
    let room = [0_u8; 4 * MARGIN];
    black_box(&room);
    black_box(work)();
    black_box(&room);
}

/// The bytes of a value, whatever else may read them.
pub fn copy_of<T>(value: &T, copy: &mut [u8]) {
    for (at, byte) in copy.iter_mut().enumerate().take(size_of::<T>()) {
        // SAFETY: it is within the value.
        *byte = unsafe { (&raw const *value).cast::<u8>().add(at).read_volatile() };
    }
}

/// Whether a part of the secret lies in these bytes: four of it, in their order or turned round, as hashes load them.
pub fn lies_in(secret: &[u8], bytes: &[u8]) -> bool {
    let turned = |part: &[u8; 4]| u32::from_ne_bytes(*part).swap_bytes().to_ne_bytes();
    let (words, _) = secret.as_chunks();
    bytes
        .windows(4)
        .any(|window| secret.windows(4).any(|part| part == window) || words.iter().any(|word| turned(word) == *window))
}
