//! The side of a ground station: a link on which AutoQuads are asked for motor telemetry.

use std::collections::BTreeMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::Args;
use mavlink_autoquad::autoquad::{
    AqEscTelemetry, Autoquad, Heartbeat, MavAutopilot, MavComponent, MavDataStream, MavType, RequestDataStream,
};
use mavlink_autoquad::wire::link::{Link, LinkError, Options, SendHalf};
use mavlink_autoquad::wire::{Dialect, Frame, Message, Sender, SystemId, Targeted};

use crate::failure::Failure;
use crate::interrupt;

/// System id of this program: that of no vehicle, and not that of the usual ground stations.
const SYSTEM: u8 = 254;

/// How long a call waits at most, so that Ctrl-C is seen soon.
const WAIT: Duration = Duration::from_millis(100);

/// Between two heartbeats.
const BEAT: Duration = Duration::from_secs(1);

/// Silence after which telemetry is asked for again.
const ASK_AGAIN: Duration = Duration::from_secs(2);

/// Silence that is said.
const LONG_SILENCE: Duration = Duration::from_secs(5);

/// What is sent to vehicles.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct Asking {
    /// Requests motor telemetry this many times a second.
    #[arg(long, value_name = "HZ", default_value_t = 10, value_parser = clap::value_parser!(u16).range(1..=200))]
    rate: u16,
    /// Sends nothing, not even heartbeats. Use it beside a ground station that requested the telemetry already.
    #[arg(long)]
    listen_only: bool,
}

/// For how long a command runs.
#[derive(Args, Clone, Copy, Debug)]
pub(crate) struct Running {
    /// Ends after this time. By default, Ctrl-C ends it.
    #[arg(long = "for", value_name = "TIME", value_parser = humantime::parse_duration)]
    time: Option<Duration>,
}

impl Running {
    /// Starts the time, and lets Ctrl-C end it.
    pub(crate) fn start(self) -> Result<Run, Failure> {
        interrupt::catch()?;
        Ok(Run { until: self.time.and_then(|time| Instant::now().checked_add(time)) })
    }
}

/// A command that is to go on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    until: Option<Instant>,
}

impl Run {
    /// Whether neither the time is up nor Ctrl-C was pressed.
    pub(crate) fn goes_on(self) -> bool {
        !interrupt::was_caught() && self.until.is_none_or(|until| Instant::now() < until)
    }
}

/// Where a command reads: from a recording, or from a link.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    Recording(PathBuf),
    Link(String),
}

impl Source {
    /// What the user means: a file that is there, `file:PATH`, or an address, which always has a colon.
    pub(crate) fn of(named: &OsStr) -> Self {
        let text = named.to_str().unwrap_or_default();
        match text.strip_prefix("file:") {
            Some(path) => Self::Recording(path.into()),
            None if text.contains(':') && !Path::new(named).exists() => Self::Link(text.to_owned()),
            None => Self::Recording(named.into()),
        }
    }
}

/// A link to vehicles.
pub(crate) struct Station {
    pub(crate) address: String,
    link: Link,
    asker: Asker,
    silence: Silence,
    ended: bool,
}

impl Station {
    /// Opens a link.
    pub(crate) fn connect(address: &str, asking: Asking) -> Result<Self, Failure> {
        // AutoQuad understands MAVLink 1 only; others are answered in their own version.
        let sender = Sender::v1(SYSTEM, MavComponent::MISSIONPLANNER);
        let link = connect(address, Options::new(Autoquad::TABLE, sender))?;
        let asker = Asker { asking, sending: link.sending(), beat: None, vehicles: BTreeMap::new() };
        Ok(Self { address: address.to_owned(), link, asker, silence: Silence::new(), ended: false })
    }

    /// To send to the vehicles from another thread.
    pub(crate) fn sending(&self) -> SendHalf {
        self.link.sending()
    }

    /// Why there is no connection now.
    pub(crate) fn trouble(&self) -> Option<String> {
        self.link.trouble()
    }

    /// Whether no more frames can come, because the link is a file.
    pub(crate) const fn has_ended(&self) -> bool {
        self.ended
    }

    /// The next frame. `None` if there was none until then, or for a tenth of a second.
    pub(crate) fn receive_until(&mut self, deadline: Instant) -> Result<Option<Frame<'_>>, Failure> {
        self.asker.beat()?;
        let frame = match self.link.receive_until(deadline.min(Instant::now() + WAIT)) {
            Ok(frame) => frame,
            Err(LinkError::Ended) => {
                self.ended = true;
                None
            }
            Err(error) => return Err(refused(&error)),
        };
        if let Some(frame) = &frame {
            self.asker.answer(frame)?;
            self.silence.end();
        }
        Ok(frame)
    }

    /// Says on standard error when there is no data for a while, and when there is again.
    pub(crate) fn say_silence(&mut self) {
        if let Some(sentence) = self.silence.sentence(&self.address, self.link.trouble(), Instant::now()) {
            eprintln!("autoquad: {sentence}");
        }
    }
}

/// Opens a link; what is wrong is a sentence.
pub(crate) fn connect(address: &str, options: Options) -> Result<Link, Failure> {
    Link::connect(address, options).map_err(|error| refused(&error))
}

