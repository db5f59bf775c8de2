//! A dialect of three messages, in the shape that the generator writes.

mod enums;
mod messages;

use mavlink_wire as wire;

pub(crate) use enums::{MavModeFlag, MavSeverity, MavState};
pub(crate) use messages::{AqEscTelemetry, Heartbeat, Statustext};

static INFOS: [&wire::MessageInfo; 3] =
    [<Heartbeat as wire::Message>::INFO, <AqEscTelemetry as wire::Message>::INFO, <Statustext as wire::Message>::INFO];
static INDEX: [u16; 200] = wire::generated::index(&INFOS);
static TABLE: wire::Table<'static> = wire::Table::indexed(&INFOS, &INDEX);

#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub(crate) enum Small {
    Heartbeat(Heartbeat),
    AqEscTelemetry(AqEscTelemetry),
    Statustext(Statustext),
}

impl wire::Dialect for Small {
    const TABLE: &'static wire::Table<'static> = &TABLE;
    const FIELDS: &'static [&'static [wire::FieldInfo]] = &[
        <Heartbeat as wire::Message>::FIELDS,
        <AqEscTelemetry as wire::Message>::FIELDS,
        <Statustext as wire::Message>::FIELDS,
    ];
    const DEFAULT: Self = Self::Heartbeat(<Heartbeat as wire::Message>::DEFAULT);

    fn decode_into(&mut self, id: u32, payload: &[u8]) -> bool {
        *self = match id {
            0 => Self::Heartbeat(wire::Message::decode(payload)),
            152 => Self::AqEscTelemetry(wire::Message::decode(payload)),
            253 => Self::Statustext(wire::Message::decode(payload)),
            _ => return false,
        };
        true
    }
}

wire::dialect!(Small { Heartbeat, AqEscTelemetry, Statustext });
