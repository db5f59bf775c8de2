//! A command that the program may stop.

use mavlink_wire::Frame;

use crate::command::{Accepted, Failure, Progress, Send};
use crate::{Instant, Output, Service, Update};

/// A command that goes on while a closure says so.
pub(super) struct While<G> {
    send: Send,
    go_on: G,
}

impl<G: FnMut(Progress) -> bool> While<G> {
    pub(super) fn new(send: Send, go_on: G) -> Self {
        Self { send, go_on }
    }
}

impl<G: FnMut(Progress) -> bool> Service for While<G> {
    type Event = Update<Progress, Accepted, Failure>;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        self.send.handle(frame, now);
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        let output = self.send.poll(now)?;
        if let Output::Event(Update::Progress(progress)) = output
            && !(self.go_on)(progress)
        {
            self.send.cancel(now);
        }
        Some(output)
    }

    fn deadline(&self) -> Option<Instant> {
        self.send.deadline()
    }
}
