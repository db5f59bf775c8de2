//! Why nothing was generated.

use std::fmt;

use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::Fault;
use crate::output::OutputError;
use crate::problems::Problems;

/// Why nothing was generated. `Display` shows every problem with its place.
#[derive(Debug)]
#[non_exhaustive]
pub enum Failure {
    /// The definitions are wrong.
    Definitions(Box<Problems>),
    /// There are warnings, and [`Builder::deny_warnings`](crate::Builder::deny_warnings) was asked for; these are they.
    Denied(Box<Problems>),
    /// The output folder could not be read or written.
    Output(OutputError),
    /// The builder was told something impossible.
    Usage(String),
    /// A model is not legal, because somebody changed it after it was resolved.
    Model(Vec<Fault>),
    /// A mistake of mavgen's own, and nothing of its user's: please report it.
    Internal(String),
}

/// What is said after warnings that were denied.
const DENIED: &str = "warnings about the dialect's own file and its overlays are denied";

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Definitions(problems) => problems.fmt(f),
            Self::Denied(problems) => write!(f, "{problems}\n\nerror: {DENIED}"),
            Self::Output(error) => error.fmt(f),
            Self::Usage(text) => f.write_str(text),
            Self::Model(faults) => {
                let faults = faults.iter().map(Fault::to_string).collect_vec();
                write!(f, "the model is not legal:\n{}", faults.join("\n"))
            }
            Self::Internal(text) => write!(f, "mavgen is wrong: {text}"),
        }
    }
}

impl From<Internal> for Failure {
    fn from(internal: Internal) -> Self {
        Self::Internal(internal.to_string())
    }
}

impl std::error::Error for Failure {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Output(error) => Some(error),
            _ => None,
        }
    }
}
