//! Messages that are asked for.

use core::marker::PhantomData;

use mavlink_wire::{Encode, Frame, Message};

use super::{Command, Failure, NoCommand};
use crate::common::{CommandAck, CommandLong, MavCmd, MavResult};
use crate::retry::Attempt;
use crate::{Address, Instant, Output, Retry, Service, Update};

/// Asks a peer for one message, which may be of your dialect, and waits for it.
///
/// ```text
///   new              the message comes
///  ─────▶ Asked ────────────────────────▶ Done
///         │ ▲ │   ack: refused              ▲
///         └─┘ └─────────────────────────────┘
///  no message:        asked often enough
///  asked again
/// ```
///
/// An acknowledgement alone is not enough: the message can be lost on its way, and is asked for again.
#[derive(Clone, Debug)]
pub struct Fetch<M> {
    own: Address,
    peer: Address,
    command: Command,
    attempt: Attempt,
    stage: Stage,
    end: Option<Result<M, Failure>>,
    message: PhantomData<fn() -> M>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    ToBeSent,
    Asked,
    Done,
}

impl<M: Message> Fetch<M> {
    /// Asks with `MAV_CMD_REQUEST_MESSAGE`; `argument` is what the message's definition says of it, often an index, else 0.
    #[must_use]
    pub fn new(own: Address, peer: Address, retry: Retry, argument: f32, now: Instant) -> Self {
        let (param1, param2) = (M::ID as f32, argument);
        let request = CommandLong { command: MavCmd::REQUEST_MESSAGE, param1, param2, ..CommandLong::DEFAULT };
        Self::asking(own, peer, retry, (Command::Long(request), now))
    }

    /// Asks with another command, for a peer that is older than `MAV_CMD_REQUEST_MESSAGE`.
    ///
    /// # Errors
    ///
    /// This is no command.
    pub fn with_command(
        own: Address,
        peer: Address,
        retry: Retry,
        command: &(impl Encode + ?Sized),
        now: Instant,
    ) -> Result<Self, NoCommand> {
        let message_id = command.info().id;
        let command = Command::from_message(command).ok_or(NoCommand { message_id })?;
        Ok(Self::asking(own, peer, retry, (command, now)))
    }

    fn asking(own: Address, peer: Address, retry: Retry, (command, now): (Command, Instant)) -> Self {
        let attempt = Attempt::start(retry, now);
        Self { own, peer, command, attempt, stage: Stage::ToBeSent, end: None, message: PhantomData }
    }

    fn finish(&mut self, end: Result<M, Failure>) {
        (self.stage, self.end) = (Stage::Done, Some(end));
    }

    fn acknowledge(&mut self, ack: &CommandAck) {
        let command = self.command.command();
        let for_us = self.own.is_target(ack.target_system, ack.target_component);
        if ack.command == command && for_us && !matches!(ack.result, MavResult::ACCEPTED | MavResult::IN_PROGRESS) {
            let (result, reason) = (ack.result, ack.result_param2);
            self.finish(Err(Failure::Refused { command, result, reason, progress: None }));
        }
    }
}

impl<M: Message> Service for Fetch<M> {
    type Event = Update<(), M, Failure>;

    fn handle(&mut self, frame: &Frame<'_>, _: Instant) {
        let asked = self.stage == Stage::Asked || (self.stage == Stage::ToBeSent && self.attempt.asked() > 1);
        if !asked || !self.peer.includes(Address::of(frame)) {
            return;
        }
        if let Some(message) = frame.decode::<M>() {
            self.finish(Ok(message));
        } else if let Some(ack) = frame.decode::<CommandAck>() {
            self.acknowledge(&ack);
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        if self.stage == Stage::Asked && !self.attempt.is_waiting(now) {
            if self.attempt.again(now) {
                self.stage = Stage::ToBeSent;
            } else {
                let (command, sent) = (self.command.command(), self.attempt.asked());
                self.finish(Err(Failure::Timeout { command, sent, progress: None }));
            }
        }
        if let Some(end) = self.end.take() {
            return Some(Output::Event(Update::Done(end)));
        }
        if self.stage != Stage::ToBeSent {
            return None;
        }
        self.stage = Stage::Asked;
        Some(Output::Send(self.command.to(self.peer, u8::try_from(self.attempt.asked() - 1).unwrap_or(u8::MAX))))
    }

    fn deadline(&self) -> Option<Instant> {
        if self.stage == Stage::Done { None } else { Some(self.attempt.deadline()) }
    }
}
