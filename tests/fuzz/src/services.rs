//! What the targets for protocols have in common: a machine, and a peer that says anything at any time.

use std::time::Duration;

use mavlink_services::common::Common;
use mavlink_services::{Address, Instant, Operation, Output, Service};
use mavlink_wire::{Dialect, Frame, MAX_FRAME, Sender};

/// What comes: milliseconds after the last one, who sends it, whom it is for, which message it is, and its payload.
pub type Arrival = (u16, u8, u8, u8, Vec<u8>);

/// Outputs that one call may cause: a list of 64 parameters or items, with a question and an event for each.
const OUTPUTS: usize = 200;

/// Times that an operation may wait until it has ended, when nothing comes any more.
const WAITS: usize = 3000;

/// The station, whose frames are sent with these ids.
#[must_use]
pub fn station() -> Address {
    Address::new(255, 190)
}

/// The component.
#[must_use]
pub fn component() -> Address {
    Address::new(1, 1)
}

/// Feeds a machine, and gives the time that it is afterwards. It comes to rest after each frame, and says what it waits for.
///
/// # Panics
///
/// If it does not, or if `tell` finds something wrong.
pub fn feed<S: Service>(machine: &mut S, arrivals: &[Arrival], mut tell: impl FnMut(S::Event)) -> Instant {
    rest(machine, Instant::ZERO, &mut tell);
    arrivals.iter().fold(Instant::ZERO, |now, arrival| step(machine, now, arrival, &mut tell))
}

/// Feeds one frame to a machine that was fed until then, and gives the time that it is afterwards.
///
/// # Panics
///
/// If it does not come to rest, or if `tell` finds something wrong.
pub fn step<S: Service>(
    machine: &mut S,
    mut now: Instant,
    (after, from, to, message, payload): &Arrival,
    mut tell: impl FnMut(S::Event),
) -> Instant {
    now += Duration::from_millis(u64::from(*after));
    if let Some(deadline) = machine.deadline().filter(|deadline| from % 4 == 3 && *deadline > now) {
        now = deadline;
    }
    let mut buffer = [0; MAX_FRAME];
    let frame = frame(*from, *to, *message, payload, &mut buffer);
    machine.handle(&frame, now);
    rest(machine, now, &mut tell);
    now
}

/// Feeds an operation, and lets time pass until it has ended: once.
///
/// # Panics
///
/// If it does not end in bounded time, or twice.
pub fn finish<O: Operation>(operation: &mut O, arrivals: &[Arrival]) {
    let mut ends = 0_usize;
    let mut now = feed(operation, arrivals, |event| ends += usize::from(event.done().is_some()));
    for _ in 0..WAITS {
        let Some(deadline) = operation.deadline() else { break };
        now = now.max(deadline);
        rest(operation, now, &mut |event| ends += usize::from(event.done().is_some()));
    }
    assert_eq!((ends, operation.deadline()), (1, None), "an operation ends once");
}

/// Takes all that a machine wants now.
fn rest<S: Service>(machine: &mut S, now: Instant, tell: &mut impl FnMut(S::Event)) {
    for _ in 0..OUTPUTS {
        match machine.poll(now) {
            None => {
                assert!(machine.deadline().is_none_or(|next| next > now), "a deadline that has passed");
                return;
            }
            Some(Output::Send(_)) => {}
            Some(Output::Event(event)) => tell(event),
        }
    }
    panic!("it does not come to rest");
}

/// A frame with some message of the protocols; most are from and for those who take part.
fn frame<'b>(from: u8, to: u8, message: u8, payload: &[u8], buffer: &'b mut [u8; MAX_FRAME]) -> Frame<'b> {
    let infos: Vec<_> = Common::TABLE.iter().collect();
    let info = infos[usize::from(message) % infos.len()];
    let mut bytes = [0; 255];
    for (to, from) in bytes.iter_mut().zip(payload) {
        *to = *from;
    }
    for (offset, target) in [(info.target_system, [1, 255, 0, 9]), (info.target_component, [1, 190, 0, 9])] {
        if let Some(offset) = offset {
            bytes[usize::from(offset)] = target[usize::from(to % 4)];
        }
    }
    let message = Common::decode(info.id, &bytes).expect("a message of the table");
    let (system_id, component_id) = [(1, 1), (255, 190), (1, 1), (7, 1)][usize::from(from / 4 % 4)];
    let mut sender = Sender::v2(system_id, component_id);
    let bytes = sender.encode(&message, buffer).expect("MAVLink 2 carries it");
    Frame::parse(bytes, Common::TABLE).expect("a whole frame")
}
