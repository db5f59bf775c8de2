//! What is generated from: models without errors, and what everything in them is called.

use std::path::PathBuf;

use crate::Failure;
use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::ir::Dialect;
use crate::lower::link::Union;
use crate::lower::names::Names;
use crate::problems::Problems;
use crate::read::Loaded;
use crate::roots::{self, Named};
use crate::select::Selection;
use crate::source::Sources;

/// A dialect that was read and resolved without errors.
#[derive(Clone, Debug)]
pub struct Resolved {
    /// The model; of several dialects, the first.
    pub dialect: Dialect,
    /// The models of the other dialects, in the order in which they were named.
    pub others: Vec<Dialect>,
    /// What everything in the model is called in Rust.
    pub(crate) names: Names,
    /// What becomes of several dialects together; `None` if there is one.
    pub(crate) union: Option<Union>,
    /// What is worth a look: warnings and notes.
    pub diagnostics: Diagnostics,
    /// The texts that the spans point into.
    pub sources: Sources,
    /// Every file that was read.
    pub watched: Vec<PathBuf>,
}

impl Resolved {
    /// The ids of the messages that names like `HEARTBEAT` and patterns like `PARAM_*` mean.
    ///
    /// # Errors
    /// [`Failure::Usage`] if there is no name, or if one means no message.
    pub fn message_ids(&self, names: &[String]) -> Result<Vec<u32>, Failure> {
        let selection = Selection::new(names.iter().map(String::as_str)).map_err(Failure::Usage)?;
        selection.check(&[&self.dialect]).map_err(Failure::Usage)?;
        let meant = self.dialect.messages.iter().filter(|message| selection.has(&message.name.text));
        Ok(meant.map(|message| message.id).collect_vec())
    }

    /// Resolves a dialect that was read by [`read::load`](crate::read::load), or from memory by
    /// [`read::read`](crate::read::read). `diagnostics` holds what was found in reading it.
    ///
    /// # Errors
    /// With every problem.
    pub fn of(loaded: Loaded, sources: Sources, mut diagnostics: Diagnostics) -> Result<Self, Box<Problems>> {
        let named = roots::resolve(&loaded, &sources, &mut diagnostics);
        let watched = loaded.watched;
        match named {
            Some(Named { dialect, names }) => {
                Ok(Self { dialect, others: Vec::new(), names, union: None, diagnostics, sources, watched })
            }
            None => Err(Box::new(Problems { diagnostics, sources, watched })),
        }
    }
}
