use mavlink_wire as wire;

use super::enums::{MavModeFlag, MavSeverity, MavState};

#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Heartbeat {
    pub(crate) r#type: u8,
    pub(crate) autopilot: u8,
    pub(crate) base_mode: MavModeFlag,
    pub(crate) custom_mode: u32,
    pub(crate) system_status: MavState,
    pub(crate) mavlink_version: u8,
}

impl wire::Message for Heartbeat {
    type Payload = [u8; 9];
    const INFO: &'static wire::MessageInfo = &wire::MessageInfo::new(0, "HEARTBEAT", 50, 9);
    const FIELDS: &'static [wire::FieldInfo] = &[
        wire::FieldInfo::new("type", wire::Kind::U8, 4),
        wire::FieldInfo::new("autopilot", wire::Kind::U8, 5),
        wire::FieldInfo::new("base_mode", wire::Kind::U8, 6).values(<MavModeFlag as wire::Enum>::INFO),
        wire::FieldInfo::new("custom_mode", wire::Kind::U32, 0),
        wire::FieldInfo::new("system_status", wire::Kind::U8, 7).values(<MavState as wire::Enum>::INFO),
        wire::FieldInfo::new("mavlink_version", wire::Kind::Version, 8),
    ];
    const DEFAULT: Self = Self {
        r#type: 0,
        autopilot: 0,
        base_mode: MavModeFlag::empty(),
        custom_mode: 0,
        system_status: MavState(0),
        mavlink_version: 3,
    };

    #[inline]
    fn read(p: &[u8; 9]) -> Self {
        Self {
            r#type: wire::generated::get(p, 4),
            autopilot: wire::generated::get(p, 5),
            base_mode: wire::generated::get(p, 6),
            custom_mode: wire::generated::get(p, 0),
            system_status: wire::generated::get(p, 7),
            mavlink_version: wire::generated::get(p, 8),
        }
    }

    #[inline]
    fn store(&self, p: &mut [u8; 9]) {
        wire::generated::put(p, 4, self.r#type);
        wire::generated::put(p, 5, self.autopilot);
        wire::generated::put(p, 6, self.base_mode);
        wire::generated::put(p, 0, self.custom_mode);
        wire::generated::put(p, 7, self.system_status);
        wire::generated::put(p, 8, self.mavlink_version);
    }
}

wire::message!(Heartbeat);

#[derive(Clone, Copy, PartialEq)]
pub(crate) struct AqEscTelemetry {
    pub(crate) time_boot_ms: u32,
    pub(crate) seq: u8,
    pub(crate) num_motors: u8,
    pub(crate) num_in_seq: u8,
    pub(crate) escid: [u8; 4],
    pub(crate) status_age: [u16; 4],
    pub(crate) data_version: [u8; 4],
    pub(crate) data0: [u32; 4],
    pub(crate) data1: [u32; 4],
}

impl wire::Message for AqEscTelemetry {
    type Payload = [u8; 55];
    const INFO: &'static wire::MessageInfo = &wire::MessageInfo::new(152, "AQ_ESC_TELEMETRY", 115, 55);
    const FIELDS: &'static [wire::FieldInfo] = &[
        wire::FieldInfo::new("time_boot_ms", wire::Kind::U32, 0).units("ms"),
        wire::FieldInfo::new("seq", wire::Kind::U8, 44),
        wire::FieldInfo::new("num_motors", wire::Kind::U8, 45),
        wire::FieldInfo::new("num_in_seq", wire::Kind::U8, 46),
        wire::FieldInfo::array("escid", wire::Kind::U8, 4, 47),
        wire::FieldInfo::array("status_age", wire::Kind::U16, 4, 36).units("ms"),
        wire::FieldInfo::array("data_version", wire::Kind::U8, 4, 51),
        wire::FieldInfo::array("data0", wire::Kind::U32, 4, 4),
        wire::FieldInfo::array("data1", wire::Kind::U32, 4, 20),
    ];
    const DEFAULT: Self = Self {
        time_boot_ms: 0,
        seq: 0,
        num_motors: 0,
        num_in_seq: 0,
        escid: [0; 4],
        status_age: [0; 4],
        data_version: [0; 4],
        data0: [0; 4],
        data1: [0; 4],
    };

    #[inline]
    fn read(p: &[u8; 55]) -> Self {
        Self {
            time_boot_ms: wire::generated::get(p, 0),
            seq: wire::generated::get(p, 44),
            num_motors: wire::generated::get(p, 45),
            num_in_seq: wire::generated::get(p, 46),
            escid: wire::generated::get(p, 47),
            status_age: wire::generated::get(p, 36),
            data_version: wire::generated::get(p, 51),
            data0: wire::generated::get(p, 4),
            data1: wire::generated::get(p, 20),
        }
    }

    #[inline]
    fn store(&self, p: &mut [u8; 55]) {
        wire::generated::put(p, 0, self.time_boot_ms);
        wire::generated::put(p, 44, self.seq);
        wire::generated::put(p, 45, self.num_motors);
        wire::generated::put(p, 46, self.num_in_seq);
        wire::generated::put(p, 47, self.escid);
        wire::generated::put(p, 36, self.status_age);
        wire::generated::put(p, 51, self.data_version);
        wire::generated::put(p, 4, self.data0);
        wire::generated::put(p, 20, self.data1);
    }
}

wire::message!(AqEscTelemetry);

#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Statustext {
    pub(crate) severity: MavSeverity,
    pub(crate) text: wire::Chars<50>,
    pub(crate) id: u16,
    pub(crate) chunk_seq: u8,
}

impl wire::Message for Statustext {
    type Payload = [u8; 54];
    const INFO: &'static wire::MessageInfo = &wire::MessageInfo::new(253, "STATUSTEXT", 83, 54).len_v1(51);
    const FIELDS: &'static [wire::FieldInfo] = &[
        wire::FieldInfo::new("severity", wire::Kind::U8, 0).values(<MavSeverity as wire::Enum>::INFO),
        wire::FieldInfo::array("text", wire::Kind::Char, 50, 1),
        wire::FieldInfo::new("id", wire::Kind::U16, 51).extension(),
        wire::FieldInfo::new("chunk_seq", wire::Kind::U8, 53).extension(),
    ];
    const DEFAULT: Self = Self { severity: MavSeverity(0), text: wire::Chars([0; 50]), id: 0, chunk_seq: 0 };

    #[inline]
    fn read(p: &[u8; 54]) -> Self {
        Self {
            severity: wire::generated::get(p, 0),
            text: wire::generated::get(p, 1),
            id: wire::generated::get(p, 51),
            chunk_seq: wire::generated::get(p, 53),
        }
    }

    #[inline]
    fn store(&self, p: &mut [u8; 54]) {
        wire::generated::put(p, 0, self.severity);
        wire::generated::put(p, 1, self.text);
        wire::generated::put(p, 51, self.id);
        wire::generated::put(p, 53, self.chunk_seq);
    }
}

wire::message!(Statustext);
