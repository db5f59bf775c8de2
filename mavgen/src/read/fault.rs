//! What makes a text no XML: what quick-xml refuses, sorted by what we say of it.

use quick_xml::Error;
use quick_xml::errors::{IllFormedError, SyntaxError};

use crate::diag::Diagnostic;

/// What makes a text no XML. It ends the reading of the file.
pub(super) type Fault = Box<Diagnostic>;

/// Why quick-xml gave up.
pub(super) enum Reason {
    /// A document type declaration, whole or not.
    DocumentType,
    /// A `&` without its `;`.
    Reference,
    /// An attribute value that runs to the end of the file, and the quote that should have closed it.
    Quote(&'static str),
    /// Something else that runs to the end of the file, and what should have closed it.
    Unclosed {
        what: &'static str,
        end: &'static str,
    },
    Other(String),
}

pub(super) fn describe(error: &Error) -> Reason {
    match error {
        Error::Syntax(error) => syntax(*error),
        Error::IllFormed(IllFormedError::MissingDoctypeName) => Reason::DocumentType,
        Error::IllFormed(IllFormedError::UnclosedReference) => Reason::Reference,
        other => Reason::Other(other.to_string()),
    }
}

fn syntax(error: SyntaxError) -> Reason {
    let (what, end) = match error {
        SyntaxError::InvalidBangMarkup => {
            return Reason::Other("`<!` starts neither a comment nor a CDATA section".to_owned());
        }
        SyntaxError::UnclosedDoctype => return Reason::DocumentType,
        SyntaxError::UnclosedPI => ("a processing instruction", "?>"),
        SyntaxError::UnclosedXmlDecl => ("the XML declaration", "?>"),
        SyntaxError::UnclosedComment => ("a comment", "-->"),
        SyntaxError::UnclosedCData => ("a CDATA section", "]]>"),
        SyntaxError::UnclosedTag => ("a tag", ">"),
        SyntaxError::UnclosedSingleQuotedAttributeValue => return Reason::Quote("'"),
        SyntaxError::UnclosedDoubleQuotedAttributeValue => return Reason::Quote("\""),
    };
    Reason::Unclosed { what, end }
}
