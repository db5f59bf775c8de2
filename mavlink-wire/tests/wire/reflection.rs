//! Messages without their types: values, names, units, what is not known, and the text of it all.

use mavlink_wire::generated::{get, put};
use mavlink_wire::reflect::{Number, Reflected, Value};
use mavlink_wire::{
    Chars, EnumInfo, FieldInfo, Frame, Invalid, Kind, MAX_FRAME, MAX_PAYLOAD, Message, MessageInfo, Sender, Sentinel,
    Table,
};
use proptest::prelude::*;

use crate::small::{AqEscTelemetry, Heartbeat, MavModeFlag, MavSeverity, MavState, Small, Statustext};

static INFO: MessageInfo = MessageInfo::new(1, "M", 0, 255);

static STATE: EnumInfo = EnumInfo::new("STATE", &[(0, "STATE_OFF"), (255, "STATE_ON")]);
static FLAGS: EnumInfo = EnumInfo::bitmask("FLAGS", &[(1, "FLAGS_A"), (4, "FLAGS_C")]);

/// The text of a message of one field `x`.
fn text(field: FieldInfo, payload: &[u8]) -> String {
    let text = Reflected::new(&INFO, &[field], payload).to_string();
    text.strip_prefix("M { x: ").and_then(|rest| rest.strip_suffix(" }")).unwrap().to_owned()
}

fn bytes<T: mavlink_wire::generated::Wire>(value: T) -> Vec<u8> {
    let mut payload = vec![0; T::SIZE];
    put(&mut payload, 0, value);
    payload
}

#[test]
fn numbers_of_every_kind() {
    for (kind, payload, shown) in [
        (Kind::U8, bytes(255_u8), "255"),
        (Kind::Version, bytes(3_u8), "3"),
        (Kind::I8, bytes(-1_i8), "-1"),
        (Kind::U16, bytes(0xfffe_u16), "65534"),
        (Kind::I16, bytes(i16::MIN), "-32768"),
        (Kind::U32, bytes(u32::MAX), "4294967295"),
        (Kind::I32, bytes(i32::MIN), "-2147483648"),
        (Kind::U64, bytes(u64::MAX), "18446744073709551615"),
        (Kind::I64, bytes(i64::MIN), "-9223372036854775808"),
        (Kind::F32, bytes(0.1_f32), "0.1"),
        (Kind::F32, bytes(1.0_f32), "1.0"),
        (Kind::F32, bytes(-0.0_f32), "-0.0"),
        (Kind::F32, bytes(f32::NAN), "NaN"),
        (Kind::F64, bytes(0.1_f64), "0.1"),
        (Kind::F64, bytes(1e300), "1e300"),
        (Kind::F64, bytes(f64::NEG_INFINITY), "-inf"),
    ] {
        assert_eq!(text(FieldInfo::new("x", kind, 0), &payload), shown, "{kind:?}");
        let shifted = [&[0xaa; 7], &payload[..]].concat();
        assert_eq!(text(FieldInfo::new("x", kind, 7), &shifted), shown, "{kind:?} at 7");
    }
}

#[test]
fn floats_keep_their_bits() {
    for bits in [0x7f80_0001_u32, 0xffa0_0001, 0x7fc0_1234, 0x8000_0000] {
        let field = [FieldInfo::new("x", Kind::F32, 0)];
        let Number::F32(value) =
            Reflected::new(&INFO, &field, &bytes(bits)).field("x").unwrap().element(0).unwrap().number()
        else {
            panic!("a float is a float");
        };
        assert_eq!(value.to_bits(), bits);
    }
}

#[test]
fn names_of_enums_and_flags() {
    let state = |kind| FieldInfo::new("x", kind, 0).values(&STATE);
    assert_eq!(text(state(Kind::U8), &[255]), "STATE_ON");
    assert_eq!(text(state(Kind::U8).units("s"), &[255]), "STATE_ON");
    assert_eq!(text(state(Kind::U8), &[7]), "7");
    assert_eq!(text(state(Kind::I8), &[255]), "-1", "no entry is negative");
    let flags = FieldInfo::new("x", Kind::U16, 0).values(&FLAGS);
    assert_eq!(text(flags, &[5, 0x80]), "FLAGS_A | FLAGS_C | 0x8000");
    assert_eq!(text(flags, &[]), "0");
    let array = FieldInfo::array("x", Kind::U8, 3, 0).values(&FLAGS);
    assert_eq!(text(array, &[1, 0, 2]), "[FLAGS_A, 0, 0x2]");
}

