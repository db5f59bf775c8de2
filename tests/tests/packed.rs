//! Views of real packed fields beyond ESCs: each member is read where it lies, set without touching the others, and refuses
//! what does not fit.

use mavlink_conformance::dialects::packed::{
    AutopilotVersion, CellVoltages, Cells, Channel, Event, FirmwareVersion, FirmwareVersionType, GpsRtcmData,
    Heartbeat, IcaoAddress, LogLevels, Mask, MavAutopilot, Px4AutoMode, Px4CustomMode, Px4MainMode, RadioRcChannels,
    RcChannel, RelayStatus, Relays, RtcmFlags, UavionixAdsbOutCfg, WriteMask,
};
use mavlink_conformance::random::Random;
use mavlink_wire::{Message, ViewError};

/// Sets every value from a range that is wider than the bits: what is read back, what else changed, what was refused.
macro_rules! set_and_get {
    ($view:expr, $set:ident, $get:ident, $values:expr, $fits:expr, $mask:expr) => {
        for value in $values {
            let before = $view;
            let mut view = before;
            let outcome = view.$set(value);
            if ($fits).contains(&value) {
                assert_eq!((outcome, view.$get()), (Ok(()), value), "{}({value})", stringify!($set));
                assert_eq!(view.bits() & !$mask, before.bits() & !$mask, "{}({value})", stringify!($set));
            } else {
                assert_eq!((outcome, view), (Err(ViewError::OutOfRange), before), "{}({value})", stringify!($set));
            }
        }
    };
}

#[test]
fn rtcm_flags() {
    let mut random = Random::new(233);
    for _ in 0..64 {
        let view = RtcmFlags::from_bits(random.number() as u8);
        let bits = view.bits();
        assert_eq!((view.fragmented(), view.fragment(), view.sequence()), (bits & 1 != 0, bits >> 1 & 3, bits >> 3));
        set_and_get!(view, set_fragment, fragment, 0..=255, 0..=3, 0x06);
        set_and_get!(view, set_sequence, sequence, 0..=255, 0..=31, 0xf8);
        for value in [false, true] {
            let changed = view.with_fragmented(value);
            assert_eq!((changed.fragmented(), changed.bits() & !1), (value, bits & !1));
        }
    }
    let mut message = GpsRtcmData { len: 9, ..GpsRtcmData::DEFAULT };
    message.set_fragmentation(RtcmFlags::from_bits(0xab));
    assert_eq!((message.flags, message.len, message.fragmentation().sequence()), (0xab, 9, 0x15));
}

#[test]
fn log_levels() {
    let view = LogLevels::from_bits(0xa5);
    assert_eq!((view.internal(), view.external()), (0xa, 0x5));
    set_and_get!(view, set_internal, internal, 0..=255, 0..=15, 0xf0);
    assert_eq!(Event { log_levels: 0x21 }.levels().external(), 1);
}

