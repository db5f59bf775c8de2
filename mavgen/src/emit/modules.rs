//! The files that hold the others together: `mod.rs`, `messages.rs`, `enums.rs`.

use std::collections::BTreeMap;

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use crate::emit::folder::{Folder, Listed};
use crate::emit::place::path;
use crate::emit::token::{decimal, ident};
use crate::emit::{Context, dialect as dialects, doc};
use crate::ir::{Access, Message, Name, Origin, View};
use crate::lower::link::Home;
use crate::lower::spelling::item_module_name;
use crate::lower::{Internal, docs};
use crate::rust::{Cell, Docs, Mentions, Paragraph};

/// `mod.rs`: modules and flat names, of what there is. It begins with an item, so that `include!` takes it.
///
/// What several dialects share has no flat names: those are their own.
pub(crate) fn root(context: &Context<'_>, folder: &Folder<'_>) -> TokenStream {
    let mut modules: Vec<TokenStream> = Vec::new();
    let mut exports = Vec::new();
    if let Some(dialect) = folder.dialect.filter(|_| !folder.messages.is_empty()) {
        let deprecated = folder.messages.iter().any(|listed| context.is_deprecated(&listed.item.origin));
        let (expect, name) = (expect_deprecated(deprecated), ident(dialect.type_name));
        modules.push(quote!(#expect mod dialect;));
        exports.push(quote!(pub use dialect::#name;));
    }
    let parts = [
        ("enums", folder.enums.is_empty()),
        ("messages", folder.messages.is_empty()),
        ("views", folder.views.is_empty()),
    ];
    for module in parts.iter().filter(|(_, is_empty)| !is_empty).map(|(name, _)| ident(name)) {
        modules.push(quote!(pub mod #module;));
        exports.extend(folder.dialect.map(|_| quote!(pub use #module::*;)));
    }
    let roots = folder.roots.iter().map(|root| ident(root));
    let docs = match (folder.home, folder.dialect) {
        (Home::Root(_), Some(dialect)) => {
            doc::inner_attributes(&about(dialect.name, !folder.messages.is_empty(), dialect.type_name))
        }
        _ => TokenStream::new(),
    };
    quote!(#docs #(pub mod #roots;)* #(#modules)* #(#exports)*)
}

/// What stands over the module of a dialect.
fn about(name: &str, has_messages: bool, type_name: &str) -> Vec<String> {
    vec![match has_messages {
        true => format!("The `{name}` dialect: its messages, its enums, and [`{type_name}`] over all messages."),
        false => format!("The `{name}` dialect."),
    }]
}

/// `dialect.rs`.
pub(crate) fn dialect(context: &Context<'_>, folder: &Folder<'_>) -> TokenStream {
    let messages: Vec<&Message> = folder.messages.iter().map(|listed| listed.item).collect();
    folder.dialect.map(|dialect| dialects::dialect(context, dialect, &messages)).unwrap_or_default()
}

/// `messages.rs`, with a table of contents by id.
pub(crate) fn messages(context: &Context<'_>, folder: &Folder<'_>) -> Result<TokenStream, Internal> {
    let messages = &folder.messages;
    let rows: Vec<_> = messages
        .iter()
        .map(|Listed { item, .. }| {
            let (id, link) = (item.id.to_string(), docs::link(&item.name.rust));
            vec![Cell::Plain(id), Cell::Plain(link), Cell::FirstSentence(&item.origin.description)]
        })
        .collect();
    let toc = Paragraph::Table(vec!["id", "message", ""], rows);
    let title = match folder.dialect {
        Some(_) => "The messages of the dialect, one type each.",
        None => "The messages that are the same in all dialects that have them, one type each.",
    };
    let docs = doc::inner_attributes(&doc::lines(&Docs(vec![Paragraph::line(title), toc])));
    let modules = messages.iter().map(|&Listed { item, home }| {
        let deprecated = context.is_deprecated(&item.origin);
        let alias = if deprecated { context.deprecated_name(item)? } else { None };
        Ok(Module { name: &item.name, home, expect: context.names_deprecated(item), deprecated, alias })
    });
    let modules = declare(context, "messages", modules.collect::<Result<_, Internal>>()?);
    Ok(quote!(#docs #modules))
}

/// `enums.rs`, with a table of contents.
pub(crate) fn enums(context: &Context<'_>, folder: &Folder<'_>) -> TokenStream {
    let enums = &folder.enums;
    let rows: Vec<_> = enums
        .iter()
        .map(|Listed { item, .. }| {
            let entries = decimal(item.entries.len() as u64).to_string();
            let link = docs::link(&item.name.rust);
            vec![Cell::Plain(entries), Cell::Plain(link), Cell::FirstSentence(&item.origin.description)]
        })
        .collect();
    let toc = Paragraph::Table(vec!["entries", "enum", ""], rows);
    let title = match folder.dialect {
        Some(_) => "The enums and flags of the dialect.",
        None => "The enums and flags that are the same in all dialects that have them, with the constants of all.",
    };
    let docs = doc::inner_attributes(&doc::lines(&Docs(vec![Paragraph::line(title), toc])));
    let deprecated = |origin: &Origin| context.is_deprecated(origin);
    let modules = enums.iter().map(|&Listed { item, home }| Module {
        name: &item.name,
        home,
        expect: deprecated(&item.origin),
        deprecated: deprecated(&item.origin),
        alias: None,
    });
    let modules = declare(context, "enums", modules.collect());
    quote!(#docs #modules)
}

/// `views.rs`: the views, and the slots that messages give them in.
pub(crate) fn views(context: &Context<'_>, folder: &Folder<'_>) -> Result<TokenStream, Internal> {
    let docs = doc::inner_attributes(&["Views of bits that are packed into fields.".to_owned()]);
    let own = folder.views.iter().filter(|listed| listed.home == folder.home);
    let modules = own.map(|Listed { item: (message, view), .. }| {
        let named = Mentions::of_view(&context.items().view(message, view)?);
        let expect = expect_deprecated(context.is_deprecated(&message.origin) || named.is_any_deprecated());
        let file = ident(&item_module_name(&view.name.text));
        Ok(quote!(#expect mod #file;))
    });
    let modules = modules.collect::<Result<Vec<_>, Internal>>()?;
    let exports = folder.views.iter().map(|Listed { item: (_, view), home }| {
        let from = if *home == folder.home {
            ident(&item_module_name(&view.name.text)).into_token_stream()
        } else {
            let way = path(&context.way(1, *home));
            quote!(#way views)
        };
        view_export(&from, view)
    });
    Ok(quote!(#docs #(#modules)* #(#exports)*))
}

fn view_export(from: &TokenStream, view: &View) -> TokenStream {
    let name = ident(&view.name.rust);
    match &view.access {
        Access::Once { .. } => quote!(pub use #from::#name;),
        Access::Slots(slots) => {
            let item = ident(&slots.item.rust);
            quote!(pub use #from::{#item, #name};)
        }
    }
}

/// A public type, and the file that has no other.
struct Module<'a> {
    name: &'a Name,
    /// The folder of the file.
    home: Home,
    /// Whether the file names something deprecated.
    expect: bool,
    /// Whether its type is deprecated.
    deprecated: bool,
    /// The alias that its type is exported by, if it is not by its own name.
    alias: Option<TokenStream>,
}

/// `mod heartbeat; …`, then `pub use heartbeat::Heartbeat; …`, each by name; then what other folders declare, and aliases.
fn declare(context: &Context<'_>, module: &str, mut modules: Vec<Module<'_>>) -> TokenStream {
    modules.sort_by(|a, b| a.name.cmp(b.name));
    let (own, others): (Vec<_>, Vec<_>) = modules.into_iter().partition(|module| module.home == context.home);
    let declarations = own.iter().map(|module| {
        let (expect, file) = (expect_deprecated(module.expect), ident(&item_module_name(&module.name.text)));
        quote!(#expect mod #file;)
    });
    let exports = own.iter().filter(|module| module.alias.is_none()).map(|module| {
        let (file, name) = (ident(&item_module_name(&module.name.text)), ident(&module.name.rust));
        let expect = expect_deprecated(module.deprecated);
        quote!(#expect pub use #file::#name;)
    });
    let reexports = reexports(context, module, &others);
    let aliases = own.iter().filter_map(|module| module.alias.as_ref());
    quote!(#(#declarations)* #(#exports)* #reexports #(#aliases)*)
}

/// `pub use super::super::messages::{Heartbeat, SystemTime};`, for each folder, those that are deprecated for themselves.
fn reexports(context: &Context<'_>, module: &str, others: &[Module<'_>]) -> TokenStream {
    let mut groups: BTreeMap<(String, bool), Vec<Ident>> = BTreeMap::new();
    for other in others {
        let group = groups.entry((context.way(1, other.home), other.deprecated)).or_default();
        group.push(ident(&other.name.rust));
    }
    let module = ident(module);
    let uses = groups.iter().map(|((way, deprecated), names)| {
        let (way, expect) = (path(way), expect_deprecated(*deprecated));
        quote!(#expect pub use #way #module::{#(#names),*};)
    });
    uses.collect()
}

fn expect_deprecated(needed: bool) -> TokenStream {
    if needed { quote!(#[expect(deprecated, reason = "what is deprecated is still on the wire")]) } else { quote!() }
}
