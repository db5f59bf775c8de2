//! `autoquad salvage`: what is left in the logs of AutoQuad's QGroundControl.

use std::collections::BTreeMap;
use std::path::PathBuf;

use clap::Args;
use mavlink_autoquad::autoquad::{AqEscTelemetry, AqTelemetryF, Autoquad, Heartbeat};
use mavlink_autoquad::wire::tlog::Writer;
use mavlink_autoquad::wire::tlog::salvage::{Record, records};
use mavlink_autoquad::wire::{ComponentId, Dialect, Encode, Frame, MAX_FRAME, Message, MessageInfo, Sender, SystemId};

use crate::failure::Failure;
use crate::input::{Input, named_after};
use crate::output::Overwriting;
use crate::progress;

/// Converts a .mavlink log, which AutoQuad's QGroundControl wrote from December 2012 on, to a tlog.
///
/// In those logs every frame lacks its last eight bytes: the checksum and the end of the payload. Fields that are lost, fully or in
/// part, become zero; the program lists their messages at the end. Motor telemetry lost only the ids of the third and the fourth
/// controller of each batch, and the firmware versions. The ids are counted on from the second, or taken from --ports; the version
/// is that of --esc-version. AQ_TELEMETRY_F is left out, because the number of its dataset is lost.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Salvage {
    /// The .mavlink log to read; `-` is standard input.
    log: PathBuf,
    /// The tlog to write; `-` is standard output. By default, the log's name with .tlog.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    overwriting: Overwriting,
    /// The firmware of the controllers, times ten: 21 for ESC32 version 2.1, which counts errors, or 30 for version 3.0,
    /// which measures the temperature.
    #[arg(long, value_name = "VERSION", default_value_t = 21)]
    esc_version: u8,
    /// The motor ports in use, such as 1,2,3,4,5,8. By default, they count from 1 without a gap.
    #[arg(long, value_name = "PORTS", value_delimiter = ',', value_parser = clap::value_parser!(u8).range(1..=16))]
    ports: Vec<u8>,
}

const AFTER_HELP: &str = "\
Examples:
  autoquad salvage 2014-06-01.mavlink         (2014-06-01.tlog)
  autoquad salvage old.mavlink --out old.tlog --esc-version 30 --ports 1,2,3,4,5,8";

/// Controllers in a message.
const BATCH: usize = 4;

/// A message that a record was made into again.
struct Salvaged {
    info: &'static MessageInfo,
    payload: [u8; 255],
}

impl Encode for Salvaged {
    fn info(&self) -> &'static MessageInfo {
        self.info
    }

    fn write(&self, payload: &mut [u8; 255]) {
        *payload = self.payload;
    }
}

impl Salvage {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let input = Input::open(&self.log)?;
        let name = input.name.clone();
        let log = input.read_whole()?;
        let mut salvaged = records(&log, Autoquad::TABLE).peekable();
        if salvaged.peek().is_none() {
            return Err(Failure::with(name, "nothing of it is a record of AutoQuad's QGroundControl"));
        }
        let out = self.out.clone().unwrap_or_else(|| named_after(&self.log, "tlog"));
        let mut writer = Writer::new(self.overwriting.whole(&out, Some(&self.log))?.of_bytes()?);
        let (mut senders, mut tally) = (BTreeMap::<_, Sender>::new(), Tally::default());
        let bar = progress::bar(log.len() as u64);
        for record in salvaged {
            bar.inc(8 + 6 + record.payload().len() as u64 + record.skipped);
            if record.message_id() == Some(AqTelemetryF::ID) {
                tally.datasets += 1;
                continue;
            }
            let Some((message, ids)) = self.message(&record) else {
                tally.unknown += 1;
                continue;
            };
            let sender = senders.entry(ids).or_insert_with(|| Sender::v1(ids.0, ids.1));
            sender.set_sequence(record.sequence().unwrap_or_default());
            let mut buffer = [0; MAX_FRAME];
            let bytes = sender.encode(&message, &mut buffer).map_err(|error| Failure::with(&name, error))?;
            let frame = Frame::parse(bytes, Autoquad::TABLE).map_err(|error| Failure::with(&name, error))?;
            writer.write(record.time_us, &frame).map_err(Failure::written)?;
            tally.count(&message, &record);
        }
        bar.finish_and_clear();
        let telemetry = tally.messages - tally.lossy.values().sum::<u64>();
        let written = format_args!("{} messages written, {telemetry} of them motor telemetry", tally.messages);
        writer.into_inner().finish_saying(written)?;
        tally.say();
        Ok(())
    }

    /// The message of a record, with what can be known of its end; `None` if it is none of the dialect.
    fn message(&self, record: &Record<'_>) -> Option<(Salvaged, (SystemId, ComponentId))> {
        let info = Autoquad::TABLE.get(record.message_id()?)?;
        let ids = (record.system_id()?, record.component_id()?);
        let whole = record.payload().len() + record.missing();
        if usize::from(info.len_v1) != whole {
            return None;
        }
        let mut payload = [0; 255];
        payload.get_mut(..record.payload().len())?.copy_from_slice(record.payload());
        blank(info, record.payload().len(), &mut payload);
        let mut message = Salvaged { info, payload };
        if info.id == AqEscTelemetry::ID {
            let mut telemetry = AqEscTelemetry::decode(&message.payload);
            self.complete(&mut telemetry);
            telemetry.write(&mut message.payload);
        }
        Some((message, ids))
    }

    /// Fills in what motor telemetry has lost.
    fn complete(&self, telemetry: &mut AqEscTelemetry) {
        telemetry.data_version = [self.esc_version; BATCH];
        let first = usize::from(telemetry.seq.saturating_sub(1)) * BATCH;
        let second = telemetry.escid.get(1).copied().unwrap_or_default();
        for (place, id) in telemetry.escid.iter_mut().enumerate().skip(2) {
            let counted = second.saturating_add(place as u8 - 1);
            *id = self.ports.get(first + place).copied().unwrap_or(counted);
        }
    }
}

