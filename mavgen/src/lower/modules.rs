//! The modules that hold the others together: `mod.rs`, `messages.rs`, `enums.rs`, `views.rs`, `commands.rs`.

use super::docs;
use super::files::Maker;
use super::folder::{Commands, Listed};
use super::imports::MODULE;
use super::link::Placement;
use super::named::NamedAccess;
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::order;
use crate::rust::{Alias, Cell, Child, ChildAccess, Content, Docs, Export, File, Paragraph, Use};

/// A public type of a module.
struct Listing<'d> {
    /// Its name in the XML, which decides the order.
    name: &'d str,
    /// The file that has no other.
    module: &'d str,
    ident: &'d str,
    /// The folder of the file.
    placement: Placement,
    /// Whether the file names something deprecated.
    expect: bool,
    /// Whether its type is deprecated.
    deprecated: bool,
    /// The alias that its type is exported by, if it is not by its own name.
    alias: Option<Alias<'d>>,
}

/// `mod.rs`: modules and flat names, of what there is. It begins with an item, so that `include!` takes it.
///
/// What several dialects share has no flat names: those are their own.
pub(super) fn root<'d>(maker: &Maker<'_, 'd>) -> Result<File<'d>, Internal> {
    let folder = maker.folder;
    let child = |ident: &str, access, expect| Child { ident: ident.to_owned(), access, expect };
    let mut children = folder.roots.iter().map(|root| child(root, ChildAccess::Public, false)).collect_vec();
    let mut exports = Vec::new();
    if let Some(dialect) = folder.dialect.filter(|_| !folder.messages.is_empty()) {
        let mut expect = false;
        for listed in &folder.messages {
            expect |= maker.items.is_deprecated(&maker.items.message_at(listed.item)?.model.origin);
        }
        children.push(child("dialect", ChildAccess::Private, expect));
        exports.push(plain(Use::Names("dialect".to_owned(), vec![dialect.type_name.to_owned()])));
    }
    let parts = [
        ("enums", folder.enums.is_empty()),
        ("messages", folder.messages.is_empty()),
        ("views", folder.views.is_empty()),
    ];
    for (module, _) in parts.iter().filter(|(_, is_empty)| !is_empty) {
        children.push(child(module, ChildAccess::Public, false));
        exports.extend(folder.dialect.map(|_| plain(Use::All((*module).to_owned()))));
    }
    if let Some(commands) = folder.commands {
        // Their names are for themselves: a command may be called like a message.
        match commands.placement == folder.placement {
            true => {
                let expect = maker.items.names_deprecated(&commands.item)?;
                children.push(child("commands", ChildAccess::Public, expect));
            }
            false => exports.push(plain(Use::Names("super".to_owned(), vec!["commands".to_owned()]))),
        }
    }
    let docs = match (folder.placement, folder.dialect) {
        (Placement::Root(_), Some(dialect)) => {
            Docs::line(about(dialect.name, !folder.messages.is_empty(), dialect.type_name))
        }
        _ => Docs::default(),
    };
    let content = Content::Module { children, exports, aliases: Vec::new() };
    Ok(File { path: folder.file.clone(), header: maker.root_header()?, docs, uses: Vec::new(), content })
}

/// What stands over the module of a dialect.
fn about(name: &str, has_messages: bool, type_name: &str) -> String {
    match has_messages {
        true => {
            format!("The `{name}` dialect: its messages, its enums, and {} over all messages.", docs::link(type_name))
        }
        false => format!("The `{name}` dialect."),
    }
}

/// `messages.rs`, with a table of contents by id; the files of the messages go to `files`.
pub(super) fn messages<'d>(maker: &Maker<'_, 'd>, files: &mut Vec<File<'d>>) -> Result<File<'d>, Internal> {
    let (mut rows, mut listings) = (Vec::new(), Vec::new());
    for &Listed { item, placement } in &maker.folder.messages {
        let message = maker.items.message_at(item)?;
        let origin = &message.model.origin;
        let (id, link) = (message.model.id.to_string(), docs::link(message.ty()));
        rows.push(vec![Cell::Plain(id), Cell::Plain(link), Cell::FirstSentence(&origin.description)]);
        let (mut expect, mut alias) = (false, None);
        if placement == maker.folder.placement {
            let made = maker.message(item)?;
            (expect, alias) = (made.expect, made.alias);
            files.push(made.file);
        }
        let (name, module) = (&message.model.name.text, &message.names.module);
        let deprecated = maker.items.is_deprecated(origin);
        listings.push(Listing { name, module, ident: message.ty(), placement, expect, deprecated, alias });
    }
    let title = match maker.folder.dialect {
        Some(_) => "The messages of the dialect, one type each.",
        None => "The messages that are the same in all dialects that have them, one type each.",
    };
    let contents = Paragraph::Table(vec!["id", "message", ""], rows);
    module(maker, "messages", Docs::line(title).then(contents), declare(maker, "messages", listings)?)
}

