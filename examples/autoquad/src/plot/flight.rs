//! What is plotted, collected from a recording.

use std::collections::BTreeMap;

use mavlink_autoquad::autoquad::Esc;
use mavlink_autoquad::esc::UptimeClock;
use mavlink_autoquad::wire::SystemId;

use super::trace::Trace;
use crate::failure::Failure;
use crate::quantity::Quantity;
use crate::recording::Recording;
use crate::telemetry::{Firmware, fault};

/// Something that happened to a controller.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Event {
    /// Since the start, in µs.
    pub(super) time_us: u64,
    pub(super) port: u8,
    pub(super) what: String,
}

/// The motors of one vehicle over time.
pub(super) struct Flight {
    pub(super) system: SystemId,
    /// Unix time in µs, if the recording knows.
    pub(super) start_us: Option<u64>,
    /// Of the last report since the start, in µs.
    pub(super) end_us: u64,
    pub(super) motors: BTreeMap<u8, Trace>,
    pub(super) events: Vec<Event>,
    /// Controllers that are out of order, and why.
    troubles: BTreeMap<u8, String>,
}

impl Flight {
    /// Collects the motors of a vehicle: of the one that is asked for, or of the first that has any.
    pub(super) fn read(
        mut recording: Recording,
        wanted: Option<SystemId>,
        firmware: Firmware,
    ) -> Result<Option<Self>, Failure> {
        let (mut flight, mut clock, mut begin_us) = (None::<Self>, UptimeClock::new(), None);
        while let Some(entry) = recording.read()? {
            let system = entry.frame.system_id();
            let chosen = flight.as_ref().map(|flight| flight.system).or(wanted);
            let Some(telemetry) = firmware.telemetry(&entry.frame).filter(|_| chosen.is_none_or(|id| id == system))
            else {
                continue;
            };
            let uptime_us = clock.update(telemetry.time_boot_ms);
            let now_us = entry.time_us.unwrap_or(uptime_us);
            let since_us = now_us.saturating_sub(*begin_us.get_or_insert(now_us));
            let flight = flight.get_or_insert_with(|| Self::new(system, entry.time_us));
            for esc in telemetry.escs() {
                flight.add(since_us, &esc);
            }
        }
        recording.finish();
        Ok(flight)
    }

    const fn new(system: SystemId, start_us: Option<u64>) -> Self {
        Self { system, start_us, end_us: 0, motors: BTreeMap::new(), events: Vec::new(), troubles: BTreeMap::new() }
    }

    fn add(&mut self, time_us: u64, esc: &Esc) {
        self.end_us = self.end_us.max(time_us);
        self.motors.entry(esc.id).or_insert_with(Trace::new).add(time_us, esc.status.map(Quantity::values));
        let trouble = match esc.status {
            None => Some("silent".to_owned()),
            Some(status) => fault(status).map(|reason| reason.to_string()),
        };
        match trouble {
            None => drop(self.troubles.remove(&esc.id)),
            Some(what) if self.troubles.get(&esc.id) == Some(&what) => {}
            Some(what) => {
                self.troubles.insert(esc.id, what.clone());
                self.events.push(Event { time_us, port: esc.id, what });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulate::flight;

    fn read(motors: u8, wanted: Option<SystemId>) -> Option<Flight> {
        let folder = tempfile::tempdir().unwrap();
        let log = folder.path().join("flight.tlog");
        flight(&log, motors, 30, 1_462_017_600_000_000);
        Flight::read(Recording::open(&log).unwrap(), wanted, Firmware::default()).unwrap()
    }

    #[test]
    fn a_flight_has_its_motors_and_what_happened_to_them() {
        let flight = read(16, None).unwrap();
        assert_eq!(
            (flight.motors.len(), flight.end_us, flight.start_us),
            (16, 30_000_000, Some(1_462_017_600_000_000))
        );
        assert_eq!(flight.events.len(), 2);
        assert!(flight.events[0].time_us.abs_diff(16_500_000) <= 100_000, "{:?}", flight.events);
        assert_eq!(flight.events[1].what, "silent");
        assert!(flight.motors[&1].lines(Quantity::Temperature).len() == 1);
        assert!(flight.motors[&4].lines(Quantity::Temperature).is_empty());
    }

    #[test]
    fn another_vehicle_is_another_flight() {
        assert!(read(1, Some(SystemId::from_u8(1))).is_some());
        assert!(read(1, Some(SystemId::from_u8(2))).is_none());
    }
}