/// Makes numbers zero of which only a part is there: half a number is another number. Of a heartbeat's mode that part has all
/// modes, one bit each; what is lost are features in effect.
fn blank(info: &MessageInfo, there: usize, payload: &mut [u8; 255]) {
    if info.id == Heartbeat::ID {
        return;
    }
    for field in Autoquad::fields(info.id).unwrap_or_default() {
        let (start, size) = (usize::from(field.offset), field.kind.size());
        let cut = (start..start + field.size()).step_by(size).find(|&at| at < there && there < at + size);
        if let Some(number) = cut.and_then(|at| payload.get_mut(at..at + size)) {
            number.fill(0);
        }
    }
}

/// What came out.
#[derive(Default)]
struct Tally {
    messages: u64,
    /// Messages of which something is lost, by name.
    lossy: BTreeMap<&'static str, u64>,
    skipped: u64,
    unknown: u64,
    /// AQ_TELEMETRY_F without the number that says what it is.
    datasets: u64,
}

impl Tally {
    fn count(&mut self, message: &Salvaged, record: &Record<'_>) {
        self.messages += 1;
        self.skipped += record.skipped;
        if message.info.id != AqEscTelemetry::ID {
            *self.lossy.entry(message.info.name).or_default() += 1;
        }
    }

    /// Says what is lost.
    fn say(&self) {
        if !self.lossy.is_empty() {
            let names: Vec<String> = self.lossy.iter().map(|(name, count)| format!("{count} {name}")).collect();
            eprintln!("autoquad: the last fields are lost of {}", names.join(", "));
        }
        if self.datasets > 0 {
            eprintln!("autoquad: {} AQ_TELEMETRY_F were left out: which dataset they are is lost", self.datasets);
        }
        if self.unknown > 0 {
            eprintln!("autoquad: {} records of unknown messages were left out", self.unknown);
        }
        if self.skipped > 0 {
            eprintln!("autoquad: {} bytes belong to no record and were skipped", self.skipped);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::*;
    use crate::recording::Recording;
    use crate::simulate::flight;

    /// The log of a flight of six motors, as AutoQuad's QGroundControl would have written it.
    fn log(path: &Path) -> u64 {
        flight(path, 6, 20, 1_400_000_000_000_000);
        let (mut recording, mut log, mut frames) = (Recording::open(path).unwrap(), Vec::new(), 0);
        while let Some(entry) = recording.read().unwrap() {
            let bytes = entry.frame.bytes();
            log.extend(entry.time_us.unwrap().to_le_bytes());
            log.extend(&bytes[..bytes.len() - 8]);
            frames += u64::from(entry.frame.message_id() != AqTelemetryF::ID);
        }
        fs::write(path, log).unwrap();
        frames
    }

    fn salvage(folder: &Path, ports: &[u8]) -> Salvage {
        Salvage {
            log: folder.join("old.mavlink"),
            out: None,
            overwriting: Overwriting { force: true },
            esc_version: 30,
            ports: ports.to_vec(),
        }
    }

    #[test]
    fn an_old_log_becomes_a_tlog() {
        let folder = tempfile::tempdir().unwrap();
        let frames = log(&folder.path().join("old.mavlink"));
        for (ports, third) in [(&[][..], 3), (&[1, 2, 7, 8, 9, 10], 7)] {
            salvage(folder.path(), ports).run().unwrap();
            let mut recording = Recording::open(&folder.path().join("old.tlog")).unwrap();
            let (mut read, mut telemetry, mut modes) = (0, Vec::new(), Vec::new());
            while let Some(entry) = recording.read().unwrap() {
                read += 1;
                assert!(entry.frame.is_verified() && entry.time_us.is_some_and(|time| time >= 1_400_000_000_000_000));
                telemetry.extend(entry.frame.decode::<AqEscTelemetry>());
                modes.extend(entry.frame.decode::<Heartbeat>().map(|beat| beat.custom_mode));
            }
            assert_eq!(read, frames);
            assert!(modes.contains(&(1 << 5)), "a mission was flown: {modes:?}");
            let flying = telemetry.iter().find(|telemetry| telemetry.time_boot_ms == 16_000).unwrap();
            assert_eq!((flying.escid, flying.data_version), ([1, 2, third, third + 1], [30; 4]));
            assert!(flying.escs().all(|esc| esc.status.is_some_and(|status| status.rpm() > 5_000)), "{flying:?}");
        }
    }

    #[test]
    fn what_is_no_such_log_is_said() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("old.mavlink"), [0x55; 300]).unwrap();
        let Err(Failure::Sentence(sentence)) = salvage(folder.path(), &[]).run() else { panic!("salvaged") };
        assert!(sentence.contains("is a record"), "{sentence}");
        assert!(!folder.path().join("old.tlog").exists());
        let onto_itself = Salvage { out: Some(folder.path().join("old.mavlink")), ..salvage(folder.path(), &[]) };
        assert!(onto_itself.run().is_err());
    }
}
