//! The files of a tree, and how each names what stands in another.

use super::{Carriers, Command, DialectEnum, Docs, Enum, Struct, View};

/// A generated file.
#[derive(Clone, Debug)]
pub(crate) struct File<'d> {
    /// Where it belongs below the output folder, with `/` between folders.
    pub(crate) path: String,
    /// The lines above the code.
    pub(crate) header: String,
    /// What stands over the module.
    pub(crate) docs: Docs<'d>,
    pub(crate) uses: Vec<Use>,
    pub(crate) content: Content<'d>,
}

/// What is in a file.
#[derive(Clone, Debug)]
pub(crate) enum Content<'d> {
    /// Modules, and what they export.
    Module { children: Vec<Child>, exports: Vec<Export>, aliases: Vec<Alias<'d>> },
    /// A message.
    Message(Box<Struct<'d>>),
    /// A topic.
    #[cfg(feature = "uorb")]
    Topic(Box<super::Topic<'d>>),
    /// A view, and the slots that a message gives it in.
    View(Box<View<'d>>),
    /// An enum or a set of flags.
    Enum(Box<Enum<'d>>),
    /// The module of the commands, and what carries them.
    Commands(Box<Content<'d>>, Carriers),
    /// A typed command.
    Command(Box<Command<'d>>),
    /// The enum over all messages of a dialect.
    Dialect(DialectEnum<'d>),
}

/// `use super::super::enums::{MavState, MavType};`
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Use {
    /// These names of a module.
    Names(String, Vec<String>),
    /// Everything in a module.
    All(String),
    /// The runtime, as `wire`.
    Runtime(String),
    /// These functions that the runtime has for generated code.
    Generated(Vec<&'static str>),
}

/// `mod heartbeat;`
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Child {
    pub(crate) ident: String,
    pub(crate) access: ChildAccess,
    /// Whether it names what is deprecated.
    pub(crate) expect: bool,
}

/// Who sees a module.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ChildAccess {
    /// `mod`.
    Private,
    /// `#[doc(hidden)] pub mod`: what is in it has no other name than an alias, which does not make a type public for lints.
    Hidden,
    /// `pub mod`.
    Public,
}

/// The name by which a deprecated message is used: `#[deprecated(…)] pub type HilControls = hil_controls::HilControls;`.
///
/// The struct itself cannot have the attribute: its fields would inherit it, and each mention of one would warn.
#[derive(Clone, Debug)]
pub(crate) struct Alias<'d> {
    pub(crate) ident: &'d str,
    /// The spelling of the XML, where it is another.
    pub(crate) alias: Option<&'d str>,
    pub(crate) docs: Docs<'d>,
    /// Why it is not to be used.
    pub(crate) deprecated: String,
    /// The module that has the struct.
    pub(crate) module: &'d str,
}

/// `pub use heartbeat::Heartbeat;`
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Export {
    /// The names of a module, or everything in it.
    pub(crate) of: Use,
    /// Whether it names what is deprecated.
    pub(crate) expect: bool,
}
