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

#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Debug(pub(crate) u16);

static DEBUG: wire::EnumInfo = wire::EnumInfo::new("DEBUG", &[(1, "DEBUG_ONE")]);
wire::open_enum!(Debug, u16, DEBUG);

#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Display(u64);

static DISPLAY: wire::EnumInfo = wire::EnumInfo::bitmask("DISPLAY", &[(1 << 63, "DISPLAY_TOP")]);
wire::flags!(Display, u64, DISPLAY);

#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Copied {
    pub(crate) debug: Debug,
}

impl wire::Message for Copied {
    type Payload = [u8; 2];
    const INFO: &'static wire::MessageInfo = &wire::MessageInfo::new(1, "COPIED", 1, 2);
    const FIELDS: &'static [wire::FieldInfo] = &[wire::FieldInfo::new("debug", wire::Kind::U16, 0).values(&DEBUG)];
    const DEFAULT: Self = Self { debug: Debug(7) };

    fn read(payload: &[u8; 2]) -> Self {
        Self { debug: wire::generated::get(payload, 0) }
    }

    fn store(&self, payload: &mut [u8; 2]) {
        wire::generated::put(payload, 0, self.debug);
    }
}

impl Copied {
    pub(crate) fn seen(&self) -> Debug {
        self.debug
    }
}

wire::message!(Copied { one seen });

#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Any {
    Copied(Copied),
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
