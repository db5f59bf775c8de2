//! Any bytes as a payload of CDR: refused, or a value that is written as what was read, in each definition that holds it.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavlink_autoquad::px4::EscStatus;
use mavlink_autoquad::wire::uorb::{CdrError, Topic, TopicByLength};

fuzz_target!(|bytes: &[u8]| {
    let by_length = EscStatus::from_cdr(bytes);
    let mut accepted = 0;
    for definition in EscStatus::DEFINITIONS {
        let Ok(status) = EscStatus::from_cdr_as(definition, bytes) else { continue };
        accepted += 1;
        let text = format!("{status:?}");
        assert_eq!(text, format!("{:?}", by_length.expect("of one definition, so of that length")));
        let mut buffer = [0; 512];
        let written = status.to_cdr(definition, &mut buffer).expect("what was read fits").to_vec();
        // Padding aside: what is not zero there is as it was.
        assert!(written.iter().zip(bytes).all(|(new, old)| new == old || *new == 0));
        let again = EscStatus::from_cdr_as(definition, &written).expect("what was written is read");
        assert_eq!(text, format!("{again:?}"));
        for other in EscStatus::DEFINITIONS {
            match status.to_cdr(other, &mut buffer) {
                Ok(payload) => assert!(EscStatus::from_cdr_as(other, payload).is_ok()),
                Err(error) => assert!(matches!(error, CdrError::DoesNotFit { .. })),
            }
        }
    }
    assert_eq!(accepted, usize::from(by_length.is_ok()));
});