#[test]
fn firmware_version() {
    let message = AutopilotVersion { flight_sw_version: 0x010f_0340, ..AutopilotVersion::DEFAULT };
    let version = message.flight_sw();
    assert_eq!((version.major(), version.minor(), version.patch()), (1, 15, 3));
    assert_eq!(version.r#type(), FirmwareVersionType::ALPHA);
    assert_eq!(
        format!("{version:?}"),
        "FirmwareVersion { type: FIRMWARE_VERSION_TYPE_ALPHA, patch: 3, minor: 15, major: 1 }"
    );
    let mut changed = version;
    changed.set_type(FirmwareVersionType(7));
    assert_eq!(changed.bits(), 0x010f_0307, "a type that no entry names keeps its number");
    assert_eq!(FirmwareVersion::from_bits(u32::MAX).major(), 255);
}

#[test]
fn px4_custom_mode() {
    let auto = Heartbeat { autopilot: MavAutopilot::PX4, custom_mode: 0x0504_0000, ..Heartbeat::DEFAULT };
    let mode = auto.px4_mode().unwrap();
    assert_eq!(
        (mode.main_mode(), mode.auto_mode(), mode.sub_mode()),
        (Px4MainMode::AUTO, Some(Px4AutoMode::RTL), None)
    );
    let mut manual = Px4CustomMode::from_bits(0x0701_0000);
    assert_eq!((manual.auto_mode(), manual.sub_mode()), (None, Some(7)));
    assert_eq!(manual.set_auto_mode(Px4AutoMode::READY), Err(ViewError::Absent));
    manual.set_main_mode(Px4MainMode::AUTO);
    assert_eq!((manual.auto_mode(), manual.bits()), (Some(Px4AutoMode(7)), 0x0704_0000));
    assert_eq!(Heartbeat { autopilot: MavAutopilot::AUTOQUAD, ..auto }.px4_mode(), None);
}

#[test]
fn relays() {
    let mut message = RelayStatus { on: 0b1000_0000_0000_0101, ..RelayStatus::DEFAULT };
    let on: Vec<Option<bool>> = [0, 1, 2, 14, 15, 16, usize::MAX].map(|relay| message.relays().on(relay)).to_vec();
    assert_eq!(on, [Some(true), Some(false), Some(true), Some(false), Some(true), None, None]);
    let mut relays = message.relays();
    relays.set_on(2, false).unwrap();
    relays.set_on(7, true).unwrap();
    assert_eq!(relays.set_on(16, true), Err(ViewError::OutOfRange));
    message.set_relays(relays);
    assert_eq!((message.on, message.relays()), (0b1000_0000_1000_0001, Relays::from_bits(message.on)));
}

#[test]
fn a_signed_scaled_field() {
    for raw in -4096_i16..=4095 {
        let mut view = RcChannel::from_bits(0xe000);
        view.set_position_raw(raw).unwrap();
        assert_eq!((view.position_raw(), view.bits() & 0xe000), (raw, 0xe000));
        assert_eq!(f64::from(view.position()), f64::from(raw) * 5.0 / 32.0 + 1500.0);
        let position = view.position();
        view.set_position_raw(0).unwrap();
        view.set_position(position).unwrap();
        assert_eq!(view.position_raw(), raw);
    }
    let view = RcChannel::from_bits(0);
    set_and_get!(view, set_position_raw, position_raw, i16::MIN..=i16::MAX, -4096..=4095, 0x1fff);
    for refused in [f32::NAN, f32::INFINITY, 859.0, 2140.0] {
        assert_eq!(RcChannel::from_bits(0).set_position(refused), Err(ViewError::OutOfRange), "{refused}");
    }
}

#[test]
fn slots_end_at_the_count() {
    let mut message = RadioRcChannels { channels: [1, 2, 3, 4], ..RadioRcChannels::DEFAULT };
    assert_eq!(message.all_channels().count(), 0);
    for count in 1..=4 {
        let slot = Channel { status: RcChannel::from_bits(count) };
        message.push_channel(slot).unwrap();
        assert_eq!(message.all_channels().count(), usize::from(count));
    }
    assert_eq!(message.push_channel(Channel::default()), Err(ViewError::Full));
    message.count = 200;
    assert_eq!((message.all_channels().count(), message.channel(4)), (4, None));
    message.count = 2;
    assert_eq!(message.set_channel(2, Channel::default()), Err(ViewError::NoSuchSlot));
    message.set_channel(1, Channel { status: RcChannel::from_bits(99) }).unwrap();
    assert_eq!(message.channels, [1, 99, 3, 4]);
}

#[test]
fn twenty_four_bits() {
    let message = UavionixAdsbOutCfg { icao: 0xff12_3456 };
    assert_eq!(message.icao_address().address(), 0x12_3456);
    let view = IcaoAddress::from_bits(0xff00_0000);
    set_and_get!(view, set_address, address, [0, 0xff_ffff, 0x100_0000, u32::MAX], 0..=0xff_ffff, 0xff_ffff);
}

#[test]
fn an_array_joined() {
    let mut message = WriteMask { write_mask: [0x8000_0001, 0x0000_0001, 0x8000_0000] };
    let mask = message.mask();
    assert_eq!((mask.low(), mask.last(), mask.pairs(20)), (0x1_8000_0001, true, None));
    let mut mask = Mask::from_bits(0);
    for pair in 0..20 {
        mask.set_pairs(pair, 3).unwrap();
        assert_eq!(mask.set_pairs(pair, 4), Err(ViewError::OutOfRange));
    }
    message.set_mask(mask);
    assert_eq!(message.write_mask[0], 0);
    let ones: u32 = message.write_mask.iter().map(|word| word.count_ones()).sum();
    assert_eq!((ones, message.mask()), (40, mask));
}

#[test]
fn several_scaled_fields() {
    let cells = Cells { cells: 0xff00_d2b9 }.voltages();
    let volts = [0, 1, 2, 3, 4].map(|cell| cells.volts(cell));
    assert_eq!(volts, [Some(3.7), Some(4.2), Some(0.0), Some(5.1), None]);
    assert_eq!((cells.volts_mv(0), cells.volts_raw(3), cells.volts_mv(4)), (Some(3700), Some(255), None));
    let mut cells = CellVoltages::from_bits(0);
    cells.set_volts(2, 3.7).unwrap();
    assert_eq!(cells.bits(), 0x00b9_0000);
    assert_eq!(cells.set_volts(0, 5.2), Err(ViewError::OutOfRange));
    assert_eq!(cells.set_volts(4, 1.0), Err(ViewError::OutOfRange));
}
