//! serde, where the dialects at hand have no example: signed enums, and fields that are called like the tag.

mod facts;

use mavlink_wire as wire;
use mavlink_wire::Message;
use mavlink_wire::serde::WithViews;

use crate::hygiene::{Any, Copied, Debug, Display};
use crate::small::{Heartbeat, Small};

#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Signed(pub(crate) i16);
static SIGNED: wire::EnumInfo = wire::EnumInfo::new("SIGNED", &[(0, "ZERO"), (32767, "TOP")]);
wire::open_enum!(Signed, i16, SIGNED);

#[derive(Clone, Copy, PartialEq)]
struct Tagged {
    r#type: Signed,
    mavtype: u8,
    mask: i8,
}

impl wire::Message for Tagged {
    type Payload = [u8; 4];
    const INFO: &'static wire::MessageInfo = &wire::MessageInfo::new(77, "TAGGED", 1, 4);
    const FIELDS: &'static [wire::FieldInfo] = &[
        wire::FieldInfo::new("type", wire::Kind::I16, 0).values(&SIGNED),
        wire::FieldInfo::new("mavtype", wire::Kind::U8, 2),
        wire::FieldInfo::new("mask", wire::Kind::I8, 3).values(&MASK),
    ];
    const DEFAULT: Self = Self { r#type: Signed(0), mavtype: 0, mask: 0 };

    fn read(p: &[u8; 4]) -> Self {
        Self {
            r#type: wire::generated::get(p, 0),
            mavtype: wire::generated::get(p, 2),
            mask: wire::generated::get(p, 3),
        }
    }

    fn store(&self, p: &mut [u8; 4]) {
        wire::generated::put(p, 0, self.r#type);
        wire::generated::put(p, 2, self.mavtype);
        wire::generated::put(p, 3, self.mask);
    }
}

/// Flags whose field is signed, as upstream has one with MAV_BOOL.
static MASK: wire::EnumInfo = wire::EnumInfo::bitmask("MASK", &[(1, "MASK_ONE")]);

wire::message!(Tagged);

#[test]
fn signed_values_survive() {
    let mut buffer = [0; 16];
    for value in [i16::MIN, -1, 0, 5, i16::MAX] {
        for mask in [i8::MIN, -1, 0, 1, 2, i8::MAX] {
            let message = Tagged { r#type: Signed(value), mavtype: 1, mask };
            let text = serde_json::to_string(&message).unwrap();
            assert_eq!(serde_json::from_str::<Tagged>(&text).unwrap(), message, "{text}");
            let bytes = postcard::to_slice(&message, &mut buffer).unwrap();
            assert_eq!(postcard::from_bytes::<Tagged>(bytes).unwrap(), message, "{bytes:?}");
        }
    }
    assert_eq!(serde_json::to_string(&Signed(-1)).unwrap(), "-1");
    assert_eq!(serde_json::from_str::<Signed>(r#""TOP""#).unwrap(), Signed(i16::MAX));
    assert_eq!(serde_json::from_str::<Signed>("-32768").unwrap(), Signed(i16::MIN));
    for wrong in ["-32769", "32768", r#""-32769""#, r#""ONE""#, "1.0", "null", "{}", r#"{"a":"TOP"}"#] {
        assert!(serde_json::from_str::<Signed>(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn fields_called_like_the_tag_have_other_keys() {
    let text = serde_json::to_string(&Tagged { r#type: Signed(5), mavtype: 6, mask: 3 }).unwrap();
    assert_eq!(text, r#"{"mavtype":5,"mavmavtype":6,"mask":"MASK_ONE | 0x2"}"#);
}

#[derive(Clone, Copy, PartialEq)]
struct Crowded {
    views: u8,
}

impl wire::Message for Crowded {
    type Payload = [u8; 1];
    const INFO: &'static wire::MessageInfo = &wire::MessageInfo::new(78, "CROWDED", 1, 1);
    const FIELDS: &'static [wire::FieldInfo] = &[wire::FieldInfo::new("views", wire::Kind::U8, 0)];
    const DEFAULT: Self = Self { views: 0 };

    fn read(p: &[u8; 1]) -> Self {
        Self { views: p[0] }
    }

    fn store(&self, p: &mut [u8; 1]) {
        p[0] = self.views;
    }
}

wire::message!(Crowded);

#[test]
fn a_field_called_like_the_views_is_not_written_twice() {
    let message = Crowded { views: 7 };
    assert_eq!(serde_json::to_string(&message).unwrap(), r#"{"views":7}"#);
    let error = serde_json::to_string(&WithViews(&message)).unwrap_err().to_string();
    assert_eq!(error, "CROWDED has a field `views`: no place for its views");
}

#[test]
fn covered_names_do_no_harm() {
    let any = Any::Copied(Copied { debug: Debug(9) });
    assert_eq!(serde_json::to_string(&any).unwrap(), r#"{"type":"COPIED","debug":9}"#);
    let expected = r#"{"type":"COPIED","debug":9,"views":{"seen":9}}"#;
    assert_eq!(serde_json::to_string(&WithViews(&any)).unwrap(), expected);
    assert_eq!(serde_json::from_str::<Any>(r#"{"debug":"DEBUG_ONE","type":"COPIED"}"#).unwrap().debug(), 1);
    assert_eq!(serde_json::to_string(&Display::all()).unwrap(), r#""DISPLAY_TOP""#);
}

#[test]
fn cut_and_foreign_data_is_refused() {
    let beat = Small::Heartbeat(Heartbeat::DEFAULT);
    let mut buffer = [0; 16];
    let bytes = postcard::to_slice(&beat, &mut buffer).unwrap();
    assert_eq!(postcard::from_bytes::<Small>(bytes).unwrap(), beat);
    assert!(postcard::from_bytes::<Small>(&bytes[..bytes.len() - 1]).is_err());
    assert!(postcard::from_bytes::<Small>(&[1, 0]).is_err(), "an id that the dialect does not have");
}
