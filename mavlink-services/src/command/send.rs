//! The station side of commands.

use core::time::Duration;

use mavlink_wire::{Encode, Frame};

use super::{Command, Failure, NoCommand, percent};
use crate::common::{CommandAck, CommandCancel, MavCmd, MavResult};
use crate::retry::Attempt;
use crate::{Address, Instant, Outgoing, Output, Retry, Service, Update};

/// Sends a command until it is acknowledged, and waits for its end.
///
/// ```text
///   new                 ack: any other result
///  ─────▶ Asked ───────────────────────────────────▶ Done
///         │ ▲ │ ▲ silence of a COMMAND_LONG:          ▲
///         └─┘ │ │ sent again                          │
///  no answer: ▼ │ IN_PROGRESS                         │
///  sent again Running ────────────────────────────────┤
///             │ ▲ │   ack: any other result, silence, │
///             └─┘ │   limit                           │
///   IN_PROGRESS   ▼ cancel                            │
///             Cancelling ─────────────────────────────┘
///             │ ▲         ack: any other result, limit,
///             └─┘         COMMAND_CANCEL sent often enough
///    COMMAND_CANCEL again
/// ```
///
/// - An answer counts if it comes from the peer, names the command, and is for this component or without a target (as in MAVLink 1).
///   Answers have no number: a late answer to an earlier command of the same kind is taken for the answer to this one.
/// - While it runs and reports, the command is not sent again. After silence, its last acknowledgement may have been lost: a `COMMAND_LONG`
///   is sent again, because its `confirmation` says that it is no new one. A `COMMAND_INT` times out: the peer might carry it out twice.
/// - It times out after the limit in spite of reported progress.
/// - A command to component 0 is answered by all components; the first final answer counts.
#[derive(Clone, Debug)]
pub struct Send {
    own: Address,
    peer: Address,
    options: Options,
    command: Command,
    stage: Stage,
    attempt: Attempt,
    limit: Instant,
    progress: Option<u8>,
    /// The command, or the cancel, is to be sent.
    due: bool,
    /// To be told.
    told: Option<Progress>,
    end: Option<Result<Accepted, Failure>>,
}

/// How far a command has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Asked,
    Running,
    Cancelling,
    Done,
}

/// Timeouts and retries of a [`Send`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Until the first acknowledgement, and of a `COMMAND_CANCEL`.
    pub retry: Retry,
    /// How long a running command may report nothing.
    pub silence: Duration,
    /// How long a command may take in all.
    pub limit: Duration,
}

impl Options {
    /// [`Retry::DEFAULT`], 5 s between reports, 10 min in all.
    pub const DEFAULT: Self =
        Self { retry: Retry::DEFAULT, silence: Duration::from_secs(5), limit: Duration::from_secs(600) };
}

impl Default for Options {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// The peer is carrying out the command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// The command.
    pub command: MavCmd,
    /// How much is done, in percent, if the peer knows.
    pub percent: Option<u8>,
}

/// A command was carried out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Accepted {
    /// The command.
    pub command: MavCmd,
    /// What the peer adds, as the command says; 0 is nothing.
    pub result_param2: i32,
}

impl Send {
    /// Sends a `COMMAND_LONG` or `COMMAND_INT` of any dialect to the peer, whatever its target says.
    ///
    /// # Errors
    ///
    /// This is no command.
    pub fn new(
        own: Address,
        peer: Address,
        options: Options,
        command: &(impl Encode + ?Sized),
        now: Instant,
    ) -> Result<Self, NoCommand> {
        let message_id = command.info().id;
        let command = Command::from_message(command).ok_or(NoCommand { message_id })?;
        Ok(Self::of(own, peer, options, (command, now)))
    }

    /// Sends a command of this crate.
    pub(crate) fn of(own: Address, peer: Address, options: Options, (command, now): (Command, Instant)) -> Self {
        let (attempt, limit) = (Attempt::start(options.retry, now), now + options.limit);
        let (progress, told, end) = (None, None, None);
        Self { own, peer, options, command, stage: Stage::Asked, attempt, limit, progress, due: true, told, end }
    }

    /// Asks the peer to stop the command. It ends with the peer's answer: `MAV_RESULT_CANCELLED`, or what came first.
    pub fn cancel(&mut self, now: Instant) {
        if matches!(self.stage, Stage::Asked | Stage::Running) {
            (self.stage, self.due) = (Stage::Cancelling, true);
            self.attempt = Attempt::start(self.options.retry, now);
        }
    }

    /// What is to be done.
    #[must_use]
    pub fn command(&self) -> MavCmd {
        self.command.command()
    }

    fn finish(&mut self, result: Result<Accepted, Failure>) {
        (self.stage, self.due, self.end) = (Stage::Done, false, Some(result));
    }

    /// Ends what takes too long, and asks again for what was not answered.
    fn watch(&mut self, now: Instant) {
        let (command, progress) = (self.command(), self.progress);
        if self.stage == Stage::Done {
            return;
        }
        if now >= self.limit {
            self.finish(Err(Failure::Endless { command, progress }));
        } else if !self.attempt.is_waiting(now) {
            let may_ask = self.stage != Stage::Running || matches!(self.command, Command::Long(_));
            if may_ask && self.attempt.again(now) {
                self.due = true;
                if self.stage == Stage::Running {
                    self.stage = Stage::Asked;
                }
            } else {
                self.finish(Err(Failure::Timeout { command, sent: self.attempt.asked(), progress }));
            }
        }
    }

    fn acknowledge(&mut self, ack: &CommandAck, now: Instant) {
        let command = self.command();
        let unsent = self.stage == Stage::Asked && self.due && self.attempt.asked() == 1;
        if self.stage == Stage::Done || unsent || ack.command != command {
            return;
        }
        match ack.result {
            MavResult::IN_PROGRESS => {
                self.progress = percent(ack.progress).or(self.progress);
                self.told = Some(Progress { command, percent: percent(ack.progress) });
                if self.stage != Stage::Cancelling {
                    (self.stage, self.due) = (Stage::Running, false);
                    self.attempt.extend(now, self.options.silence);
                }
            }
            MavResult::ACCEPTED => self.finish(Ok(Accepted { command, result_param2: ack.result_param2 })),
            result => {
                let (reason, progress) = (ack.result_param2, self.progress);
                self.finish(Err(Failure::Refused { command, result, reason, progress }));
            }
        }
    }

    fn message(&self) -> Outgoing {
        if self.stage == Stage::Cancelling {
            let (target_system, target_component) = self.peer.target();
            return CommandCancel { target_system, target_component, command: self.command() }.into();
        }
        self.command.to(self.peer, u8::try_from(self.attempt.asked() - 1).unwrap_or(u8::MAX))
    }
}

impl Service for Send {
    type Event = Update<Progress, Accepted, Failure>;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        let Some(ack) = frame.decode::<CommandAck>() else { return };
        if self.peer.includes(Address::of(frame)) && self.own.is_target(ack.target_system, ack.target_component) {
            self.acknowledge(&ack, now);
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Self::Event>> {
        self.watch(now);
        if let Some(progress) = self.told.take() {
            return Some(Output::Event(Update::Progress(progress)));
        }
        if let Some(end) = self.end.take() {
            return Some(Output::Event(Update::Done(end)));
        }
        if !self.due {
            return None;
        }
        self.due = false;
        Some(Output::Send(self.message()))
    }

    fn deadline(&self) -> Option<Instant> {
        if self.stage == Stage::Done { None } else { Some(self.attempt.deadline().min(self.limit)) }
    }
}
