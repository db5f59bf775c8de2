//! Without the feature `commands` there are no types of commands, in the committed sources and in generated ones.
#![cfg(not(feature = "commands"))]

use mavlink_autoquad::autoquad::*;
use mavlink_autoquad::wire::Message;
use others::*;

/// Of two modules of one name that come by `*`, neither can be used: what compiles here would not if there were commands.
mod others {
    pub(super) mod commands {
        pub(crate) const OTHERS: u8 = 1;
    }
}

#[test]
fn only_their_types_are_not_there() {
    assert_eq!((commands::OTHERS, CommandLong::ID, MavCmd::NAV_TAKEOFF.0), (1, 76, 22));
    assert_eq!(MavCmd::AQ_TELEMETRY.params()[1].label, Some("Interval"));
}
