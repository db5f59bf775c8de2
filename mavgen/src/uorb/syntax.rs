//! A `.msg` file as it is written: every spelling with its place, nothing looked up.

use crate::source::{FileId, Span, Spanned};

/// A `.msg` file.
#[derive(Clone, Debug)]
pub struct MsgFile {
    /// The file.
    pub id: FileId,
    /// The lines of the comment that the file begins with.
    pub about: Vec<String>,
    /// What `# TOPICS` lines name.
    pub topics: Vec<Spanned<String>>,
    /// Fields, in the order of the file.
    pub fields: Vec<FieldSyntax>,
    /// Constants, in the order of the file.
    pub constants: Vec<ConstantSyntax>,
}

/// `float32[3] position # [m] where it is`
#[derive(Clone, Debug)]
pub struct FieldSyntax {
    /// The type, without the length of an array.
    pub element: Spanned<String>,
    /// The length of an array.
    pub array: Option<Spanned<u16>>,
    /// The name.
    pub name: Spanned<String>,
    /// What the comments say.
    pub comment: Comment,
}

/// `uint8 FAILURE_OVER_RPM = 3 # too fast`
#[derive(Clone, Debug)]
pub struct ConstantSyntax {
    /// The type.
    pub element: Spanned<String>,
    /// The name.
    pub name: Spanned<String>,
    /// The value.
    pub value: Spanned<i128>,
    /// What the comments say.
    pub comment: Comment,
}

/// The comment of a line, and of the comment lines directly before it.
#[derive(Clone, Debug, Default)]
pub struct Comment {
    /// The bracket groups that it begins with.
    pub groups: Vec<Group>,
    /// The prose behind them, line by line.
    pub lines: Vec<String>,
}

/// `[m/s]`, `[@range 0, 1]`: a bracket group that a comment begins with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// What it is.
    pub kind: GroupKind,
    /// Where it stands, brackets included.
    pub span: Span,
}

/// What a bracket group says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum GroupKind {
    /// `[m/s]`; `[-]` says that there is no unit and is left out.
    Units(String),
    /// `[@enum P Q]`: the prefixes of the constants that the field takes.
    Enum(Vec<String>),
    /// `[@range a, b]`: the smallest and the largest value, either of which may be missing.
    Range(String, String),
    /// `[@invalid V text]`: the value that says "not known", and what is said of it.
    Invalid(String),
    /// `[@frame F]`: the frame of reference.
    Frame(String),
}
