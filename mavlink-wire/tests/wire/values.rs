//! Values in a payload.

use mavlink_wire::generated::{Wire, get, put, zero_extended};
use mavlink_wire::{Chars, Encode, Message, MessageInfo, Version};
use proptest::prelude::*;

use crate::small::{AqEscTelemetry, Heartbeat, MavModeFlag, MavState, Small, Statustext};

#[track_caller]
fn lies<T: Wire + PartialEq + core::fmt::Debug>(value: T, bytes: &[u8]) {
    let mut payload = [0xAA; 32];
    put(&mut payload, 3, value);
    assert_eq!((T::SIZE, &payload[3..3 + bytes.len()]), (bytes.len(), bytes));
    assert!(payload[..3].iter().chain(&payload[3 + bytes.len()..]).all(|&byte| byte == 0xAA));
    assert_eq!(get::<T>(&payload, 3), value);
}

#[test]
fn values_are_little_endian() {
    lies(0x12_u8, &[0x12]);
    lies(-2_i8, &[0xFE]);
    lies(0x1234_u16, &[0x34, 0x12]);
    lies(-2_i16, &[0xFE, 0xFF]);
    lies(0x1234_5678_u32, &[0x78, 0x56, 0x34, 0x12]);
    lies(-2_i32, &[0xFE, 0xFF, 0xFF, 0xFF]);
    lies(0x0102_0304_0506_0708_u64, &[8, 7, 6, 5, 4, 3, 2, 1]);
    lies(-2_i64, &[0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF]);
    lies(1.0_f32, &[0, 0, 0x80, 0x3F]);
    lies(1.0_f64, &[0, 0, 0, 0, 0, 0, 0xF0, 0x3F]);
    lies([0x0102_u16, 0x0304], &[2, 1, 4, 3]);
    lies(Chars(*b"ab\0c"), b"ab\0c");
    lies([MavState(4), MavState(200)], &[4, 200]);
    lies(MavModeFlag::from_bits_retain(0x43), &[0x43]);
}

#[test]
fn missing_bytes_are_zero_and_not_written() {
    assert_eq!((get::<u32>(&[1, 2, 3], 1), get::<u32>(&[1], 1), get::<u32>(&[1], 9)), (0x0302, 0, 0));
    assert_eq!(get::<[u16; 3]>(&[1, 2, 3], 0), [0x0201, 3, 0]);
    let mut short = [0; 3];
    put(&mut short, 1, [0x0102_u16, 0x0304]);
    put(&mut short, 9, 7_u8);
    assert_eq!(short, [0, 2, 1]);
    assert_eq!((zero_extended::<4>(&[1, 2]), zero_extended::<2>(&[1, 2, 3])), ([1, 2, 0, 0], [1, 2]));
}

#[test]
fn signalling_nans_keep_their_bits() {
    for bits in [0x7f80_0001_u32, 0xffad_beef, 0x7fc0_0000] {
        let mut payload = [0; 4];
        put(&mut payload, 0, f32::from_bits(bits));
        assert_eq!((payload, get::<f32>(&payload, 0).to_bits()), (bits.to_le_bytes(), bits));
    }
    let bits = 0x7ff0_0000_0000_0001_u64;
    assert_eq!(get::<[f64; 1]>(&bits.to_le_bytes(), 0)[0].to_bits(), bits);
}

proptest! {
    #[test]
    fn every_payload_comes_back(bytes in proptest::collection::vec(any::<u8>(), 0..60), cut in 0..60_usize) {
        let bytes = &bytes[..cut.min(bytes.len())];
        comes_back(&Small::from(Heartbeat::decode(bytes)), bytes);
        comes_back(&Small::from(AqEscTelemetry::decode(bytes)), bytes);
        comes_back(&Statustext::decode(bytes), bytes);
    }

    #[test]
    fn trailing_zeros_are_cut(mut bytes in proptest::collection::vec(any::<u8>(), 255), zeros_from in 0..=255_usize) {
        bytes[zeros_from..].fill(0);
        let mut buffer = [0xAA; 255];
        let raw = Raw(bytes.clone());
        let expected = bytes.iter().rposition(|&byte| byte != 0).map_or(1, |last| last + 1);
        prop_assert_eq!(raw.payload(Version::V2, &mut buffer), &bytes[..expected]);
        prop_assert_eq!(raw.payload(Version::V1, &mut buffer), &bytes[..100]);
    }
}

fn comes_back(message: &dyn Encode, bytes: &[u8]) {
    let (mut buffer, info) = ([0xAA; 255], message.info());
    let mut expected = bytes.to_vec();
    expected.resize(usize::from(info.len_v2), 0);
    assert_eq!(message.payload(Version::V1, &mut buffer), &expected[..usize::from(info.len_v1)]);
    while expected.len() > 1 && expected.last() == Some(&0) {
        expected.pop();
    }
    assert_eq!(message.payload(Version::V2, &mut buffer), expected);
}

/// A message of the largest size.
struct Raw(Vec<u8>);

impl Encode for Raw {
    fn info(&self) -> &'static MessageInfo {
        const { &MessageInfo::new(1, "RAW", 0, 255).len_v1(100) }
    }

    fn write(&self, payload: &mut [u8; 255]) {
        payload.copy_from_slice(&self.0);
    }
}
