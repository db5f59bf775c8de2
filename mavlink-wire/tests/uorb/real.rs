//! Logs of real vehicles, which lie in a folder that `PX4_LOGS` names: they are no part of the project.

use std::{env, fs};

use mavlink_wire::uorb::ulog::{End, Log};

use crate::topic::EscStatus;

#[test]
#[ignore = "needs the folder that PX4_LOGS names"]
fn every_record_of_real_logs_is_read() {
    let folder = env::var("PX4_LOGS").unwrap();
    // Records, the sum of all rpm, and the first and last time, as pyulog reads them.
    for (name, records, rpm, first, last) in [
        ("esc_status_log", 127, 1_186_791, 5_081_348_405, 5_120_249_475),
        ("sample_px4_events", 126, 475_273, 1_710_773_350_354_000, 1_710_773_381_350_000),
        ("ekf_failure", 320, 11_335_996, 46_943_859, 126_436_382),
    ] {
        let bytes = fs::read(format!("{folder}/{name}.esc.ulg")).unwrap();
        let log = Log::new(&bytes).unwrap();
        let mut samples = log.read::<EscStatus>();
        let read: Vec<_> = samples.by_ref().map(|(_, status)| status).collect();
        let sum: i64 = read.iter().flat_map(|status| &status.esc).map(|esc| i64::from(esc.esc_rpm)).sum();
        let times = (read.first().map(|status| status.timestamp), read.last().map(|status| status.timestamp));
        assert_eq!((read.len(), sum, times), (records, rpm, (Some(first), Some(last))), "{name}");
        assert_eq!((samples.unreadable(), samples.end()), (0, End::Complete), "{name}");
    }
}
