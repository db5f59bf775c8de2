//! Every public error: small, `Copy`, an [`Error`], and says what to do.

use core::error::Error;

use mavlink_wire::{EncodeError, FrameError, OutOfRange, TooLong, UnknownName, ViewError};

/// An error, and a part of what it has to say. At most three words of 64 bits, so that firmware can keep it in a queue.
fn says<E: Error + Copy + Send + Sync + 'static>(error: E, part: &str) {
    assert!(size_of::<E>() <= 24, "{} bytes", size_of::<E>());
    let text = error.to_string();
    assert!(text.contains(part), "{text}");
    // What is wrong, and behind that what to do.
    assert!(text.contains([':', ';']) && !text.ends_with('.') && !text.contains('\n'), "{text}");
}

#[test]
fn errors_say_what_to_do() {
    says(EncodeError::IdTooLarge { message_id: 300 }, "send it with Sender::v2");
    says(EncodeError::SignatureInV1 { message_id: 300 }, "or do not sign");
    says(EncodeError::CarriesKey, "do not forward it");
    says(FrameError::NotStx { found: 0x55 }, "not 0x55: skip to the next");
    says(FrameError::Incomplete { needed: 21 }, "21 bytes: try again with more");
    says(FrameError::IncompatFlags { flags: 4 }, "0x04 are not known here: discard");
    says(FrameError::Checksum { message_id: 152 }, "message 152: discard");
    says(TooLong { length: 60, capacity: 50 }, "60 bytes do not fit a field of 50: shorten");
    says(UnknownName { name: "MAV_STATE" }, "MAV_STATE: use a name");
    says(OutOfRange, "nothing was set");
    says(ViewError::OutOfRange, "nothing was set");
    says(ViewError::Absent, "another switch value");
    says(ViewError::NoSuchSlot, "add one first");
    says(ViewError::Full, "start another message");
}

#[cfg(feature = "embedded-io")]
#[test]
fn errors_of_links_say_what_to_do() {
    use mavlink_wire::embedded_io::{ReceiveError, SendError};

    type Link = SendError<embedded_io::ErrorKind>;
    says(Link::Encode(EncodeError::IdTooLarge { message_id: 300 }), "send it with Sender::v2");
    says(Link::Link(embedded_io::ErrorKind::BrokenPipe), "the link has failed: ");
    says(Link::NothingTaken, "open it again");
    says(ReceiveError::Link(embedded_io::ErrorKind::BrokenPipe), "the link has failed: ");
    says(ReceiveError::<embedded_io::ErrorKind>::NothingYet, "read again");
}

#[cfg(feature = "signing")]
#[test]
fn errors_of_signing_say_what_to_do() {
    use mavlink_wire::Timestamp;
    use mavlink_wire::signing::SigningError;

    let (timestamp, local) = (Timestamp::new(7), Timestamp::new(9));
    says(SigningError::Unsigned { message_id: 1 }, "message 1 is not signed: discard");
    says(SigningError::WrongHash { link_id: 1, system_id: 2.into(), component_id: 3.into() }, "link 1 of 2/3");
    says(SigningError::Replayed { timestamp, last: local }, "timestamp 7 is not after 9");
    says(SigningError::TooOld { timestamp, local }, "timestamp 7 of a new stream");
    says(SigningError::TooManyStreams { limit: 16 }, "all 16 streams are in use: make");
    let (timestamp, local) = (Timestamp::new(9), Timestamp::new(3));
    says(SigningError::TooFarAhead { timestamp, local }, "timestamp 9 is over a day ahead of 3: discard");
    says(SigningError::Broadcast { system_id: 1.into(), component_id: 0.into() }, "1/0, which are many: send");
}

#[cfg(feature = "std")]
#[test]
fn an_error_of_encoding_is_one_of_input_and_output() {
    let error = std::io::Error::from(EncodeError::CarriesKey);
    assert_eq!(error.kind(), std::io::ErrorKind::InvalidInput);
    assert_eq!(error.get_ref().and_then(|inner| inner.downcast_ref()), Some(&EncodeError::CarriesKey));
}
