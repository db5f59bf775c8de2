//! From the ground stations to the vehicle.

use std::collections::BTreeMap;
use std::sync::mpsc;
use std::thread::{self, JoinHandle};

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::link::{Link, LinkError, SendHalf};
use mavlink_autoquad::wire::{ComponentId, Dialect, Frame, FrameBuf, MAX_FRAME, Sender, SystemId, Version};

use crate::failure::Failure;
use crate::station::refused;

/// How a link has ended.
type End = Result<(), Failure>;

/// The ground stations, each with a thread that forwards what it sends.
pub(super) struct Ground {
    sending: Vec<SendHalf>,
    threads: Vec<JoinHandle<()>>,
    ends: (mpsc::Sender<End>, mpsc::Receiver<End>),
}

impl Default for Ground {
    fn default() -> Self {
        Self { sending: Vec::new(), threads: Vec::new(), ends: mpsc::channel() }
    }
}

impl Ground {
    /// Adds a ground station, which is heard by the vehicle from now on.
    pub(super) fn add(&mut self, link: Link, vehicle: SendHalf) {
        self.sending.push(link.sending());
        let end = self.ends.0.clone();
        self.threads.push(thread::spawn(move || drop(end.send(forward(link, &vehicle)))));
    }

    /// Sends frames to all. A ground station that is not there now is no fault, and one that is slow has lost a frame.
    pub(super) fn send(&self, frames: &[FrameBuf]) {
        for frame in frames {
            for ground in &self.sending {
                let _ = ground.send_frame(&frame.as_frame());
            }
        }
    }

    /// How the link to a ground station has ended, if one has.
    pub(super) fn ended(&self) -> Option<End> {
        self.ends.1.try_recv().ok()
    }

    /// Closes all links.
    pub(super) fn close(self) {
        self.sending.iter().for_each(SendHalf::close);
        self.threads.into_iter().for_each(|thread| drop(thread.join()));
    }
}

/// Forwards all frames of a ground station until its link is closed.
fn forward(mut link: Link, vehicle: &SendHalf) -> End {
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