#[test]
fn units_follow_numbers_and_arrays() {
    assert_eq!(text(FieldInfo::new("x", Kind::U8, 0).units("cm/s"), &[9]), "9 cm/s");
    assert_eq!(text(FieldInfo::array("x", Kind::I16, 2, 1).units("mV"), &[0, 1, 0, 0xff, 0xff]), "[1, -1] mV");
    assert_eq!(text(FieldInfo::array("x", Kind::U8, 1, 0), &[4]), "[4]");
}

#[test]
fn what_is_not_known() {
    const FF: Sentinel = Sentinel::Unsigned(255);
    let scalar = FieldInfo::new("x", Kind::U8, 0).units("s");
    assert_eq!(text(scalar.invalid(Invalid::Each(FF)), &[255]), "unknown");
    assert_eq!(text(scalar.invalid(Invalid::Each(FF)), &[254]), "254 s");
    let array = FieldInfo::array("x", Kind::U8, 3, 0).units("s");
    for (invalid, payload, shown) in [
        (Invalid::Each(FF), [255, 1, 255], "[unknown, 1, unknown] s"),
        (Invalid::First(FF), [255, 1, 255], "[unknown, 1, 255] s"),
        (Invalid::First(FF), [1, 255, 255], "[1, 255, 255] s"),
        (Invalid::All(FF), [255, 1, 255], "unknown"),
        (Invalid::All(FF), [1, 255, 255], "[1, 255, 255] s"),
    ] {
        assert_eq!(text(array.invalid(invalid), &payload), shown, "{invalid:?}");
        let fields = [array.invalid(invalid)];
        let field = Reflected::new(&INFO, &fields, &payload).field("x").unwrap();
        assert_eq!(field.is_invalid(), shown == "unknown");
        let all = field.elements().all(|element| element.is_invalid());
        assert_eq!(all, shown == "unknown", "every element of an array that is not known is not known");
    }
}

#[test]
fn sentinels_are_compared_in_the_fields_own_type() {
    let field = |kind, sentinel| FieldInfo::new("x", kind, 0).invalid(Invalid::Each(sentinel));
    assert_eq!(text(field(Kind::I8, Sentinel::Signed(-1)), &[255]), "unknown");
    assert_eq!(text(field(Kind::F32, Sentinel::NotANumber), &bytes(-f32::NAN)), "unknown");
    assert_eq!(text(field(Kind::F64, Sentinel::NotANumber), &bytes(f64::NAN)), "unknown");
    assert_eq!(text(field(Kind::F32, Sentinel::Float(0.1)), &bytes(0.1_f32)), "unknown");
    assert_eq!(text(field(Kind::F64, Sentinel::Float(0.1)), &bytes(f64::from(0.1_f32))), "0.10000000149011612");
    assert_eq!(text(field(Kind::F32, Sentinel::Float(0.0)), &bytes(-0.0_f32)), "unknown", "zeros are equal");
    assert_eq!(text(field(Kind::U8, Sentinel::NotANumber), &[0]), "0");
}

