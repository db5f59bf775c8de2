//! All that was heard of: vehicles, their controllers, the link.

use std::collections::{BTreeMap, VecDeque};

use mavlink_autoquad::autoquad::{
    Autoquad, AutoquadNavStatus, Esc32Status, Heartbeat, MavAutopilot, MavModeFlag, SysStatus,
};
use mavlink_autoquad::esc::{EscRow, EscTable, ONLINE_LIMIT_MS, Update};
use mavlink_autoquad::wire::{Frame, Losses, SystemId};

use super::limits::{Level, Limits};
use crate::quantity::{Quantity, Values};
use crate::telemetry::{Firmware, fault, state};
use crate::time::{self, SECOND_US};

/// Microseconds between two points of a trend.
const TREND_STEP_US: u64 = SECOND_US / 2;

/// Points that a trend keeps.
const TREND_LENGTH: usize = 240;

/// Microseconds over which rates are measured.
const RATE_US: u64 = 3 * SECOND_US;

/// Texts of vehicles that are kept.
const TEXTS: usize = 8;

/// Everything that was heard. Times are in µs of one clock: that of the recording, or of the host.
pub(crate) struct Fleet {
    firmware: Firmware,
    pub(crate) vehicles: BTreeMap<SystemId, Vehicle>,
    pub(crate) texts: VecDeque<String>,
    losses: Losses<32>,
    heard: VecDeque<(u64, usize)>,
    pub(crate) heard_us: Option<u64>,
}

/// One vehicle.
pub(crate) struct Vehicle {
    pub(crate) table: EscTable,
    pub(crate) beat: Option<Heartbeat>,
    pub(crate) battery: Option<SysStatus>,
    /// When its motor telemetry was heard last.
    telemetry_us: Option<u64>,
    pub(crate) trends: BTreeMap<u8, VecDeque<Values>>,
    trend_us: Option<u64>,
    /// Of all its controllers, in volts.
    highest_v: f32,
}

/// One controller as it is shown.
pub(crate) struct Shown {
    pub(crate) port: u8,
    pub(crate) state: String,
    /// What it reports; `None` if it is silent.
    pub(crate) status: Option<Esc32Status>,
    pub(crate) age_ms: Option<u64>,
    /// What is wrong with it.
    pub(crate) trouble: Option<String>,
}

/// Sums and means over the controllers that report.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Totals {
    pub(crate) motors: u8,
    pub(crate) online: u8,
    pub(crate) current_a: f32,
    pub(crate) power_w: f32,
    pub(crate) mean_v: f32,
}

impl Fleet {
    pub(crate) fn new(firmware: Firmware) -> Self {
        Self {
            firmware,
            vehicles: BTreeMap::new(),
            texts: VecDeque::new(),
            losses: Losses::new(),
            heard: VecDeque::new(),
            heard_us: None,
        }
    }

    /// Takes in a frame that was received at a time. Gives the vehicle whose motors it updated, if it did.
    pub(crate) fn receive(&mut self, now_us: u64, frame: &Frame<'_>) -> Option<(SystemId, Update)> {
        self.losses.count(frame);
        self.heard_us = Some(now_us);
        self.heard.push_back((now_us, frame.bytes().len()));
        while self.heard.front().is_some_and(|&(then_us, _)| then_us + RATE_US < now_us) {
            self.heard.pop_front();
        }
        let system = frame.system_id();
        if let Some(telemetry) = self.firmware.telemetry(frame) {
            let vehicle = self.vehicles.entry(system).or_insert_with(Vehicle::new);
            let update = vehicle.table.update(&telemetry);
            vehicle.add_trends(now_us);
            return Some((system, update));
        }
        match frame.message()? {
            Autoquad::Heartbeat(beat) if beat.autopilot == MavAutopilot::AUTOQUAD => {
                self.vehicles.entry(system).or_insert_with(Vehicle::new).beat = Some(beat);
            }
            Autoquad::SysStatus(status) => {
                if let Some(vehicle) = self.vehicles.get_mut(&system) {
                    vehicle.battery = Some(status);
                }
            }
            Autoquad::Statustext(text) => {
                self.texts.truncate(TEXTS - 1);
                self.texts.push_front(format!("{system}: {}", String::from_utf8_lossy(text.text.as_bytes())));
            }
            _ => {}
        }
        None
    }

    /// Messages and bytes a second.
    pub(crate) fn rate(&self, now_us: u64) -> (f64, f64) {
        let recent = self.heard.iter().filter(|&&(then_us, _)| then_us + RATE_US >= now_us);
        let (frames, bytes) = recent.fold((0, 0), |(frames, bytes), &(_, size)| (frames + 1, bytes + size));
        let seconds = RATE_US as f64 / SECOND_US as f64;
        (f64::from(frames) / seconds, bytes as f64 / seconds)
    }

