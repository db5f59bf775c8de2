//! Frames that a router signs for another link.

use super::*;
use mavlink_wire::{EncodeError, FrameBuf, Table};

fn kept(bytes: &[u8]) -> FrameBuf {
    Frame::parse(bytes, &Table::of(&[])).unwrap().into()
}

#[test]
fn another_links_signature_replaces_the_old_one() {
    let other = Key::new([9; 32]);
    let expected = made(&mut Sender::v2(1, 1).signed(Signer::new(other.clone(), 7, at(5))), &HEARTBEAT);
    for before in [frame_at(1000), made(&mut Sender::v2(1, 1), &HEARTBEAT)] {
        let (mut frame, mut signer) = (kept(&before), Signer::new(other.clone(), 7, at(5)));
        assert_eq!(frame.sign(&mut signer), Ok(()));
        assert_eq!((frame.bytes(), signer.timestamp()), (&expected[..], at(6)));
        assert_eq!(frame.as_frame(), kept(&expected).as_frame());
    }
}

#[test]
fn what_cannot_be_signed_stays_as_it_was() {
    let mut signer = Signer::new(key(), 7, at(5));
    let v1 = made(&mut Sender::v1(1, 1), &HEARTBEAT);
    let setup = made(&mut Sender::v2(1, 1), &mavlink_wire::signing::Setup::off(1, 1).unwrap());
    for (bytes, refusal) in [(v1, EncodeError::SignatureInV1 { message_id: 0 }), (setup, EncodeError::CarriesKey)] {
        let mut frame = kept(&bytes);
        assert_eq!(frame.sign(&mut signer), Err(refusal));
        assert_eq!((frame.bytes(), signer.timestamp()), (&bytes[..], at(5)));
    }
}

#[test]
fn a_forwarded_frame_is_numbered_and_signed_as_the_senders_own() {
    let mut sender = Sender::v2(1, 1).signed(Signer::new(key(), 7, at(5)));
    let mut own = sender.clone();
    for before in [frame_at(1000), made(&mut Sender::v2(1, 1), &HEARTBEAT)] {
        let forwarded = sender.renumber(&kept(&before).as_frame()).unwrap();
        assert_eq!(forwarded.bytes(), made(&mut own, &HEARTBEAT));
    }
    let v1 = made(&mut Sender::v1(1, 1), &HEARTBEAT);
    assert_eq!(sender.renumber(&kept(&v1).as_frame()), Err(EncodeError::SignatureInV1 { message_id: 0 }));
    assert_eq!((sender.sequence(), sender.signer()), (2, own.signer()));
}

#[test]
fn a_new_number_takes_the_signature_along() {
    let mut frame = kept(&frame_at(1000));
    frame.set_sequence(0);
    assert_eq!(frame.bytes(), made(&mut Sender::v2(1, 1), &HEARTBEAT));
}
