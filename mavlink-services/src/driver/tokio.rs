//! A station for tokio.

use std::boxed::Box;
use std::collections::BTreeMap;
use std::time;
use std::vec;
use std::vec::Vec;

use mavlink_wire::link::Options;
use mavlink_wire::link::tokio::Link;
use mavlink_wire::{Dialect, Encode, Frame, FrameBuf, Message, Sender};

use super::session::{OLD_VERSION, Patience, Session, arming, making_current};
use super::until::While;
use super::verbs::verbs;
use super::{Error, STATION, unless_full};
use crate::command::{self, Accepted, Fetch, Progress};
use crate::common::{AutopilotVersion, Common, Heartbeat, MavMissionType, MavResult};
use crate::heartbeat::Beacon;
use crate::interval::{self, Interval};
use crate::mission::{Clear, Download, MissionItem, Sent, SetCurrent, Upload, Uploaded};
use crate::param::{List, ListProgress, Listed, Name, ParamValue, Read, Which, Write};
use crate::timesync::{Measure, Offset};
use crate::{Address, Instant, Operation, Outgoing, Output, Update};

/// A ground station: waits for a vehicle, and has a method for each operation.
///
/// ```no_run
/// # async fn fly() -> Result<(), mavlink_services::Error> {
/// use mavlink_services::tokio::Station;
///
/// let mut station = Station::connect("udpin:0.0.0.0:14550").await?;
/// println!("{} is a {}", station.vehicle(), station.heartbeat().r#type);
/// station.set_param("RATE_P", 0.2).await?;
/// station.arm().await?;
/// # Ok(())
/// # }
/// ```
///
/// It sends its heartbeat and watches the vehicle's only while it waits for something. Between two operations, call
/// [`receive_until`](Self::receive_until).
///
/// Every future may be dropped before its end: no frame is torn, and the next operation starts afresh. To continue an operation,
/// keep it and [`run`](Self::run) it again.
pub struct Station {
    link: Link,
    session: Session,
}

impl Station {
    /// Opens a link as system 255, component 190, and waits for a vehicle.
    ///
    /// # Errors
    ///
    /// The address is wrong, the link cannot be opened, or no vehicle is heard in ten seconds.
    pub async fn connect(address: &str) -> Result<Self, Error> {
        let (system_id, component_id) = STATION;
        let options = Options::new(Common::TABLE, Sender::v2(system_id, component_id));
        Self::over(Link::connect(address, options).await?, Patience::DEFAULT).await
    }

    /// Waits for a vehicle on a link of yours: with other ids, with messages of your dialect, with signatures.
    ///
    /// # Errors
    ///
    /// The link fails, or no vehicle is heard in time.
    pub async fn over(link: Link, patience: Patience) -> Result<Self, Error> {
        let own = Address::new(link.system_id(), link.component_id());
        let mut station = Self { link, session: Session::new(own, patience) };
        let until = time::Instant::now() + patience.connect;
        while station.session.heard().is_none() {
            if time::Instant::now() >= until {
                return Err(Error::NoVehicle { waited: patience.connect });
            }
            station.idle(station.session.now(), None, Some(until), |_, _| {}).await?;
        }
        Ok(station)
    }

    /// Runs an operation to its end. One whose future was dropped may be continued.
    ///
    /// # Errors
    ///
    /// The operation fails, or the link does.
    pub async fn run<O: Operation>(
        &mut self,
        operation: &mut O,
        mut progress: impl FnMut(O::Progress),
    ) -> Result<O::Outcome, Error>
    where
        Error: From<O::Failure>,
    {
        let mut now = self.session.now();
        loop {
            while let Some(output) = operation.poll(now) {
                match output {
                    Output::Send(message) => say(&self.link, &message).await?,
                    Output::Event(Update::Progress(told)) => progress(told),
                    Output::Event(Update::Done(end)) => {
                        flush(&self.link).await?;
                        return end.map_err(|why| self.session.explain(why.into()));
                    }
                }
            }
            let Some(deadline) = operation.deadline() else { return Err(Error::Over) };
            now = self.idle(now, Some(deadline), None, |frame, now| operation.handle(frame, now)).await?;
        }
    }

    /// Waits for the next frame from any sender; `None` if there is none by the deadline.
    ///
    /// # Errors
    ///
    /// The link fails.
    pub async fn receive_until(&mut self, deadline: time::Instant) -> Result<Option<FrameBuf>, Error> {
        let mut received = None;
        while received.is_none() && time::Instant::now() < deadline {
            self.idle(self.session.now(), None, Some(deadline), |frame, _| received = Some(FrameBuf::from(*frame)))
                .await?;
        }
        Ok(received)
    }

    /// Lets a frame come, or the time; gives the time.
    async fn idle(
        &mut self,
        now: Instant,
        deadline: Option<Instant>,
        until: Option<time::Instant>,
        take: impl FnOnce(&Frame<'_>, Instant),
    ) -> Result<Instant, Error> {
        while let Some(message) = self.session.poll(now) {
            say(&self.link, &message).await?;
        }
        flush(&self.link).await?;
        let own = self.session.deadline(deadline, now);
        let received = self.link.receive_until(until.map_or(own, |until| until.min(own))).await?;
        let now = self.session.now();
        if let Some(frame) = received {
            self.session.handle(&frame, now);
            take(&frame, now);
        }
        Ok(now)
    }

    verbs!([async] [.await]);
}

/// Sends with the next [`flush`].
///
/// It borrows the link alone, so that the futures of a station can go to another thread.
async fn say(link: &Link, message: &Outgoing) -> Result<(), Error> {
    unless_full(link.queue(message).await.map(drop))
}

async fn flush(link: &Link) -> Result<(), Error> {
    unless_full(link.flush().await)
}