#[test]
fn text_ends_at_a_nul_or_with_the_field() {
    let field = FieldInfo::array("x", Kind::Char, 4, 1);
    assert_eq!(text(field, b"_abcdef"), "\"abcd\"");
    assert_eq!(text(field, b"_ab\0cdef"), "\"ab\"");
    assert_eq!(text(field, b"_ab"), "\"ab\"");
    assert_eq!(text(field, b""), "\"\"");
    assert_eq!(text(field, b"_\"\n"), r#""\"\n""#);
    assert_eq!(text(field, b"_a\xff"), r#"b"a\xff""#);
    assert_eq!(text(field.invalid(Invalid::All(Sentinel::Unsigned(0))), b"_\0bc"), "unknown");
    assert_eq!(text(FieldInfo::new("x", Kind::Char, 0), b"abc"), "\"a\"");
}

#[test]
fn a_message_is_a_line_in_the_order_of_the_xml() {
    let flags = MavModeFlag::SAFETY_ARMED | MavModeFlag::from_bits_retain(2);
    let beat = Heartbeat { base_mode: flags, system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT };
    let mut buffer = [0; MAX_FRAME];
    let bytes = Sender::v2(1, 1).encode(&beat, &mut buffer).unwrap();
    let frame = Frame::parse(bytes, &Table::of(&[Heartbeat::INFO])).unwrap();
    let message = frame.reflect::<Small>().unwrap();
    assert_eq!(
        message.to_string(),
        "HEARTBEAT { type: 0, autopilot: 0, base_mode: MAV_MODE_FLAG_SAFETY_ARMED | 0x2, custom_mode: 0, \
         system_status: MAV_STATE_ACTIVE, mavlink_version: 3 }"
    );
    assert_eq!(format!("{message:#}").lines().count(), 8);
    assert_eq!((message.info().id, message.fields().len()), (0, 6));
    assert!(message.field("Type").is_none());
}

#[test]
fn a_frame_of_another_definition_is_not_reflected() {
    let mut buffer = [0; MAX_FRAME];
    let bytes = Sender::v2(1, 1).encode(&Heartbeat::DEFAULT, &mut buffer).unwrap();
    let frame = Frame::parse(bytes, &Table::of(&[])).unwrap();
    assert!(!frame.is_verified() && frame.reflect::<Small>().is_some(), "the checksum says which definition");
    let other = MessageInfo::new(0, "HEARTBEAT", 51, 9);
    assert!(frame.reflect_as(&other, Heartbeat::FIELDS).is_none());
    assert!(frame.reflect_as(Statustext::INFO, Statustext::FIELDS).is_none());
}

#[test]
fn elements_are_counted_and_found() {
    let message = Reflected::new(AqEscTelemetry::INFO, AqEscTelemetry::FIELDS, &[0; 55]);
    let ages = message.field("status_age").unwrap();
    let Value::Array(mut elements) = ages.value() else { panic!("an array is an array") };
    assert_eq!((elements.len(), ages.elements().map(|one| one.index()).collect()), (4, vec![0, 1, 2, 3]));
    elements.next();
    assert_eq!(elements.len(), 3);
    assert!(ages.element(3).is_some() && ages.element(4).is_none() && ages.element(256).is_none());
    let time = message.field("time_boot_ms").unwrap();
    assert!(time.element(0).is_some() && time.element(1).is_none());
}

proptest! {
    /// Any payload of any length: what is reflected is what the message type holds.
    #[test]
    fn reflection_agrees_with_decoding(payload in proptest::collection::vec(any::<u8>(), 0..=255)) {
        let (typed, message) = (Statustext::decode(&payload), Reflected::new(Statustext::INFO, Statustext::FIELDS, &payload));
        let integer = |name: &str| message.field(name).unwrap().element(0).unwrap().number().as_integer();
        prop_assert_eq!(MavSeverity(integer("severity").unwrap() as u8), typed.severity);
        prop_assert_eq!(integer("id"), Some(typed.id.into()));
        prop_assert_eq!(integer("chunk_seq"), Some(typed.chunk_seq.into()));
        let Value::Text(text) = message.field("text").unwrap().value() else { panic!("text is text") };
        prop_assert_eq!(text, typed.text.as_bytes());
    }

    /// Tables may be as wrong as a program makes them.
    #[test]
    fn nothing_panics(
        kind in 0..12_usize,
        array in proptest::option::of(any::<u8>()),
        offset in any::<u8>(),
        payload in proptest::collection::vec(any::<u8>(), 0..=255),
    ) {
        use Kind::{Char, F32, F64, I8, I16, I32, I64, U8, U16, U32, U64, Version};
        let kind = [Char, F32, F64, I8, I16, I32, I64, U8, U16, U32, U64, Version][kind];
        let field = match array {
            Some(length) => FieldInfo::array("x", kind, length, offset),
            None => FieldInfo::new("x", kind, offset),
        };
        let field = field.values(&FLAGS).units("s");
        for invalid in [Invalid::All, Invalid::Each, Invalid::First] {
            let fields = [field.invalid(invalid(Sentinel::Unsigned(7)))];
            let _ = Reflected::new(&INFO, &fields, &payload).to_string();
        }
    }
}

#[test]
fn chars_and_reflection_show_the_same_text() {
    for bytes in [&b"abc"[..], b"a\xffb", b"\0x", b"", "Grüße".as_bytes()] {
        let chars: Chars<8> = Chars(mavlink_wire::generated::zero_extended(bytes));
        assert_eq!(text(FieldInfo::array("x", Kind::Char, 8, 0), bytes), format!("{chars:?}"));
    }
}

const KINDS: [Kind; 12] = [
    Kind::Char,
    Kind::U8,
    Kind::I8,
    Kind::U16,
    Kind::I16,
    Kind::U32,
    Kind::I32,
    Kind::U64,
    Kind::I64,
    Kind::F32,
    Kind::F64,
    Kind::Version,
];

proptest! {
    /// What is read from one payload and set in another is the same bytes, and nothing else is touched.
    #[test]
    fn set_is_the_inverse_of_reading(kind in 0..KINDS.len(), offset in 0..200_u8, payload in any::<[u8; 32]>()) {
        let kind = KINDS[kind];
        let from: [u8; MAX_PAYLOAD] = mavlink_wire::generated::zero_extended(&[&[0; 200][..], &payload].concat());
        let (source, target) = (FieldInfo::array("x", kind, 3, 200), FieldInfo::array("x", kind, 3, offset));
        let mut to = [0; MAX_PAYLOAD];
        for element in Reflected::new(&INFO, &[source], &from).field("x").unwrap().elements() {
            target.set(&mut to, element.index(), element.number()).unwrap();
        }
        let (start, size) = (usize::from(offset), source.size());
        prop_assert_eq!(&to[start..start + size], &from[200..200 + size]);
        to[start..start + size].fill(0);
        prop_assert_eq!(to, [0; MAX_PAYLOAD]);
    }
}

#[test]
fn what_does_not_fit_is_not_set() {
    for (kind, number) in [
        (Kind::U8, Number::U64(256)),
        (Kind::U8, Number::I64(-1)),
        (Kind::I8, Number::U64(128)),
        (Kind::I64, Number::U64(1 << 63)),
        (Kind::U64, Number::I64(-1)),
        (Kind::U8, Number::F32(1.0)),
        (Kind::F32, Number::F64(1e39)),
    ] {
        let mut payload = [7; MAX_PAYLOAD];
        assert!(FieldInfo::new("x", kind, 0).set(&mut payload, 0, number).is_err(), "{kind:?} {number:?}");
        assert_eq!(payload, [7; MAX_PAYLOAD]);
    }
    let mut payload = [0; MAX_PAYLOAD];
    assert!(FieldInfo::new("x", Kind::U8, 0).set(&mut payload, 1, Number::U64(1)).is_err());
    assert!(FieldInfo::array("x", Kind::U8, 2, 0).set(&mut payload, 2, Number::U64(1)).is_err());
    assert!(FieldInfo::new("x", Kind::U32, 252).set(&mut payload, 0, Number::U64(1)).is_err(), "payloads end earlier");
    for (number, shown) in [(Number::F64(0.1), "0.1"), (Number::I64(-3), "-3.0"), (Number::F64(f64::INFINITY), "inf")] {
        FieldInfo::new("x", Kind::F32, 0).set(&mut payload, 0, number).unwrap();
        assert_eq!(text(FieldInfo::new("x", Kind::F32, 0), &payload), shown);
    }
}

#[test]
fn a_text_is_set_whole_or_not_at_all() {
    let (field, mut payload) = (FieldInfo::array("x", Kind::Char, 4, 1), [7; MAX_PAYLOAD]);
    field.set_text(&mut payload, "ab").unwrap();
    assert_eq!(payload[..6], *b"\x07ab\0\0\x07");
    field.set_text(&mut payload, "abcd").unwrap();
    assert_eq!(text(field, &payload), "\"abcd\"");
    assert!(field.set_text(&mut payload, "abcde").is_err() && payload[..6] == *b"\x07abcd\x07");
    assert!(FieldInfo::array("x", Kind::U8, 9, 0).set_text(&mut payload, "a").is_err());
    assert!(
        FieldInfo::array("x", Kind::Char, 9, 250).set_text(&mut payload, "a").is_err(),
        "no such field in a payload"
    );
}

/// As if derived, but for values without a name, which are numbers; so that `{:#?}` and what numbers are printed with hold; of enums the names, and numbers without units.
#[test]
fn debug_is_as_if_derived() {
    #[derive(Debug)]
    #[expect(dead_code, reason = "it is printed")]
    struct Statustext<'a> {
        severity: MavSeverity,
        text: &'a str,
        id: u16,
        chunk_seq: u8,
    }
    let sent = crate::small::Statustext {
        severity: MavSeverity(0),
        text: "a \"b\"".try_into().unwrap(),
        id: 65535,
        ..Message::DEFAULT
    };
    let derived = Statustext { severity: MavSeverity(0), text: "a \"b\"", id: 65535, chunk_seq: 0 };
    assert_eq!(format!("{sent:?} {sent:#?}"), format!("{derived:?} {derived:#?}"));
    assert_eq!(format!("{:?}", Small::from(sent)), format!("Statustext({derived:?})"));

    let telemetry = AqEscTelemetry { status_age: [1, 0xffff, 0, 0], data0: [0xa, 0, 0, 0], ..Message::DEFAULT };
    let text = format!("{telemetry:02x?}");
    assert!(text.starts_with("AqEscTelemetry { time_boot_ms: 00, seq: 00,"), "{text}");
    assert!(text.ends_with("status_age: [01, ffff, 00, 00], data_version: [00, 00, 00, 00], data0: [0a, 00, 00, 00], data1: [00, 00, 00, 00] }"), "{text}");
    let beat =
        Heartbeat { base_mode: MavModeFlag::from_bits_retain(0x82), system_status: MavState(200), ..Message::DEFAULT };
    assert_eq!(
        format!("{beat:?}"),
        "Heartbeat { type: 0, autopilot: 0, base_mode: MAV_MODE_FLAG_SAFETY_ARMED | 0x2, custom_mode: 0, system_status: 200, mavlink_version: 3 }"
    );
    let reading = format!("{:.1?} {:?}", Plain(1.25, f64::NAN, -1), Plain(1.0, -0.0, i8::MIN));
    assert_eq!(
        reading,
        "Plain { single: 1.2, double: NaN, signed: -1 } Plain { single: 1.0, double: -0.0, signed: -128 }"
    );
}

#[derive(Clone, Copy, PartialEq)]
struct Plain(f32, f64, i8);

impl Message for Plain {
    type Payload = [u8; 13];
    const INFO: &'static MessageInfo = &MessageInfo::new(2, "PLAIN", 0, 13);
    const FIELDS: &'static [FieldInfo] = &[
        FieldInfo::new("single", Kind::F32, 8).units("m"),
        FieldInfo::new("double", Kind::F64, 0).invalid(Invalid::Each(Sentinel::NotANumber)),
        FieldInfo::new("signed", Kind::I8, 12),
    ];
    const DEFAULT: Self = Self(0.0, 0.0, 0);

    fn read(p: &[u8; 13]) -> Self {
        Self(get(p, 8), get(p, 0), get(p, 12))
    }

    fn store(&self, p: &mut [u8; 13]) {
        put(p, 0, self.1);
        put(p, 8, self.0);
        put(p, 12, self.2);
    }
}

mavlink_wire::message!(Plain);
