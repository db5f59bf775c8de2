//! Where a component has its parameters.

use super::{Name, Param, ParamValue, is_same};
use crate::common::MavParamError;

/// The parameters of a component, in an order that does not change.
///
/// Arrays, slices and vectors of [`Param`] are such tables, which take any value. Implement it to check values, to compute
/// them, or to keep them elsewhere.
///
/// ```
/// use mavlink_services::common::MavParamError;
/// use mavlink_services::param::{Name, Param, ParamValue, Parameters};
///
/// struct Tuning { rate_p: f32 }
///
/// impl Parameters for Tuning {
///     fn count(&self) -> u16 { 1 }
///
///     fn get(&self, index: u16) -> Option<Param> {
///         (index == 0).then(|| Param::new("RATE_P", self.rate_p))
///     }
///
///     fn set(&mut self, _index: u16, value: ParamValue) -> Result<(), MavParamError> {
///         match value {
///             ParamValue::F32(value @ 0.0..1.0) => self.rate_p = value,
///             _ => return Err(MavParamError::VALUE_OUT_OF_RANGE),
///         }
///         Ok(())
///     }
/// }
///
/// let mut tuning = Tuning { rate_p: 0.2 };
/// assert_eq!(tuning.find(&Name::truncated("RATE_P")), Some(0));
/// assert_eq!(tuning.set(0, ParamValue::F32(7.0)), Err(MavParamError::VALUE_OUT_OF_RANGE));
/// ```
pub trait Parameters {
    /// How many there are; at most 32,767 can be asked for by index.
    fn count(&self) -> u16;

    /// The one at this place.
    fn get(&self, index: u16) -> Option<Param>;

    /// Gives one another value, which has its type.
    ///
    /// # Errors
    ///
    /// It keeps its value, for this reason.
    fn set(&mut self, index: u16, value: ParamValue) -> Result<(), MavParamError>;

    /// Where the one with this name is. Looks at one after the other, unless you know better.
    fn find(&self, name: &Name) -> Option<u16> {
        (0..self.count()).find(|index| self.get(*index).is_some_and(|param| is_same(&param.name, name)))
    }
}

impl<S: AsRef<[Param]> + AsMut<[Param]>> Parameters for S {
    fn count(&self) -> u16 {
        u16::try_from(self.as_ref().len()).unwrap_or(u16::MAX)
    }

    fn get(&self, index: u16) -> Option<Param> {
        self.as_ref().get(usize::from(index)).copied()
    }

    fn set(&mut self, index: u16, value: ParamValue) -> Result<(), MavParamError> {
        let param = self.as_mut().get_mut(usize::from(index)).ok_or(MavParamError::DOES_NOT_EXIST)?;
        param.value = value;
        Ok(())
    }
}
