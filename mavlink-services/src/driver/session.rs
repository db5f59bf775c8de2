//! What a station knows, without its link: blocking or not, it is the same.

use core::time::Duration;
use std::boxed::Box;
use std::string::{String, ToString};
use std::time;

use mavlink_wire::{Encode, Frame, Message, Version};

use super::Error;
use crate::common::{
    CommandLong, Heartbeat, MavAutopilot, MavCmd, MavMissionType, MavProtocolCapability, MavState, MavType, Statustext,
};
use crate::heartbeat::{Beacon, Monitor};
use crate::mission::Form;
use crate::param::Encoding;
use crate::{Address, Instant, Outgoing, Output, Retry, Service, command, earliest, mission, param, timesync};

/// How patient a station is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Patience {
    /// How long it waits for the vehicle's first heartbeat.
    pub connect: Duration,
    /// Of commands.
    pub command: command::Options,
    /// Of questions.
    pub retry: Retry,
    /// Of time measurements.
    pub time: timesync::Options,
}

impl Patience {
    /// Ten seconds for the heartbeat, and the usual of all else.
    pub const DEFAULT: Self = Self {
        connect: Duration::from_secs(10),
        command: command::Options::DEFAULT,
        retry: Retry::DEFAULT,
        time: timesync::Options::DEFAULT,
    };
}

