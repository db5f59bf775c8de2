//! The component side of commands.

use core::time::Duration;

use mavlink_wire::{Frame, crc};

use super::{Command, percent};
use crate::common::{CommandAck, CommandCancel, MavCmd, MavResult};
use crate::{Address, Instant, Outgoing, Output, Service, earliest};

/// How long an answer is remembered after it was given, so that a command whose acknowledgement was lost is not carried out again: as
/// long as a station lets a running command be silent, and six seconds for its tries.
const REMEMBERED: Duration = Duration::from_secs(11);

/// The same of a `COMMAND_INT`, which does not say whether it is sent again: two tries of a station. Who wants it once more takes longer.
const REMEMBERED_INT: Duration = Duration::from_secs(2);

/// How often the progress of a running command is reported if nothing changes.
const REPORTED: Duration = Duration::from_secs(1);

/// Reports each command for this component once, and sends the answers. Up to `N` commands run or are remembered.
///
/// ```text
///            command              finish
///   Free ───────────▶ Open ─────────────────▶ Finished ──▶ Free
///                     │  ▲ │ progress            ▲  │ ▲   after 11 s, or when
///                     │  │ ▼ or the same again   │  │ │   the place is needed
///                     └▶ Running ────────────────┘  └─┘
///                        │ ▲   finish           the same again, or a cancel:
///                        └─┘                    acknowledged again
///           every second, or the same again: IN_PROGRESS
/// ```
///
/// - Every [`Request`] needs an answer, sooner or later: [`finish`](Self::finish). Unknown commands are `UNSUPPORTED`.
/// - A repeated command is reported once even if the acknowledgement was lost, and gets the last answer again. A `COMMAND_LONG` is recognised
///   by its `confirmation`, up to 11 s after that answer. A `COMMAND_INT` has none: the same one is a repetition up to 2 s after the answer.
/// - The same command with other parameters while it runs, and a command without a free place, is `TEMPORARILY_REJECTED`.
#[derive(Clone, Debug)]
pub struct Component<const N: usize = 4> {
    own: Address,
    slots: [Slot; N],
    request: Option<Request>,
    /// What was turned away, and how.
    bounced: Option<(Address, MavCmd, MavResult)>,
}

/// A command to be carried out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Request {
    /// What the answer is given for.
    pub ticket: Ticket,
    /// Who commands.
    pub from: Address,
    /// What.
    pub command: Command,
}

/// Names a command that has not come to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Ticket {
    slot: u8,
    generation: u16,
}

/// What a [`Component`] reports.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// Carry this out.
    Request(Request),
    /// The sender asks to stop this command: [`finish`](Component::finish) it as `CANCELLED`, or carry on.
    Cancel(Ticket),
}

#[derive(Clone, Copy, Debug)]
struct Slot {
    state: State,
    from: Address,
    command: MavCmd,
    generation: u16,
    /// Checksum of what it is, without the confirmation.
    digest: u16,
    /// Of the frame that brought it, and its confirmation.
    brought: (u8, u8),
    result: MavResult,
    progress: u8,
    result_param2: i32,
    /// A `COMMAND_LONG`, which says that it is sent again.
    is_long: bool,
    /// When it is reported again, or forgotten.
    next: Instant,
    /// An acknowledgement is to be sent.
    due: bool,
    cancel: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Free,
    Open,
    Running,
    Finished,
}

impl Slot {
    const FREE: Self = Self {
        state: State::Free,
        from: Address::EVERYBODY,
        command: MavCmd(0),
        generation: 0,
        digest: 0,
        brought: (0, 0),
        result: MavResult::IN_PROGRESS,
        progress: u8::MAX,
        result_param2: 0,
        is_long: true,
        next: Instant::ZERO,
        due: false,
        cancel: false,
    };

    fn is_active(&self) -> bool {
        matches!(self.state, State::Open | State::Running)
    }

    /// How long its answer is remembered.
    const fn remembered(&self) -> Duration {
        if self.is_long { REMEMBERED } else { REMEMBERED_INT }
    }

    fn ack(&self) -> Outgoing {
        acknowledgement(self.from, self.command, self.result, (self.progress, self.result_param2))
    }
}

fn acknowledgement(to: Address, command: MavCmd, result: MavResult, more: (u8, i32)) -> Outgoing {
    let (target_system, target_component) = to.target();
    let (progress, result_param2) = more;
    CommandAck { command, result, progress, result_param2, target_system, target_component }.into()
}

impl<const N: usize> Component<N> {
    /// A component with this address.
    #[must_use]
    pub fn new(own: Address) -> Self {
        Self { own, slots: [Slot::FREE; N], request: None, bounced: None }
    }

    /// Reports progress in percent; `None` is unknown. The report is repeated every second.
    ///
    /// Returns `false` if the command has ended.
    pub fn progress(&mut self, ticket: Ticket, progress: Option<u8>, now: Instant) -> bool {
        let Some(slot) = self.active(ticket) else { return false };
        slot.progress = progress.and_then(percent).unwrap_or(u8::MAX);
        (slot.state, slot.due, slot.next) = (State::Running, true, now + REPORTED);
        true
    }

    /// Ends a command: `ACCEPTED`, or the reason why not. For `IN_PROGRESS`, use [`progress`](Self::progress).
    ///
    /// Returns `false` if the command has ended already.
    pub fn finish(&mut self, ticket: Ticket, result: MavResult, now: Instant) -> bool {
        self.finish_with(ticket, result, 0, now)
    }