    /// The share of all frames that never arrived, in percent.
    pub(crate) fn lost_percent(&self) -> f64 {
        let total = self.losses.total();
        100.0 * total.lost as f64 / (total.lost + total.received).max(1) as f64
    }
}

impl Vehicle {
    fn new() -> Self {
        Self {
            table: EscTable::new(),
            beat: None,
            battery: None,
            telemetry_us: None,
            trends: BTreeMap::new(),
            trend_us: None,
            highest_v: 0.0,
        }
    }

    fn add_trends(&mut self, now_us: u64) {
        self.telemetry_us = Some(now_us);
        let due = self.trend_us.is_none_or(|then| now_us.abs_diff(then) >= TREND_STEP_US);
        let uptime_us = self.table.uptime_us();
        for row in self.table.iter() {
            let status = row.status.filter(|_| row.is_online(uptime_us, ONLINE_LIMIT_MS));
            self.highest_v = status.map_or(self.highest_v, |status| self.highest_v.max(status.voltage()));
            if due {
                let trend = self.trends.entry(row.id).or_default();
                trend.push_back(status.map_or([None; 4], Quantity::values));
                if trend.len() > TREND_LENGTH {
                    trend.pop_front();
                }
            }
        }
        if due {
            self.trend_us = Some(now_us);
        }
    }

    /// The vehicle's uptime at a time, in µs.
    pub(crate) fn uptime_us(&self, now_us: u64) -> u64 {
        let silence_us = self.telemetry_us.map_or(0, |then| now_us.saturating_sub(then));
        self.table.uptime_us().saturating_add(silence_us)
    }

    /// The controllers, by motor port.
    pub(crate) fn shown(&self, now_us: u64, limits: &Limits) -> Vec<Shown> {
        let uptime_us = self.uptime_us(now_us);
        self.table.iter().map(|row| self.shown_one(row, uptime_us, limits)).collect()
    }

    fn shown_one(&self, row: &EscRow, uptime_us: u64, limits: &Limits) -> Shown {
        let status = row.status.filter(|_| row.is_online(uptime_us, ONLINE_LIMIT_MS));
        let (port, age_ms) = (row.id, row.age_ms(uptime_us));
        let Some(status) = status else {
            let trouble = age_ms.map_or("never reported".to_owned(), |age| format!("silent for {}", age_text(age)));
            return Shown { port, state: "SILENT".to_owned(), status: None, age_ms, trouble: Some(trouble) };
        };
        let beyond = |&quantity: &Quantity| self.level(quantity, status, limits) == Level::Fault;
        let trouble = match fault(status) {
            Some(reason) => Some(format!("disarmed, {reason}")),
            None => Quantity::ALL.iter().find(|quantity| beyond(quantity)).map(|quantity| quantity.beyond_limit()),
        };
        Shown { port, state: state(status.state()), status: Some(status), age_ms, trouble }
    }

    /// How a value is.
    pub(crate) fn level(&self, quantity: Quantity, status: Esc32Status, limits: &Limits) -> Level {
        limits.level(quantity, status, self.highest_v)
    }

    /// Over the controllers that report.
    pub(crate) fn totals(&self, shown: &[Shown]) -> Totals {
        let mut totals = Totals { motors: self.table.num_motors(), ..Totals::default() };
        for status in shown.iter().filter_map(|shown| shown.status) {
            totals.online += 1;
            totals.current_a += status.current();
            totals.power_w += status.voltage() * status.current();
            totals.mean_v += status.voltage();
        }
        totals.mean_v /= f32::from(totals.online.max(1));
        totals
    }

    /// What the vehicle says of itself: armed or not, its mode, its battery.
    pub(crate) fn summary(&self, now_us: u64) -> String {
        let mut parts = Vec::new();
        if let Some(beat) = &self.beat {
            let armed = beat.base_mode.contains(MavModeFlag::SAFETY_ARMED);
            parts.push(if armed { "armed" } else { "disarmed" }.to_owned());
            parts.push(mode(beat.custom_mode));
        }
        if let Some(battery) = self.battery {
            let volts = f64::from(battery.voltage_battery) / 1000.0;
            parts.push(format!("battery {volts:.1} V, {} %", battery.battery_remaining));
        }
        parts.push(format!("up {}", time::clock(self.uptime_us(now_us))));
        parts.join("  ")
    }
}

/// The names of a mode's bits, without the prefix of their enum.
fn mode(custom_mode: u32) -> String {
    let status = AutoquadNavStatus::from_bits_retain(custom_mode);
    status.to_string().replace("AQ_NAV_STATUS_", "").replace(" | ", "+")
}

/// An age as short as it can be read.
pub(crate) fn age_text(age_ms: u64) -> String {
    match age_ms {
        0..1000 => format!("{age_ms} ms"),
        1000..60_000 => format!("{}.{} s", age_ms / 1000, age_ms / 100 % 10),
        _ => time::clock(age_ms.saturating_mul(1000)),
    }
}
