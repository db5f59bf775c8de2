//! Where the monitor's frames come from: a link now, or a recording then.

use std::path::Path;
use std::time::{Duration, Instant};

use mavlink_autoquad::wire::Frame;

use super::playback::Playback;
use super::screen::Origin;
use crate::failure::Failure;
use crate::station::{Asking, Source, Station};
use crate::time;

/// Where frames come from.
pub(super) enum Feed {
    Link(Box<Station>),
    Log { name: String, playback: Box<Playback>, before: Instant },
}

impl Feed {
    /// Opens a link or a recording.
    pub(super) fn open(source: &Source, asking: Asking) -> Result<Self, Failure> {
        Ok(match source {
            Source::Link(address) => Self::Link(Box::new(Station::connect(address, asking)?)),
            Source::Recording(path) => Self::log(path)?,
        })
    }

    fn log(path: &Path) -> Result<Self, Failure> {
        Ok(Self::Log {
            name: path.display().to_string(),
            playback: Box::new(Playback::open(path)?),
            before: Instant::now(),
        })
    }

    /// The time at which the feed is: Unix time in µs.
    pub(super) fn now_us(&self) -> u64 {
        match self {
            Self::Link(_) => time::now_us(),
            Self::Log { playback, .. } => playback.position_us(),
        }
    }

    /// Hands over what comes until then. A recording hands over what is due, and does not wait.
    pub(super) fn pump(&mut self, until: Instant, mut receive: impl FnMut(u64, &Frame<'_>)) -> Result<(), Failure> {
        match self {
            Self::Link(station) => loop {
                if let Some(frame) = station.receive_until(until)? {
                    receive(time::now_us(), &frame);
                }
                if Instant::now() >= until {
                    return Ok(());
                }
            },
            Self::Log { playback, before, .. } => {
                let now = Instant::now();
                let elapsed: Duration = now - std::mem::replace(before, now);
                playback.advance(elapsed, receive)
            }
        }
    }

    /// What the screen says of it.
    pub(super) fn origin(&self) -> Origin<'_> {
        match self {
            Self::Link(station) => Origin::Link { address: &station.address, trouble: station.trouble() },
            Self::Log { name, playback, .. } => {
                let (progress, speed, paused) = (playback.progress(), playback.speed(), playback.paused);
                Origin::Log { name, progress, speed, paused }
            }
        }
    }

    /// The recording, if it is one.
    pub(super) fn playback(&mut self) -> Option<&mut Playback> {
        match self {
            Self::Link(_) => None,
            Self::Log { playback, .. } => Some(playback),
        }
    }
}
