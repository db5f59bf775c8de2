//! A typed command: an entry of `MAV_CMD`, with its params as fields.

use super::{Docs, EnumType, Ty};

#[derive(Clone, Debug)]
pub(crate) struct Command<'d> {
    pub(crate) ident: &'d str,
    /// The entry in the XML, by which searches find the type.
    pub(crate) alias: &'d str,
    pub(crate) docs: Docs<'d>,
    /// Why it is not to be used.
    pub(crate) deprecated: Option<String>,
    pub(crate) id: u16,
    /// By param.
    pub(crate) fields: Vec<CommandField<'d>>,
    /// What is sent of params without a field, by their number, where that is not zero.
    pub(crate) fixed: Vec<(u8, f64)>,
}

/// The type that says which messages carry the commands of a module.
pub(crate) const CARRIERS: &str = "Carriers";

/// The messages that carry commands, as paths from the module of the commands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Carriers {
    pub(crate) long: Option<String>,
    /// `COMMAND_INT`, and the type of its frame.
    pub(crate) int: Option<(String, String)>,
}

/// A public field of a command.
#[derive(Clone, Debug)]
pub(crate) struct CommandField<'d> {
    pub(crate) ident: &'d str,
    /// The param: 1 to 7.
    pub(crate) index: u8,
    pub(crate) ty: ParamTy<'d>,
    /// The value in `DEFAULT`; of an enum a number that it has.
    pub(crate) default: f64,
    pub(crate) docs: Docs<'d>,
}

/// What a param is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ParamTy<'d> {
    /// A float in both messages.
    Float,
    /// Param 5 or 6: a float in one message, an integer in the other.
    Number,
    /// Param 5 or 6 of a place: in the other message scaled as the frame says.
    Place,
    Enum(EnumType<'d>),
}

impl<'d> ParamTy<'d> {
    pub(crate) fn ty(self) -> Ty<'d> {
        match self {
            Self::Float => Ty::F32,
            Self::Number | Self::Place => Ty::F64,
            Self::Enum(one) => Ty::Enum(one),
        }
    }
}
