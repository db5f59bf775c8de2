use mavlink_wire as wire;

#[derive(Clone, Copy, PartialEq)]
pub(crate) struct MavState(pub(crate) u8);

impl MavState {
    pub(crate) const UNINIT: Self = Self(0);
    pub(crate) const STANDBY: Self = Self(3);
    pub(crate) const ACTIVE: Self = Self(4);
}

static STATE: wire::EnumInfo =
    wire::EnumInfo::new("MAV_STATE", &[(0, "MAV_STATE_UNINIT"), (3, "MAV_STATE_STANDBY"), (4, "MAV_STATE_ACTIVE")]);
wire::open_enum!(MavState, u8, STATE);

#[derive(Clone, Copy, PartialEq)]
pub(crate) struct MavSeverity(pub(crate) u8);

impl MavSeverity {
    pub(crate) const EMERGENCY: Self = Self(0);
    pub(crate) const INFO: Self = Self(6);
}

static SEVERITY: wire::EnumInfo =
    wire::EnumInfo::new("MAV_SEVERITY", &[(0, "MAV_SEVERITY_EMERGENCY"), (6, "MAV_SEVERITY_INFO")]);
wire::open_enum!(MavSeverity, u8, SEVERITY);

#[derive(Clone, Copy, PartialEq)]
pub(crate) struct MavModeFlag(u8);

impl MavModeFlag {
    pub(crate) const CUSTOM_MODE_ENABLED: Self = Self(1);
    pub(crate) const SAFETY_ARMED: Self = Self(128);
}

static MODE_FLAG: wire::EnumInfo = wire::EnumInfo::bitmask(
    "MAV_MODE_FLAG",
    &[(1, "MAV_MODE_FLAG_CUSTOM_MODE_ENABLED"), (128, "MAV_MODE_FLAG_SAFETY_ARMED")],
);
wire::flags!(MavModeFlag, u8, MODE_FLAG);
