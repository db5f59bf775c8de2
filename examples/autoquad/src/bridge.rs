//! `autoquad bridge`: an AutoQuad for the ground stations of today.

mod ground;
mod vehicle;

use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Args;
use mavlink_autoquad::autoquad::{Autoquad, MavComponent};
use mavlink_autoquad::wire::link::{Link, Options};
use mavlink_autoquad::wire::signing::{Key, Signer, Verifier};
use mavlink_autoquad::wire::{Dialect, Sender, Timestamp};

use crate::failure::Failure;
use crate::input::Input;
use crate::station::{Asking, Run, Running, Station, connect};
use crate::telemetry::Firmware;
use crate::time;
use ground::Ground;
use vehicle::Translation;

/// How often the motors are reported.
const REPORT: Duration = Duration::from_millis(100);

/// Connects an AutoQuad to current ground stations such as QGroundControl, which show ESC_INFO and ESC_STATUS.
///
/// The bridge forwards all that the vehicle sends, except AQ_TELEMETRY_F and AQ_ESC_TELEMETRY: ArduPilot uses their ids for other
/// messages. Instead it sends ESC_INFO once and ESC_STATUS ten times a second, from the vehicle's own system and component, with
/// continuous sequence numbers. It forwards what ground stations send to the vehicle as MAVLink 1, because AutoQuad understands
/// nothing else.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Bridge {
    /// The vehicle's address: udpin:, udpout:, udpbcast:, tcpin:, tcpout:HOST:PORT or serial:DEVICE:BAUD.
    vehicle: String,
    /// The addresses of the ground stations.
    #[arg(required = true)]
    ground: Vec<String>,
    /// Signs all frames to the ground stations, as MAVLink 2, and accepts only signed frames from them. The file holds the
    /// passphrase of the ground station; `-` is standard input.
    #[arg(long, value_name = "FILE")]
    sign: Option<PathBuf>,
    #[command(flatten)]
    running: Running,
    #[command(flatten)]
    asking: Asking,
    #[command(flatten)]
    firmware: Firmware,
}

const AFTER_HELP: &str = "\
Examples:
  autoquad bridge serial:/dev/ttyUSB0:57600 udpout:127.0.0.1:14550
  autoquad bridge udpin:0.0.0.0:14551 udpout:192.168.0.7:14550 tcpin:0.0.0.0:5760
  autoquad bridge serial:/dev/ttyUSB0:57600 udpout:192.168.0.7:14550 --sign passphrase.txt";

impl Bridge {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let run = self.running.start()?;
        let key = self.sign.as_ref().map(|path| key(path)).transpose()?;
        let mut station = Station::connect(&self.vehicle, self.asking)?;
        let mut ground = Ground::default();
        for address in &self.ground {
            ground.add(ground_link(address, key.as_ref())?, station.sending());
        }
        eprintln!("autoquad: forwards {} to {}; Ctrl-C ends it", self.vehicle, self.ground.join(", "));
        let mut translation = Translation::new(self.firmware, key);
        let result = forward(run, &mut station, &mut ground, &mut translation);
        ground.close();
        eprintln!("autoquad: {}", translation.tally());
        result
    }
}

/// Forwards from the vehicle to the ground, and looks after what goes the other way.
fn forward(run: Run, station: &mut Station, ground: &mut Ground, translation: &mut Translation) -> Result<(), Failure> {
    let mut reported = Instant::now();
    while run.goes_on() && !station.has_ended() {
        if let Some(result) = ground.ended() {
            return result;
        }
        if let Some(frame) = station.receive_until(reported + REPORT)? {
            ground.send(&translation.forward(&frame));
        }
        if reported.elapsed() >= REPORT {
            reported = Instant::now();
            ground.send(&translation.report(Timestamp::from_unix_micros(time::now_us())));
        }
        station.say_silence();
    }
    Ok(())
}

/// The key of the passphrase in a file.
fn key(path: &std::path::Path) -> Result<Key, Failure> {
    let input = Input::open(path)?;
    let name = input.name.clone();
    let text = String::from_utf8(input.read_whole()?).map_err(|_| Failure::with(&name, "is no text in UTF-8"))?;
    match text.trim_end_matches(['\r', '\n']) {
        "" => Err(Failure::with(name, "has no passphrase")),
        passphrase => Ok(Key::of_passphrase(passphrase)),
    }
}

/// A link to a ground station. The sender is never used: all frames say by themselves who speaks.
fn ground_link(address: &str, key: Option<&Key>) -> Result<Link, Failure> {
    let options = Options::new(Autoquad::TABLE, Sender::v2(1, MavComponent::AUTOPILOT1));
    let options = match key {
        Some(key) => options.with_verifier(Verifier::new(Some(key.clone()))),
        None => options,
    };
    connect(address, options)
}

/// What signs the frames of one component.
fn signer(key: &Key, now: Timestamp) -> Signer {
    Signer::new(key.clone(), 0, now)
}
