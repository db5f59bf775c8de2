//! Positions as integers and as floats.

use crate::common::{MavCmd, MavFrame};

/// What an integer counts: the float is a number of degrees, of metres, or what the command says.
fn scale(frame: MavFrame, command: MavCmd) -> f64 {
    match frame {
        _ if !has_position(command) => 1.0,
        MavFrame::MISSION => 1.0,
        MavFrame::GLOBAL
        | MavFrame::GLOBAL_RELATIVE_ALT
        | MavFrame::GLOBAL_INT
        | MavFrame::GLOBAL_RELATIVE_ALT_INT
        | MavFrame::GLOBAL_TERRAIN_ALT
        | MavFrame::GLOBAL_TERRAIN_ALT_INT => 1e7,
        _ => 1e4,
    }
}

/// The float for an integer; `i32::MAX`, which stands for "none", is NaN.
pub(super) fn to_float(value: i32, frame: MavFrame, command: MavCmd) -> f32 {
    if value == i32::MAX { f32::NAN } else { (f64::from(value) / scale(frame, command)) as f32 }
}

/// The nearest integer for a float, if there is one.
pub(super) fn to_int(value: f32, frame: MavFrame, command: MavCmd) -> Option<i32> {
    round(f64::from(value) * scale(frame, command))
}

/// The nearest integer; NaN is `i32::MAX`, which stands for "none".
pub(super) fn round(value: f64) -> Option<i32> {
    if value.is_nan() {
        return Some(i32::MAX);
    }
    let half = if value < 0.0 { -0.5 } else { 0.5 };
    let fits = value > -2_147_483_648.5 && value < 2_147_483_647.5;
    // `as` cuts towards zero.
    fits.then_some((value + half) as i32)
}

/// Whether the command's parameters 5 to 7 are a position. A command that is not of `common` has none, as far as is known here.
pub(super) const fn has_position(command: MavCmd) -> bool {
    matches!(
        command,
        MavCmd::NAV_WAYPOINT
            | MavCmd::NAV_LOITER_UNLIM
            | MavCmd::NAV_LOITER_TURNS
            | MavCmd::NAV_LOITER_TIME
            | MavCmd::NAV_LAND
            | MavCmd::NAV_TAKEOFF
            | MavCmd::NAV_LAND_LOCAL
            | MavCmd::NAV_TAKEOFF_LOCAL
            | MavCmd::NAV_FOLLOW
            | MavCmd::NAV_LOITER_TO_ALT
            | MavCmd::DO_ORBIT
            | MavCmd::DO_FIGURE_EIGHT
            | MavCmd::NAV_ARC_WAYPOINT
            | MavCmd::NAV_ROI
            | MavCmd::NAV_PATHPLANNING
            | MavCmd::NAV_SPLINE_WAYPOINT
            | MavCmd::NAV_VTOL_TAKEOFF
            | MavCmd::NAV_VTOL_LAND
            | MavCmd::NAV_PAYLOAD_PLACE
            | MavCmd::DO_SET_HOME
            | MavCmd::DO_RETURN_PATH_START
            | MavCmd::DO_LAND_START
            | MavCmd::DO_REPOSITION
            | MavCmd::DO_SET_ROI_LOCATION
            | MavCmd::DO_SET_ROI
            | MavCmd::OVERRIDE_GOTO
            | MavCmd::DO_SET_GLOBAL_ORIGIN
            | MavCmd::SET_GUIDED_SUBMODE_CIRCLE
            | MavCmd::CONDITION_GATE
            | MavCmd::NAV_FENCE_RETURN_POINT
            | MavCmd::NAV_FENCE_POLYGON_VERTEX_INCLUSION
            | MavCmd::NAV_FENCE_POLYGON_VERTEX_EXCLUSION
            | MavCmd::NAV_FENCE_CIRCLE_INCLUSION
            | MavCmd::NAV_FENCE_CIRCLE_EXCLUSION
            | MavCmd::NAV_RALLY_POINT
            | MavCmd::PAYLOAD_PREPARE_DEPLOY
            | MavCmd::EXTERNAL_POSITION_ESTIMATE
            | MavCmd::WAYPOINT_USER_1
            | MavCmd::WAYPOINT_USER_2
            | MavCmd::WAYPOINT_USER_3
            | MavCmd::WAYPOINT_USER_4
            | MavCmd::WAYPOINT_USER_5
            | MavCmd::SPATIAL_USER_1
            | MavCmd::SPATIAL_USER_2
            | MavCmd::SPATIAL_USER_3
            | MavCmd::SPATIAL_USER_4
            | MavCmd::SPATIAL_USER_5
    )
}
