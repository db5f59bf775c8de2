//! Views that `mavgen::decode` reads by the model are, member by member, what the generated accessors give.

use mavgen::Builder;
use mavgen::decode::{Bits, Content, Reading, Slot, Tables, Value, bindings, views};
use mavgen::ir::Dialect;
use mavlink_autoquad::autoquad::{AqEscTelemetry, Autoquad, Esc, Heartbeat, LegacyEsc};
use mavlink_conformance::autoquad::SUBJECTS;
use mavlink_conformance::dialects::packed::{self, Packed};
use mavlink_conformance::golden::view_floats::{Gauge, Gauges, ParamValue};
use mavlink_conformance::payload::Fill;
use mavlink_conformance::random::Random;
use mavlink_wire::{Dialect as _, Message, Repr};

/// Random payloads of each kind for each view.
const PAYLOADS: usize = 3_000;

/// What a member holds: a number, or the bits of a float; `None` where the layout lacks it.
#[derive(Debug, PartialEq)]
enum Held {
    Number(i128),
    Float(u32),
}

/// The members by name, several alike as a list.
type Members = Vec<(String, Vec<Option<Held>>)>;

/// A slot, or a view that has none: the keys, and the members if the bits mean something.
type Seen = (Vec<Option<i128>>, Option<Members>);

fn interpreted(reading: &Reading<'_>) -> Vec<Seen> {
    let slot = |slot: &Slot<'_>| {
        let keys = slot.keys.iter().map(|key| if key.is_invalid() { None } else { key.number.as_integer() });
        (keys.collect(), slot.status.as_ref().map(members))
    };
    match &reading.content {
        Content::Once(bits) => vec![(vec![], bits.as_ref().map(members))],
        Content::Slots(slots) => slots.iter().map(slot).collect(),
        // `accepted` compares records of values.
        Content::Record(_) => Vec::new(),
    }
}

fn members(bits: &Bits<'_>) -> Members {
    let held = |value| match value {
        Value::Flag(flag) => Held::Number(flag.into()),
        Value::Entry(_, value) => Held::Number(value.into()),
        Value::Unsigned(value) => Held::Number(value as i128),
        Value::Signed(value) => Held::Number(value),
        Value::Scaled(ratio) => Held::Float((ratio.to_f64() as f32).to_bits()),
    };
    let member = |member: &mavgen::ir::Member| {
        let count = member.repeat.map_or(1, |repeat| repeat.count);
        (member.name.shown(), (0..count).map(|index| bits.value(member, index).map(held)).collect())
    };
    bits.view().members.iter().map(member).collect()
}

/// What an accessor gives, as the interpreter would say it.
trait Given {
    fn held(self) -> Option<Held>;
}

impl<T: Given> Given for Option<T> {
    fn held(self) -> Option<Held> {
        self.and_then(T::held)
    }
}

impl Given for f32 {
    fn held(self) -> Option<Held> {
        Some(Held::Float(self.to_bits()))
    }
}

macro_rules! given {
    ($($integer:ty)*) => {$(
        impl Given for $integer {
            fn held(self) -> Option<Held> {
                Some(Held::Number(self.into()))
            }
        }
    )*};
}

given!(bool u8 u16 u32 u64 i32);

/// An enum's number.
fn of<E: mavlink_wire::Enum>(value: E) -> u64 {
    value.repr().bits()
}

/// The members of a view by its accessors, in the order of the overlay.
macro_rules! members {
    ($($name:literal $values:expr;)*) => {
        vec![$(($name.to_owned(), Vec::from($values.map(Given::held)))),*]
    };
}

/// What compiled accessors give of a view.
type Compiled<M> = fn(&M) -> Vec<Seen>;

/// Compares what the compiled accessors of the message `M` give with what is interpreted, view by view.
fn compare<M: Message>(dialect: &Dialect, prepare: impl Fn(&mut [u8], u64), compiled: &[(&str, Compiled<M>)]) {
    let message = dialect.messages.iter().find(|message| message.id == M::ID).unwrap();
    let names: Vec<&str> = message.views.iter().map(|view| view.name.text.as_str()).collect();
    assert_eq!(names, compiled.iter().map(|(name, _)| *name).collect::<Vec<_>>(), "every view is compared");
    let mut random = Random::new(M::ID.into());
    let mut with_meaning = 0;
    for fill in Fill::ALL {
        for _ in 0..PAYLOADS {
            let length = random.below(usize::from(M::INFO.len_v2) + 2);
            let mut payload = fill.payload(length, &mut random);
            prepare(&mut payload, random.number());
            let typed = M::decode(&payload);
            for (reading, (name, expected)) in views(message, &payload).zip(compiled) {
                let (found, expected) = (interpreted(&reading), expected(&typed));
                assert_eq!(found, expected, "{name} from {payload:02x?}");
                with_meaning += found.iter().filter(|(_, members)| members.is_some()).count();
            }
        }
    }
    assert!(with_meaning > PAYLOADS / 2, "{} {with_meaning}", M::INFO.name);
}

