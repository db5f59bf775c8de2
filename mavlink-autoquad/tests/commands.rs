//! Every command in both messages, as pymavlink packs it, and back; and whatever comes in one of them.

#![allow(deprecated, reason = "what is deprecated is tested like the rest")]
#![expect(clippy::unwrap_used, reason = "a failing test panics")]

use std::fmt::Debug;

use mavlink_autoquad::autoquad::commands::*;
use mavlink_autoquad::autoquad::{CommandInt, CommandLong, MavCmd, MavFrame};
use mavlink_autoquad::wire::{Command, CommandError, Encode, Enum, MAX_PAYLOAD, Message, Version};

/// What all commands are.
trait Carried: Command<Carriers = Carriers> + Default + Debug {}

impl<C: Command<Carriers = Carriers> + Default + Debug> Carried for C {}

/// A command and what pymavlink packs for it.
struct Case {
    id: u16,
    packed: fn(),
    came: fn(&mut Numbers) -> usize,
}

macro_rules! commands {
    ($($name:ident { $($field:ident: $value:expr),* } $long:literal $frame:literal $int:literal)*) => {
        const CASES: &[Case] = &[$(Case {
            id: $name::ID,
            packed: || packed($name { $($field: $value),* }, $long, MavFrame($frame), $int),
            came: came::<$name>,
        }),*];
    };
}

include!("commands/vectors.rs");

fn payload(message: &impl Encode) -> String {
    let bytes = message.payload(Version::V2, &mut [0; MAX_PAYLOAD]).to_vec();
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// As it prints: a NaN is like another.
fn shown(command: &impl Debug) -> String {
    format!("{command:?}")
}

fn packed<C: Carried>(command: C, long: &str, frame: MavFrame, int: &str) {
    let by_long = command.long(7, 8).unwrap();
    assert_eq!(payload(&by_long), long, "{command:?}");
    let by_int = command.int(frame, 7, 8).unwrap();
    assert_eq!(payload(&by_int), int, "{command:?} in {frame}");
    assert_eq!(shown(&C::from_int(&by_int).unwrap()), shown(&command), "in {frame}: exact");
    let back = C::from_long(&by_long).unwrap();
    assert_eq!(payload(&back.long(7, 8).unwrap()), long, "{back:?}: each float is kept");

    let other = MavCmd(by_long.command.0 ^ 0x8000);
    let refused = Some(CommandError::OtherCommand { expected: C::ID, found: other.0 });
    assert_eq!(C::from_long(&CommandLong { command: other, ..by_long }).err(), refused);
    assert_eq!(C::from_int(&CommandInt { command: other, ..by_int }).err(), refused);
}

#[test]
fn every_command_is_as_pymavlink_packs_it() {
    let mut ids: Vec<u16> = CASES.iter().map(|case| case.id).collect();
    ids.dedup();
    assert_eq!((ids.len(), CASES.len()), (174, 3 * 174));
    CASES.iter().for_each(|case| (case.packed)());
}

/// Pseudo-random numbers (xorshift).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// Any float, more often one that enums and counts have.
    fn float(&mut self) -> f32 {
        match self.next() % 4 {
            0 => f32::from_bits(self.next() as u32),
            1 => f32::NAN,
            _ => (self.next() % 200) as f32,
        }
    }

    /// Any integer, more often a small one, and the one that is not known.
    fn integer(&mut self) -> i32 {
        match self.next() % 4 {
            0 => self.next() as i32,
            1 => i32::MAX,
            _ => (self.next() % 200) as i32,
        }
    }
}

/// Whatever comes is read or refused; what is read is sent as it came, in what has a name. How many were read.
fn came<C: Carried>(numbers: &mut Numbers) -> usize {
    let command = MavCmd(C::ID);
    let (param1, param2, param3, param4) = (numbers.float(), numbers.float(), numbers.float(), numbers.float());
    let (param5, param6, param7) = (numbers.float(), numbers.float(), numbers.float());
    let long = CommandLong { command, param1, param2, param3, param4, param5, param6, param7, ..CommandLong::DEFAULT };
    let (x, y, frame) = (numbers.integer(), numbers.integer(), MavFrame((numbers.next() % 24) as u8));
    let int = CommandInt { command, frame, param1, param2, param3, param4, x, y, z: param7, ..CommandInt::DEFAULT };
    let mut read = 0;
    if let Ok(first) = C::from_long(&long) {
        let again = C::from_long(&first.long(0, 0).unwrap()).unwrap();
        assert_eq!(shown(&again), shown(&first), "{long:?}");
        read += 1;
    }
    if let Ok(first) = C::from_int(&int) {
        let sent = first.int(frame, 0, 0).unwrap();
        let again = C::from_int(&sent).unwrap();
        assert_eq!(shown(&again), shown(&first), "{int:?}");
        // What is sent of a param without a field does not hang on what came.
        let fixed = C::DEFAULT.int(MavFrame::GLOBAL, 0, 0).unwrap();
        assert!([int.x, fixed.x].contains(&sent.x) && [int.y, fixed.y].contains(&sent.y), "{int:?}: {sent:?}");
        read += 1;
    }
    read
}

#[test]
fn whatever_comes_is_refused_or_kept() {
    let mut numbers = Numbers(0x9e37_79b9_7f4a_7c15);
    let read: usize = (0..40).flat_map(|_| CASES).map(|case| (case.came)(&mut numbers)).sum();
    println!("{read} of {}", 80 * CASES.len());
    assert!(read > 20 * CASES.len(), "{read}");
}

/// The nearest float: no other is nearer to the integer that `COMMAND_INT` carries.
#[test]
fn a_place_by_long_is_the_nearest_float() {
    let mut numbers = Numbers(7);
    for _ in 0..20_000 {
        let x = (numbers.next() % 3_600_000_001) as i64 - 1_800_000_000;
        let int = CommandInt { command: MavCmd(NavWaypoint::ID), x: x as i32, ..CommandInt::DEFAULT };
        let float = NavWaypoint::from_int(&int).unwrap().long(0, 0).unwrap().param5;
        // Both in units of 1e-7 degrees times 2^-60: exact in 128 bits.
        let distance =
            |float: f32| ((f64::from(float) * 2f64.powi(60)) as i128 * 10_000_000 - (i128::from(x) << 60)).abs();
        assert!(distance(float) <= distance(float.next_up()).min(distance(float.next_down())), "{x}");
    }
}
