//! `autoquad monitor`: the motors live, or as a recording has them.

mod columns;
mod feed;
mod fleet;
mod limits;
mod paint;
mod plain;
mod playback;
mod screen;

use std::ffi::OsString;
use std::io::{self, IsTerminal};
use std::path::Path;
use std::time::{Duration, Instant};

use clap::Args;
use ratatui::DefaultTerminal;
use ratatui::crossterm::event::{self, Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

use crate::failure::Failure;
use crate::interrupt;
use crate::output::Output;
use crate::quantity::Quantity;
use crate::recording::Recording;
use crate::station::{Asking, Running, Source, Station};
use crate::telemetry::Firmware;
use crate::time::{self, SECOND_US};
use feed::Feed;
use fleet::Fleet;
use limits::Limits;
use paint::Paint;
use plain::Plain;
use screen::{View, draw};

/// How long a picture stands.
const PICTURE: Duration = Duration::from_millis(100);

/// How far an arrow goes in a recording.
const STEP_US: u64 = 10 * SECOND_US;

/// Shows the motor controllers live: state, values and age of each, limits in colour, trends, totals, faults, quality of the link.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Monitor {
    /// A recording (`-` is standard input, with --plain), or the vehicle's address: udpin:, udpout:, udpbcast:, tcpin:, tcpout:HOST:PORT or serial:DEVICE:BAUD.
    source: OsString,
    /// Prints lines once a second instead of drawing a screen, for pipes.
    #[arg(long)]
    plain: bool,
    #[command(flatten)]
    running: Running,
    #[command(flatten)]
    asking: Asking,
    #[command(flatten)]
    limits: Limits,
    #[command(flatten)]
    firmware: Firmware,
}

const AFTER_HELP: &str = "\
Keys: q quits, tab shows the next vehicle, t another trend. In a recording, space pauses, the left and right arrows go 10 s back and \
forward, page up and page down a minute, home and end to the start and the end; - and + change the speed.

Examples:
  autoquad monitor udpin:0.0.0.0:14550
  autoquad monitor serial:/dev/ttyUSB0:57600
  autoquad monitor flight.tlog
  autoquad monitor flight.tlog --max-current 25 --min-voltage 14
  autoquad monitor flight.tlog --plain | grep WARNING";