/// A view over plain fields.
fn once(members: Members) -> Vec<Seen> {
    vec![(vec![], Some(members))]
}

fn autoquad() -> Dialect {
    Builder::new("../xml/autoquad.xml").overlay("../xml/overlay/autoquad.xml").resolve().unwrap().dialect
}

fn packed() -> Dialect {
    Builder::new("packed/packed.xml").overlay("packed/packed.overlay.xml").resolve().unwrap().dialect
}

fn escs(message: &AqEscTelemetry) -> Vec<Seen> {
    let slot = |esc: Esc| {
        let status = esc.status.map(|v| {
            members! {
                "state" [of(v.state())];
                "voltage" [v.voltage()];
                "current" [v.current()];
                "rpm" [v.rpm()];
                "duty" [v.duty()];
                "temperature" [v.temperature()];
                "disarm_v3" [v.disarm_v3().map(of)];
                "errors" [v.errors()];
                "disarm_v2" [v.disarm_v2().map(of)];
            }
        });
        (vec![Some(esc.id.into()), esc.age_ms.map(i128::from)], status)
    };
    message.escs().map(slot).collect()
}

fn legacy_escs(message: &AqEscTelemetry) -> Vec<Seen> {
    let slot = |esc: LegacyEsc| {
        let status = esc.status.map(|v| {
            members! {
                "state" [of(v.state())];
                "voltage" [v.voltage()];
                "current" [v.current()];
                "rpm" [v.rpm()];
                "duty" [v.duty()];
                "errors" [v.errors()];
            }
        });
        (vec![Some(esc.id.into()), esc.age_ms.map(i128::from)], status)
    };
    message.legacy_escs().map(slot).collect()
}

/// Few slots, some of them silent, and versions near the borders of the layouts.
fn likely_esc_telemetry(payload: &mut [u8], random: u64) {
    let mut set = |at: usize, value: u8| payload.iter_mut().skip(at).take(1).for_each(|byte| *byte = value);
    set(46, random as u8 % 6);
    if random & 0x100 != 0 {
        set(36, 0xff);
        set(37, 0xff);
    }
    (0..4).for_each(|slot| set(51 + slot, (random >> (16 + 8 * slot)) as u8 % 36));
}

#[test]
fn esc_telemetry_in_both_layouts() {
    let views: [(&str, Compiled<AqEscTelemetry>); 2] = [("ESC32_STATUS", escs), ("ESC32_STATUS_UNPACKED", legacy_escs)];
    compare(&autoquad(), likely_esc_telemetry, &views);
}

#[test]
fn bits_of_floats() {
    let dialect = Builder::new("../mavgen/tests/golden/view_floats/main.xml")
        .overlay("../mavgen/tests/golden/view_floats/main.overlay.xml")
        .resolve()
        .unwrap()
        .dialect;
    let int = |message: &ParamValue| once(members! { "value" [message.int().value()]; });
    compare::<ParamValue>(&dialect, |_, _| {}, &[("INT_PARAM", int)]);
    let joined = |message: &Gauges| {
        let v = message.joined();
        once(members! { "pair" [v.pair()]; "low" [v.low()]; "high" [v.high()]; })
    };
    let gauges = |message: &Gauges| {
        let slot = |gauge: Gauge| {
            let status = gauge.status.map(|v| members! { "raw" [v.raw()]; "sign" [v.sign()]; });
            (vec![Some(gauge.id.into())], status)
        };
        message.gauges().map(slot).collect()
    };
    compare::<Gauges>(&dialect, |_, _| {}, &[("JOINED", joined), ("CELL", gauges)]);
}

#[test]
fn bindings_hold_where_the_accessors_say() {
    let dialect = autoquad();
    let message = dialect.messages.iter().find(|message| message.id == Heartbeat::ID).unwrap();
    let mut random = Random::new(14);
    for length in (0..12).cycle().take(PAYLOADS) {
        let mut payload = Fill::Random.payload(length, &mut random);
        if random.below(2) == 0 && length > 5 {
            payload[5] = 14;
        }
        let found: Vec<Option<u64>> = bindings(message, &payload).map(|(_, value)| value).collect();
        assert_eq!(found, [Heartbeat::decode(&payload).nav_status().map(of)], "{payload:02x?}");
    }
}