impl Default for Patience {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// How long a `STATUSTEXT` may be ago to be the reason of a refusal.
const RECENT: Duration = Duration::from_secs(1);

/// What a ground station says.
const STATION: Heartbeat = Heartbeat {
    r#type: MavType::GCS,
    autopilot: MavAutopilot::INVALID,
    system_status: MavState::ACTIVE,
    ..Heartbeat::DEFAULT
};

/// What is shown every frame.
pub(super) type Listener = dyn FnMut(&Frame<'_>) + Send;

/// The station's clock, its heartbeat, and the vehicle's.
pub(super) struct Session {
    pub(super) patience: Patience,
    pub(super) listener: Option<Box<Listener>>,
    /// Once the vehicle was asked.
    pub(super) encoding: Option<Encoding>,
    form: Form,
    /// What the vehicle is spoken to in: MAVLink 2 once it has sent that.
    version: Option<Version>,
    started: time::Instant,
    own: Address,
    peer: Option<Address>,
    beacon: Beacon,
    vehicle: Monitor<1>,
    heartbeat: Heartbeat,
    text: Option<(Instant, String)>,
}

impl Session {
    pub(super) fn new(own: Address, patience: Patience) -> Self {
        Self {
            patience,
            listener: None,
            encoding: None,
            form: Form::Int,
            version: None,
            started: time::Instant::now(),
            own,
            peer: None,
            beacon: Beacon::from(STATION),
            vehicle: Monitor::new(),
            heartbeat: Heartbeat::DEFAULT,
            text: None,
        }
    }

    pub(super) fn now(&self) -> Instant {
        Instant::ZERO + self.started.elapsed()
    }

    /// The same time on the clock of the system; far away is a day.
    pub(super) fn at(&self, deadline: Instant, now: Instant) -> time::Instant {
        let far = Duration::from_secs(86_400);
        self.started + (deadline - Instant::ZERO).min(now - Instant::ZERO + far)
    }

    /// Looks at a frame, whatever else it is for.
    pub(super) fn handle(&mut self, frame: &Frame<'_>, now: Instant) {
        if let Some(listener) = &mut self.listener {
            listener(frame);
        }
        let from = Address::of(frame);
        if let Some(heartbeat) = frame.decode::<Heartbeat>() {
            let vehicle = heartbeat.autopilot != MavAutopilot::INVALID && heartbeat.r#type != MavType::GCS;
            if self.peer.is_none() && vehicle {
                self.peer = Some(from);
                self.vehicle = Monitor::of(from, Duration::from_secs(5));
            }
            if self.peer == Some(from) {
                self.heartbeat = heartbeat;
                self.vehicle.handle(frame, now);
            }
        } else if self.peer == Some(from)
            && let Some(text) = frame.decode::<Statustext>()
        {
            self.text = Some((now, text.text.to_string()));
        }
        if self.peer == Some(from) && self.version != Some(Version::V2) {
            self.version = Some(frame.version());
        }
    }

    /// What the station has to say by itself.
    pub(super) fn poll(&mut self, now: Instant) -> Option<Outgoing> {
        while self.vehicle.poll(now).is_some() {}
        match self.beacon.poll(now)? {
            Output::Send(message) => Some(message),
            Output::Event(event) => match event {},
        }
    }

    /// When it has something to say.
    pub(super) fn deadline(&self, other: Option<Instant>, now: Instant) -> time::Instant {
        let deadline = earliest(earliest(self.beacon.deadline(), self.vehicle.deadline()), other);
        self.at(deadline.unwrap_or(Instant::MAX), now)
    }

    /// The vehicle, once it was heard.
    pub(super) fn heard(&self) -> Option<Address> {
        self.peer
    }

    /// The vehicle, which has been heard since the station was made.
    pub(super) fn peer(&self) -> Address {
        debug_assert!(self.peer.is_some(), "a station is made when its vehicle was heard");
        self.peer.unwrap_or(Address::EVERYBODY)
    }

    pub(super) fn own(&self) -> Address {
        self.own
    }

    pub(super) fn heartbeat(&self) -> &Heartbeat {
        &self.heartbeat
    }

    pub(super) fn is_alive(&self) -> bool {
        self.vehicle.peers().next().is_some()
    }

    pub(super) fn beacon(&mut self) -> &mut Beacon {
        &mut self.beacon
    }

    pub(super) fn set_peer(&mut self, peer: Address) {
        (self.encoding, self.form, self.version) = (None, Form::Int, None);
        self.peer = Some(peer);
        self.vehicle = Monitor::of(peer, Duration::from_secs(5));
    }

    /// The same error, with what the vehicle said when it refused.
    pub(super) fn explain(&self, error: Error) -> Error {
        match (error, &self.text) {
            (Error::Command { failure: failure @ command::Failure::Refused { .. }, .. }, Some((at, text)))
                if self.now() - *at < RECENT =>
            {
                Error::Command { failure, text: Some(text.clone()) }
            }
            (error, _) => error,
        }
    }

    /// Takes what the vehicle says that it can do, or that it says nothing.
    pub(super) fn learn(&mut self, capabilities: Option<MavProtocolCapability>) {
        self.encoding = Some(Encoding::of(capabilities, self.heartbeat.autopilot));
        self.form = Form::of(capabilities, self.heartbeat.autopilot);
    }

    pub(super) fn params(&self) -> param::Access {
        let encoding = self.encoding.unwrap_or(Encoding::Bytewise);
        param::Access { retry: self.patience.retry, ..param::Access::new(self.own, self.peer(), encoding) }
    }

    pub(super) fn plan(&self, plan: MavMissionType) -> mission::Access {
        let access = mission::Access::new(self.own, self.peer()).plan(plan);
        mission::Access { form: self.form, version: self.version.unwrap_or(access.version), ..access }
    }

    pub(super) fn command(&self, command: &(impl Encode + ?Sized)) -> Result<command::Send, Error> {
        Ok(command::Send::new(self.own, self.peer(), self.patience.command, command, self.now())?)
    }

    pub(super) fn fetch<M: Message>(&self, argument: f32) -> command::Fetch<M> {
        command::Fetch::new(self.own, self.peer(), self.patience.retry, argument, self.now())
    }
}

/// The command that arms or disarms.
pub(super) const fn arming(arm: bool) -> CommandLong {
    let param1 = if arm { 1.0 } else { 0.0 };
    CommandLong { command: MavCmd::COMPONENT_ARM_DISARM, param1, ..CommandLong::DEFAULT }
}

/// The command that sends a vehicle to an item.
pub(super) fn making_current(seq: u16) -> CommandLong {
    CommandLong { command: MavCmd::DO_SET_MISSION_CURRENT, param1: f32::from(seq), ..CommandLong::DEFAULT }
}

/// How `AUTOPILOT_VERSION` was asked for before 2019.
pub(super) const OLD_VERSION: CommandLong =
    CommandLong { command: MavCmd::REQUEST_AUTOPILOT_CAPABILITIES, param1: 1.0, ..CommandLong::DEFAULT };
