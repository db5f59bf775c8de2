//! Stations over a link: the machines, a clock and a [`Link`](mavlink_wire::link::Link).

mod blocking;
mod error;
mod session;
mod station;
#[cfg(feature = "tokio")]
pub(crate) mod tokio;
mod until;
mod verbs;

use std::boxed::Box;
use std::collections::BTreeMap;
use std::time;
use std::vec;
use std::vec::Vec;

use mavlink_wire::link::{LinkError, Options};
use mavlink_wire::{Dialect, Encode, Frame, FrameBuf, Message, Sender};

pub use blocking::Station;
pub use error::Error;
pub use session::Patience;

use crate::command::{self, Accepted, Fetch, Progress};
use crate::common::{AutopilotVersion, Common, Heartbeat, MavMissionType, MavResult};
use crate::heartbeat::Beacon;
use crate::interval::{self, Interval};
use crate::mission::{Clear, Download, MissionItem, Sent, SetCurrent, Upload, Uploaded};
use crate::param::{List, ListProgress, Listed, Name, ParamValue, Read, Which, Write};
use crate::timesync::{Measure, Offset};
use crate::{Address, Instant, Operation, Outgoing, Output, Update};
use session::{OLD_VERSION, Session, arming, making_current};
use until::While;

/// The ids of a ground station, unless it has others.
const STATION: (u8, u8) = (255, 190);

/// What finds no room in the buffer is lost, as on the air, and is asked for again.
fn unless_full(sent: Result<(), LinkError>) -> Result<(), Error> {
    match sent {
        Ok(()) | Err(LinkError::Full) => Ok(()),
        Err(error) => Err(error.into()),
    }
}
