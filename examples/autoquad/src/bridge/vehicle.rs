//! From the vehicle to the ground stations.

use std::collections::BTreeMap;
use std::time::Instant;

use mavlink_autoquad::autoquad::{AqEscTelemetry, AqTelemetryF, Autoquad};
use mavlink_autoquad::esc::{Conversion, EscTable};
use mavlink_autoquad::wire::signing::Key;
use mavlink_autoquad::wire::{
    ComponentId, Dialect, Encode, Frame, FrameBuf, MAX_FRAME, Message, Sender, SystemId, Timestamp, Version,
};

use super::signer;
use crate::telemetry::Firmware;
use crate::time;

/// Reports of the motors of which one is with ESC_INFO.
const INFO_EVERY: u32 = 10;

/// Who speaks.
type Speaker = (SystemId, ComponentId);

/// Makes of what vehicles send what ground stations of today understand.
pub(super) struct Translation {
    firmware: Firmware,
    key: Option<Key>,
    senders: BTreeMap<Speaker, Sender>,
    vehicles: BTreeMap<Speaker, Motors>,
    reports: u32,
    forwarded: u64,
    translated: u64,
    withheld: u64,
}

/// The motors of a vehicle, and when it reported them last.
struct Motors {
    table: EscTable,
    heard: Instant,
}

impl Translation {
    pub(super) fn new(firmware: Firmware, key: Option<Key>) -> Self {
        Self {
            firmware,
            key,
            senders: BTreeMap::new(),
            vehicles: BTreeMap::new(),
            reports: 0,
            forwarded: 0,
            translated: 0,
            withheld: 0,
        }
    }

    /// What goes on of a frame: the frame with the next number, or nothing.
    pub(super) fn forward(&mut self, frame: &Frame<'_>) -> Vec<FrameBuf> {
        let speaker = (frame.system_id(), frame.component_id());
        if [AqEscTelemetry::ID, AqTelemetryF::ID].contains(&frame.message_id()) {
            if let Some(telemetry) = self.firmware.telemetry(frame) {
                let new = || Motors { table: EscTable::new(), heard: Instant::now() };
                let motors = self.vehicles.entry(speaker).or_insert_with(new);
                motors.table.update(&telemetry);
                motors.heard = Instant::now();
                self.translated += 1;
            }
            return Vec::new();
        }
        let signs = self.key.is_some();
        let sender = self.sender(speaker);
        let next = match frame.version() {
            // MAVLink 1 has no signatures.
            Version::V1 if signs => frame.message::<Autoquad>().and_then(|message| encode(sender, &message)),
            _ => sender.renumber(frame).ok(),
        };
        match next {
            Some(_) => self.forwarded += 1,
            None => self.withheld += 1,
        }
        next.into_iter().collect()
    }

    /// The motors of all vehicles, in the messages of today.
    pub(super) fn report(&mut self, now: Timestamp) -> Vec<FrameBuf> {
        let with_info = self.reports.is_multiple_of(INFO_EVERY);
        self.reports = self.reports.wrapping_add(1);
        self.senders.values_mut().for_each(|sender| sender.advance_time(now));
        let mut frames = Vec::new();
        let reports: Vec<_> =
            self.vehicles.iter().map(|(&speaker, motors)| (speaker, motors.report(with_info))).collect();
        for (speaker, messages) in reports {
            let sender = self.sender(speaker);
            frames.extend(messages.iter().filter_map(|message| encode(sender, message)));
        }
        frames
    }

    /// What was done, in a sentence.
    pub(super) fn tally(&self) -> String {
        let Self { forwarded, translated, withheld, .. } = self;
        let kept = if *withheld > 0 { format!(", {withheld} withheld") } else { String::new() };
        format!("{forwarded} frames forwarded, {translated} of motor telemetry translated{kept}")
    }

    /// Everything of one component is numbered and signed by one sender, what is forwarded and what is made.
    fn sender(&mut self, speaker: Speaker) -> &mut Sender {
        let key = self.key.as_ref();
        self.senders.entry(speaker).or_insert_with(|| {
            let mut sender = Sender::v2(speaker.0, speaker.1);
            sender.set_signer(key.map(|key| signer(key, Timestamp::from_unix_micros(time::now_us()))));
            sender
        })
    }
}

