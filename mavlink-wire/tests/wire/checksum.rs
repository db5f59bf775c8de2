//! The checksum and its inverse.

use mavlink_wire::crc;
use proptest::prelude::*;

#[test]
fn check_value() {
    assert_eq!(crc::checksum(b"123456789"), 0x6F91);
    assert_eq!(b"123456789".iter().fold(0xFFFF, |crc, &byte| crc::step(crc, byte)), 0x6F91);
    assert_eq!(crc::checksum(b""), 0xFFFF);
}

#[test]
fn every_byte_is_found_again() {
    for before in (0..=0xFFFF).step_by(251) {
        for byte in 0..=255 {
            assert_eq!(crc::byte_between(before, crc::step(before, byte)), Some(byte));
        }
    }
}

#[test]
fn one_in_256_checksums_is_explained() {
    let explained = (0..=0xFFFF_u16).filter_map(|after| Some((after, crc::byte_between(0x1234, after)?)));
    let explained: Vec<_> = explained.collect();
    assert_eq!(explained.len(), 256);
    assert!(explained.iter().all(|&(after, byte)| crc::step(0x1234, byte) == after));
}

proptest! {
    #[test]
    fn the_table_and_the_steps_agree(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let steps = bytes.iter().fold(0xFFFF, |crc, &byte| crc::step(crc, byte));
        prop_assert_eq!(crc::checksum(&bytes), steps);
    }
}
