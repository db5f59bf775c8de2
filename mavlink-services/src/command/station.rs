//! Who sends commands.

use core::time::Duration;

use mavlink_wire::{Encode, Frame};

use super::{Command, Failure, StartError, percent};
use crate::common::{CommandAck, CommandCancel, MavCmd, MavResult};
use crate::retry::Attempt;
use crate::{Address, Instant, Outgoing, Output, Retry, Service};

/// Sends one command at a time to a peer, and tells what became of it.
///
/// ```text
///            start                      ack: any other result
///   Idle ───────────────▶ Asked ─────────────────────────────────────▶ Finished ──▶ Idle
///                         │ ▲ │ ack: IN_PROGRESS                          ▲
///             no answer:  └─┘ ▼                                           │
///             sent again   Running ───────────────────────────────────────┤
///             (retries)    │ ▲ │ ▲   ack: any other result                │
///                          └─┘ └─┘   silence, limit, retries used up ─────┘
///               ack: IN_PROGRESS  cancel: COMMAND_CANCEL, repeated
/// ```
///
/// - Answers count that come from the peer, name the command, and are for this component or, as MAVLink 1 has no room for
///   addressees, for nobody in particular.
/// - While it runs, the command is not sent again. Silence ends it, and so does the limit, however much progress is reported.
/// - A command to component 0 is answered by all components; the first final answer counts.
#[derive(Clone, Debug)]
pub struct Station {
    own: Address,
    peer: Address,
    options: Options,
    active: Option<Active>,
    progress: Option<Event>,
    finished: Option<Event>,
}

/// How patient a [`Station`] is.
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

/// What a [`Station`] tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Event {
    /// The peer is at it.
    Progress {
        /// The command.
        command: MavCmd,
        /// How much is done, in percent, if the peer knows.
        progress: Option<u8>,
    },
    /// The end of the command. The next one can be started.
    Finished(Result<Accepted, Failure>),
}

/// A command was carried out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Accepted {
    /// The command.
    pub command: MavCmd,
    /// What the peer adds, as the command says; 0 is nothing.
    pub result_param2: i32,
}

/// The command that has not come to its end.
#[derive(Clone, Copy, Debug)]
struct Active {
    command: Command,
    attempt: Attempt,
    limit: Instant,
    running: bool,
    progress: Option<u8>,
    /// The command, or the cancel, is to be sent.
    due: bool,
    cancel: bool,
}

impl Station {
    /// A station that commands this peer.
    #[must_use]
    pub fn new(own: Address, peer: Address) -> Self {
        Self::with_options(own, peer, Options::DEFAULT)
    }

    /// A station that is as patient as this.
    #[must_use]
    pub fn with_options(own: Address, peer: Address, options: Options) -> Self {
        Self { own, peer, options, active: None, progress: None, finished: None }
    }

    /// Sends a `COMMAND_LONG` or `COMMAND_INT` of any dialect to the peer, whatever its target says.
    ///
    /// # Errors
    ///
    /// Another command has not come to its end, or this is no command. Nothing is sent then.
    pub fn start(&mut self, command: &(impl Encode + ?Sized), now: Instant) -> Result<(), StartError> {
        if let Some(active) = &self.active {
            return Err(StartError::Busy { command: active.command.command() });
        }
        let message_id = command.info().id;
        let command = Command::from_message(command).ok_or(StartError::NoCommand { message_id })?;
        self.active = Some(Active {
            command,
            attempt: Attempt::start(self.options.retry, now),
            limit: now + self.options.limit,
            running: false,
            progress: None,
            due: true,
            cancel: false,
        });
        (self.progress, self.finished) = (None, None);
        Ok(())
    }

    /// Asks the peer to stop the command. It ends with the peer's answer: `MAV_RESULT_CANCELLED`, or what came first.
    ///
    /// Gives `false` if there is no command to be cancelled.
    pub fn cancel(&mut self, now: Instant) -> bool {
        let Some(active) = &mut self.active else { return false };
        if !active.cancel {
            (active.cancel, active.due) = (true, true);
            active.attempt = Attempt::start(self.options.retry, now);
        }
        true
    }

    /// The command that has not come to its end.
    #[must_use]
    pub fn active(&self) -> Option<MavCmd> {
        self.active.as_ref().map(|active| active.command.command())
    }

    /// Forgets the command without a word to the peer, as when nobody waits for it any more.
    pub fn abandon(&mut self) {
        (self.active, self.progress, self.finished) = (None, None, None);
    }

    fn finish(&mut self, result: Result<Accepted, Failure>) {
        self.active = None;
        self.finished = Some(Event::Finished(result));
    }

    /// Ends what takes too long, and asks again for what was not answered.
    fn watch(&mut self, now: Instant) {
        let Some(active) = &mut self.active else { return };
        let (command, progress) = (active.command.command(), active.progress);
        if now >= active.limit {
            return self.finish(Err(Failure::Endless { command, progress }));
        }
        if active.attempt.is_waiting(now) {
            return;
        }
        let repeats = active.cancel || !active.running;
        if repeats && active.attempt.again(now) {
            active.due = true;
        } else {
            let sent = active.attempt.asked();
            self.finish(Err(Failure::Timeout { command, sent, progress }));
        }
    }

    fn acknowledge(&mut self, ack: &CommandAck, now: Instant) {
        let Some(active) = &mut self.active else { return };
        let command = ack.command;
        if command != active.command.command() || active.is_unsent() {
            return;
        }
        match ack.result {
            MavResult::IN_PROGRESS => {
                active.running = true;
                active.progress = percent(ack.progress).or(active.progress);
                if !active.cancel {
                    active.attempt.extend(now, self.options.silence);
                    active.due = false;
                }
                self.progress = Some(Event::Progress { command, progress: percent(ack.progress) });
            }
            MavResult::ACCEPTED => self.finish(Ok(Accepted { command, result_param2: ack.result_param2 })),
            result => {
                let (reason, progress) = (ack.result_param2, active.progress);
                self.finish(Err(Failure::Refused { command, result, reason, progress }));
            }
        }
    }
}

impl Active {
    /// Whether an answer cannot be to this one yet.
    fn is_unsent(&self) -> bool {
        self.due && !self.cancel && self.attempt.asked() == 1
    }
}

impl Service for Station {
    type Event = Event;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        let Some(ack) = frame.decode::<CommandAck>() else { return };
        if self.peer.includes(Address::of(frame)) && self.own.is_target(ack.target_system, ack.target_component) {
            self.acknowledge(&ack, now);
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Event>> {
        self.watch(now);
        if let Some(event) = self.progress.take().or_else(|| self.finished.take()) {
            return Some(Output::Event(event));
        }
        let active = self.active.as_mut().filter(|active| active.due)?;
        active.due = false;
        Some(Output::Send(if active.cancel {
            let (target_system, target_component) = self.peer.target();
            Outgoing::from(CommandCancel { target_system, target_component, command: active.command.command() })
        } else {
            let confirmation = u8::try_from(active.attempt.asked() - 1).unwrap_or(u8::MAX);
            active.command.to(self.peer, confirmation)
        }))
    }

    fn deadline(&self) -> Option<Instant> {
        self.active.as_ref().map(|active| active.attempt.deadline().min(active.limit))
    }
}
