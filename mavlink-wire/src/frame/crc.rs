//! The checksum: CRC-16/MCRF4XX (polynomial 0x1021 reflected, start 0xFFFF, check value 0x6F91).
//!
//! A frame's checksum covers everything between its first byte and the checksum, and then one byte that is not sent,
//! the message's `crc_extra`.
//!
//! ```
//! use mavlink_wire::crc::{byte_between, checksum, step};
//!
//! let heartbeat = [0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
//! let crc = checksum(&heartbeat[1..15]);
//! assert_eq!(step(crc, 50), 0x4390);
//! assert_eq!(byte_between(crc, 0x4390), Some(50));
//! ```

use core::ops::Range;

use super::header::LONGEST as LONGEST_HEADER;
use crate::MAX_PAYLOAD;
use crate::parser::work;

/// The first table has, for each byte, the register after it if the register was zero before; each further one has that after
/// one more zero byte.
#[cfg(feature = "fast-crc")]
static TABLES: [[u16; 256]; 16] = tables();

#[cfg(feature = "fast-crc")]
#[expect(clippy::indexing_slicing, reason = "the indices end where the tables do")]
const fn tables() -> [[u16; 256]; 16] {
    let (mut tables, mut zeros) = ([[0; 256]; 16], 0);
    while zeros < 16 {
        let mut bit = 1;
        while bit < 256 {
            let crc = if zeros == 0 { step(0, bit as u8) } else { step(tables[zeros - 1][bit], 0) };
            let (table, mut lower) = (&mut tables[zeros], 0);
            // The register after two bits is the sum of those after each.
            while lower < bit {
                table[bit + lower] = crc ^ table[lower];
                lower += 1;
            }
            bit *= 2;
        }
        zeros += 1;
    }
    tables
}

/// The checksum of these bytes.
///
/// By blocks of sixteen, with what is left over in the first one rather than in the last: zeros in front of it leave an
/// empty register empty, so that it costs no more than the others. Byte by byte, fifteen left over cost more than four blocks.
#[cfg(feature = "fast-crc")]
#[must_use]
pub fn checksum(bytes: &[u8]) -> u16 {
    let (Some(first), Some(last)) = (bytes.first_chunk::<8>(), bytes.last_chunk::<8>()) else {
        return extend(INITIAL, bytes, 0..bytes.len());
    };
    work::count(bytes.len() / 4);
    let length = (bytes.len() - 1) % 16 + 1;
    let short = match bytes.first_chunk::<16>() {
        Some(block) => u128::from_le_bytes(*block) << (128 - 8 * length),
        // Eight to fifteen bytes: both ends, which agree where they overlap.
        None => {
            u128::from(u64::from_le_bytes(*last)) << 64 | u128::from(u64::from_le_bytes(*first)) << (128 - 8 * length)
        }
    };
    // The start value acts on two bytes; if the block has only one, half of it is left.
    let short = (short ^ 0xFFFF << (128 - 8 * length)).to_le_bytes();
    let crc = after(0, &short) ^ if length == 1 { 0xFF } else { 0 };
    let (blocks, _) = bytes.get(length..).unwrap_or_default().as_chunks();
    blocks.iter().fold(crc, after)
}

/// The register after a block of sixteen bytes.
#[cfg(feature = "fast-crc")]
#[expect(clippy::indexing_slicing, reason = "a byte cannot leave a table of 256")]
#[inline(always)]
fn after(crc: u16, block: &[u8; 16]) -> u16 {
    let [low, high] = crc.to_le_bytes();
    let [first, second, others @ ..] = *block;
    let [tables @ .., second_table, first_table] = &TABLES;
    // What does not wait for the block before comes first.
    let sum = others.iter().rev().zip(tables).fold(0, |sum, (&byte, table)| sum ^ table[usize::from(byte)]);
    sum ^ second_table[usize::from(second ^ high)] ^ first_table[usize::from(first ^ low)]
}

