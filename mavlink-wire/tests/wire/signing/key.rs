//! The key: never shown, compared whole, made of a passphrase as ground stations do.

use super::*;

#[test]
fn a_key_is_never_shown() {
    let (key, shown) =
        (Key::new([0xA7; 32]), |text: String| text.contains("167") || text.to_lowercase().contains("a7"));
    let signer = Signer::new(key.clone(), 1, at(1));
    let sender = Sender::v2(1, 1).signed(signer.clone());
    let setup = mavlink_wire::signing::Setup::new(1, 1, key.clone(), at(1)).unwrap();
    let verifier = Verifier::new(Some(key.clone()));
    for text in [
        format!("{key:?}"),
        format!("{signer:?}"),
        format!("{sender:?}"),
        format!("{setup:?}"),
        format!("{verifier:?}"),
    ] {
        assert!(text.contains("Key(secret)") && !shown(text.clone()), "{text}");
    }
}

#[test]
fn a_key_is_wiped_when_dropped() {
    assert!(std::mem::needs_drop::<Key>());
}

#[test]
fn keys_are_equal_in_every_byte_or_not() {
    let mut other = *key().as_bytes();
    assert_eq!(Key::from(other), key());
    other[31] ^= 1;
    assert_ne!(Key::from(other), key());
    assert!(Key::new([0; 32]).is_zero() && !key().is_zero());
}

/// SHA-256 of the passphrase: FIPS 180-2, appendix B.1.
#[test]
fn a_passphrase_becomes_the_key_that_ground_stations_make_of_it() {
    let of_abc = Key::of_passphrase("abc");
    assert_eq!(of_abc.as_bytes()[..8], [0xba, 0x78, 0x16, 0xbf, 0x8f, 0x01, 0xcf, 0xea]);
    assert_eq!(of_abc.as_bytes()[28..], [0xf2, 0x00, 0x15, 0xad]);
}
