//! The gateway as async tasks, in the shape that executors such as embassy's run: one task receives, one sends, and a channel lies
//! between them. Tasks that are generic over the traits of `embedded-io-async` take the UART of any HAL.

#![no_std]
#![no_main]

mod uart;

use core::cell::Cell;
use core::future::{Future, poll_fn};
use core::panic::PanicInfo;
use core::pin::pin;
use core::task::{Context, Poll, Waker};

use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};
use embedded_io_async::{Read, Write};
use mavlink_autoquad::autoquad::{AqEscTelemetry, CommandLong, EscStatus, Heartbeat, MavCmd, MavState};
use mavlink_autoquad::esc::{Conversion, EscTable};
use mavlink_autoquad::wire::embedded_io_async::{FrameReader, FrameWriter, ReceiveError, SendError};
use mavlink_autoquad::wire::{Message, Sender, Table};

use uart::Uart;

static RECEIVED: Table<'static> = Table::of(&[Heartbeat::INFO, CommandLong::INFO, AqEscTelemetry::INFO]);
const BEAT: Heartbeat = Heartbeat { system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT };

/// What the task that receives tells the one that sends.
enum Word {
    Beat,
    Status(EscStatus),
    Stop,
}

/// Receives until it is told to shut down. With embassy, this and [`answer`] are spawned.
async fn listen<R: Read>(rx: R, heard: &Channel<Word>) -> Result<(), R::Error> {
    let (mut reader, mut escs) = (FrameReader::<R>::new(rx, &RECEIVED), EscTable::new());
    loop {
        let frame = match reader.receive().await {
            Ok(Some(frame)) => frame,
            Ok(None) => break,
            Err(ReceiveError::NothingYet) => continue,
            Err(ReceiveError::Link(error)) => return Err(error),
        };
        if frame.decode::<Heartbeat>().is_some() {
            heard.tell(Word::Beat).await;
        } else if let Some(telemetry) = frame.decode::<AqEscTelemetry>() {
            escs.update(&telemetry);
            if let Some(status) = escs.to_esc_status(0, escs.uptime_us(), &Conversion::DEFAULT) {
                heard.tell(Word::Status(status)).await;
            }
        } else if let Some(CommandLong { command: MavCmd::PREFLIGHT_REBOOT_SHUTDOWN, .. }) = frame.decode() {
            break;
        }
    }
    heard.tell(Word::Stop).await;
    Ok(())
}

/// Answers what was heard: with the state of the motors, or a heartbeat.
async fn answer<W: Write>(tx: W, heard: &Channel<Word>) -> Result<(), SendError<W::Error>> {
    let mut writer = FrameWriter::new(tx, Sender::v2(1, 99));
    loop {
        match heard.hear().await {
            Word::Beat => writer.send(&BEAT).await?,
            Word::Status(status) => writer.send(&status).await?,
            Word::Stop => return Ok(()),
        }
    }
}

#[entry]
fn main() -> ! {
    let heard = Channel(Cell::new(None));
    run(listen(Uart::new(), &heard), answer(Uart::new(), &heard));
    debug::exit(EXIT_SUCCESS);
    loop {
        core::hint::spin_loop();
    }
}

/// The compiler gives every async function a panic for whoever polls it again after its end, which nobody does here. Our own
/// code has none: the gateway, which has no async functions, links without.
#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    debug::exit(EXIT_FAILURE);
    loop {
        core::hint::spin_loop();
    }
}

/// A word on its way from one task to another, as a `Channel` of embassy.
struct Channel<T>(Cell<Option<T>>);

impl<T> Channel<T> {
    /// Waits until the word before was heard.
    async fn tell(&self, word: T) {
        let mut word = Some(word);
        poll_fn(|_| {
            let before = self.0.take();
            let is_free = before.is_none();
            self.0.set(if is_free { word.take() } else { before });
            if is_free { Poll::Ready(()) } else { Poll::Pending }
        })
        .await;
    }

    async fn hear(&self) -> T {
        poll_fn(|_| self.0.take().map_or(Poll::Pending, Poll::Ready)).await
    }
}

/// The smallest of all executors: polls two tasks in turn until both have ended.
fn run(one: impl Future, other: impl Future) {
    let (mut one, mut other) = (pin!(one), pin!(other));
    let (mut one_runs, mut other_runs) = (true, true);
    let mut context = Context::from_waker(Waker::noop());
    while one_runs || other_runs {
        one_runs = one_runs && one.as_mut().poll(&mut context).is_pending();
        other_runs = other_runs && other.as_mut().poll(&mut context).is_pending();
    }
}
