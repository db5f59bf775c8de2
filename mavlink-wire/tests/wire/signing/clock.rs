//! Time: conversions, how far behind a stream may start, clocks that jump.

use std::time::Duration;

use super::*;

#[test]
fn timestamps_count_ten_microseconds_since_2015() {
    const START: u64 = 1_420_070_400_000_000;
    for (unix, units) in [(0, 0), (START, 0), (START + 9, 0), (START + 10, 1), (START + 60_000_000, MINUTE)] {
        assert_eq!(Timestamp::from_unix_micros(unix).units(), units, "{unix}");
    }
    assert_eq!(Timestamp::from_unix_micros(u64::MAX), Timestamp::MAX);
    assert_eq!((Timestamp::new(1 << 48), Timestamp::MAX.units()), (Timestamp::MAX, 0xFFFF_FFFF_FFFF));
    assert_eq!(at(123_456).to_unix_micros(), START + 1_234_560);
    assert_eq!(Timestamp::from_unix_micros(Timestamp::MAX.to_unix_micros()), Timestamp::MAX);
    assert_eq!(at(1).saturating_add(Duration::from_secs(60)), at(MINUTE + 1));
    assert_eq!(
        (at(1).saturating_add(Duration::MAX), at(1).saturating_add(Duration::from_micros(9))),
        (Timestamp::MAX, at(1))
    );
}

#[test]
fn a_stream_may_start_one_minute_behind_and_no_more() {
    let local = at(10 * MINUTE);
    for (behind, expected) in [
        (0, Ok(Trust::Signed)),
        (MINUTE, Ok(Trust::Signed)),
        (MINUTE + 1, Err(SigningError::TooOld { timestamp: at(9 * MINUTE - 1), local })),
    ] {
        let mut verifier = Verifier::new(Some(key()));
        let frame = frame_at(10 * MINUTE - behind);
        assert_eq!(verifier.check(&Frame::parse(&frame, Small::TABLE).unwrap(), local), expected, "{behind}");
        assert_eq!((verifier.streams().len(), verifier.timestamp()), (usize::from(expected.is_ok()), local));
    }
}

#[test]
fn a_known_stream_may_be_as_far_behind_as_it_likes() {
    let mut verifier = Verifier::new(Some(key()));
    assert_eq!(checked(&mut verifier, &frame_at(1000)), Ok(Trust::Signed));
    verifier.advance_time(at(100 * MINUTE));
    assert_eq!(checked(&mut verifier, &frame_at(1001)), Ok(Trust::Signed));
}

#[test]
fn a_frame_of_the_future_takes_the_local_time_along() {
    let mut verifier = Verifier::new(Some(key()));
    assert_eq!(checked(&mut verifier, &frame_at(10 * MINUTE)), Ok(Trust::Signed));
    assert_eq!(verifier.timestamp(), at(10 * MINUTE));
    let refusal = SigningError::TooOld { timestamp: at(9 * MINUTE - 1), local: at(10 * MINUTE) };
    assert_eq!(checked(&mut verifier, &frame_of(stream(4, 1, 1, 9 * MINUTE - 1))), Err(refusal));
    let mut signer = Signer::new(key(), 0, at(5));
    signer.advance_time(verifier.timestamp());
    assert_eq!(signer.timestamp(), at(10 * MINUTE));
}

#[test]
fn a_clock_that_jumps_back_opens_nothing() {
    let mut verifier = Verifier::new(Some(key()));
    verifier.advance_time(at(10 * MINUTE));
    let old = frame_at(MINUTE);
    let refusal = SigningError::TooOld { timestamp: at(MINUTE), local: at(10 * MINUTE) };
    assert_eq!(verifier.check(&Frame::parse(&old, Small::TABLE).unwrap(), at(MINUTE)), Err(refusal));
    assert_eq!(verifier.timestamp(), at(10 * MINUTE));
}

#[test]
fn a_clock_that_jumps_ahead_leaves_known_streams_alone() {
    let mut verifier = Verifier::new(Some(key()));
    assert_eq!(checked(&mut verifier, &frame_at(1000)), Ok(Trust::Signed));
    let frame = frame_at(1001);
    let frame = Frame::parse(&frame, Small::TABLE).unwrap();
    assert_eq!(verifier.check(&frame, Timestamp::MAX), Ok(Trust::Signed));
    assert_eq!(verifier.streams(), [stream(3, 1, 1, 1001)]);
}

/// One day.
const DAY: u64 = 24 * 60 * MINUTE;

#[test]
fn a_clock_in_the_future_stops_nobody_who_has_a_clock() {
    let now = at(100 * DAY);
    let check =
        |verifier: &mut Verifier, stream| verifier.check(&Frame::parse(&frame_of(stream), Small::TABLE).unwrap(), now);
    let mut verifier = Verifier::new(Some(key()));
    let refusal = |timestamp| Err(SigningError::TooFarAhead { timestamp: at(timestamp), local: now });
    for timestamp in [101 * DAY + 1, Timestamp::MAX.units()] {
        assert_eq!(check(&mut verifier, stream(0, 9, 1, timestamp)), refusal(timestamp), "{timestamp}");
    }
    assert_eq!((verifier.streams().len(), verifier.timestamp()), (0, now));
    // A day ahead is believed, and goes along with what is told to the signers, but streams with the right time begin.
    assert_eq!(check(&mut verifier, stream(0, 9, 1, 101 * DAY)), Ok(Trust::Signed));
    assert_eq!(verifier.timestamp(), at(101 * DAY));
    assert_eq!(check(&mut verifier, stream(0, 1, 1, 100 * DAY - MINUTE)), Ok(Trust::Signed));
    let late = Err(SigningError::TooOld { timestamp: at(100 * DAY - MINUTE - 1), local: now });
    assert_eq!(check(&mut verifier, stream(0, 2, 1, 100 * DAY - MINUTE - 1)), late);
    // As well after a restart.
    let mut restarted = Verifier::new(Some(key()));
    assert_eq!(restarted.restore(verifier.timestamp(), verifier.streams()), Ok(()));
    assert_eq!(check(&mut restarted, stream(0, 3, 1, 100 * DAY)), Ok(Trust::Signed));
}

#[test]
fn without_a_clock_the_future_cannot_be_told() {
    let mut verifier = Verifier::new(Some(key()));
    verifier.advance_time(at(100 * DAY));
    assert_eq!(checked(&mut verifier, &frame_at(200 * DAY)), Ok(Trust::Signed));
    assert_eq!(verifier.timestamp(), at(200 * DAY));
}

#[test]
fn a_signer_stays_at_the_end_of_time() {
    let mut sender = Sender::v2(1, 1).signed(Signer::new(key(), 0, at(Timestamp::MAX.units() - 1)));
    let mut verifier = Verifier::new(Some(key()));
    let last = Timestamp::MAX;
    let verdicts = [Ok(Trust::Signed), Ok(Trust::Signed), Err(SigningError::Replayed { timestamp: last, last })];
    for expected in verdicts {
        assert_eq!(checked(&mut verifier, &made(&mut sender, &HEARTBEAT)), expected);
    }
}

#[test]
fn behind_the_last_timestamp_comes_nothing() {
    let mut verifier = Verifier::new(Some(key()));
    assert_eq!(checked(&mut verifier, &frame_at(Timestamp::MAX.units())), Ok(Trust::Signed));
    let refusal = SigningError::Replayed { timestamp: at(0), last: Timestamp::MAX };
    assert_eq!(checked(&mut verifier, &frame_at(0)), Err(refusal));
}
