//! The files of a tree, and how each names what stands in another.

use super::{Carriers, Command, DialectEnum, Docs, Enum, Struct, View};

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

impl<'d> File<'d> {
    /// One with nothing over its code, which imports nothing.
    pub(crate) fn of(path: String, header: String, content: Content<'d>) -> Self {
        Self { path, header, docs: Docs::default(), uses: Vec::new(), content }
    }
}

/// What is in a file.
#[derive(Clone, Debug)]
pub(crate) enum Content<'d> {
    /// Modules, and what they export.
    Module {
        children: Vec<Child>,
        exports: Vec<Export>,
        aliases: Vec<Alias<'d>>,
    },
    Message(Box<Struct<'d>>),
    #[cfg(feature = "uorb")]
    Topic(Box<super::Topic<'d>>),
    /// A view, and the slots that a message gives it in.
    View(Box<View<'d>>),
    Enum(Box<Enum<'d>>),
    /// The module of the commands, and what carries them.
    Commands(Box<Content<'d>>, Carriers),
    Command(Box<Command<'d>>),
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

impl Use {
    /// This name of a module.
    pub(crate) fn one(module: &str, name: &str) -> Self {
        Self::Names(module.to_owned(), vec![name.to_owned()])
    }
}

/// `mod heartbeat;`
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Child {
    pub(crate) ident: String,
    pub(crate) access: ChildAccess,
    /// Whether it names what is deprecated.
    pub(crate) expect: bool,
    /// The cargo feature that compiles it, if it is not always compiled.
    pub(crate) feature: Option<String>,
}

impl Child {
    /// One that names nothing that is deprecated.
    pub(crate) fn of(ident: &str, access: ChildAccess) -> Self {
        Self { ident: ident.to_owned(), access, expect: false, feature: None }
    }
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
    /// The cargo feature that compiles it, if it is not always compiled.
    pub(crate) feature: Option<String>,
}

impl From<Use> for Export {
    /// One that names nothing that is deprecated.
    fn from(of: Use) -> Self {
        Self { of, expect: false, feature: None }
    }
}
