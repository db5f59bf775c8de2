//! A recording that is played: as fast as it was recorded, faster, slower, from any place.

use std::fs::{self, File};
use std::io::{Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::time::Duration;

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_autoquad::wire::tlog::Reader;
use mavlink_autoquad::wire::{Dialect, Frame, FrameBuf};

use crate::failure::Failure;
use crate::input::is_standard;
use crate::recording::{Entry, Recording};
use crate::time::SECOND_US;

/// Bytes of the time in front of each frame.
const TIME: u64 = 8;

/// So much before the place that is asked for is read, so that the trends have something to show.
const LEAD_US: u64 = 120 * SECOND_US;

/// Speeds that can be chosen.
const SPEEDS: [f64; 9] = [0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 100.0];

/// A recording, and where in it the playback is.
pub(crate) struct Playback {
    path: PathBuf,
    /// Times and places of entries, about one a second.
    index: Vec<(u64, u64)>,
    end_us: u64,
    reader: Reader<'static, File>,
    /// Read, and not due yet.
    next: Option<(u64, FrameBuf)>,
    position_us: u64,
    speed: usize,
    pub(crate) paused: bool,
}

impl Playback {
    /// Opens a recording, and notes where in the file which second is.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        if is_standard(path) || fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
            return Err(Failure::file(path, "cannot be played, as it is no file; give --plain for lines"));
        }
        let mut recording = Recording::open(path)?;
        let (mut index, mut place, mut end_us) = (Vec::<(u64, u64)>::new(), 0, None);
        while let Some(entry) = recording.read()? {
            place += entry.skipped;
            if let Some(time_us) = entry.time_us {
                if index.last().is_none_or(|&(last_us, _)| time_us >= last_us + SECOND_US) {
                    index.push((time_us, place));
                }
                end_us = end_us.max(Some(time_us));
            }
            place += TIME + entry.frame.bytes().len() as u64;
        }
        recording.finish();
        let (Some(&(start_us, _)), Some(end_us)) = (index.first(), end_us) else {
            return Err(Failure::file(path, "has no times: it is a raw stream, not a tlog"));
        };
        let reader = Self::reader(path, 0)?;
        let normal = SPEEDS.iter().position(|&speed| speed >= 1.0).unwrap_or_default();
        let path = path.to_owned();
        Ok(Self { path, index, end_us, reader, next: None, position_us: start_us, speed: normal, paused: false })
    }

    fn reader(path: &Path, place: u64) -> Result<Reader<'static, File>, Failure> {
        let refused = |error| Failure::file(path, error);
        let mut file = File::open(path).map_err(refused)?;
        file.seek(SeekFrom::Start(place)).map_err(refused)?;
        Ok(Reader::new(file, Autoquad::TABLE))
    }

    /// Unix time in µs at which the playback is.
    pub(crate) const fn position_us(&self) -> u64 {
        self.position_us
    }

    /// Microseconds since the start, and of the whole recording.
    pub(crate) fn progress(&self) -> (u64, u64) {
        let start_us = self.start_us();
        (self.position_us.saturating_sub(start_us), self.end_us.saturating_sub(start_us))
    }

    /// Whether all is played.
    pub(crate) const fn has_ended(&self) -> bool {
        self.position_us >= self.end_us
    }

    /// Times the speed at which it was recorded.
    pub(crate) fn speed(&self) -> f64 {
        SPEEDS.get(self.speed).copied().unwrap_or(1.0)
    }

    /// Plays faster from now on.
    pub(crate) fn faster(&mut self) {
        self.speed = (self.speed + 1).min(SPEEDS.len() - 1);
    }

    /// Plays slower from now on.
    pub(crate) const fn slower(&mut self) {
        self.speed = self.speed.saturating_sub(1);
    }

    fn start_us(&self) -> u64 {
        self.index.first().map_or(0, |&(time_us, _)| time_us)
    }

    /// Goes on by so much of the host's time.
    pub(crate) fn advance(&mut self, elapsed: Duration, receive: impl FnMut(u64, &Frame<'_>)) -> Result<(), Failure> {
        if self.paused {
            return Ok(());
        }
        let played_us = (elapsed.as_micros() as f64 * self.speed()) as u64;
        self.play_to(self.position_us.saturating_add(played_us).min(self.end_us), receive)
    }

    /// Goes to a time, and plays what comes shortly before it at once. What was heard before is void.
    pub(crate) fn seek(&mut self, time_us: u64, receive: impl FnMut(u64, &Frame<'_>)) -> Result<(), Failure> {
        let time_us = time_us.clamp(self.start_us(), self.end_us);
        let from_us = time_us.saturating_sub(LEAD_US);
        let before = self.index.partition_point(|&(entry_us, _)| entry_us <= from_us).saturating_sub(1);
        let place = self.index.get(before).map_or(0, |&(_, place)| place);
        self.reader = Self::reader(&self.path, place)?;
        self.next = None;
        self.play_to(time_us, receive)
    }

    fn play_to(&mut self, time_us: u64, mut receive: impl FnMut(u64, &Frame<'_>)) -> Result<(), Failure> {
        self.position_us = time_us;
        loop {
            if self.next.is_none() {
                let entry = self.reader.read().map_err(|error| Failure::file(&self.path, error))?;
                let Some(entry) = entry.map(Entry::from) else { return Ok(()) };
                self.next = Some((entry.time_us.unwrap_or(time_us), FrameBuf::from(entry.frame)));
            }
            match self.next.take_if(|(due_us, _)| *due_us <= time_us) {
                Some((due_us, frame)) => receive(due_us, &frame.as_frame()),
                None => return Ok(()),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulate::flight;

    const START_US: u64 = 1_462_017_600_000_000;

    fn playback(seconds: u64) -> (tempfile::TempDir, Playback) {
        let folder = tempfile::tempdir().unwrap();
        let log = folder.path().join("flight.tlog");
        flight(&log, 4, seconds, START_US);
        let playback = Playback::open(&log).unwrap();
        (folder, playback)
    }

    #[test]
    fn a_recording_plays_at_its_speed() {
        let (_folder, mut playback) = playback(20);
        let mut times = Vec::new();
        playback.advance(Duration::from_secs(5), |time_us, _| times.push(time_us)).unwrap();
        assert_eq!((times.first(), times.last()), (Some(&START_US), Some(&(START_US + 5_000_000))));
        playback.paused = true;
        playback.advance(Duration::from_secs(5), |_, _| panic!("it plays on")).unwrap();
        playback.paused = false;
        playback.faster();
        playback.advance(Duration::from_secs(5), |time_us, _| times.push(time_us)).unwrap();
        assert_eq!(playback.progress(), (15_000_000, 20_000_000));
        playback.advance(Duration::from_secs(50), |time_us, _| times.push(time_us)).unwrap();
        assert!(playback.has_ended() && times.is_sorted());
    }

    #[test]
    fn a_place_shows_the_same_however_it_is_reached() {
        let (_folder, mut playback) = playback(300);
        let mut played = Vec::new();
        playback.advance(Duration::from_secs(250), |_, frame| played.push(frame.bytes().to_vec())).unwrap();
        for detour in [290, 0] {
            playback.seek(START_US + detour * 1_000_000, |_, _| ()).unwrap();
            let mut sought = Vec::new();
            playback.seek(START_US + 250_000_000, |_, frame| sought.push(frame.bytes().to_vec())).unwrap();
            assert!(played.ends_with(&sought) && sought.len() < played.len() && !sought.is_empty());
            assert_eq!(playback.progress().0, 250_000_000);
        }
        playback.seek(u64::MAX, |_, _| ()).unwrap();
        assert!(playback.has_ended());
        playback.seek(0, |_, _| ()).unwrap();
        assert_eq!(playback.progress().0, 0);
    }

    #[test]
    fn times_of_any_number_are_played() {
        let (folder, _) = playback(20);
        let path = folder.path().join("flight.tlog");
        let log = std::fs::read(&path).unwrap();
        let entries = mavlink_autoquad::wire::tlog::entries(&log, Autoquad::TABLE).zip(0..);
        let wrong = entries.flat_map(|(entry, n): (_, u64)| {
            let time = if n % 3 == 0 { u64::MAX } else { crate::time::END_US - n };
            [&time.to_be_bytes(), entry.frame.bytes()].concat()
        });
        std::fs::write(&path, wrong.collect::<Vec<u8>>()).unwrap();
        let mut playback = Playback::open(&path).unwrap();
        for place in [u64::MAX, 0, crate::time::END_US] {
            playback.seek(place, |time_us, _| assert!(time_us < crate::time::END_US)).unwrap();
            playback.advance(Duration::from_secs(1_000), |_, _| ()).unwrap();
        }
    }
}
