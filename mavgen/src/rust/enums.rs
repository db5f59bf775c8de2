//! Enums, flags and commands; and the enum over all messages of a dialect.

use super::{Docs, Int, Method};
use crate::ir;

#[derive(Clone, Debug)]
pub(crate) struct Enum<'d> {
    pub(crate) ident: &'d str,
    /// The spelling of the XML, where it is another.
    pub(crate) alias: Option<&'d str>,
    pub(crate) docs: Docs<'d>,
    /// Why it is not to be used.
    pub(crate) deprecated: Option<String>,
    pub(crate) int: Int,
    pub(crate) flags: bool,
    pub(crate) constants: Vec<Constant<'d>>,
    pub(crate) methods: Vec<Method<'d>>,
    /// The parameters of commands, by value.
    pub(crate) params: Vec<(u64, Vec<ParamInfo<'d>>)>,
    /// The name in the XML.
    pub(crate) name: &'d str,
    /// The names of entries in the XML by value; of several for one value, the first is shown.
    pub(crate) entries: Vec<(u64, &'d str)>,
}

#[derive(Clone, Debug)]
pub(crate) struct Constant<'d> {
    pub(crate) ident: &'d str,
    pub(crate) docs: Docs<'d>,
    /// Why it is not to be used.
    pub(crate) deprecated: Option<String>,
    pub(crate) value: u64,
}

/// A parameter of a command, and the name in the XML of the enum that it carries.
#[derive(Clone, Debug)]
pub(crate) struct ParamInfo<'d> {
    pub(crate) param: &'d ir::Param,
    pub(crate) carries: Option<&'d str>,
}

/// The enum over all messages of a dialect.
#[derive(Clone, Debug)]
pub(crate) struct DialectEnum<'d> {
    pub(crate) ident: &'d str,
    pub(crate) docs: Docs<'d>,
    /// By id.
    pub(crate) variants: Vec<Variant<'d>>,
    /// The macro of the runtime that completes it: `dialect` or `topics`.
    pub(crate) completed_by: &'static str,
    /// Whether the macro does not implement `Debug`.
    pub(crate) derives_debug: bool,
}

/// A message of a dialect.
#[derive(Clone, Debug)]
pub(crate) struct Variant<'d> {
    pub(crate) ident: &'d str,
    pub(crate) docs: Docs<'d>,
}
