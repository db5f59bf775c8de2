//! Flags types where code asks for `bitflags::Flags`.

use std::fmt::Debug;

use bitflags::parser::WriteHex;
use bitflags::{Bits, Flags};
use mavlink_autoquad::autoquad::{AutoquadNavStatus, EscFailureFlags, MavModeFlag, MavProtocolCapability};
use mavlink_wire::{Enum, Repr};

/// A flags type of the dialect, and of `bitflags`.
fn check<F>()
where
    F: Flags<Bits: Repr + WriteHex + Debug> + Enum<Repr = F::Bits> + PartialEq + Debug + ToString,
{
    let flags: Vec<_> = F::FLAGS.iter().map(|flag| (flag.value().repr().bits(), flag.name())).collect();
    assert_eq!(flags, F::INFO.entries);
    assert_eq!(F::all().repr().bits(), F::INFO.all_bits());
    let every = F::from_bits_retain(F::Bits::ALL);
    assert_eq!(Flags::bits(&every), F::Bits::ALL);
    assert_eq!(F::from_bits_truncate(F::Bits::ALL), F::all());
    assert_eq!(F::from_bits(F::Bits::ALL).is_some(), F::all() == every, "some bits may have no name");
    let mut text = String::new();
    bitflags::parser::to_writer(&every, &mut text).unwrap();
    assert_eq!(text, every.to_string(), "the same text as ours");
    for (name, value) in every.iter_names() {
        assert_eq!(F::from_name(name), Some(value));
    }
}

#[test]
fn flags_of_every_width_are_flags_of_bitflags() {
    check::<MavModeFlag>();
    check::<EscFailureFlags>();
    check::<AutoquadNavStatus>();
    check::<MavProtocolCapability>();
}
