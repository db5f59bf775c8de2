//! A model that somebody changed by hand: what is not legal any more is told, and nothing panics.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::path::Path;

use mavgen::ir::{EnumId, FieldIndex, Values, Word};
use mavgen::{Builder, Failure, Resolved};

fn resolved() -> (Builder, Resolved) {
    let xml = Path::new("../xml");
    let builder = Builder::new(xml.join("autoquad.xml")).overlay(xml.join("overlay/autoquad.xml"));
    let resolved = builder.resolve().unwrap();
    (builder, resolved)
}

#[test]
fn what_is_resolved_is_legal() {
    let (builder, resolved) = resolved();
    assert_eq!(resolved.dialect.validate().map(|valid| valid.name.clone()), Ok("autoquad".to_owned()));
    assert!(!builder.emit(&resolved).unwrap().is_empty());
}

#[test]
fn what_was_made_illegal_is_not_generated() {
    let (builder, mut resolved) = resolved();
    resolved.dialect.messages[0].crc_extra ^= 1;
    resolved.dialect.messages[0].fields[0].values = Some(Values::Typed(EnumId(usize::MAX)));
    let mut messages = resolved.dialect.messages.iter_mut();
    let message = messages.find(|message| message.name.text == "AQ_ESC_TELEMETRY").unwrap();
    message.views[0].words[0] = Word::Joined(FieldIndex(usize::MAX));
    let failure = builder.emit(&resolved).unwrap_err();
    let Failure::Model(faults) = &failure else { unreachable!("{failure}") };
    assert!(faults.len() >= 3, "{failure}");
    let said = failure.to_string();
    assert!(said.starts_with("the model is not legal:\nmessage `HEARTBEAT`: its `crc_extra` is another\n"), "{said}");
}