/// `enums.rs`, with a table of contents; the files of the enums go to `files`.
pub(super) fn enums<'d>(maker: &Maker<'_, 'd>, files: &mut Vec<File<'d>>) -> Result<File<'d>, Internal> {
    let (mut rows, mut listings) = (Vec::new(), Vec::new());
    for &Listed { item, placement } in &maker.folder.enums {
        let one = maker.items.enum_at(item)?;
        let (model, ident) = (one.model, one.names.ty.as_str());
        let (entries, link) = (model.entries.len().to_string(), docs::link(ident));
        rows.push(vec![Cell::Plain(entries), Cell::Plain(link), Cell::FirstSentence(&model.origin.description)]);
        if placement == maker.folder.placement {
            files.push(maker.enum_(item)?.file);
        }
        let deprecated = maker.items.is_deprecated(&model.origin);
        let (name, module) = (&model.name.text, &one.names.module);
        listings.push(Listing { name, module, ident, placement, expect: deprecated, deprecated, alias: None });
    }
    let title = match maker.folder.dialect {
        Some(_) => "The enums and flags of the dialect.",
        None => "The enums and flags that are the same in all dialects that have them, with the constants of all.",
    };
    let contents = Paragraph::Table(vec!["entries", "enum", ""], rows);
    module(maker, "enums", Docs::line(title).then(contents), declare(maker, "enums", listings)?)
}

/// `views.rs`: the views, and the slots that messages give them in; their files go to `files`.
pub(super) fn views<'d>(maker: &Maker<'_, 'd>, files: &mut Vec<File<'d>>) -> Result<File<'d>, Internal> {
    let (mut children, mut exports) = (Vec::new(), Vec::new());
    for &Listed { item, placement } in &maker.folder.views {
        let view = maker.items.message_at(item.0)?.view(item.1)?;
        let module = &view.names.module;
        let from = if placement == maker.folder.placement {
            let made = maker.view(item)?;
            files.push(made.file);
            children.push(Child { ident: module.clone(), access: ChildAccess::Private, expect: made.expect });
            module.clone()
        } else {
            maker.items.way(MODULE, placement)? + "views"
        };
        let types = match view.access()? {
            NamedAccess::Once(_) | NamedAccess::Record(_) => vec![view.ty()],
            NamedAccess::Slots(slots) => vec![slots.item, view.ty()],
        };
        exports.push(plain(Use::Names(from, types.into_iter().map(str::to_owned).collect_vec())));
    }
    let docs = Docs::line("What overlays see in fields: packed bits, and values.");
    module(maker, "views", docs, Content::Module { children, exports, aliases: Vec::new() })
}

/// `commands.rs`, with a table of contents by number; the files of the commands go to `files`.
pub(super) fn commands<'d>(
    maker: &Maker<'_, 'd>,
    commands: Commands,
    files: &mut Vec<File<'d>>,
) -> Result<File<'d>, Internal> {
    let (mut rows, mut listings) = (Vec::new(), Vec::new());
    for command in maker.items.enum_at(commands.enum_)?.commands() {
        let (origin, ident) = (&command.entry.origin, command.names.ty.as_str());
        let (id, link) = (command.entry.value.to_string(), docs::link(ident));
        rows.push(vec![Cell::Plain(id), Cell::Plain(link), Cell::FirstSentence(&origin.description)]);
        let made = maker.command(command)?;
        files.push(made.file);
        listings.push(Listing {
            name: &command.entry.name.text,
            module: &command.names.module,
            ident,
            placement: maker.folder.placement,
            expect: made.expect,
            deprecated: maker.items.is_deprecated(origin),
            alias: made.alias,
        });
    }
    let title = "The commands of the dialect, one type each, with the parameters that have a name.";
    let contents = Paragraph::Table(vec!["command", "type", ""], rows);
    let content = Content::Commands(Box::new(declare(maker, "commands", listings)?), maker.items.carriers(&commands)?);
    let file = module(maker, "commands", Docs::line(title).then(contents), content)?;
    Ok(File { uses: vec![maker.runtime()], ..file })
}

fn module<'d>(maker: &Maker<'_, 'd>, name: &str, docs: Docs<'d>, content: Content<'d>) -> Result<File<'d>, Internal> {
    let (path, header) = (maker.path(&format!("{name}.rs")), maker.header(&[])?);
    Ok(File { path, header, docs, uses: Vec::new(), content })
}

/// `mod heartbeat; …`, then `pub use heartbeat::Heartbeat; …`, each by name; then what other folders declare, and aliases.
fn declare<'d>(maker: &Maker<'_, 'd>, module: &str, mut listings: Vec<Listing<'d>>) -> Result<Content<'d>, Internal> {
    order::sort_by_key(&mut listings, |listing| (listing.name, listing.ident));
    let (mut children, mut exports, mut aliases) = (Vec::new(), Vec::new(), Vec::new());
    let mut others: Vec<((String, bool), Vec<String>)> = Vec::new();
    for Listing { name: _, module: file, ident, placement, expect, deprecated, alias } in listings {
        if placement == maker.folder.placement {
            let access = if alias.is_some() { ChildAccess::Hidden } else { ChildAccess::Private };
            children.push(Child { ident: file.to_owned(), access, expect });
            match alias {
                Some(alias) => aliases.push(alias),
                None => {
                    let of = Use::Names(file.to_owned(), vec![ident.to_owned()]);
                    exports.push(Export { of, expect: deprecated });
                }
            }
        } else {
            let way = maker.items.way(MODULE, placement)? + module;
            let from = (way, deprecated);
            match others.iter_mut().find(|(known, _)| *known == from) {
                Some((_, names)) => names.push(ident.to_owned()),
                None => others.push((from, vec![ident.to_owned()])),
            }
        }
    }
    order::sort_by_key(&mut others, |(from, _)| from.clone());
    exports.extend(others.into_iter().map(|((way, expect), names)| Export { of: Use::Names(way, names), expect }));
    Ok(Content::Module { children, exports, aliases })
}

fn plain(of: Use) -> Export {
    Export { of, expect: false }
}
