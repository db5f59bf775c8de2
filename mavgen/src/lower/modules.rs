//! The modules that hold the others together: `mod.rs`, `messages.rs`, `enums.rs`, `views.rs`, `commands.rs`.

use super::docs;
use super::files::{Made, Maker, header, root_header};
use super::folder::CommandSet;
use super::imports::MODULE;
use super::items::NamedMessage;
use super::link::Placement;
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::Origin;
use crate::order;
use crate::rust::{Cell, Child, ChildAccess, Content, Docs, Export, File, Paragraph, Use};

/// A public type of a module.
struct Listing<'d> {
    /// What stands before it in the table of contents.
    cell: String,
    origin: &'d Origin,
    /// Its name in the XML, which decides the order.
    name: &'d str,
    /// The file that has no other.
    module: &'d str,
    ident: &'d str,
    /// The folder of the file.
    placement: Placement,
    /// What this module has to know of the file, if the file is in this folder.
    made: Option<Made<'d>>,
}

/// `mod.rs`: modules and flat names, of what there is. It begins with an item, so that `include!` takes it.
///
/// What several dialects share has no flat names: those are their own.
pub(super) fn root<'d>(maker: &Maker<'_, 'd>) -> Result<File<'d>, Internal> {
    let folder = maker.folder;
    let mut children = folder.roots.iter().map(|root| Child::of(root, ChildAccess::Public)).collect_vec();
    let mut exports = Vec::<Export>::new();
    if let Some(dialect) = folder.dialect.filter(|_| !folder.messages.is_empty()) {
        let mut expect = false;
        for at in &folder.messages {
            expect |= maker.items.is_deprecated(&maker.items.message_at(*at)?.model.origin);
        }
        children.push(Child { expect, ..Child::of("dialect", ChildAccess::Private) });
        exports.push(Use::one("dialect", dialect.type_name).into());
    }
    let parts = [
        ("enums", folder.enums.is_empty()),
        ("messages", folder.messages.is_empty()),
        ("views", folder.views.is_empty()),
    ];
    for (module, _) in parts.iter().filter(|(_, is_empty)| !is_empty) {
        children.push(Child::of(module, ChildAccess::Public));
        exports.extend(folder.dialect.map(|_| Use::All((*module).to_owned()).into()));
    }
    let feature = maker.options.commands.feature().map(str::to_owned);
    match maker.commands() {
        // Their names are for themselves: a command may be called like a message.
        Some((commands, placement)) if placement == folder.placement => {
            let expect = maker.items.names_deprecated(&commands)?;
            children.push(Child { expect, feature, ..Child::of("commands", ChildAccess::Public) });
        }
        Some(_) => exports.push(Export { feature, ..Use::one("super", "commands").into() }),
        None => {}
    }
    let header = header(&folder.sources);
    let (header, docs) = match (folder.placement, folder.dialect) {
        (Placement::Shared, _) => (root_header(&header, maker.options), Docs::default()),
        (Placement::Root(_), Some(dialect)) => {
            (header, Docs::line(about(dialect.name, !folder.messages.is_empty(), dialect.type_name)))
        }
        (Placement::Root(_), None) => (header, Docs::default()),
    };
    let content = Content::Module { children, exports, aliases: Vec::new() };
    Ok(File { docs, ..File::of(folder.file.clone(), header, content) })
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
    let mut listings = Vec::new();
    for &at in &maker.folder.messages {
        let (NamedMessage { model, names }, placement) = (maker.items.message_at(at)?, maker.items.message_home(at)?);
        let is_here = placement == maker.folder.placement;
        listings.push(Listing {
            cell: model.id.to_string(),
            origin: &model.origin,
            name: &model.name.text,
            module: &names.module,
            ident: &names.ty,
            placement,
            made: is_here.then(|| maker.message(at, files)).transpose()?,
        });
    }
    let title = match maker.folder.dialect {
        Some(_) => "The messages of the dialect, one type each.",
        None => "The messages that are the same in all dialects that have them, one type each.",
    };
    contents(maker, ("messages", title, ["id", "message"]), listings)
}

/// `enums.rs`, with a table of contents; the files of the enums go to `files`.
pub(super) fn enums<'d>(maker: &Maker<'_, 'd>, files: &mut Vec<File<'d>>) -> Result<File<'d>, Internal> {
    let mut listings = Vec::new();
    for &id in &maker.folder.enums {
        let (one, placement) = (maker.items.enum_at(id)?, maker.items.enum_home(id)?);
        let is_here = placement == maker.folder.placement;
        listings.push(Listing {
            cell: one.model.entries.len().to_string(),
            origin: &one.model.origin,
            name: &one.model.name.text,
            module: &one.names.module,
            ident: &one.names.ty,
            placement,
            made: is_here.then(|| maker.enum_(id, files)).transpose()?,
        });
    }
    let title = match maker.folder.dialect {
        Some(_) => "The enums and flags of the dialect.",
        None => "The enums and flags that are the same in all dialects that have them, with the constants of all.",
    };
    contents(maker, ("enums", title, ["entries", "enum"]), listings)
}

