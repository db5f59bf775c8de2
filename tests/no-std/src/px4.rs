//! A log of PX4 in flash, and a payload of CDR.

use mavlink_autoquad::px4::EscStatus;
use mavlink_autoquad::px4::px4_msgs::Px4Msgs;
use mavlink_autoquad::wire::uorb::ulog::{End, Log};
use mavlink_autoquad::wire::uorb::{Topic, TopicByLength};

static LOG: &[u8] = include_bytes!("../../vectors/px4/main.ulg");

/// How many motors the log tells of, 4 and 12, and 1 more if the last status is the same after it went out as CDR.
pub fn worth() -> u8 {
    let Ok(log) = Log::new(LOG) else { return 0 };
    let (mut statuses, mut motors, mut last) = (log.read::<EscStatus>(), 0_u8, EscStatus::UNKNOWN);
    for (_, status) in statuses.by_ref() {
        motors = motors.saturating_add(status.motors().fold(0, |count, _| count + 1));
        last = status;
    }
    let mut stream = log.messages::<Px4Msgs>();
    let streamed = stream.by_ref().last().map(|logged| logged.message);
    let is_whole = statuses.end() == End::Complete && statuses.unreadable() == 0 && streamed == Some(last.into());
    if is_whole { motors + u8::from(survives(&last)) } else { 0 }
}

fn survives(status: &EscStatus) -> bool {
    let mut buffer = [0; 512];
    let Ok(payload) = status.to_cdr(&EscStatus::MAIN, &mut buffer) else { return false };
    EscStatus::from_cdr(payload).is_ok_and(|read| read == *status)
}
