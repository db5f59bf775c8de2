//! Frames without a signature, and what a rule can allow.

use super::*;
use mavlink_wire::MessageInfo;

static RADIO_STATUS: MessageInfo = MessageInfo::new(109, "RADIO_STATUS", 185, 9);

struct RadioStatus;

impl Encode for RadioStatus {
    fn info(&self) -> &'static MessageInfo {
        &RADIO_STATUS
    }
    fn write(&self, payload: &mut [u8; 255]) {
        payload[..9].fill(1);
    }
}

#[test]
fn unsigned_frames_are_refused_in_both_versions() {
    let mut verifier = Verifier::new(Some(key()));
    for mut sender in [Sender::v1(1, 1), Sender::v2(1, 1)] {
        let refusal = SigningError::Unsigned { message_id: 0 };
        assert_eq!(checked(&mut verifier, &made(&mut sender, &HEARTBEAT)), Err(refusal));
    }
}

#[test]
fn radio_status_needs_no_signature() {
    let mut verifier = Verifier::new(Some(key()));
    for mut sender in [Sender::v1(51, 68), Sender::v2(51, 68)] {
        assert_eq!(checked(&mut verifier, &made(&mut sender, &RadioStatus)), Ok(Trust::Allowed));
    }
    let signed = made(&mut Sender::v2(51, 68).signed(Signer::new(key(), 0, at(1))), &RadioStatus);
    assert_eq!(checked(&mut verifier, &signed), Ok(Trust::Signed));
    assert_eq!(checked(&mut verifier, &signed), Ok(Trust::Allowed));
}

#[test]
fn a_rule_is_asked_about_what_no_signature_vouches_for_and_leaves_no_trace() {
    let (good, mut forged) = (frame_at(1000), frame_at(1001));
    *forged.last_mut().unwrap() ^= 1;
    let plain = made(&mut Sender::v2(1, 1), &HEARTBEAT);
    let mut verifier = Verifier::new(Some(key()));
    let mut asked = vec![];
    for (bytes, rule, expected) in [
        (&forged, true, Ok(Trust::Allowed)),
        (&plain, true, Ok(Trust::Allowed)),
        (&plain, false, Err(SigningError::Unsigned { message_id: 0 })),
        (&good, false, Ok(Trust::Signed)),
        (&good, true, Ok(Trust::Allowed)),
    ] {
        let frame = Frame::parse(bytes, Small::TABLE).unwrap();
        let allow = |frame: &Frame<'_>| {
            asked.push(frame.message_id());
            rule
        };
        assert_eq!(verifier.check_with(&frame, at(0), allow), expected);
    }
    assert_eq!((asked, verifier.streams()), (vec![0; 4], &[stream(3, 1, 1, 1000)][..]));
}

#[test]
fn without_a_key_everything_passes_and_nothing_is_claimed() {
    let mut verifier = Verifier::new(None);
    let mut forged = frame_at(1001);
    *forged.last_mut().unwrap() ^= 1;
    for bytes in [frame_at(1000), frame_at(1000), forged, made(&mut Sender::v1(1, 1), &HEARTBEAT)] {
        assert_eq!(checked(&mut verifier, &bytes), Ok(Trust::Unchecked));
    }
    assert_eq!((verifier.streams(), verifier.timestamp()), (&[][..], at(0)));
}