/// What is wrong with a link.
pub(crate) fn refused(error: &LinkError) -> Failure {
    Failure::new(error.to_string())
}

/// Whether something that could not be sent matters: a full buffer does not.
pub(crate) fn sent<T>(result: Result<T, LinkError>) -> Result<(), Failure> {
    match result {
        Ok(_) | Err(LinkError::Full) => Ok(()),
        Err(error) => Err(refused(&error)),
    }
}

/// Says that the station is there, and asks.
struct Asker {
    asking: Asking,
    sending: SendHalf,
    beat: Option<Instant>,
    vehicles: BTreeMap<SystemId, Vehicle>,
}

/// When a vehicle was asked last, and when it reported its motors last.
#[derive(Clone, Copy, Default)]
struct Vehicle {
    asked: Option<Instant>,
    reported: Option<Instant>,
}

impl Asker {
    fn beat(&mut self) -> Result<(), Failure> {
        if self.asking.listen_only || self.beat.is_some_and(|then| then.elapsed() < BEAT) {
            return Ok(());
        }
        self.beat = Some(Instant::now());
        let beat = Heartbeat { r#type: MavType::GCS, autopilot: MavAutopilot::INVALID, ..Heartbeat::DEFAULT };
        sent(self.sending.send(&beat))
    }

    /// A request may get lost: it is made again until there is telemetry.
    fn answer(&mut self, frame: &Frame<'_>) -> Result<(), Failure> {
        let now = Instant::now();
        if frame.message_id() == AqEscTelemetry::ID && frame.is_verified() {
            self.vehicles.entry(frame.system_id()).or_default().reported = Some(now);
            return Ok(());
        }
        let Some(beat) = frame.decode::<Heartbeat>() else { return Ok(()) };
        let vehicle = self.vehicles.entry(frame.system_id()).or_default();
        let is_recent = |then: Option<Instant>| then.is_some_and(|then| now - then < ASK_AGAIN);
        if beat.autopilot != MavAutopilot::AUTOQUAD
            || self.asking.listen_only
            || is_recent(vehicle.asked)
            || is_recent(vehicle.reported)
        {
            return Ok(());
        }
        vehicle.asked = Some(now);
        let request = RequestDataStream {
            req_stream_id: MavDataStream::PROPULSION,
            req_message_rate: self.asking.rate,
            start_stop: 1,
            ..RequestDataStream::DEFAULT
        };
        sent(self.sending.send(&request.to(frame.system_id(), frame.component_id())))
    }
}

/// Whether there is data.
struct Silence {
    since: Instant,
    said: bool,
    ended: Option<Duration>,
}

impl Silence {
    fn new() -> Self {
        Self { since: Instant::now(), said: false, ended: None }
    }

    fn end(&mut self) {
        let now = Instant::now();
        if self.said {
            self.ended = Some(now - self.since);
        }
        (self.since, self.said) = (now, false);
    }

    fn sentence(&mut self, address: &str, trouble: Option<String>, now: Instant) -> Option<String> {
        if let Some(silence) = self.ended.take() {
            return Some(format!("{address}: data again after {} s", silence.as_secs()));
        }
        if self.said || now - self.since < LONG_SILENCE {
            return None;
        }
        self.said = true;
        let why = trouble.map(|trouble| format!(" ({trouble})")).unwrap_or_default();
        Some(format!("{address}: no data for {} s{why}; waiting", LONG_SILENCE.as_secs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_named_is_a_recording_or_a_link() {
        for (text, path) in
            [("flight.tlog", "flight.tlog"), ("file:flight.raw", "flight.raw"), ("Cargo.toml", "Cargo.toml")]
        {
            assert_eq!(Source::of(OsStr::new(text)), Source::Recording(path.into()));
        }
        for text in ["udpin:0.0.0.0:14550", "serial:/dev/ttyUSB0:57600", "udp:nonsense"] {
            assert_eq!(Source::of(OsStr::new(text)), Source::Link(text.to_owned()));
        }
    }

    #[test]
    fn silence_is_said_once_and_its_end_as_well() {
        let (mut silence, start) = (Silence::new(), Instant::now());
        let at = |silence: &mut Silence, second| silence.sentence("udpin", None, start + Duration::from_secs(second));
        assert_eq!(at(&mut silence, 4), None);
        assert_eq!(at(&mut silence, 6).as_deref(), Some("udpin: no data for 5 s; waiting"));
        assert_eq!(at(&mut silence, 60), None);
        silence.end();
        assert_eq!(at(&mut silence, 0).as_deref(), Some("udpin: data again after 0 s"));
        assert_eq!(at(&mut silence, 1), None);
    }

    #[test]
    fn a_wrong_address_is_a_sentence() {
        let asking = Asking { rate: 10, listen_only: true };
        for (address, said) in [
            ("udp:0.0.0.0:14550", "udpin"),
            ("serial:/dev/none:57600", "there is no device /dev/none"),
            #[cfg(unix)]
            ("serial:/dev/null:57600", "/dev/null does not open as a serial port"),
            ("tcpout:127.0.0.1:1", "nobody answers"),
        ] {
            let Err(Failure::Sentence(sentence)) = Station::connect(address, asking) else { panic!("{address}") };
            assert!(sentence.contains(said), "{sentence}");
        }
    }
}