    /// The same with a number whose meaning the command says, as a reason.
    pub fn finish_with(&mut self, ticket: Ticket, result: MavResult, result_param2: i32, now: Instant) -> bool {
        if result == MavResult::IN_PROGRESS {
            return self.progress(ticket, None, now);
        }
        let Some(slot) = self.active(ticket) else { return false };
        (slot.result, slot.result_param2) = (result, result_param2);
        (slot.state, slot.due, slot.next, slot.cancel) = (State::Finished, true, now + slot.remembered(), false);
        if result == MavResult::ACCEPTED {
            slot.progress = 0;
        }
        true
    }

    fn active(&mut self, ticket: Ticket) -> Option<&mut Slot> {
        let slot = self.slots.get_mut(usize::from(ticket.slot))?;
        if slot.is_active() && slot.generation == ticket.generation { Some(slot) } else { None }
    }

    /// Takes a command that is for this component.
    fn take(&mut self, command: Command, frame: &Frame<'_>, now: Instant) {
        let (from, brought, digest) = (Address::of(frame), brought(&command, frame), digest(&command));
        let same = |slot: &&mut Slot| (slot.from, slot.command) == (from, command.command());
        if let Some(slot) = self.slots.iter_mut().filter(|slot| slot.state != State::Free).find(same) {
            if slot.is_active() {
                if slot.digest != digest {
                    self.bounced = Some((from, command.command(), MavResult::TEMPORARILY_REJECTED));
                } else {
                    // Nobody has answered yet: the sender should know that it need not ask again.
                    (slot.state, slot.due) = (State::Running, true);
                }
                return;
            }
            if now < slot.next && slot.digest == digest && is_repeat(slot.brought, brought, &command) {
                (slot.due, slot.next) = (true, now + slot.remembered());
                return;
            }
            slot.state = State::Free;
        }
        self.open(command, (from, brought, digest));
    }

    /// Makes a request of it, if there is room.
    fn open(&mut self, command: Command, (from, brought, digest): (Address, (u8, u8), u16)) {
        let free = self.slots.iter_mut().enumerate().filter(|(_, slot)| !slot.is_active());
        let oldest = free.min_by_key(|(_, slot)| (slot.state != State::Free, slot.next));
        let (Some((at, slot)), None) = (oldest, &self.request) else {
            self.bounced = Some((from, command.command(), MavResult::TEMPORARILY_REJECTED));
            return;
        };
        let generation = slot.generation.wrapping_add(1);
        let is_long = matches!(command, Command::Long(_));
        *slot = Slot { state: State::Open, from, generation, digest, brought, is_long, ..Slot::FREE };
        slot.command = command.command();
        // More than 256 slots make no sense; those would never be reached.
        let ticket = Ticket { slot: u8::try_from(at).unwrap_or(u8::MAX), generation };
        self.request = Some(Request { ticket, from, command });
    }

    /// Passes the wish on, or says again how it ended.
    fn cancel(&mut self, command: MavCmd, from: Address, now: Instant) {
        let same = |slot: &&mut Slot| (slot.from, slot.command) == (from, command);
        match self.slots.iter_mut().find(same) {
            Some(slot) if slot.is_active() => slot.cancel = true,
            Some(slot) if slot.state == State::Finished && now < slot.next => slot.due = true,
            _ => {}
        }
    }

    fn event(&mut self) -> Option<Event> {
        if let Some(request) = self.request.take() {
            return Some(Event::Request(request));
        }
        let (at, slot) = self.slots.iter_mut().enumerate().find(|(_, slot)| slot.cancel)?;
        slot.cancel = false;
        Some(Event::Cancel(Ticket { slot: u8::try_from(at).unwrap_or(u8::MAX), generation: slot.generation }))
    }
}

/// The sequence number of the frame, and how often the command says that it was sent before.
fn brought(command: &Command, frame: &Frame<'_>) -> (u8, u8) {
    let confirmation = match command {
        Command::Long(long) => long.confirmation,
        Command::Int(_) => 0,
    };
    (frame.sequence(), confirmation)
}

/// Whether a command is one that was there before: the same frame, one that says that it is sent again, or one that cannot say so.
fn is_repeat(first: (u8, u8), again: (u8, u8), command: &Command) -> bool {
    first.0 == again.0 || again.1 > first.1 || matches!(command, Command::Int(_))
}

/// What tells a command from others of the same kind.
fn digest(command: &Command) -> u16 {
    let mut payload = [0; mavlink_wire::MAX_PAYLOAD];
    mavlink_wire::Encode::write(&command.to(Address::EVERYBODY, 0), &mut payload);
    crc::checksum(payload.get(..40).unwrap_or_default())
}

impl<const N: usize> Service for Component<N> {
    type Event = Event;

    fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        if let Some(command) = Command::from_frame(frame) {
            if command.is_for(self.own) {
                self.take(command, frame, now);
            }
        } else if let Some(cancel) = self.own.addressed::<CommandCancel>(frame) {
            self.cancel(cancel.command, Address::of(frame), now);
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Event>> {
        if let Some(event) = self.event() {
            return Some(Output::Event(event));
        }
        if let Some((to, command, result)) = self.bounced.take() {
            return Some(Output::Send(acknowledgement(to, command, result, (0, 0))));
        }
        let is_due = |slot: &&mut Slot| slot.due || (slot.state == State::Running && now >= slot.next);
        let slot = self.slots.iter_mut().find(is_due)?;
        slot.due = false;
        if slot.state == State::Running {
            slot.next = now + REPORTED;
        }
        Some(Output::Send(slot.ack()))
    }

    fn deadline(&self) -> Option<Instant> {
        let running = self.slots.iter().filter(|slot| slot.state == State::Running);
        running.fold(None, |first, slot| earliest(first, Some(slot.next)))
    }
}
