//! The files that hold the others together: `mod.rs`, `messages.rs`, `enums.rs`.

use proc_macro2::TokenStream;
use quote::quote;

use crate::docs::first_sentence;
use crate::emit::token::{decimal, ident};
use crate::emit::{Context, doc, views as all_views};
use crate::ir::{Access, Name, Origin};
use crate::names::item_module_name;

/// `mod.rs`: modules and flat names, of what there is. It begins with an item, so that `include!` takes it.
pub(crate) fn root(context: &Context<'_>) -> TokenStream {
    let messages = &context.dialect.messages;
    let expect = expect_deprecated(messages.iter().any(|message| context.is_deprecated(&message.origin)));
    let dialect = ident(&context.dialect.type_name);
    let mut modules = Vec::new();
    let mut exports = Vec::new();
    if !messages.is_empty() {
        modules.push(quote!(#expect mod dialect;));
        exports.push(quote!(pub use dialect::#dialect;));
    }
    if !context.dialect.enums.is_empty() {
        modules.push(quote!(
            pub mod enums;
        ));
        exports.push(quote!(
            pub use enums::*;
        ));
    }
    if !messages.is_empty() {
        modules.push(quote!(
            pub mod messages;
        ));
        exports.push(quote!(
            pub use messages::*;
        ));
    }
    if all_views(context.dialect).next().is_some() {
        modules.push(quote!(
            pub mod views;
        ));
        exports.push(quote!(
            pub use views::*;
        ));
    }
    quote!(#(#modules)* #(#exports)*)
}

/// `messages.rs`, with a table of contents by id.
pub(crate) fn messages(context: &Context<'_>) -> TokenStream {
    let messages = &context.dialect.messages;
    let rows: Vec<_> = messages
        .iter()
        .map(|message| {
            let (id, link) = (message.id.to_string(), doc::link(&message.name));
            [id, link, first_sentence(&message.origin.description)]
        })
        .collect();
    let toc = doc::table(["id", "message", ""], &rows);
    let docs = doc::inner_attributes(&doc::join([vec!["The messages of the dialect, one type each.".to_owned()], toc]));
    let modules = messages.iter().map(|message| Module {
        name: &message.name,
        expect: context.names_deprecated(message),
        deprecated: context.is_deprecated(&message.origin),
    });
    let modules = declare(modules.collect());
    quote!(#docs #modules)
}

/// `enums.rs`, with a table of contents.
pub(crate) fn enums(context: &Context<'_>) -> TokenStream {
    let enums = &context.dialect.enums;
    let rows: Vec<_> = enums
        .iter()
        .map(|values| {
            let entries = decimal(values.entries.len() as u64).to_string();
            [entries, doc::link(&values.name), first_sentence(&values.origin.description)]
        })
        .collect();
    let toc = doc::table(["entries", "enum", ""], &rows);
    let docs = doc::inner_attributes(&doc::join([vec!["The enums and flags of the dialect.".to_owned()], toc]));
    let deprecated = |origin: &Origin| context.is_deprecated(origin);
    let modules = enums.iter().map(|values| Module {
        name: &values.name,
        expect: deprecated(&values.origin),
        deprecated: deprecated(&values.origin),
    });
    let modules = declare(modules.collect());
    quote!(#docs #modules)
}

/// `views.rs`: the views, and the slots that messages give them in.
pub(crate) fn views(context: &Context<'_>) -> TokenStream {
    let docs = doc::inner_attributes(&["Views of bits that are packed into fields.".to_owned()]);
    let views: Vec<_> = all_views(context.dialect).collect();
    let modules = views.iter().map(|(message, view)| {
        let expect = expect_deprecated(context.is_deprecated(&message.origin));
        let file = ident(&item_module_name(&view.name.xml));
        quote!(#expect mod #file;)
    });
    let exports = views.iter().map(|(_, view)| {
        let (file, name) = (ident(&item_module_name(&view.name.xml)), ident(&view.name.rust));
        match &view.access {
            Access::Once { .. } => quote!(pub use #file::#name;),
            Access::Slots(slots) => {
                let item = ident(&slots.item.rust);
                quote!(pub use #file::{#item, #name};)
            }
        }
    });
    quote!(#docs #(#modules)* #(#exports)*)
}

/// A file with one public type.
struct Module<'a> {
    name: &'a Name,
    /// Whether the file names something deprecated.
    expect: bool,
    /// Whether its type is deprecated.
    deprecated: bool,
}

/// `mod heartbeat; …`, then `pub use heartbeat::Heartbeat; …`, each by name.
fn declare(mut modules: Vec<Module<'_>>) -> TokenStream {
    modules.sort_by(|a, b| a.name.cmp(b.name));
    let declarations = modules.iter().map(|module| {
        let (expect, file) = (expect_deprecated(module.expect), ident(&item_module_name(&module.name.xml)));
        quote!(#expect mod #file;)
    });
    let exports = modules.iter().map(|module| {
        let (file, name) = (ident(&item_module_name(&module.name.xml)), ident(&module.name.rust));
        let expect = expect_deprecated(module.deprecated);
        quote!(#expect pub use #file::#name;)
    });
    quote!(#(#declarations)* #(#exports)*)
}

fn expect_deprecated(needed: bool) -> TokenStream {
    if needed { quote!(#[expect(deprecated, reason = "what is deprecated is still on the wire")]) } else { quote!() }
}
