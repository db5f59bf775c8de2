//! `mavlink_core::Message` of a dialect; its connections, and all messages of a real dialect, are tested in `tests/interop`.

use mavlink_core::Message;
use mavlink_wire::Message as _;

use crate::small::{Heartbeat, Small};

#[test]
fn messages_are_found_by_name_and_by_id() {
    for (name, id) in [("HEARTBEAT", Some(0)), ("STATUSTEXT", Some(253)), ("heartbeat", None), ("", None)] {
        assert_eq!(Small::message_id_from_name(name), id, "{name}");
    }
    for (id, crc_extra) in [(0, 50), (253, 83), (1, 0)] {
        assert_eq!(Small::extra_crc(id), crc_extra, "{id}");
    }
    let beat = Small::Heartbeat(Heartbeat::DEFAULT);
    assert_eq!((Small::default_message_from_id(0), Small::default_message_from_id(1)), (Some(beat), None));
    assert_eq!((beat.message_id(), beat.message_name(), beat.target_system_id()), (0, "HEARTBEAT", None));
}
