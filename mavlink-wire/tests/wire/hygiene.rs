//! The macros work where a dialect's own names cover those of the prelude.

#![expect(dead_code, reason = "the covering names need no use")]

use mavlink_wire as wire;

pub(crate) struct Option;
pub(crate) struct Some;
pub(crate) struct None;
pub(crate) struct Result;
pub(crate) struct Ok;
pub(crate) struct Err;
pub(crate) struct String;
pub(crate) struct Iterator;
pub(crate) struct Message;
pub(crate) struct Encode;
pub(crate) struct Enum;
pub(crate) struct Wire;
pub(crate) struct Serialize;
pub(crate) struct Deserialize;
pub(crate) struct Serializer;
pub(crate) struct Deserializer;
pub(crate) struct Format;
pub(crate) struct Formatter;
pub(crate) struct Arbitrary;
pub(crate) struct Unstructured;
pub(crate) struct Flags;
pub(crate) struct Flag;
pub(crate) trait Default {}
pub(crate) trait From {}
pub(crate) trait Into {}
pub(crate) trait TryFrom {}
pub(crate) trait Clone {}
pub(crate) trait FromStr {}
pub(crate) trait IntoIterator {}
pub(crate) trait Extend {}

#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Debug(pub(crate) u16);

static DEBUG: wire::EnumInfo = wire::EnumInfo { name: "DEBUG", bitmask: false, entries: &[(1, "DEBUG_ONE")] };
wire::open_enum!(Debug, u16, DEBUG);

#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Display(u64);

static DISPLAY: wire::EnumInfo =
    wire::EnumInfo { name: "DISPLAY", bitmask: true, entries: &[(1 << 63, "DISPLAY_TOP")] };
wire::flags!(Display, u64, DISPLAY);

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Copied {
    pub(crate) debug: Debug,
}

impl wire::Message for Copied {
    const ID: u32 = 1;
    const INFO: &'static wire::MessageInfo = &wire::MessageInfo {
        id: 1,
        name: "COPIED",
        crc_extra: 1,
        len_v1: 2,
        len_v2: 2,
        target_system: ::core::option::Option::None,
        target_component: ::core::option::Option::None,
    };
    const FIELDS: &'static [wire::FieldInfo] = &[wire::FieldInfo::new("debug", wire::Kind::U16, 0).values(&DEBUG)];
    const DEFAULT: Self = Self { debug: Debug(7) };

    fn decode(payload: &[u8]) -> Self {
        Self { debug: wire::generated::get(payload, 0) }
    }
}

impl wire::Encode for Copied {
    fn info(&self) -> &'static wire::MessageInfo {
        <Self as wire::Message>::INFO
    }

    fn write(&self, p: &mut [u8; 255]) {
        wire::generated::put(p, 0, self.debug);
    }
}
wire::message!(Copied);

#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Any {
    Copied(Copied),
}

static INFOS: [&wire::MessageInfo; 1] = [<Copied as wire::Message>::INFO];
static TABLE: wire::Table<'static> = wire::Table::of(&INFOS);

impl wire::Dialect for Any {
    const TABLE: &'static wire::Table<'static> = &TABLE;
    const FIELDS: &'static [&'static [wire::FieldInfo]] = &[<Copied as wire::Message>::FIELDS];
    const DEFAULT: Self = Self::Copied(<Copied as wire::Message>::DEFAULT);

    fn decode_into(&mut self, id: u32, payload: &[u8]) -> bool {
        *self = Self::Copied(wire::Message::decode(payload));
        id == 1
    }
}
wire::dialect!(Any { Copied });

impl Any {
    pub(crate) fn debug(self) -> u16 {
        let Self::Copied(Copied { debug: Debug(number) }) = self;
        number
    }
}

#[test]
fn macros_name_the_core_items_in_full() {
    assert_eq!(format!("{:?} {}", Debug(1), Display::all()), "DEBUG_ONE DISPLAY_TOP");
    assert_eq!(<Copied as ::core::default::Default>::default().debug, Debug(7));
    let any: Any = ::core::convert::From::from(Copied { debug: Debug(9) });
    assert_eq!(wire::Encode::info(&any).name, "COPIED");
    let back: ::core::result::Result<Copied, Any> = ::core::convert::TryFrom::try_from(any);
    assert_eq!(back, ::core::result::Result::Ok(Copied { debug: Debug(9) }));
}
