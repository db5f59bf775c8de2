//! Sequences of signed frames: the runtime thinks of each what the C library thinks of it.

use mavlink_autoquad::autoquad::{Autoquad, Heartbeat, SetupSigning};
use mavlink_conformance::sequences::{self, Arrival, SIGNING};
use mavlink_conformance::vectors::key;
use mavlink_wire::signing::{Key, Setup, Signer, SigningError, Trust, Verifier};
use mavlink_wire::{Dialect, Encode, Frame, MAX_FRAME, Message, Sender, Timestamp};

fn verdict(result: Result<Trust, SigningError>) -> &'static str {
    match result {
        Ok(Trust::Signed) => "signed",
        Ok(Trust::Allowed) => "allowed",
        Err(SigningError::Unsigned { .. }) => "unsigned",
        Err(SigningError::WrongHash { .. }) => "wrong_hash",
        Err(SigningError::Replayed { .. }) => "replayed",
        Err(SigningError::TooOld { .. }) => "too_old",
        Err(SigningError::TooManyStreams { limit: 16 }) => "too_many_streams",
        other => panic!("the C library has no {other:?}"),
    }
}

#[test]
fn every_verdict_and_every_time_is_that_of_the_c_library() {
    let mut frames = 0;
    for sequence in sequences::read(SIGNING) {
        let mut verifier = Verifier::new(Some(Key::new(key())));
        verifier.advance_time(Timestamp::new(sequence.time));
        for (at, arrival) in sequence.arrivals.iter().enumerate() {
            let frame = Frame::parse(&arrival.bytes, Autoquad::TABLE).unwrap();
            let found = (verdict(verifier.check(&frame, Timestamp::ZERO)), verifier.timestamp().units());
            assert_eq!(found, (&*arrival.verdict, arrival.time), "{} {at}", sequence.name);
            frames += 1;
        }
    }
    assert!(frames >= 79, "{frames}");
}

/// pymavlink 2.4.50 stores the time of a stream before it looks at the hash: after a forged frame it refuses genuine ones. It
/// also counts no streams. Everywhere else it agrees.
#[test]
fn pymavlink_differs_only_where_it_stores_the_time_too_early_and_bounds_no_streams() {
    let differs = |arrival: &&Arrival| arrival.is_accepted() != arrival.accepted_by_pymavlink;
    let mut differences = vec![];
    for sequence in sequences::read(SIGNING) {
        let verdicts = sequence.arrivals.iter().filter(differs).map(|arrival| arrival.verdict.clone());
        differences.extend(verdicts.map(|verdict| (sequence.name.clone(), verdict)));
    }
    let expected = [
        ("forged_then_genuine", "signed"),
        ("forged_then_genuine", "signed"),
        ("forged_first", "signed"),
        ("seventeen_streams", "too_many_streams"),
    ];
    assert_eq!(differences, expected.map(|(name, verdict)| (name.to_owned(), verdict.to_owned())));
}

/// Up to the last timestamp: behind it pymavlink's starts at zero again, where all it signs is older than before.
#[test]
fn a_sender_counts_the_time_as_pymavlinks_does() {
    for name in ["one_stream", "end_of_time"] {
        let sequence = sequences::read(SIGNING).into_iter().find(|sequence| sequence.name == name).unwrap();
        let frames = sequence.arrivals.iter().map(|arrival| Frame::parse(&arrival.bytes, Autoquad::TABLE).unwrap());
        let first = frames.clone().next().unwrap();
        let signature = first.signature().unwrap();
        let signer = Signer::new(Key::new(key()), signature.link_id(), signature.timestamp());
        let mut sender = Sender::v2(first.system_id(), first.component_id()).signed(signer);
        let before_the_end =
            |frame: &Frame<'_>| frame.signature().is_some_and(|next| next.timestamp() >= signature.timestamp());
        for frame in frames.take_while(before_the_end) {
            sender.set_sequence(0);
            let message: Heartbeat = frame.decode().unwrap();
            assert_eq!(sender.encode(&message, &mut [0xA5; MAX_FRAME]), Ok(frame.bytes()), "{name}");
        }
    }
}

#[test]
fn a_setup_is_the_setup_signing_of_the_dialect() {
    let timestamp = Timestamp::new(0x0102_0304_0506);
    let setup = Setup::new(7, 8, Key::new(key()), timestamp).unwrap();
    let message =
        SetupSigning { target_system: 7, target_component: 8, secret_key: key(), initial_timestamp: timestamp.units() };
    assert_eq!(setup.info(), SetupSigning::INFO);
    for (setup, message) in [
        (setup, message),
        (Setup::off(7, 8).unwrap(), SetupSigning { target_system: 7, target_component: 8, ..SetupSigning::DEFAULT }),
    ] {
        let mut buffer = [0xA5; MAX_FRAME];
        let frame = Sender::v2(255, 190).encode(&message, &mut buffer).unwrap();
        assert_eq!(Sender::v2(255, 190).encode(&setup, &mut [0xA5; MAX_FRAME]), Ok(frame));
        let received = Setup::decode(&Frame::parse(frame, Autoquad::TABLE).unwrap()).unwrap();
        assert!(received.target_system() == 7 && received.target_component() == 8);
        let key = received.key().map(|(key, timestamp)| (*key.as_bytes(), timestamp.units()));
        let off = (message.secret_key, message.initial_timestamp) == ([0; 32], 0);
        assert_eq!(key, (!off).then_some((message.secret_key, message.initial_timestamp)));
    }
}

/// Of a message that carries a key, whichever way it is printed: no byte of it, in decimal or hexadecimal.
#[test]
fn a_key_is_never_printed() {
    let setup = SetupSigning { secret_key: [0xa7; 32], initial_timestamp: 5, ..SetupSigning::DEFAULT };
    let message = Autoquad::from(setup);
    let (mut sender, mut buffer) = (Sender::v2(255, 190), [0; MAX_FRAME]);
    let frame = Frame::parse(sender.encode(&setup, &mut buffer).unwrap(), Autoquad::TABLE).unwrap();
    let reflected = frame.reflect::<Autoquad>().unwrap();
    let elements: Vec<String> =
        reflected.fields().flat_map(|field| field.elements()).map(|element| element.to_string()).collect();
    let texts = [
        format!("{setup:?}"),
        format!("{setup:#?}"),
        format!("{message:?}"),
        format!("{frame:?}"),
        reflected.to_string(),
        elements.join(" "),
    ];
    for text in texts {
        assert!(text.contains("secret"), "{text}");
        for digits in ["167", "a7", "A7"] {
            assert!(!text.contains(digits), "{text}");
        }
    }
    assert_eq!(frame.message::<Autoquad>(), Some(message), "and it is there");
}