/// `views.rs`: the views, and the slots that messages give them in; their files go to `files`.
pub(super) fn views<'d>(maker: &Maker<'_, 'd>, files: &mut Vec<File<'d>>) -> Result<File<'d>, Internal> {
    let (mut children, mut exports) = (Vec::new(), Vec::new());
    for &at in &maker.folder.views {
        let (view, placement) = (maker.items.message_at(at.0)?.view(at.1)?, maker.items.view_home(at)?);
        let module = &view.names.module;
        let from = if placement == maker.folder.placement {
            let expect = maker.view(at, files)?.expect;
            children.push(Child { expect, ..Child::of(module, ChildAccess::Private) });
            module.clone()
        } else {
            maker.items.way(MODULE, placement)? + "views"
        };
        let types = view.names.slots.iter().map(|slots| &slots.ty).chain([&view.names.ty]);
        exports.push(Use::Names(from, types.cloned().collect_vec()).into());
    }
    let content = Content::Module { children, exports, aliases: Vec::new() };
    let file = maker.file("views.rs", &[], Vec::new(), content)?;
    Ok(File { docs: Docs::line("What overlays see in fields: packed bits, and values."), ..file })
}

/// `commands.rs`, with a table of contents by number; the files of the commands go to `files`.
pub(super) fn commands<'d>(
    maker: &Maker<'_, 'd>,
    commands: CommandSet,
    files: &mut Vec<File<'d>>,
) -> Result<File<'d>, Internal> {
    let mut listings = Vec::new();
    for command in maker.items.enum_at(commands.enum_)?.commands() {
        listings.push(Listing {
            cell: command.entry.value.to_string(),
            origin: &command.entry.origin,
            name: &command.entry.name.text,
            module: &command.names.module,
            ident: &command.names.ty,
            placement: maker.folder.placement,
            made: Some(maker.command(command, files)?),
        });
    }
    let title = "The commands of the dialect, one type each, with the parameters that have a name.";
    let file = contents(maker, ("commands", title, ["command", "type"]), listings)?;
    let content = Content::Commands(Box::new(file.content), maker.items.carriers(&commands)?);
    Ok(File { uses: vec![maker.runtime()], content, ..file })
}

/// A module of types: its name, a line on what is in it, and the heads of its table of contents. The table has the types in the
/// order of `listings`, the code has them by name.
fn contents<'d>(
    maker: &Maker<'_, 'd>,
    (name, title, [first, second]): (&str, &str, [&'d str; 2]),
    listings: Vec<Listing<'d>>,
) -> Result<File<'d>, Internal> {
    let rows = listings.iter().map(|Listing { cell, origin, ident, .. }| {
        vec![Cell::Plain(cell.clone()), Cell::Plain(docs::link(ident)), Cell::FirstSentence(&origin.description)]
    });
    let contents = Paragraph::Table(vec![first, second, ""], rows.collect_vec());
    let file = maker.file(&format!("{name}.rs"), &[], Vec::new(), declare(maker, name, listings)?)?;
    Ok(File { docs: Docs::line(title).then(contents), ..file })
}

/// `mod heartbeat; …`, then `pub use heartbeat::Heartbeat; …`, each by name; then what other folders declare, and aliases.
fn declare<'d>(maker: &Maker<'_, 'd>, name: &str, mut listings: Vec<Listing<'d>>) -> Result<Content<'d>, Internal> {
    order::sort_by_key(&mut listings, |listing| (listing.name, listing.ident));
    let (mut children, mut exports, mut aliases) = (Vec::new(), Vec::new(), Vec::new());
    let mut others: Vec<((String, bool), Vec<String>)> = Vec::new();
    for Listing { origin, module, ident, placement, made, .. } in listings {
        let deprecated = maker.items.is_deprecated(origin);
        match made {
            Some(Made { expect, alias }) => {
                let access = if alias.is_some() { ChildAccess::Hidden } else { ChildAccess::Private };
                children.push(Child { expect, ..Child::of(module, access) });
                match alias {
                    Some(alias) => aliases.push(alias),
                    None => exports.push(Export { expect: deprecated, ..Use::one(module, ident).into() }),
                }
            }
            None => {
                let from = (maker.items.way(MODULE, placement)? + name, deprecated);
                match others.iter_mut().find(|(known, _)| *known == from) {
                    Some((_, names)) => names.push(ident.to_owned()),
                    None => others.push((from, vec![ident.to_owned()])),
                }
            }
        }
    }
    order::sort_by_key(&mut others, |(from, _)| from.clone());
    exports.extend(others.into_iter().map(|((way, expect), names)| Export { expect, ..Use::Names(way, names).into() }));
    Ok(Content::Module { children, exports, aliases })
}
