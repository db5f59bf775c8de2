//! What the goldens of mavgen do: one test for each construct, with bytes and numbers worked out by hand.

use mavlink_conformance::golden::*;
use mavlink_wire::{Chars, Command, Dialect, Encode, MAX_PAYLOAD, Message, Targeted, Version};

/// The payload of a message, without the zeros that MAVLink 2 cuts.
fn payload(message: &impl Encode) -> Vec<u8> {
    message.payload(Version::V2, &mut [0; MAX_PAYLOAD]).to_vec()
}

#[test]
fn fields() {
    use fields::Tank;

    let label = Chars::truncated("diesel");
    let tank = Tank { id: 7, time_usec: 0x0102, level: 1.0, tilt: [-1, 0, 1], label, ..Tank::DEFAULT };
    assert_eq!(tank.mavlink_version, 3);
    let expected =
        [&[2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 128, 63, 255, 255, 0, 0, 1, 0, 7][..], b"diesel\0\0", &[3]].concat();
    assert_eq!(payload(&tank), expected);
    assert_eq!(Tank::decode(&expected), tank);
    assert_eq!((Tank::INFO.len_v1, Tank::INFO.len_v2), (28, 36), "the extension is not sent in MAVLink 1");
}

#[test]
fn open_enums() {
    use open_enums::{NeverCarried, PumpState, Pumps};

    assert_eq!((PumpState::ON.to_string(), PumpState(9).to_string()), ("PUMP_STATE_ON".into(), "9".into()));
    assert_eq!("PUMP_STATE_3_WAY".parse(), Ok(PumpState::STATE_3_WAY));
    assert_eq!(NeverCarried::FARTHER.0, 70_001_u32);
    let mut pumps = Pumps { signed_state: -1, ..Pumps::DEFAULT };
    assert_eq!((pumps.state(), pumps.signed_state()), (PumpState::OFF, None));
    assert!(pumps.set_signed_state(PumpState::STATE_3_WAY).is_err(), "200 is beyond an int8_t");
    assert_eq!((pumps.set_signed_state(PumpState::ON), pumps.signed_state), (Ok(()), 1));
    assert_eq!((pumps.set_others(1, PumpState::ON), pumps.others, pumps.others(2)), (Ok(()), [0, 1], None));
}

#[test]
fn flags() {
    use flags::{Fault, Faults};

    let now = Fault::DRY | Fault::FATAL | Fault::from_bits_retain(64);
    let faults = Faults::decode(&payload(&Faults { now, before: [Fault::HOT; 3] }));
    assert_eq!(faults.now, now);
    assert!(faults.now.contains(Fault::FATAL) && !faults.now.contains(Fault::HOT));
    assert_eq!(faults.now.to_string(), "FAULT_DRY | FAULT_FATAL | 0x40");
}

#[test]
fn invalid() {
    use invalid::{Flow, Measured};

    let mut it = Measured { pressure: u16::MAX, temperature: f32::NAN, flow: Flow::UNKNOWN, ..Measured::DEFAULT };
    it.each = [i16::MAX, 5];
    it.whole = [255; 3];
    assert_eq!((it.pressure(), it.temperature(), it.flow(), it.whole()), (None, None, None, None));
    assert_eq!((it.each(0), it.each(1), it.each(2)), (None, Some(5), None));
    it.set_pressure(Some(1013));
    it.set_flow(None);
    assert_eq!((it.pressure, it.pressure(), it.flow), (1013, Some(1013), Flow::UNKNOWN));
    it.first = [255, 1, 2];
    assert_eq!([0, 1, 2].map(|index| it.first(index)), [None, Some(1), Some(2)], "the others are known");
}

#[test]
fn targets() {
    use targets::Refuel;

    let order = Refuel { amount: 2.0, ..Refuel::DEFAULT }.to(1, 154);
    assert_eq!((order.target_system, order.target_component), (1, 154));
    assert_eq!(payload(&order), [0, 0, 0, 64, 1, 154]);
}

