//! What makes a text no XML. It ends the reading of the file.

use crate::diag::{Code, Diagnostic};
use crate::source::Span;

pub(super) type Fault = Box<Diagnostic>;

pub(super) fn not_well_formed(span: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(Code::NotWellFormed, span, message)
}
