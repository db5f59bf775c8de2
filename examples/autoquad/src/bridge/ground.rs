//! From the ground stations to the vehicle.

use std::collections::BTreeMap;

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::link::{Link, LinkError, SendHalf};
use mavlink_autoquad::wire::{ComponentId, Dialect, Frame, FrameBuf, MAX_FRAME, Sender, SystemId, Version};

use crate::failure::Failure;
use crate::station::refused;

/// Forwards all frames of a ground station until its link is closed.
pub(super) fn forward(mut link: Link, vehicle: &SendHalf) -> Result<(), Failure> {
    let mut older = Older::default();
    loop {
        let frame = match link.receive() {
            Ok(frame) => frame,
            Err(LinkError::Closed | LinkError::Ended) => return Ok(()),
            Err(error) => return Err(refused(&error)),
        };
        if let Some(frame) = older.frame(&frame) {
            // A vehicle that is not there now hears it not: ground stations ask again.
            let _ = vehicle.send_frame(&frame.as_frame());
        }
    }
}

/// Makes MAVLink 1 of MAVLink 2, which AutoQuad does not understand.
#[derive(Default)]
pub(super) struct Older {
    senders: BTreeMap<(SystemId, ComponentId), Sender>,
}

impl Older {
    /// The frame in MAVLink 1, numbered anew; `None` if MAVLink 1 has no such message.
    pub(super) fn frame(&mut self, frame: &Frame<'_>) -> Option<FrameBuf> {
        let (system, component) = (frame.system_id(), frame.component_id());
        let sender = self.senders.entry((system, component));
        let sender = sender.or_insert_with(|| Sender::v1(system, component));
        match frame.version() {
            Version::V1 => sender.renumber(frame).ok(),
            Version::V2 => {
                let mut buffer = [0; MAX_FRAME];
                let bytes = sender.encode(&frame.message::<Autoquad>()?, &mut buffer).ok()?;
                Frame::parse(bytes, Autoquad::TABLE).ok().map(FrameBuf::from)
            }
        }
    }
}