impl Motors {
    fn report(&self, with_info: bool) -> Vec<Autoquad> {
        let silence_us = u64::try_from(self.heard.elapsed().as_micros()).unwrap_or(u64::MAX);
        let (now_us, conversion) = (self.table.uptime_us().saturating_add(silence_us), Conversion::DEFAULT);
        let batches = 0..self.table.num_motors().div_ceil(4);
        let mut messages = Vec::new();
        for batch in batches {
            if with_info {
                messages.extend(self.table.to_esc_info(batch, now_us, &conversion).map(Autoquad::from));
            }
            messages.extend(self.table.to_esc_status(batch, now_us, &conversion).map(Autoquad::from));
        }
        messages
    }
}

fn encode(sender: &mut Sender, message: &impl Encode) -> Option<FrameBuf> {
    let mut buffer = [0; MAX_FRAME];
    let bytes = sender.encode(message, &mut buffer).ok()?;
    Frame::parse(bytes, Autoquad::TABLE).ok().map(FrameBuf::from)
}

#[cfg(test)]
mod tests {
    use super::super::ground::Older;
    use super::*;
    use crate::recording::Recording;
    use crate::simulate::flight;
    use mavlink_autoquad::autoquad::{CommandLong, EscInfo, EscStatus, MavCmd};
    use mavlink_autoquad::wire::Losses;
    use mavlink_autoquad::wire::signing::Verifier;

    /// What ground stations get of a flight, with a report after every tenth frame.
    fn bridged(motors: u8, key: Option<&Key>) -> Vec<FrameBuf> {
        let folder = tempfile::tempdir().unwrap();
        let log = folder.path().join("flight.tlog");
        flight(&log, motors, 20, 1_462_017_600_000_000);
        let (mut recording, mut out) = (Recording::open(&log).unwrap(), Vec::new());
        let mut translation = Translation::new(Firmware::default(), key.cloned());
        let mut count = 0_u32;
        while let Some(entry) = recording.read().unwrap() {
            out.extend(translation.forward(&entry.frame));
            count += 1;
            if count.is_multiple_of(10) {
                out.extend(translation.report(Timestamp::from_unix_micros(time::now_us())));
            }
        }
        out
    }

    #[test]
    fn ground_stations_get_escs_of_today_and_no_gap() {
        for motors in [1, 4, 6, 16] {
            let (frames, mut losses) = (bridged(motors, None), Losses::<4>::new());
            let (mut info, mut status) = (Vec::new(), Vec::new());
            for frame in &frames {
                let frame = frame.as_frame();
                losses.count(&frame);
                assert!(![150, 152].contains(&frame.message_id()));
                assert_eq!((frame.system_id(), frame.component_id()), (1.into(), 1.into()));
                info.extend(frame.decode::<EscInfo>());
                status.extend(frame.decode::<EscStatus>());
            }
            assert_eq!((losses.total().lost, losses.total().received), (0, frames.len() as u64));
            let batches = usize::from(motors.div_ceil(4));
            assert!(
                info.len() >= batches && status.len() >= 9 * info.len(),
                "{motors}: {} {}",
                info.len(),
                status.len()
            );
            assert!(info.iter().all(|info| info.count == motors && info.index % 4 == 0));
            assert!(status.iter().any(|status| status.rpm[0] > 5_000 && status.voltage[0] > 13.0));
        }
    }

    #[test]
    fn signed_frames_are_all_believed() {
        let key = Key::of_passphrase("of the test");
        let mut verifier = Verifier::new(Some(key.clone()));
        let frames = bridged(4, Some(&key));
        for frame in &frames {
            let now = Timestamp::from_unix_micros(time::now_us());
            assert_eq!(frame.as_frame().version(), Version::V2);
            verifier.check(&frame.as_frame(), now).unwrap();
        }
        assert!(frames.len() > 100);
    }

    #[test]
    fn ground_stations_are_heard_in_mavlink_1() {
        let command = CommandLong { command: MavCmd::AQ_TELEMETRY, param1: 1.0, ..CommandLong::DEFAULT };
        let (mut ground, mut older) = (Sender::v2(255, 190), Older::default());
        for sequence in 0..3 {
            let frame = encode(&mut ground, &command).unwrap();
            let old = older.frame(&frame.as_frame()).unwrap();
            let old = old.as_frame();
            assert_eq!((old.version(), old.sequence(), old.system_id()), (Version::V1, sequence, 255.into()));
            assert_eq!(old.decode::<CommandLong>(), Some(command));
        }
        // MAVLink 1 has no such message.
        let status = encode(&mut ground, &EscStatus::DEFAULT).unwrap();
        assert!(older.frame(&status.as_frame()).is_none());
    }
}
