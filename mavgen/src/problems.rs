//! What is wrong with a set of definitions.

use std::fmt;
use std::path::PathBuf;

use crate::diag::{Diagnostics, Style, render};
use crate::source::Sources;

/// The problems of a set of definitions.
#[derive(Debug, Default)]
pub struct Problems {
    /// The problems.
    pub diagnostics: Diagnostics,
    /// The texts that the spans point into.
    pub sources: Sources,
    /// Every file that was read, and every place where a missing include was looked for.
    pub watched: Vec<PathBuf>,
}

impl fmt::Display for Problems {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, diagnostic) in self.diagnostics.iter().enumerate() {
            let gap = if index == 0 { "" } else { "\n\n" };
            write!(f, "{gap}{}", render(diagnostic, &self.sources, Style::Plain))?;
        }
        Ok(())
    }
}
