//! What became of the hostile definitions works: bytes, names, sentinels. That it compiles under
//! `deny(warnings, missing_docs, clippy::all)` is for the library to show.

#![allow(deprecated, reason = "what is deprecated is tested like the rest")]

use std::fs;
use std::path::PathBuf;

use mavlink_conformance::dialects::hostile::{
    Base, Bits, Converted, Debug, DebugEnum, E, Edges, EnumFields, Far, Hostile, I, LongMixed, MavCmd, Narrow,
    OldMessage, Ones, Option_, Radius, Resolution, Sentinels, Setters, Signed, SignedBits, Versioned, Wide, WideBits,
    Widened, Words,
};
use mavlink_conformance::dialects::names::{NamesDialect, OptionEnum, Self_, SelfEnum};
use mavlink_conformance::payload::{Canonical, Fill};
use mavlink_conformance::random::Random;
use mavlink_wire::{Chars, Dialect, Encode, Frame, MAX_FRAME, MAX_PAYLOAD, Message, OutOfRange, Sender};

fn every_message_survives<D: Dialect>() -> usize {
    let mut random = Random::new(7);
    for info in D::TABLE.iter() {
        for fill in Fill::ALL {
            let payload = fill.payload(random.below(MAX_PAYLOAD + 1), &mut random);
            let message = D::decode(info.id, &payload).unwrap();
            assert_eq!(Canonical::sent(&message), Canonical::of(&payload, info), "{} from {payload:02x?}", info.name);
            let mut buffer = [0; MAX_FRAME];
            let frame = Sender::v2(1, 1).encode(&message, &mut buffer).unwrap();
            assert!(Frame::parse(frame, D::TABLE).unwrap().message::<D>().is_some(), "{}", info.name);
        }
    }
    D::TABLE.len()
}

#[test]
fn every_message_survives_its_frame() {
    assert!(every_message_survives::<Hostile>() >= 80);
    assert!(every_message_survives::<NamesDialect>() >= 40);
    assert_eq!(Hostile::TABLE.get(0xFF_FFFF).map(|info| info.name), Some("LAST"));
}

#[test]
fn types_of_one_name_are_told_apart() {
    let debug = Debug { debug: DebugEnum::LATER };
    assert_eq!((debug.info().name, debug.debug.0, Option_::B.0), ("DEBUG", 2, 1));
    let self_ = Self_ { a: SelfEnum::A, ..Self_::DEFAULT };
    assert_eq!((self_.a(), OptionEnum::A.name()), (None, Some("OPTION_A")));
}

#[test]
fn constants_are_named_and_valued() {
    assert_eq!((Words::SELF.0, Words::FN.0, Words::CAMEL_CASE9.0, Words::LEADING.0), (0, 5, 9, 10));
    assert_eq!((E::A.0, E::E_1.0, E::E_.0, Resolution::RESOLUTION_2_7K_17_9.0), (0, 1, 2, 1));
    assert_eq!((Radius::RADIUS_75_M.0, Radius::RADIUS_7_5_M.0, Radius::RADIUS_7_5M.0, I::J.0), (0, 1, 2, 1));
    assert_eq!((Edges::BINARY.0, Edges::POWER_63.0, Edges::LAST.0), (6, 1 << 63, u64::MAX));
    assert_eq!((Narrow::OTHER_PREFIX.0, Narrow::NARROW_200.0, Narrow::MORE.0), (9, 200, 201));
    assert_eq!((Bits::NONE.bits(), Bits::all().bits()), (0, 1 << 63 | 0x33));
    assert_eq!(Bits::BOTH.to_string(), "BITS_ALL | BITS_TOP");
    assert_eq!("BITS_BOTH|0x40".parse(), Ok(Bits::BOTH | Bits::from_bits_retain(0x40)));
    assert_eq!(Signed::from(-1).to_string(), "-1");
    assert_eq!(SignedBits::from_bits_retain(-128).to_string(), "0x80");
    // The fifth has nothing but a description.
    assert!(MavCmd::EVERYTHING.params().iter().map(|param| param.index).eq([1, 2, 3, 4, 7]));
    assert!(MavCmd::EVERYTHING.params()[0].default.unwrap().is_nan());
}

#[test]
fn versions_are_those_of_their_files() {
    assert_eq!((Versioned::DEFAULT.version, Base::DEFAULT.version), (255, 4));
}

