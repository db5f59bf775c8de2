//! The flags types behave as those of `bitflags` do, method by method.

use mavlink_wire as wire;
use proptest::prelude::*;

/// With a zero entry, overlapping entries, an entry of two bits that no other names, and gaps.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Ours(u16);

static INFO: wire::EnumInfo = wire::EnumInfo::bitmask(
    "THEIRS",
    &[(0, "NONE"), (1, "A"), (2, "B"), (3, "AB"), (4, "C"), (0x18, "PAIR"), (0x4001, "HIGH"), (0x8000, "TOP")],
);
wire::flags!(Ours, u16, INFO);

bitflags::bitflags! {
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub(crate) struct Theirs: u16 {
        const NONE = 0;
        const A = 1;
        const B = 2;
        const AB = 3;
        const C = 4;
        const PAIR = 0x18;
        const HIGH = 0x4001;
        const TOP = 0x8000;
    }
}

fn pair(bits: u16) -> (Ours, Theirs) {
    (Ours::from_bits_retain(bits), Theirs::from_bits_retain(bits))
}

#[track_caller]
fn same(ours: Ours, theirs: Theirs) {
    assert_eq!(ours.bits(), theirs.bits());
}

type Change<F> = fn(&mut F, F);

fn value() -> impl Strategy<Value = u16> {
    prop_oneof![any::<u16>(), 0..0x20_u16, any::<u16>().prop_map(|bits| bits & Theirs::all().bits())]
}

proptest! {
    #[test]
    fn values_answer_alike(bits in value()) {
        let (ours, theirs) = pair(bits);
        prop_assert_eq!(ours.bits(), theirs.bits());
        prop_assert_eq!(Ours::from_bits(bits).map(|f| f.bits()), Theirs::from_bits(bits).map(|f| f.bits()));
        same(Ours::from_bits_truncate(bits), Theirs::from_bits_truncate(bits));
        prop_assert_eq!((ours.is_empty(), ours.is_all()), (theirs.is_empty(), theirs.is_all()));
        same(ours.complement(), theirs.complement());
        same(!ours, !theirs);
        let mine: Vec<u16> = ours.iter().map(|f| f.bits()).collect();
        prop_assert_eq!(&mine, &theirs.iter().map(|f| f.bits()).collect::<Vec<_>>());
        prop_assert_eq!(&mine, &ours.into_iter().map(|f| f.bits()).collect::<Vec<_>>());
        let (mut mine, mut its) = (ours.iter_names(), theirs.iter_names());
        loop {
            same(mine.remaining(), *its.remaining());
            let (mine, its) = (mine.next(), its.next());
            prop_assert_eq!(mine.map(|(name, f)| (name, f.bits())), its.map(|(name, f)| (name, f.bits())));
            if mine.is_none() {
                break;
            }
        }
    }

    #[test]
    fn pairs_answer_alike(a in value(), b in value(), on in any::<bool>()) {
        let ((a, x), (b, y)) = (pair(a), pair(b));
        prop_assert_eq!((a.contains(b), a.intersects(b)), (x.contains(y), x.intersects(y)));
        same(a.intersection(b), x.intersection(y));
        same(a.union(b), x.union(y));
        same(a.difference(b), x.difference(y));
        same(a.symmetric_difference(b), x.symmetric_difference(y));
        same(a | b, x | y);
        same(a & b, x & y);
        same(a ^ b, x ^ y);
        same(a - b, x - y);
        let changes: [(Change<Ours>, Change<Theirs>); 7] = [
            (|f, g| *f |= g, |f, g| *f |= g),
            (|f, g| *f &= g, |f, g| *f &= g),
            (|f, g| *f ^= g, |f, g| *f ^= g),
            (|f, g| *f -= g, |f, g| *f -= g),
            (Ours::insert, Theirs::insert),
            (Ours::remove, Theirs::remove),
            (Ours::toggle, Theirs::toggle),
        ];
        for (ours, theirs) in changes {
            let (mut f, mut g) = (a, x);
            ours(&mut f, b);
            theirs(&mut g, y);
            same(f, g);
        }
        let (mut f, mut g) = (a, x);
        f.set(b, on);
        g.set(y, on);
        same(f, g);
    }

    #[test]
    fn collections_answer_alike(values in proptest::collection::vec(value(), 0..5), start in value()) {
        let (mut ours, mut theirs) = pair(start);
        same(values.iter().map(|&v| pair(v).0).collect(), values.iter().map(|&v| pair(v).1).collect());
        ours.extend(values.iter().map(|&v| pair(v).0));
        theirs.extend(values.iter().map(|&v| pair(v).1));
        same(ours, theirs);
    }

    #[test]
    fn text_comes_back(bits in value()) {
        let flags = Ours::from_bits_retain(bits);
        prop_assert_eq!(flags.to_string().parse(), Ok(flags));
        prop_assert_eq!(format!("{flags:?}"), flags.to_string());
    }
}

#[test]
fn constants_are_alike() {
    const ALL: Ours = Ours::all();
    same(ALL, Theirs::all());
    same(Ours::empty(), Theirs::empty());
    for name in ["NONE", "A", "AB", "PAIR", "TOP", "a", "", "A | B"] {
        assert_eq!(Ours::from_name(name).map(|f| f.bits()), Theirs::from_name(name).map(|f| f.bits()));
    }
}

#[test]
fn text_is_names_and_a_rest() {
    assert_eq!(Ours::from_bits_retain(0x0043).to_string(), "A | B | 0x40");
    assert_eq!(Ours::from_bits_retain(0x40).to_string(), "0x40");
    assert_eq!(Ours::empty().to_string(), "0");
    assert_eq!("TOP|A |  0x40 | 128".parse(), Ok(Ours::from_bits_retain(0x80C1)));
    for wrong in ["", "A |", "D", "a", "0x10000", "A, B", "-1", "+1"] {
        assert_eq!(wrong.parse::<Ours>(), Err(wire::UnknownName { name: "THEIRS" }), "{wrong:?}");
    }
}

#[test]
fn signed_flags_keep_their_top_bit() {
    #[derive(Clone, Copy, PartialEq)]
    pub(crate) struct Signed(i8);
    static INFO: wire::EnumInfo = wire::EnumInfo::bitmask("SIGNED", &[(1, "ONE"), (0x80, "TOP")]);
    wire::flags!(Signed, i8, INFO);
    let all = Signed::from_bits_retain(-1);
    assert_eq!(all.to_string(), "ONE | TOP | 0x7e");
    assert_eq!("ONE | TOP | 0x7e".parse(), Ok(all));
    assert_eq!(Signed::all().bits(), -127);
    assert_eq!(all.iter().map(|f| f.bits()).collect::<Vec<_>>(), [1, -128, 0x7e]);
}
