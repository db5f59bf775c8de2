//! Text: enums, character fields, errors.

use mavlink_wire as wire;
use mavlink_wire::{Arrival, Chars, Enum, Invalid, Kind, Message, Sentinel, TooLong, UnknownName, Version};

use crate::small::{Heartbeat, MavModeFlag, MavSeverity, MavState, Small};

#[test]
fn enums_have_text_both_ways() {
    assert_eq!((MavState::STANDBY.to_string(), MavState(9).to_string()), ("MAV_STATE_STANDBY".into(), "9".into()));
    assert_eq!(format!("{:?} {:?}", MavState::UNINIT, MavState(9)), "MAV_STATE_UNINIT MavState(9)");
    assert_eq!(format!("[{:>18}] [{:03}]", MavState::ACTIVE, MavState(9)), "[  MAV_STATE_ACTIVE] [009]");
    for value in 0..=255 {
        assert_eq!(MavState(value).to_string().parse(), Ok(MavState(value)));
        assert_eq!(MavState(value).is_known(), matches!(value, 0 | 3 | 4));
    }
    assert_eq!("0xFF".parse(), Ok(MavState(255)));
    for wrong in ["", "MAV_STATE", "mav_state_active", "256", "-1", "+1", "0x", "0x100", " 1"] {
        assert_eq!(wrong.parse::<MavState>(), Err(UnknownName { name: "MAV_STATE" }), "{wrong:?}");
    }
}

#[test]
fn signed_enums_have_a_sign() {
    #[derive(Clone, Copy, PartialEq)]
    pub(crate) struct Signed(pub(crate) i8);
    static INFO: wire::EnumInfo = wire::EnumInfo::new("SIGNED", &[(0, "ZERO"), (127, "TOP")]);
    wire::open_enum!(Signed, i8, INFO);
    assert_eq!((Signed(-1).to_string(), format!("{:?}", Signed(-1))), ("-1".into(), "Signed(-1)".into()));
    assert_eq!(("-128".parse(), "TOP".parse()), (Ok(Signed(-128)), Ok(Signed(127))));
    assert_eq!("128".parse::<Signed>(), Err(UnknownName { name: "SIGNED" }));
}

#[test]
fn enums_convert_and_match() {
    assert_eq!((u8::from(MavSeverity::INFO), MavSeverity::from(0)), (6, MavSeverity::EMERGENCY));
    assert_eq!(u8::from(MavModeFlag::SAFETY_ARMED | MavModeFlag::CUSTOM_MODE_ENABLED), 129);
    assert!(matches!(MavState::from_repr(4), MavState::ACTIVE));
    assert_eq!((MavState::INFO.name, MavModeFlag::INFO.bitmask), ("MAV_STATE", true));
}

#[test]
fn characters_end_at_a_nul_and_keep_what_follows() {
    let chars = Chars(*b"ab\0c");
    assert_eq!((chars.as_bytes(), chars.to_str()), (&b"ab"[..], Ok("ab")));
    assert!(chars == "ab" && chars == *"ab" && chars != "ab\0c");
    assert_ne!(chars, Chars(*b"ab\0d"));
    assert_eq!((Chars(*b"abcd").to_str(), Chars::<3>::default().to_str()), (Ok("abcd"), Ok("")));
}

#[test]
fn characters_are_cut_only_on_request() {
    assert_eq!(Chars::<4>::try_from("abcd"), Ok(Chars(*b"abcd")));
    assert_eq!(Chars::<4>::try_from("abcde"), Err(TooLong { length: 5, capacity: 4 }));
    const CUT: Chars<4> = Chars::truncated("aäöü");
    assert_eq!((CUT.to_str(), CUT.0[3]), (Ok("aä"), 0));
    assert_eq!(Chars::<1>::truncated("ä").to_str(), Ok(""));
    assert_eq!(Chars::<0>::truncated("a").to_str(), Ok(""));
}

#[test]
fn characters_print_like_text() {
    assert_eq!(format!("{0} {0:?} [{0:>4}]", Chars(*b"a\"\0")), "a\" \"a\\\"\" [  a\"]");
    let bad = Chars(*b"a\xffb\xfe");
    assert_eq!(format!("{bad} {bad:?}"), "a\u{fffd}b\u{fffd} b\"a\\xffb\\xfe\"");
    assert!(bad.to_str().is_err());
}

#[test]
fn words_of_the_field_are_printed() {
    assert_eq!([Version::V1, Version::V2].map(|version| version.to_string()), ["MAVLink 1", "MAVLink 2"]);
    assert_eq!([Kind::Char, Kind::Version].map(|kind| kind.to_string()), ["char", "uint8_t_mavlink_version"]);
    assert_eq!(format!("[{:>9}] [{:<10}]", Kind::U16, Arrival::Next), "[ uint16_t] [next      ]");
    assert_eq!([Arrival::Gap(3), Arrival::Late].map(|arrival| arrival.to_string()), ["gap of 3", "late"]);
    let invalid = [
        Invalid::Each(Sentinel::Unsigned(65535)),
        Invalid::All(Sentinel::Signed(-1)),
        Invalid::First(Sentinel::NotANumber),
        Invalid::Each(Sentinel::Float(-0.5)),
    ];
    assert_eq!(invalid.map(|invalid| invalid.to_string()), ["65535", "[-1:]", "[NaN,]", "-0.5"]);
}

#[test]
fn messages_and_dialects_are_shown_as_their_fields_say() {
    let beat = Heartbeat { custom_mode: 4, system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT };
    let mut payload = [0; 255];
    wire::Encode::write(&beat, &mut payload);
    let reflected = wire::reflect::Reflected::new(Heartbeat::INFO, Heartbeat::FIELDS, &payload).to_string();
    assert!(
        reflected.starts_with("HEARTBEAT {") && reflected.contains("system_status: MAV_STATE_ACTIVE"),
        "{reflected}"
    );
    assert_eq!([beat.to_string(), Small::from(beat).to_string()], [reflected.clone(), reflected]);
}