#[test]
fn sentinels_of_every_kind() {
    let mut s = Sentinels::DEFAULT;
    assert_eq!((s.a(), s.f(), s.g(), s.c()), (Some(0.0), None, None, Some(0.0)));
    s.set_a(None);
    s.set_d(None);
    s.set_l(None);
    s.set_p(None);
    s.set_s(Some([1, -1, -1]));
    assert!(s.a.is_nan() && s.a().is_none() && s.p[2].is_nan() && s.p().is_none());
    assert_eq!((s.d, s.d(), s.l, s.l()), (1e300, None, i64::MIN, None));
    assert_eq!(s.s(), Some([1, -1, -1]));
    s.q = [f32::NAN; 3];
    s.t = [-1; 3];
    assert!(s.q(0).is_none() && s.q(1).is_some() && s.q(3).is_none());
    assert_eq!((s.t(0), s.t(1), s.t(3)), (None, Some(-1), None));
    assert_eq!((s.set_r(2, None), s.r, s.r(2), s.set_r(3, None)), (Ok(()), [0, 0, -1], None, Err(OutOfRange)));
    s.set_g(None);
    s.set_y(None);
    s.set_z(None);
    assert!(s.g.is_sign_negative() && s.y().is_none() && s.z().is_none() && s.z > 0.0);
}

#[test]
fn sentinels_of_enums() {
    let mut e = EnumFields::DEFAULT;
    assert_eq!((e.edges(), e.old(), e.young(), e.signed()), (Some(Edges::ZERO), None, None, Some(Signed::ZERO)));
    e.set_signeds(None);
    e.set_bits(None);
    assert_eq!((e.signeds, e.bits, e.bits()), ([Signed(-1); 3], Bits::TOP, None));
    assert_eq!(e.set_wides(0, None).map(|()| e.wides), Ok([Wide::WIDE_300, Wide(0)]));
    e.wides = [Wide::WIDE_300; 2];
    assert_eq!((e.wides(0), e.wides(1)), (None, Some(Wide::WIDE_300)));
    let old = OldMessage::DEFAULT;
    assert_eq!((old.old(), Ones::DEFAULT.d(0), LongMixed::DEFAULT.d), (None, None, Chars([0; 2])));
}

#[test]
fn enums_in_narrower_fields() {
    let mut c = Converted { other_sign: -1, signed_narrow: -1, ..Converted::DEFAULT };
    assert_eq!((c.narrow(), c.other_sign(), c.signed_narrow()), (Far(0), None, None));
    assert_eq!((c.set_narrow(Far::FAR_33), c.set_narrow(Far::ONE), c.narrow), (Err(OutOfRange), Ok(()), 1));
    assert_eq!((c.set_half_bits(WideBits::BITS_17), c.half_bits()), (Err(OutOfRange), None));
    assert_eq!((c.set_narrows(2, Far::ONE), c.set_narrows(1, Far::ONE)), (Err(OutOfRange), Ok(())));
    assert_eq!((c.narrows(1), c.narrows(2)), (Some(Far::ONE), None));
}

#[test]
fn enums_in_wider_fields() {
    let mut w = Widened { a: 300, b: 200, f: -1, ..Widened::DEFAULT };
    assert_eq!((w.a(), w.b(), w.h()), (None, Some(Narrow::NARROW_200), Some(Narrow::ZERO)));
    w.set_a(Narrow::MORE);
    assert_eq!((w.a, w.a(), w.set_h(Narrow::MORE)), (201, Some(Narrow::MORE), Err(OutOfRange)));
}

/// A field that is called like another's setter is a field and no more.
#[test]
fn a_getter_gives_way_to_a_setter() {
    let mut setters = Setters { set_x: 3, ..Setters::DEFAULT };
    setters.set_x(Some(9));
    assert_eq!((setters.x(), setters.set_x), (Some(9), 3));
}

/// Lines that rustdoc would compile as Rust: fences, and what is indented by four. The texts of the definitions and of the
/// overlay are full of them, and come through as prose.
#[test]
fn no_text_becomes_a_doctest() {
    let mut folders = vec![PathBuf::from(concat!(env!("OUT_DIR"), "/hostile"))];
    let (mut lines, mut fences) = (0, 0);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            for line in fs::read_to_string(&path).unwrap().lines() {
                let line = line.trim_start();
                let Some(text) = line.strip_prefix("///").or_else(|| line.strip_prefix("//!")) else { continue };
                assert!(!text.starts_with("     ") && !text.contains('\t'), "{}: {line}", path.display());
                let fence = ["```", "~~~"].iter().any(|fence| text.trim_start().starts_with(fence));
                assert!(!fence, "{}: {line}", path.display());
                lines += 1;
                fences += usize::from(text.contains(r"\`\`\`"));
            }
        }
    }
    assert!(lines > 3000 && fences > 20, "{lines} lines, {fences} fences");
}
