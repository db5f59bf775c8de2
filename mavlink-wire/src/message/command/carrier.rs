//! What `COMMAND_LONG` and `COMMAND_INT` make of params. Both have them at the same places of the payload; they differ in params
//! 5 and 6, which one carries as floats and the other as integers.

use super::{Command, CommandError, ParamError};
use crate::generated::{Wire, get, put};
use crate::{ComponentId, Enum, MAX_PAYLOAD, Repr, SystemId};

/// Bytes of the longer one, `COMMAND_INT`.
const LENGTH: usize = 35;

/// Where the number of the command stands.
const COMMAND: usize = 28;

/// Where the frame of `COMMAND_INT` stands.
const FRAME: usize = 32;

/// `x` and `y` of a `COMMAND_INT` that are not known (`invalid="INT32_MAX"`).
const UNKNOWN: i32 = i32::MAX;

/// The params of a command, on their way into a message or out of one.
#[derive(Debug)]
pub struct Params {
    payload: [u8; LENGTH],
    /// The frame of a `COMMAND_INT`, which carries params 5 and 6 as integers.
    frame: Option<u8>,
    /// Whether they come out of a message.
    came: bool,
    /// The first of what is wrong.
    error: Option<CommandError>,
}

impl Params {
    /// Those that go into a `COMMAND_LONG`.
    pub(super) fn long(target: (SystemId, ComponentId)) -> Self {
        Self::to(target, None)
    }

    /// Those that go into a `COMMAND_INT`.
    pub(super) fn int(target: (SystemId, ComponentId), frame: u8) -> Self {
        let mut params = Self::to(target, Some(frame));
        put(&mut params.payload, FRAME, frame);
        params
    }

    fn to((system, component): (SystemId, ComponentId), frame: Option<u8>) -> Self {
        let mut payload = [0; LENGTH];
        put(&mut payload, COMMAND + 2, [system.to_u8(), component.to_u8()]);
        Self { payload, frame, came: false, error: None }
    }

    /// The payload of the message that carries a command.
    #[inline]
    pub(super) fn made_of<C: Command>(mut self, command: &C) -> Result<[u8; LENGTH], CommandError> {
        put(&mut self.payload, COMMAND, C::ID);
        { *command }.params(&mut self);
        self.error.map_or(Ok(self.payload), Err)
    }

    /// Those of a `COMMAND_LONG`.
    pub(super) fn of_long(payload: &[u8; MAX_PAYLOAD]) -> Self {
        Self { payload: get(payload, 0), frame: None, came: true, error: None }
    }

    /// Those of a `COMMAND_INT`.
    pub(super) fn of_int(payload: &[u8; MAX_PAYLOAD]) -> Self {
        Self { frame: Some(get(payload, FRAME)), ..Self::of_long(payload) }
    }

    /// The command that came.
    #[inline]
    pub(super) fn read<C: Command>(mut self) -> Result<C, CommandError> {
        let (expected, found, mut command) = (C::ID, get(&self.payload, COMMAND), C::DEFAULT);
        if found != expected {
            return Err(CommandError::OtherCommand { expected, found });
        }
        command.params(&mut self);
        self.error.map_or(Ok(command), Err)
    }

    /// A param that is a float in both messages: 1 to 4, and 7.
    pub fn float(&mut self, index: u8, value: &mut f32) {
        if self.came { *value = self.get(index) } else { self.put(index, *value) }
    }

    /// Param 5 or 6. NaN says that it is not known.
    pub fn number(&mut self, index: u8, value: &mut f64) {
        self.scaled(index, value, 1.0);
    }

    /// Param 5 or 6, if it is a coordinate in degrees or metres. NaN says that it is not known.
    pub fn place(&mut self, index: u8, value: &mut f64) {
        match self.frame.map(|frame| scale(frame).ok_or(CommandError::Frame { frame })) {
            None => self.number(index, value),
            Some(Ok(scale)) => self.scaled(index, value, scale),
            Some(Err(error)) => self.fail(error),
        }
    }

    /// A param that is the value of an enum.
    #[inline]
    pub fn entry<E: Enum>(&mut self, index: u8, value: &mut E) {
        if !self.came {
            return self.put_whole(index, value.repr().number());
        }
        let number = self.whole(index);
        *value = E::from_repr(E::Repr::from_bits(number as u64));
        if value.repr().number() != number {
            self.fail_at(index, ParamError::OutOfRange);
        }
    }

