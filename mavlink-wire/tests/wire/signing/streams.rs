//! Streams: nothing is taken twice, and there are only so many.

use super::*;

#[test]
fn a_frame_is_taken_once() {
    let mut verifier = Verifier::new(Some(key()));
    for (timestamp, last) in [(1000, None), (1000, Some(1000)), (999, Some(1000)), (1001, None), (1000, Some(1001))] {
        let expected = match last {
            None => Ok(Trust::Signed),
            Some(last) => Err(SigningError::Replayed { timestamp: at(timestamp), last: at(last) }),
        };
        assert_eq!(checked(&mut verifier, &frame_at(timestamp)), expected, "{timestamp}");
    }
    assert_eq!(verifier.streams(), [stream(3, 1, 1, 1001)]);
}

#[test]
fn link_system_and_component_make_a_stream() {
    let mut verifier = Verifier::new(Some(key()));
    let streams = [stream(3, 1, 1, 1000), stream(4, 1, 1, 900), stream(3, 2, 1, 800), stream(3, 1, 2, 700)];
    for &stream in &streams {
        assert_eq!(checked(&mut verifier, &frame_of(stream)), Ok(Trust::Signed));
    }
    for &stream in &streams {
        let refusal = SigningError::Replayed { timestamp: stream.timestamp, last: stream.timestamp };
        assert_eq!(checked(&mut verifier, &frame_of(stream)), Err(refusal));
    }
    assert_eq!(verifier.streams(), streams);
}

#[test]
fn the_seventeenth_stream_is_refused_and_the_others_go_on() {
    let mut verifier = Verifier::new(Some(key()));
    for system in 1..=16 {
        assert_eq!(checked(&mut verifier, &frame_of(stream(0, system, 1, 10 * MINUTE))), Ok(Trust::Signed));
    }
    let refusal = Err(SigningError::TooManyStreams { limit: 16 });
    for timestamp in [0, 11 * MINUTE] {
        assert_eq!(checked(&mut verifier, &frame_of(stream(0, 17, 1, timestamp))), refusal, "{timestamp}");
    }
    assert_eq!((verifier.streams().len(), verifier.timestamp()), (16, at(10 * MINUTE)));
    for system in 1..=16 {
        assert_eq!(checked(&mut verifier, &frame_of(stream(0, system, 1, 10 * MINUTE + 1))), Ok(Trust::Signed));
    }
}

#[test]
fn the_bound_is_the_callers() {
    let refusal = |limit| Err(SigningError::TooManyStreams { limit });
    assert_eq!(checked(&mut Verifier::<0>::with_streams(Some(key())), &frame_at(1)), refusal(0));
    let mut one = Verifier::<1>::with_streams(Some(key()));
    assert_eq!(checked(&mut one, &frame_at(1)), Ok(Trust::Signed));
    assert_eq!(checked(&mut one, &frame_of(stream(3, 1, 2, 1))), refusal(1));
}

#[test]
fn a_forger_uses_no_stream_up() {
    let mut verifier = Verifier::new(Some(key()));
    for system in 1..=255 {
        let mut forged = frame_of(stream(0, system, 1, 1000));
        *forged.last_mut().unwrap() ^= 1;
        assert_eq!(
            checked(&mut verifier, &forged),
            Err(SigningError::WrongHash { link_id: 0, system_id: system.into(), component_id: 1.into() })
        );
    }
    assert_eq!(verifier.streams(), []);
}

#[test]
fn forgotten_streams_make_room_and_cannot_be_replayed() {
    let mut verifier = Verifier::<3>::with_streams(Some(key()));
    let streams = [stream(0, 1, 1, MINUTE - 1), stream(0, 2, 1, MINUTE), stream(0, 3, 1, 2 * MINUTE - 1)];
    for &stream in &streams {
        assert_eq!(checked(&mut verifier, &frame_of(stream)), Ok(Trust::Signed));
    }
    assert_eq!(verifier.forget_stale(), 0);
    verifier.advance_time(at(2 * MINUTE));
    assert_eq!((verifier.forget_stale(), verifier.streams()), (1, &streams[1..]));
    let refusal = SigningError::TooOld { timestamp: at(MINUTE - 1), local: at(2 * MINUTE) };
    assert_eq!(checked(&mut verifier, &frame_of(streams[0])), Err(refusal));
    assert_eq!(checked(&mut verifier, &frame_of(stream(0, 4, 1, 2 * MINUTE))), Ok(Trust::Signed));
}

#[test]
fn a_table_of_stale_streams_makes_room() {
    let mut verifier = Verifier::<2>::with_streams(Some(key()));
    for system in [1, 2] {
        assert_eq!(checked(&mut verifier, &frame_of(stream(0, system, 1, MINUTE))), Ok(Trust::Signed));
    }
    assert!(checked(&mut verifier, &frame_of(stream(0, 3, 1, MINUTE))).is_err(), "both are in use");
    verifier.advance_time(at(2 * MINUTE));
    assert!(checked(&mut verifier, &frame_of(stream(0, 3, 1, 2 * MINUTE))).is_err(), "a minute is not over");
    verifier.advance_time(at(2 * MINUTE + 1));
    assert_eq!(checked(&mut verifier, &frame_of(stream(0, 3, 1, 2 * MINUTE))), Ok(Trust::Signed));
    assert_eq!(verifier.streams(), [stream(0, 3, 1, 2 * MINUTE)]);
}

#[test]
fn a_restored_verifier_takes_no_frame_again() {
    let mut before = Verifier::new(Some(key()));
    let streams = [stream(3, 1, 1, 1000), stream(4, 1, 1, 900)];
    for &stream in &streams {
        assert_eq!(checked(&mut before, &frame_of(stream)), Ok(Trust::Signed));
    }
    let mut after = Verifier::new(Some(key()));
    assert_eq!(after.restore(before.timestamp(), before.streams()), Ok(()));
    assert_eq!((after.timestamp(), after.streams()), (at(1000), &streams[..]));
    for &stream in &streams {
        let refusal = SigningError::Replayed { timestamp: stream.timestamp, last: stream.timestamp };
        assert_eq!(checked(&mut after, &frame_of(stream)), Err(refusal));
    }
}

#[test]
fn restoring_sets_nothing_back() {
    let mut verifier = Verifier::<1>::with_streams(Some(key()));
    assert_eq!(checked(&mut verifier, &frame_at(1000)), Ok(Trust::Signed));
    let saved = [stream(3, 1, 1, 900), stream(4, 1, 1, 900)];
    assert_eq!(verifier.restore(at(900), &saved), Err(SigningError::TooManyStreams { limit: 1 }));
    assert_eq!((verifier.timestamp(), verifier.streams()), (at(1000), &[stream(3, 1, 1, 1000)][..]));
    assert_eq!(verifier.restore(at(2000), &[stream(3, 1, 1, 1500)]), Ok(()));
    assert_eq!((verifier.timestamp(), verifier.streams()), (at(2000), &[stream(3, 1, 1, 1500)][..]));
    let behind_one_without_room = [stream(4, 1, 1, 900), stream(3, 1, 1, 1600)];
    assert!(verifier.restore(at(2000), &behind_one_without_room).is_err());
    assert_eq!(verifier.streams(), [stream(3, 1, 1, 1600)]);
}