impl Monitor {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let source = Source::of(&self.source);
        match (self.plain, &source) {
            (true, Source::Recording(path)) => self.print(path),
            (true, Source::Link(address)) => self.listen(address),
            (false, _) if !io::stdout().is_terminal() => {
                Err(Failure::new("standard output is no terminal; give --plain for lines"))
            }
            (false, _) => {
                let feed = Feed::open(&source, self.asking)?;
                let mut terminal = ratatui::try_init().map_err(|error| Failure::with("the terminal", error))?;
                let result = self.show(&mut terminal, feed);
                ratatui::restore();
                result
            }
        }
    }

    /// Prints a recording.
    fn print(&self, path: &Path) -> Result<(), Failure> {
        let mut recording = Recording::open(path)?;
        let (mut fleet, mut plain) = (Fleet::new(self.firmware), Plain::new(Output::standard(), self.limits));
        let mut now_us = 0;
        while let Some(entry) = recording.read()? {
            now_us = entry.time_us.unwrap_or(now_us);
            if let Some(update) = fleet.receive(now_us, &entry.frame) {
                plain.updated(&fleet, update, now_us).map_err(Failure::written)?;
            }
        }
        recording.finish();
        Ok(())
    }

    /// Prints what a link carries.
    fn listen(&self, address: &str) -> Result<(), Failure> {
        let run = self.running.start()?;
        let mut station = Station::connect(address, self.asking)?;
        let (mut fleet, mut plain) = (Fleet::new(self.firmware), Plain::new(Output::standard(), self.limits));
        while run.goes_on() {
            let received = station.receive_until(Instant::now() + PICTURE)?;
            let now_us = time::now_us();
            let update = received.and_then(|frame| fleet.receive(now_us, &frame));
            let printed = match update {
                Some(update) => plain.updated(&fleet, update, now_us),
                None => plain.silent(&fleet, now_us),
            };
            printed.map_err(Failure::written)?;
            station.say_silence();
        }
        Ok(())
    }

    fn show(&self, terminal: &mut DefaultTerminal, mut feed: Feed) -> Result<(), Failure> {
        let failed = |error| Failure::with("the terminal", error);
        interrupt::catch_on_screen()?;
        let (run, paint) = (self.running.start()?, Paint::of_environment());
        let (mut fleet, mut choice) = (Fleet::new(self.firmware), Choice::default());
        while run.goes_on() {
            let until = Instant::now() + PICTURE;
            feed.pump(until, |time_us, frame| {
                fleet.receive(time_us, frame);
            })?;
            let view = View {
                fleet: &fleet,
                origin: feed.origin(),
                now_us: feed.now_us(),
                selected: choice.vehicle,
                trend: choice.trend,
                limits: self.limits,
                paint,
            };
            terminal.draw(|frame| draw(frame, &view)).map_err(failed)?;
            while event::poll(until.saturating_duration_since(Instant::now())).map_err(failed)? {
                let Event::Key(event) = event::read().map_err(failed)? else { break };
                match Key::of(event).filter(|_| event.kind != KeyEventKind::Release) {
                    Some(Key::Quit) => return Ok(()),
                    Some(Key::Vehicle) => choice.vehicle = choice.vehicle.wrapping_add(1),
                    Some(Key::Trend) => choice.trend = choice.trend.next(),
                    Some(Key::Play(key)) => self.play(key, &mut feed, &mut fleet)?,
                    None => {}
                }
            }
        }
        Ok(())
    }

    fn play(&self, key: PlayKey, feed: &mut Feed, fleet: &mut Fleet) -> Result<(), Failure> {
        let Some(playback) = feed.playback() else { return Ok(()) };
        let position_us = playback.position_us();
        let place_us = match key {
            PlayKey::Pause => {
                // At the end, it begins anew.
                playback.paused = !playback.paused && !playback.has_ended();
                if !playback.has_ended() {
                    return Ok(());
                }
                0
            }
            PlayKey::Faster => {
                playback.faster();
                return Ok(());
            }
            PlayKey::Slower => {
                playback.slower();
                return Ok(());
            }
            PlayKey::Back(by_us) => position_us.saturating_sub(by_us),
            PlayKey::On(by_us) => position_us.saturating_add(by_us),
        };
        *fleet = Fleet::new(self.firmware);
        playback.seek(place_us, |time_us, frame| {
            fleet.receive(time_us, frame);
        })
    }
}

/// What the user looks at.
struct Choice {
    vehicle: usize,
    trend: Quantity,
}

impl Default for Choice {
    fn default() -> Self {
        Self { vehicle: 0, trend: Quantity::Speed }
    }
}

/// What a key means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Key {
    Quit,
    Vehicle,
    Trend,
    Play(PlayKey),
}

/// What a key means to a recording. Ways are in µs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum PlayKey {
    Pause,
    Faster,
    Slower,
    Back(u64),
    On(u64),
}

impl Key {
    fn of(event: KeyEvent) -> Option<Self> {
        Some(match event.code {
            KeyCode::Char('c') if event.modifiers.contains(KeyModifiers::CONTROL) => Self::Quit,
            KeyCode::Char('q') | KeyCode::Esc => Self::Quit,
            KeyCode::Tab => Self::Vehicle,
            KeyCode::Char('t') => Self::Trend,
            KeyCode::Char(' ') => Self::Play(PlayKey::Pause),
            KeyCode::Char('+' | '=') => Self::Play(PlayKey::Faster),
            KeyCode::Char('-') => Self::Play(PlayKey::Slower),
            KeyCode::Left => Self::Play(PlayKey::Back(STEP_US)),
            KeyCode::Right => Self::Play(PlayKey::On(STEP_US)),
            KeyCode::PageUp => Self::Play(PlayKey::Back(6 * STEP_US)),
            KeyCode::PageDown => Self::Play(PlayKey::On(6 * STEP_US)),
            KeyCode::Home => Self::Play(PlayKey::Back(u64::MAX)),
            KeyCode::End => Self::Play(PlayKey::On(u64::MAX)),
            _ => return None,
        })
    }
}