    /// A param without a field: what is sent of it.
    pub fn fixed(&mut self, index: u8, value: f64) {
        if self.came {
        } else if matches!(index, 5 | 6) {
            self.number(index, &mut { value });
        } else {
            self.put(index, value as f32);
        }
    }

    fn scaled(&mut self, index: u8, value: &mut f64, scale: f64) {
        match (self.frame, self.came) {
            (None, false) => {
                let float = *value as f32;
                self.put(index, float);
                if float.is_infinite() && value.is_finite() {
                    self.fail_at(index, ParamError::OutOfRange);
                }
            }
            (None, true) => *value = self.get::<f32>(index).into(),
            (Some(_), false) if value.is_nan() => self.put(index, UNKNOWN),
            (Some(_), false) => match nearest(*value * scale) {
                // By chance that which says that it is not known.
                None | Some(UNKNOWN) => self.fail_at(index, ParamError::OutOfRange),
                Some(whole) if scale == 1.0 && f64::from(whole) != *value => self.fail_at(index, ParamError::NotWhole),
                Some(whole) => self.put(index, whole),
            },
            (Some(_), true) => {
                *value = match self.get(index) {
                    UNKNOWN => f64::NAN,
                    whole => f64::from(whole) / scale,
                }
            }
        }
    }

    /// Whether a param is an integer in the message.
    fn is_integer(&self, index: u8) -> bool {
        self.frame.is_some() && matches!(index, 5 | 6)
    }

    /// Puts a number of at most 64 bits.
    fn put_whole(&mut self, index: u8, number: i128) {
        if self.is_integer(index) {
            return match i32::try_from(number) {
                Ok(number) => self.put(index, number),
                Err(_) => self.fail_at(index, ParamError::OutOfRange),
            };
        }
        let magnitude = number.unsigned_abs() as u64;
        let float = magnitude as f32;
        self.put(index, if number < 0 { -float } else { float });
        if whole(float) != Some(magnitude) {
            self.fail_at(index, ParamError::NoFloat);
        }
    }

    fn whole(&mut self, index: u8) -> i128 {
        if self.is_integer(index) {
            return self.get::<i32>(index).into();
        }
        let float: f32 = self.get(index);
        match whole(float.abs()).map(i128::from) {
            Some(magnitude) if float < 0.0 => -magnitude,
            Some(magnitude) => magnitude,
            None => {
                self.fail_at(index, ParamError::NotWhole);
                0
            }
        }
    }

    fn get<T: Wire>(&self, index: u8) -> T {
        get(&self.payload, offset(index))
    }

    fn put(&mut self, index: u8, value: impl Wire) {
        put(&mut self.payload, offset(index), value);
    }

    fn fail_at(&mut self, index: u8, error: ParamError) {
        self.fail(CommandError::Param { index, error });
    }

    fn fail(&mut self, error: CommandError) {
        self.error.get_or_insert(error);
    }
}

/// How many of the integers of a frame make one degree, or one metre; `None` if coordinates have no meaning in it
/// (`MAV_FRAME`).
fn scale(frame: u8) -> Option<f64> {
    match frame {
        // GLOBAL, GLOBAL_RELATIVE_ALT, GLOBAL_TERRAIN_ALT, each with and without `_INT`.
        0 | 3 | 5 | 6 | 10 | 11 => Some(1e7),
        // LOCAL_*, BODY_*, and what was local before it was reserved.
        1 | 4 | 7..=9 | 12..=21 => Some(1e4),
        // MISSION is no frame of coordinates.
        _ => None,
    }
}

/// Where a param stands.
fn offset(index: u8) -> usize {
    usize::from(index).wrapping_sub(1).wrapping_mul(4)
}

/// A float as the whole number that it is; `None` if it is none of 64 bits.
fn whole(float: f32) -> Option<u64> {
    // What is beyond would become the highest.
    const BEYOND: f32 = 18_446_744_073_709_551_616.0;
    let number = float as u64;
    (number as f32 == float && float < BEYOND).then_some(number)
}

/// The nearest integer, away from zero where two are equally near; `None` if it is no `i32`.
fn nearest(value: f64) -> Option<i32> {
    let cut = value as i64;
    // Exact below 2⁵³; what is beyond is refused anyway.
    let rest = value - cut as f64;
    let step = i64::from(rest >= 0.5) - i64::from(rest <= -0.5);
    i32::try_from(cut.saturating_add(step)).ok()
}
