//! The *emit* stage: from the Rust model to the text of files.
//!
//! It looks nothing up and decides nothing: an emitter is a template that looks like its output, of which `mavgen/tests/golden`
//! has small examples for each construct. Each file is a job of its own, so that threads can share the work, the wrapping of prose and
//! the formatting with it; the result does not depend on how they do.

mod body;
mod command;
mod dialect;
mod doc;
mod enums;
mod field;
mod message;
mod method;
mod modules;
mod token;
#[cfg(feature = "uorb")]
mod topic;
mod ty;
mod view;

pub use token::is_identifier;
pub(crate) use token::is_path;

use crate::format::Layout;
use crate::internal::Internal;
use crate::rust::{Content, File};
use crate::threads;
use crate::tokens::{ToTokens, TokenStream, quote};

/// A generated file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GeneratedFile {
    /// Where it belongs below the output folder, with `/` between folders.
    pub path: String,
    /// Its text.
    pub text: String,
}

/// Emits every file, in their order.
pub(crate) fn emit(files: &[File<'_>], layout: Layout) -> Result<Vec<GeneratedFile>, Internal> {
    threads::in_order(files, |file| generate(file, layout)).into_iter().collect()
}

fn generate(file: &File<'_>, layout: Layout) -> Result<GeneratedFile, Internal> {
    let File { path, header, docs, uses, content } = file;
    let items = quote!(#{doc::inner_documentation(docs)} #(for used in uses => use #used;)* #content);
    Ok(GeneratedFile { path: path.clone(), text: format!("{header}\n\n{}", layout.text(&items)?) })
}

/// The items of a file.
impl ToTokens for Content<'_> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        match self {
            Content::Module { children, exports, aliases } => modules::module(children, exports, aliases),
            Content::Commands(module, carriers) => quote!(#module #{command::carriers(carriers)}),
            Content::Message(message) => message::message(message),
            #[cfg(feature = "uorb")]
            Content::Topic(topic) => topic::topic(topic),
            Content::View(view) => view::view(view),
            Content::Enum(one) => enums::enum_(one),
            Content::Command(command) => command::command(command),
            Content::Dialect(dialect) => dialect::dialect(dialect),
        }
        .to_tokens(tokens);
    }
}