#[test]
#[expect(deprecated, reason = "that is what they are")]
fn deprecated() {
    use deprecated::{Drive, NewMode, OldDrive, OldMode};

    let mut drive = Drive { mode: NewMode::FAST, packed: 0x10, ..Drive::DEFAULT };
    assert_eq!((drive.mode(), drive.bound_mode()), (None, OldMode::SLOW));
    assert_eq!((drive.bits_of().old(), drive.bits_of().current()), (OldMode::SLOW, NewMode::FAST));
    drive.set_bound_mode(OldMode(3));
    assert_eq!(drive.bound, 3);
    assert_eq!(OldDrive::DEFAULT.mode, OldMode::SLOW);
}

#[test]
fn commands() {
    use mav_cmd::MavCmd;

    let labels: Vec<_> = MavCmd::SPRAY.params().iter().map(|param| (param.index, param.label)).collect();
    assert_eq!(labels[..3], [(1, Some("Nozzle")), (2, Some("Flow")), (3, Some("Mode"))]);
    assert_eq!(MavCmd::SPRAY.params()[0].max, Some(4.0));
    assert!(MavCmd::STOP.params().is_empty());
}

#[test]
#[expect(deprecated, reason = "one of them is deprecated")]
fn commands_are_typed() {
    use mav_cmd::commands::{CarriersCommand, Commands, GoTo, SprayModeCommand, Stop};
    use mav_cmd::{CommandInt, CommandLong, MavCmd, MavFrame, SprayMode, SprayParts};

    let go = GoTo { r#type: SprayParts::RIGHT, latitude: 47.397_742_1, longitude: -8.5, ..GoTo::DEFAULT };
    let long = go.long(1, 2).unwrap();
    let expected =
        CommandLong { command: MavCmd::GO_TO, target_system: 1, target_component: 2, ..CommandLong::DEFAULT };
    let expected = CommandLong { param1: 65_536.0, param2: 0.1, param5: 47.397_743, param6: -8.5, ..expected };
    assert!(long.param7.is_nan(), "an altitude that nobody set is not known");
    assert_eq!(CommandLong { param7: 0.0, ..long }, expected);
    let int = go.int(MavFrame::GLOBAL, 1, 2).unwrap();
    assert_eq!((int.x, int.y, int.frame, int.param1), (473_977_421, -85_000_000, MavFrame::GLOBAL, 65_536.0));
    assert_eq!(GoTo::from_int(&int).unwrap().latitude.to_bits(), go.latitude.to_bits());
    let local = GoTo { latitude: 1.5, longitude: f64::NAN, ..go }.int(MavFrame::LOCAL_NED, 0, 0).unwrap();
    assert_eq!((local.x, local.y), (15_000, i32::MAX), "metres; not known");

    let number = SprayModeCommand { _4th: SprayMode(3), number: 7.0, ..SprayModeCommand::DEFAULT };
    let int = number.int(MavFrame::MISSION, 0, 0).unwrap();
    assert_eq!((int.param1, int.x, int.y, int.z.is_nan()), (3.0, 65_536, 7, true), "no place, so no scale");
    assert_eq!(SprayModeCommand::from_int(&int), Ok(number));
    let place = CarriersCommand { latitude_x: 473_977_421.0, longitude_y: -1.0 };
    assert_eq!(
        CarriersCommand::from_int(&place.int(MavFrame::GLOBAL, 0, 0).unwrap()),
        Ok(place),
        "degE7 is the integer"
    );
    assert!(Commands.long(0, 0).unwrap().param6.is_nan());
    assert_eq!(
        Commands.int(MavFrame::GLOBAL, 0, 0).unwrap(),
        CommandInt { command: MavCmd::COMMANDS, y: i32::MAX, ..CommandInt::DEFAULT }
    );
    assert_eq!(Stop::from_long(&Stop.long(0, 0).unwrap()), Ok(Stop));
}

#[cfg(feature = "typed-commands")]
#[test]
fn commands_are_there_with_their_feature() {
    use command_feature::{commands::Spray, main};

    assert_eq!(Spray { nozzle: 2.0 }.long(1, 1).map(|long| long.param1), Ok(2.0));
    assert_eq!(main::commands::Spray::ID, command_feature::other_root::commands::Spray::ID);
}

/// Of two modules of one name that come by `*`, neither can be used: what compiles here would not if there were commands.
#[cfg(not(feature = "typed-commands"))]
mod without_commands {
    use mavlink_conformance::golden::command_feature;
    use mavlink_wire::Dialect;

    mod others {
        pub(super) mod commands {
            pub(in super::super) const ARE_THERE: bool = false;
        }
    }

    #[test]
    fn commands_are_not_there_without_their_feature() {
        use command_feature::main::*;
        use others::*;

        assert_eq!((commands::ARE_THERE, Main::TABLE.iter().count()), (false, 1));
    }
}

#[test]
#[expect(deprecated, reason = "one of them is deprecated")]
fn commands_that_cannot_be_carried() {
    use mav_cmd::commands::{GoTo, SprayModeCommand, Stop};
    use mav_cmd::{CommandInt, MavCmd, MavFrame, SprayMode, SprayParts};
    use mavlink_wire::{CommandError, ParamError};

    let param = |index, error| Some(CommandError::Param { index, error });
    let go = |latitude, frame| GoTo { latitude, ..GoTo::DEFAULT }.int(frame, 1, 1).err();
    assert_eq!(go(214.748_364_6, MavFrame::GLOBAL), None);
    assert_eq!(go(214.748_364_7, MavFrame::GLOBAL), param(5, ParamError::OutOfRange), "it would not be known");
    assert_eq!(go(f64::INFINITY, MavFrame::GLOBAL), param(5, ParamError::OutOfRange));
    assert_eq!(go(1.0, MavFrame::MISSION), Some(CommandError::Frame { frame: 2 }));
    let parts = |bits| GoTo { r#type: SprayParts::from_bits_retain(bits), ..GoTo::DEFAULT }.long(1, 1).err();
    assert_eq!((parts(1 << 31), parts((1 << 24) + 1)), (None, param(1, ParamError::NoFloat)));
    let number = |number| SprayModeCommand { number, ..SprayModeCommand::DEFAULT };
    assert_eq!(number(0.5).int(MavFrame::GLOBAL, 1, 1).err(), param(6, ParamError::NotWhole));
    assert_eq!(number(1e39).long(1, 1).err(), param(6, ParamError::OutOfRange));

    let came = |param1, x| {
        SprayModeCommand::from_int(&CommandInt { command: MavCmd::SPRAY_MODE, param1, x, ..CommandInt::DEFAULT })
    };
    assert_eq!(came(255.0, 0).map(|command| command._4th), Ok(SprayMode(255)), "no entry, and kept");
    assert_eq!(came(256.0, 0).err(), param(1, ParamError::OutOfRange));
    assert_eq!(came(f32::NAN, 0).err(), param(1, ParamError::NotWhole));
    assert_eq!(came(0.0, -1).err(), param(5, ParamError::OutOfRange));
    let other = CommandError::OtherCommand { expected: 43, found: 44 };
    assert_eq!(Stop::from_long(&GoTo::DEFAULT.long(1, 1).unwrap()), Err(other));
}

#[test]
fn names() {
    use names::{Iterator_, Option_, OptionEnum, Some_};

    let it = Iterator_ { r#type: OptionEnum::TYPE, self_: 2, store_item: [0, 3], ..Iterator_::DEFAULT };
    assert_eq!((it.store_item(0), it.store_item(1)), (None, Some(3)));
    assert_eq!(Option_ { into: 1 }.info().name, "OPTION");
    let slots: Vec<_> = Some_ { words: 0, parts: [0b0111_1011, 0] }.ok().collect();
    let status = slots[0].status;
    assert_eq!((slots.len(), status.r#fn(), status.index(), status.shl(1)), (2, 1.5, true, Some(1)));
}

#[test]
fn bind() {
    use bind::{AcmeMode, Beat, State, Vendor};

    let mut beat = Beat { vendor: Vendor::ACME, custom: 65_537, state: 3 };
    assert_eq!((beat.mode(), beat.activity()), (Some(AcmeMode::ARMED | AcmeMode::WET), State::BUSY));
    beat.vendor = Vendor(8);
    assert_eq!(beat.mode(), None, "it means something else there");
    beat.set_mode(AcmeMode::WET);
    assert_eq!((beat.vendor, beat.custom), (Vendor(8), 65_536), "whose it is, is for the caller to say");
}

#[test]
fn view_bits() {
    use view_bits::{Gear, Status};

    let mut status = Status { low: 0x8f5f_fa03, high: [0xfff8, 0xffff] };
    let flags = status.flags();
    assert_eq!((flags.armed(), flags.gear(), flags.trim(), flags.count()), (true, Gear::DOWN, -32, 0x7fe));
    assert_eq!(
        [0, 1, 2, 3, 4].map(|index| flags.relay(index)),
        [Some(true), Some(false), Some(true), Some(true), None]
    );
    assert_eq!([0, 1, 2, 3].map(|index| flags.pairs(index)), [Some(-1), Some(-2), Some(-2), None]);
    assert!(status.part().top());
    let mut changed = flags;
    assert!(changed.set_trim(-33).is_err() && changed == flags);
    _ = changed.set_trim(31);
    _ = changed.set_pairs(2, 1);
    status.set_flags(changed);
    assert_eq!((status.low, status.high), (0x8f5f_f9f3, [0xfff4, 0xffff]), "the reserved bits stay");
}

/// -1 in the bits of a float is a signalling or a quiet NaN, and comes back.
#[test]
fn view_floats() {
    use view_floats::{Gauges, IntParam, ParamValue};

    let mut param = ParamValue { param_value: f32::from_bits(u32::MAX), param_type: 6 };
    assert_eq!(param.int().value(), -1);
    for value in [0, 7, -2, i32::MIN, i32::MAX, 0x7f80_0001] {
        let mut int = IntParam::from_bits(0);
        int.set_value(value);
        param.set_int(int);
        assert_eq!((param.param_value.to_bits(), param.int().value()), (value as u32, value));
        assert_eq!(payload(&param), [&value.to_le_bytes()[..], &[6]].concat());
    }

    let bits = [0x3f80_0000, 0xffff_ffff, 0x7fff_ffff];
    let mut gauges = Gauges {
        word: f64::from_bits(0xfff0_0000_0000_0001),
        pair: [f32::from_bits(3), f32::from_bits(0xff80_0001)],
        cell: bits.map(f32::from_bits),
        id: [7, 8, 9],
    };
    let joined = gauges.joined();
    assert_eq!((joined.pair(), joined.low(), joined.high()), (0xff80_0001_0000_0003, 1, 0xfff_0000_0000_0000));
    let slots: Vec<_> =
        gauges.gauges().map(|slot| (slot.id, slot.status.map(|status| (status.raw(), status.sign())))).collect();
    assert_eq!(slots, [(7, Some((0x3f80_0000, false))), (8, None), (9, Some((0x7fff_ffff, false)))]);
    let mut slot = gauges.gauge(2).unwrap();
    slot.status = None;
    assert_eq!(gauges.set_gauge(0, slot), Ok(()));
    assert_eq!((gauges.cell[0].to_bits(), gauges.id[0]), (u32::MAX, 9));
}

#[test]
fn view_scaled() {
    use view_scaled::{Battery, Gauge};

    let mut battery = Battery { word: 1234 | 100 << 12 | 0b11110 << 21 | 0b111_010 << 26 };
    let state = battery.state();
    assert_eq!((state.voltage(), state.voltage_mv(), state.voltage_raw()), (12.34, 12_340, 1234));
    assert_eq!((state.temperature(), state.temperature_cdegc(), state.climb()), (-7.0, -700, 1.0));
    assert_eq!((state.share_raw(0), state.share(1), state.share(2)), (Some(2), Some(100.0), None));
    let mut changed = state;
    assert!(changed.set_voltage(f32::NAN).is_err() && changed.set_voltage(40.96).is_err() && changed == state);
    assert_eq!((changed.set_temperature(-6.875), changed.temperature_raw()), (Ok(()), 101), "half is rounded up");
    battery.set_state(changed);
    assert_eq!(battery.state().temperature(), -6.75);

    let reading = Gauge { word: 4095 | 0xfffff << 12 | 9 << 32 | 2 << 40 | 7 << 48 }.reading();
    assert_eq!((reading.narrow(), reading.wide(), reading.above()), (4095.0, 1_048_575.0, 44.5));
    assert_eq!((reading.below(), reading.falling()), (-3.5, -2.0));
}

/// A value that is set makes its condition hold, and leaves other fields alone.
#[test]
fn view_values() {
    use view_values::{OldWind, RawSensors, Sensors, Spraying, Tank, Topic, Wind};

    let wind = Wind { speed: 7.5, r#type: 2.0, age_ms: Some(250) };
    let sent = Sensors { small: -3, ..Sensors::DEFAULT }.with_wind(wind);
    let expected = Sensors { index: Topic::WIND, value1: 7.5, value2: 2.0, whole: 250, small: -3, ..Sensors::DEFAULT };
    assert_eq!(sent, expected);
    assert_eq!((sent.wind(), sent.tank(), sent.raw()), (Some(wind), None, RawSensors { first: 7.5 }));
    assert_eq!(sent.old_wind(), Some(OldWind { north: 7.5, east: 2.0 }), "nothing tells them apart");
    let mut unknown = sent;
    unknown.set_wind(Wind { age_ms: None, ..wind });
    assert_eq!((unknown.whole, unknown.wind().unwrap().age_ms), (u16::MAX, None));
    unknown.index = Topic(77);
    assert_eq!((unknown.wind(), unknown.old_wind()), (None, None));

    let tank = Tank { status: Spraying::from_bits_retain(0x82), level: -0.1, heat_degc: i8::MIN };
    assert_eq!(sent.with_tank(tank).tank(), Some(tank), "unknown flags stay");
    assert_eq!(sent.with_raw(RawSensors { first: -0.0 }).wind().unwrap().speed.to_bits(), (-0.0_f32).to_bits());
    assert_eq!(Sensors::DEFAULT.with_old_wind(OldWind::default()), Sensors { index: Topic::WIND, ..Sensors::DEFAULT });
}

#[test]
fn view_switch() {
    use view_switch::{Layout, Report};

    let mut report = Report { layout: Layout::LATEST, word: 0xc807, other: 0xfffd };
    let details = report.details();
    assert_eq!((details.speed(), details.load(), details.error()), (7, Some(100.0), None));
    report.layout = Layout(77);
    assert_eq!((report.details().load(), report.details().error()), (None, Some(8)));
    assert_eq!(report.other_details(), None);
    report.layout = Layout::NEW;
    let other = report.other_details().unwrap();
    assert_eq!((other.kind(), other.near(), other.far()), (1, None, Some(-1)));
    report.set_details(details);
    assert_eq!(report.layout, Layout::LATEST, "a view brings its layout along");
}

#[test]
fn view_slots() {
    use view_slots::{Amount, Source, Wheel, WheelStatus, Wheels};

    let mut wheels = Wheels { used: Amount::BOTH, radius: 0.5, ..Wheels::DEFAULT };
    wheels.source = [Source::BUS, Source::NOBODY, Source::BUS, Source::BUS];
    (wheels.low, wheels.high, wheels.age) = ([3, 3, 3, 3], [80, 0, 0, 0], [u16::MAX, 9, 0, 0]);
    let all: Vec<Wheel> = wheels.all().collect();
    assert_eq!(all.len(), 2, "the others are not in use");
    let status = all[0].status.unwrap();
    assert_eq!((all[0].source, all[0].age_ms, all[0].radius), (Some(Source::BUS), None, 0.5));
    assert_eq!((status.turning(), status.rpm(), status.heat()), (true, 1, 0.0));
    assert_eq!((all[1].source, all[1].age_ms, all[1].status), (None, Some(9), None), "it stays, without a status");
    let slot = Wheel { source: Some(Source::BUS), age_ms: None, radius: 0.5, status: Some(WheelStatus::from_bits(5)) };
    assert_eq!((wheels.push_wheel(slot), wheels.used, wheels.wheel(2)), (Ok(()), Amount(3), Some(slot)));
    assert!(wheels.set_wheel(3, slot).is_err(), "not in use");
    assert!(wheels.push_wheel(slot).is_ok() && wheels.push_wheel(slot).is_err(), "four are all");
}

#[test]
fn roots() {
    use roots::{main, other_root};

    let paint: main::Paint = other_root::Paint { color: other_root::Color::GREEN };
    assert_eq!(paint.color.to_string(), "COLOR_GREEN", "one type, with the constants of both");
    assert_eq!((main::Brush::INFO.len_v2, other_root::Brush::INFO.len_v2), (1, 2), "two definitions, two types");
    let message = main::Main::decode(316, &[1]).unwrap();
    assert_eq!(message, main::Main::Paint(main::Paint { color: main::Color::BLUE }));
}