fn px4_mode(message: &packed::Heartbeat) -> Vec<Seen> {
    let mode = message.px4_mode().map(|v| {
        members! {
            "main_mode" [of(v.main_mode())];
            "auto_mode" [v.auto_mode().map(of)];
            "sub_mode" [v.sub_mode()];
        }
    });
    vec![(vec![], mode)]
}

fn flight_sw(message: &packed::AutopilotVersion) -> Vec<Seen> {
    let v = message.flight_sw();
    once(members! { "type" [of(v.r#type())]; "patch" [v.patch()]; "minor" [v.minor()]; "major" [v.major()]; })
}

fn fragmentation(message: &packed::GpsRtcmData) -> Vec<Seen> {
    let v = message.fragmentation();
    once(members! { "fragmented" [v.fragmented()]; "fragment" [v.fragment()]; "sequence" [v.sequence()]; })
}

fn relays(message: &packed::RelayStatus) -> Vec<Seen> {
    let v = message.relays();
    once(members! { "on" std::array::from_fn::<_, 16, _>(|index| v.on(index)); })
}

fn levels(message: &packed::Event) -> Vec<Seen> {
    let v = message.levels();
    once(members! { "external" [v.external()]; "internal" [v.internal()]; })
}

fn all_channels(message: &packed::RadioRcChannels) -> Vec<Seen> {
    let slot = |slot: packed::Channel| (vec![], Some(members! { "position" [slot.status.position()]; }));
    message.all_channels().map(slot).collect()
}

fn icao_address(message: &packed::UavionixAdsbOutCfg) -> Vec<Seen> {
    once(members! { "address" [message.icao_address().address()]; })
}

fn mask(message: &packed::WriteMask) -> Vec<Seen> {
    let v = message.mask();
    let pairs = std::array::from_fn::<_, 20, _>(|index| v.pairs(index));
    once(members! { "low" [v.low()]; "pairs" pairs; "last" [v.last()]; })
}

fn voltages(message: &packed::Cells) -> Vec<Seen> {
    let v = message.voltages();
    once(members! { "volts" std::array::from_fn::<_, 4, _>(|index| v.volts(index)); })
}

/// Many from a PX4, and many in its mode AUTO.
fn likely_heartbeat(payload: &mut [u8], random: u64) {
    payload.iter_mut().skip(5).take(random as usize % 2).for_each(|autopilot| *autopilot = 12);
    payload.iter_mut().skip(2).take(random as usize >> 8 & 1).for_each(|main_mode| *main_mode = 4);
}

#[test]
fn packed_fields_beyond_escs() {
    let (dialect, any) = (packed(), |_: &mut [u8], _| {});
    compare::<packed::Heartbeat>(&dialect, likely_heartbeat, &[("PX4_CUSTOM_MODE", px4_mode)]);
    compare::<packed::AutopilotVersion>(&dialect, any, &[("FIRMWARE_VERSION", flight_sw)]);
    compare::<packed::GpsRtcmData>(&dialect, any, &[("RTCM_FLAGS", fragmentation)]);
    compare::<packed::RelayStatus>(&dialect, any, &[("RELAYS", relays)]);
    compare::<packed::Event>(&dialect, any, &[("LOG_LEVELS", levels)]);
    compare::<packed::RadioRcChannels>(&dialect, any, &[("RC_CHANNEL", all_channels)]);
    compare::<packed::UavionixAdsbOutCfg>(&dialect, any, &[("ICAO_ADDRESS", icao_address)]);
    compare::<packed::WriteMask>(&dialect, any, &[("MASK", mask)]);
    compare::<packed::Cells>(&dialect, any, &[("CELL_VOLTAGES", voltages)]);
    let with_views = dialect.messages.iter().filter(|message| !message.views.is_empty()).count();
    assert_eq!(with_views, 9, "every message with views is compared");
}

/// The tables that are made from the model are those that are generated from it.
#[test]
fn tables_at_run_time_are_the_generated_ones() {
    let tables = Tables::leak(&autoquad());
    assert_eq!(tables.table().len(), SUBJECTS.len());
    for info in Autoquad::TABLE.iter() {
        assert_eq!(tables.table().get(info.id), Some(info));
        assert_eq!(tables.fields(info.id), Autoquad::fields(info.id), "{}", info.name);
    }
    let tables = Tables::leak(&packed());
    for info in Packed::TABLE.iter() {
        assert_eq!((tables.table().get(info.id), tables.fields(info.id)), (Some(info), Packed::fields(info.id)));
    }
}
