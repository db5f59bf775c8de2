//! Any file as a log of PX4: read to its end, in the same records whoever walks over them, and no more than there are bytes for.

#![no_main]

use libfuzzer_sys::fuzz_target;
use mavlink_autoquad::px4::EscStatus;
use mavlink_autoquad::wire::uorb::ulog::{End, Log};

fuzz_target!(|bytes: &[u8]| {
    let Ok(log) = Log::new(bytes) else { return };
    let mut records = log.records();
    let (mut count, mut data, mut length) = (0, 0, 0);
    for record in records.by_ref() {
        count += 1;
        data += usize::from(record.kind == b'D');
        length += 3 + record.payload.len();
    }
    assert!(length <= bytes.len(), "{count} records of {length} bytes");
    if records.end() == End::Complete {
        assert!(length + 16 <= bytes.len());
    }
    let mut samples = log.read::<EscStatus>();
    let read = samples.by_ref().map(|(_, status)| status.motors().count()).collect::<Vec<_>>();
    assert!(read.len() + samples.unreadable() <= count, "{} of {data}", read.len());
    assert!(read.iter().all(|motors| *motors <= 12));
    assert_eq!(samples.end(), records.end());
    let _ = samples.fit().to_string();
    // Bound by hand, a record says what it says there.
    if let (Some(binding), true) = (log.bind::<EscStatus>("esc_status"), !read.is_empty()) {
        assert!(
            log.records()
                .filter(|record| record.kind == b'D')
                .any(|record| { record.payload.get(2..).and_then(|data| binding.read(data)).is_some() })
        );
    }
});
