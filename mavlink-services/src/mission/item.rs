//! The items of a plan.

use mavlink_wire::Encode;

use super::access::Form;
use super::position;
use crate::common::{self, MavCmd, MavFrame, MavMissionType, MissionItemInt};
use crate::{Address, Outgoing, convert};

/// One item of a mission, a fence or a list of rally points: a waypoint, a corner, or something else to do.
///
/// ```
/// use mavlink_services::common::{MavCmd, MavFrame};
/// use mavlink_services::mission::MissionItem;
///
/// let item = MissionItem::at(MavCmd::NAV_WAYPOINT, 47.397_742, 8.545_594, 30.0);
/// assert_eq!((item.frame, item.x, item.y, item.z), (MavFrame::GLOBAL_RELATIVE_ALT_INT, 473_977_420, 85_455_940, 30.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MissionItem {
    /// What to do. Commands of another dialect are `MavCmd(31_000)`.
    pub command: MavCmd,
    /// What `x`, `y` and `z` mean.
    pub frame: MavFrame,
    /// Whether the vehicle is at this item, or is to begin here.
    pub current: bool,
    /// Whether it goes on to the next item when this one is done.
    pub autocontinue: bool,
    /// Parameters 1 to 4 of the command; NaN is "none" where the command says so.
    pub params: [f32; 4],
    /// Parameter 5: latitude in degrees times 1e7, or a local X in metres times 1e4, or a number as it is; `i32::MAX` is "none".
    pub x: i32,
    /// Parameter 6: longitude or Y, likewise.
    pub y: i32,
    /// Parameter 7: altitude or Z in metres, or a number as it is.
    pub z: f32,
}

impl MissionItem {
    /// Nothing, at no place: to be completed, and to fill storage with.
    pub const DEFAULT: Self = Self {
        command: MavCmd(0),
        frame: MavFrame::MISSION,
        current: false,
        autocontinue: true,
        params: [0.0; 4],
        x: 0,
        y: 0,
        z: 0.0,
    };

    /// A command at a place: degrees north and east, metres above home. Degrees that are out of range or not a number are "none".
    #[must_use]
    pub fn at(command: MavCmd, latitude: f64, longitude: f64, altitude: f32) -> Self {
        let scaled = |degrees: f64| position::round(degrees * 1e7).unwrap_or(i32::MAX);
        let frame = MavFrame::GLOBAL_RELATIVE_ALT_INT;
        Self { command, frame, x: scaled(latitude), y: scaled(longitude), z: altitude, ..Self::DEFAULT }
    }

    /// The item in a `MISSION_ITEM_INT` or `MISSION_ITEM` of any dialect; `None` if it is another message, or a float is no
    /// position.
    #[must_use]
    pub fn of(message: &(impl Encode + ?Sized)) -> Option<Self> {
        match convert::<MissionItemInt>(message) {
            Some(item) => Some(Self::from(item)),
            None => Self::of_float(&convert::<common::MissionItem>(message)?),
        }
    }

    /// The item in the old message, whose position may be no number that the new one can carry.
    pub(super) fn of_float(item: &common::MissionItem) -> Option<Self> {
        let common::MissionItem { command, frame, x, y, z, .. } = *item;
        Some(Self {
            command,
            frame,
            current: item.current == 1,
            autocontinue: item.autocontinue != 0,
            params: [item.param1, item.param2, item.param3, item.param4],
            x: position::to_int(x, frame, command)?,
            y: position::to_int(y, frame, command)?,
            z,
        })
    }

    /// The message that carries it, to somebody.
    pub(super) fn message(&self, seq: u16, to: Address, plan: MavMissionType, form: Form) -> Outgoing {
        match form {
            Form::Int => self.int(seq, to, plan).into(),
            Form::Float => self.float(seq, to, plan).into(),
        }
    }

    fn int(&self, seq: u16, to: Address, mission_type: MavMissionType) -> MissionItemInt {
        let (target_system, target_component) = to.target();
        let Self { command, frame, current, autocontinue, params: [param1, param2, param3, param4], x, y, z } = *self;
        let (current, autocontinue) = (current.into(), autocontinue.into());
        MissionItemInt {
            target_system,
            target_component,
            seq,
            frame,
            command,
            current,
            autocontinue,
            param1,
            param2,
            param3,
            param4,
            x,
            y,
            z,
            mission_type,
        }
    }

    fn float(&self, seq: u16, to: Address, plan: MavMissionType) -> common::MissionItem {
        let int = self.int(seq, to, plan);
        common::MissionItem {
            target_system: int.target_system,
            target_component: int.target_component,
            seq,
            frame: int.frame,
            command: int.command,
            current: int.current,
            autocontinue: int.autocontinue,
            param1: int.param1,
            param2: int.param2,
            param3: int.param3,
            param4: int.param4,
            x: position::to_float(self.x, self.frame, self.command),
            y: position::to_float(self.y, self.frame, self.command),
            z: int.z,
            mission_type: plan,
        }
    }
}

impl Default for MissionItem {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl From<MissionItemInt> for MissionItem {
    fn from(item: MissionItemInt) -> Self {
        let MissionItemInt { command, frame, x, y, z, .. } = item;
        Self {
            command,
            frame,
            current: item.current == 1,
            autocontinue: item.autocontinue != 0,
            params: [item.param1, item.param2, item.param3, item.param4],
            x,
            y,
            z,
        }
    }
}