/// The checksum of these bytes.
#[cfg(not(feature = "fast-crc"))]
#[must_use]
pub fn checksum(bytes: &[u8]) -> u16 {
    extend(INITIAL, bytes, 0..bytes.len())
}

/// The register at the start.
pub(crate) const INITIAL: u16 = 0xFFFF;

/// The register after these bytes.
pub(crate) fn extend(crc: u16, bytes: &[u8], range: Range<usize>) -> u16 {
    work::count(range.len());
    range.fold(crc, |crc, at| step(crc, bytes.get(at).copied().unwrap_or_default()))
}

/// Bytes by which [`advance`] counts: each of them where time counts, and fewer powers where flash does.
pub(crate) const WORD: usize = if cfg!(feature = "fast-crc") { 2 } else { 8 };

/// Words of the longest range that has a checksum: a header without its first byte, and a payload.
const WORDS: usize = (LONGEST_HEADER - 1 + MAX_PAYLOAD) / WORD;

/// The register after so many words of zeros. As a polynomial, it is multiplied by a power of x, each bit of it by another.
#[cfg(feature = "fast-crc")]
pub(crate) fn advance(crc: u16, words: usize) -> u16 {
    /// x to the power of the index.
    static POWERS: [u16; 8 * WORD * WORDS + 16] = powers(1);
    const BITS: [u16; 16] = powers(1);
    work::count(8);
    let powers = POWERS.get(8 * WORD * words..).and_then(<[u16]>::first_chunk::<16>);
    let powers = powers.unwrap_or(&[0; 16]);
    powers.iter().zip(BITS).fold(0, |sum, (power, bit)| sum ^ if crc & bit == 0 { 0 } else { *power })
}

/// The register after so many words of zeros. As a polynomial, it is multiplied by a power of x.
#[cfg(not(feature = "fast-crc"))]
pub(crate) fn advance(mut crc: u16, words: usize) -> u16 {
    /// x to the power of the bits in so many words.
    static POWERS: [u16; WORDS + 1] = powers(8 * WORD);
    work::count(8);
    let (mut power, mut product) = (POWERS.get(words).copied().unwrap_or_default(), 0);
    while crc != 0 {
        product ^= if crc & ONE == 0 { 0 } else { power };
        (crc, power) = (crc << 1, times_x(power));
    }
    product
}

/// The polynomial 1. The bits of a register are reflected: its lowest is of the highest power.
const ONE: u16 = 0x8000;

/// The polynomial times x.
const fn times_x(polynomial: u16) -> u16 {
    (polynomial >> 1) ^ if polynomial & 1 == 0 { 0 } else { 0x8408 }
}

/// Powers of x, so many apart, from 1 on.
const fn powers<const N: usize>(apart: usize) -> [u16; N] {
    let (mut powers, mut power) = ([0; N], ONE);
    let mut rest: &mut [u16] = &mut powers;
    while let [first, others @ ..] = rest {
        *first = power;
        let mut times = 0;
        while times < apart {
            (power, times) = (times_x(power), times + 1);
        }
        rest = others;
    }
    powers
}

/// The checksum after one more byte.
#[inline]
#[must_use]
pub const fn step(crc: u16, byte: u8) -> u16 {
    let mut t = byte ^ crc as u8;
    t ^= t << 4;
    let t = t as u16;
    (crc >> 8) ^ (t << 8) ^ (t << 3) ^ (t >> 4)
}

/// The byte that leads from one checksum to another, if there is one: the inverse of [`step`].
///
/// `crc_extra` of a frame whose message is not known; a false frame has one in only 1 of 256 cases.
#[inline]
#[must_use]
pub const fn byte_between(before: u16, after: u16) -> Option<u8> {
    let sum = after ^ (before >> 8);
    // The high byte of a step is t ^ (t >> 5), which undoes itself within eight bits; so does t ^ (t << 4).
    let high = (sum >> 8) as u8;
    let t = high ^ (high >> 5);
    if (t << 3) ^ (t >> 4) == sum as u8 { Some(t ^ (t << 4) ^ before as u8) } else { None }
}
