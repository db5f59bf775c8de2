//! Streams that are made to cost a parser as much as possible. Nothing else is needed here, so that benchmarks and fuzz
//! targets can have this file, too.

use std::vec;
use std::vec::Vec;

/// A message that the parser knows: id, length, `crc_extra`.
pub(crate) type Known = (u8, u8, u8);

/// Bytes of a stream, as good as.
const LENGTH: usize = 8_000;

/// The streams, by name.
pub(crate) fn streams(known: Known) -> Vec<(&'static str, Vec<u8>)> {
    let (id, length, _) = known;
    vec![
        ("good frames", good(known)),
        ("0xFE", periodic(&[0xFE])),
        ("0xFD", periodic(&[0xFD])),
        ("0xFE and 0xFD", periodic(&[0xFE, 0xFD])),
        ("longest MAVLink 2", periodic(&[0xFD, 0xFF, 0])),
        ("longest, signed", periodic(&[0xFD, 0xFF, 1])),
        ("known, MAVLink 1", periodic(&[0xFE, length, id])),
        ("known, MAVLink 2", periodic(&[0xFD, 0xFF, 0, id, 0, 0, 0, 0])),
        ("starts of known ones", periodic(&[0xFD, 0xFF, 0, 0, 0])),
        ("short and long", periodic(&[0xFE, 0xFE, 0xFE, 0])),
        ("explained, each 4 bytes", explained(&[0xFE, 244, 5, 6], 244)),
        ("explained, each 12 bytes", explained(&[0xFE, 244, 0, 0, 1, 7, 0xFD, 200, 0, 0, 0, 0], 244)),
        ("explained around starts", explained(&[0xFE, 252, 0xFE, length, 0xFE, length, 3, id, id, id], 252)),
        ("explained around a frame", around(known, 60)),
        ("explained between noise", between(known)),
        ("chance", chance(known, 1)),
    ]
}

/// Frames as they should be.
fn good((id, length, crc_extra): Known) -> Vec<u8> {
    let mut stream = Stream::new(2);
    while stream.bytes.len() < LENGTH {
        stream.frame(id, length, crc_extra);
    }
    stream.bytes
}

fn periodic(period: &[u8]) -> Vec<u8> {
    period.iter().copied().cycle().take(LENGTH).collect()
}

/// The same bytes over and over, in which the first of each period starts a frame of MAVLink 1 with a payload of this
/// length, and its checksum is right.
fn explained(period: &[u8], length: usize) -> Vec<u8> {
    let mut stream = Stream::new(3);
    stream.push(1);
    while stream.bytes.len() < LENGTH {
        stream.start(6 + length, 9);
        period.iter().for_each(|&byte| stream.push(byte));
    }
    stream.bytes
}

/// So many unknown frames begin before a known one and end behind it.
fn around((id, length, crc_extra): Known, frames: u8) -> Vec<u8> {
    let mut stream = Stream::new(4);
    while stream.bytes.len() < LENGTH {
        stream.push(1);
        for frame in 0..frames {
            let before = 3 * (frames - frame) + length + 8 + 2 * frame;
            stream.start(usize::from(before), 9);
            [0xFE, before - 6, 77].iter().for_each(|&byte| stream.push(byte));
        }
        stream.frame(id, length, crc_extra);
        (0..2 * frames + 8).for_each(|_| stream.push(7));
    }
    stream.bytes
}

/// Short unknown frames, each behind noise and with the start of a known one at its end.
fn between((id, ..): Known) -> Vec<u8> {
    let mut stream = Stream::new(5);
    while stream.bytes.len() < LENGTH {
        stream.push(1);
        stream.start(16, 9);
        [0xFE, 10, 1, 1, 1, 77, 0xFD, 0xFF, 0, 0, 0, 0, 0, id, 0, 0, 0, 0].iter().for_each(|&byte| stream.push(byte));
    }
    stream.bytes
}

/// Starts of frames wherever chance wants them, known ones and others, many with a checksum that is right.
pub(crate) fn chance((id, length, crc_extra): Known, seed: u64) -> Vec<u8> {
    let mut stream = Stream::new(seed);
    let [density, checks, knowns] = [1 + stream.random(12), 1 + stream.random(4), 1 + stream.random(4)];
    while stream.bytes.len() < LENGTH {
        let start = stream.bytes.len();
        if stream.random(density) != 0 {
            let byte = stream.random(256) as u8;
            stream.push(byte);
            continue;
        }
        let (is_v2, is_known) = (stream.random(2) == 0, stream.random(knowns) == 0);
        let payload = if is_known { length } else { stream.random(256) as u8 };
        let id = if is_known { id } else { 77 };
        if stream.random(checks) != 0 {
            stream.start(usize::from(payload) + if is_v2 { 10 } else { 6 }, if is_known { crc_extra } else { 9 });
        }
        let (v1, v2) = ([0xFE, payload, 0, 1, 1, id], [0xFD, payload, 0, 0, 0, 1, 1, id, 0, 0]);
        let header = if is_v2 { &v2[..] } else { &v1[..] };
        // Cut off by the next one, as often as not.
        let whole = if stream.random(2) == 0 { header.len() } else { 1 + stream.random(header.len() as u64) as usize };
        header.iter().take(whole).for_each(|&byte| stream.push(byte));
        debug_assert!(stream.bytes.len() > start);
    }
    stream.bytes
}

/// A stream, with the checksums that are to stand in it.
struct Stream {
    bytes: Vec<u8>,
    /// Where, of the bytes from where, and with which `crc_extra`.
    checksums: Vec<(usize, usize, u8)>,
    random: u64,
}

impl Stream {
    fn new(seed: u64) -> Self {
        Self { bytes: vec![], checksums: vec![], random: seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1 }
    }

    /// Here starts a frame that has so many bytes in front of its checksum.
    fn start(&mut self, checked_length: usize, crc_extra: u8) {
        let start = self.bytes.len();
        self.checksums.push((start + checked_length, start + 1, crc_extra));
    }

    /// A whole frame of MAVLink 1.
    fn frame(&mut self, id: u8, length: u8, crc_extra: u8) {
        self.start(6 + usize::from(length), crc_extra);
        [0xFE, length, 1, 1, 1, id].iter().for_each(|&byte| self.push(byte));
        (0..length + 2).for_each(|_| self.push(0x55));
    }

    /// Goes on with this byte, or with that of a checksum which is to stand here.
    fn push(&mut self, byte: u8) {
        let here = self.bytes.len();
        self.checksums.retain(|&(place, ..)| place + 2 > here);
        let checksum = self.checksums.iter().find(|&&(place, ..)| place <= here).copied();
        self.bytes.push(match checksum {
            Some((place, from, crc_extra)) => {
                let crc = self.bytes.get(from..place).unwrap_or_default().iter().fold(0xFFFF, step);
                step(crc, &crc_extra).to_le_bytes()[here - place]
            }
            None => byte,
        });
    }

    /// Below `limit`.
    fn random(&mut self, limit: u64) -> u64 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 7;
        self.random ^= self.random << 17;
        self.random % limit
    }
}

fn step(crc: u16, byte: &u8) -> u16 {
    (0..8).fold(crc ^ u16::from(*byte), |crc, _| if crc & 1 == 0 { crc >> 1 } else { (crc >> 1) ^ 0x8408 })
}
