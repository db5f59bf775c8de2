//! The tree of a package: a file for each topic and each enum, and the modules that hold them.

use super::docs::named_topics;
use super::names::TopicNames;
use super::{Named, Topics, UnionNames};
use crate::collect::CollectVec as _;
use crate::docs::first_sentence;
use crate::internal::Internal;
use crate::lower::docs::link;
use crate::lower::files::{header, root_header};
use crate::lower::names::EnumNames;
use crate::lower::options::Options;
use crate::order;
use crate::rust::{
    Cell, Child, ChildAccess, Content, DialectEnum, Docs, Export, File, Held, Paragraph, Part, Plain, Scalars, Topic,
    TopicSlot, TopicType, Use, Variant,
};
use crate::threads;
use crate::uorb::model::{EnumIndex, MessageIndex};
use crate::uorb::union::Union;

/// The files of a package, in a fixed order.
pub(crate) fn tree<'d>(
    union: &'d Union,
    names: &'d UnionNames,
    options: &'d Options,
) -> Result<Vec<File<'d>>, Internal> {
    let topics = Topics { union, names };
    let mut files = vec![root(topics, options), messages(topics)];
    files.extend((!union.messages.is_empty()).then(|| all(topics, options)));
    files.extend((!union.enums.is_empty()).then(|| enums(topics)));
    let places = (0..union.messages.len()).map(MessageIndex).collect_vec();
    for file in threads::in_order(&places, |index| topic(topics, *index, options)) {
        files.push(file?);
    }
    for (at, (one, names)) in union.enums.iter().zip(&names.enums).enumerate() {
        let (path, header) = (format!("enums/{}.rs", names.module), header(&format!("{}.msg", one.message)));
        let content = Content::Enum(Box::new(topics.enum_item(EnumIndex(at))?));
        files.push(File { uses: vec![Use::Runtime(options.runtime.clone())], ..File::of(path, header, content) });
    }
    Ok(files)
}

/// `mod.rs`. It begins with an item, so that `include!` takes it.
fn root<'d>(Topics { union, names }: Topics<'d>, options: &Options) -> File<'d> {
    let (mut children, mut exports) = (Vec::new(), Vec::<Export>::new());
    for (module, is_empty) in [("enums", union.enums.is_empty()), ("messages", union.messages.is_empty())] {
        if !is_empty {
            children.push(Child::of(module, ChildAccess::Public));
            exports.push(Use::All(module.to_owned()).into());
        }
    }
    if !union.messages.is_empty() {
        children.push(Child::of(ALL, ChildAccess::Private));
        exports.push(Use::one(ALL, &names.all).into());
    }
    let header = root_header(&header(&union.name), options);
    let content = Content::Module { children, exports, aliases: Vec::new() };
    File { docs: Docs::line(about(union)), ..File::of("mod.rs".to_owned(), header, content) }
}

/// The module of the enum over all messages.
const ALL: &str = "package";

/// `package.rs`: the enum over all messages.
fn all<'d>(Topics { union, names }: Topics<'d>, options: &Options) -> File<'d> {
    let mut messages = names.messages.iter().zip(&union.messages).collect_vec();
    order::sort_by_key(&mut messages, |(names, _)| names.ty.as_str());
    let imported = messages.iter().map(|(names, _)| names.ty.clone()).collect_vec();
    let variants = messages.into_iter().map(|(names, model)| {
        let docs = Docs::line(format!("A message of the {}.", named_topics(&model.topics)));
        Variant { ident: &names.ty, docs }
    });
    let docs = Docs::line(format!("Any message of `{}`.", union.name))
        .then(Paragraph::line("A later version may have more; match with a `_` arm."));
    let item = DialectEnum {
        ident: &names.all,
        docs,
        variants: variants.collect_vec(),
        completed_by: "topics",
        derives_debug: true,
    };
    let uses = vec![Use::Names("super::messages".to_owned(), imported), Use::Runtime(options.runtime.clone())];
    File { uses, ..File::of(format!("{ALL}.rs"), header(&union.name), Content::Dialect(item)) }
}

/// What stands over the module of a package.
pub(crate) fn about(union: &Union) -> String {
    let definitions: Vec<String> = union.definitions.iter().map(|one| format!("`{}`", one.name)).collect();
    match definitions.as_slice() {
        [_] => format!("uORB messages of `{}`.", union.name),
        all => format!("uORB messages of `{}`, of the definitions {}.", union.name, all.join(", ")),
    }
}

/// `messages.rs`, with a table of contents.
fn messages<'d>(Topics { union, names }: Topics<'d>) -> File<'d> {
    let mut all = union.messages.iter().zip(&names.messages).collect_vec();
    order::sort_by_key(&mut all, |(model, _)| model.name.as_str());
    let listed = all.into_iter().map(|(model, TopicNames { module, ty, .. })| {
        (model.fields.len(), first_sentence(&model.text), module.as_str(), ty.as_str())
    });
    let docs = Docs::line("The messages, one type each.");
    contents(&union.name, ("messages.rs", docs, ["fields", "message"]), listed.collect_vec())
}

/// `enums.rs`, with a table of contents.
fn enums<'d>(Topics { union, names }: Topics<'d>) -> File<'d> {
    let mut all = union.enums.iter().zip(&names.enums).collect_vec();
    order::sort_by_key(&mut all, |(model, _)| &model.name.text);
    let listed = all.into_iter().map(|(model, EnumNames { module, ty, .. })| {
        (model.entries.len(), format!("of `{}`", model.message), module.as_str(), ty.as_str())
    });
    let docs = Docs::line("Enums and flags: constants that fields of messages take.");
    contents(&union.name, ("enums.rs", docs, ["entries", "enum"]), listed.collect_vec())
}

/// A module of types: of each how many parts it has, what it is, its module and its name.
fn contents<'d>(
    package: &str,
    (path, docs, [first, second]): (&str, Docs<'d>, [&'d str; 2]),
    listed: Vec<(usize, String, &str, &str)>,
) -> File<'d> {
    let (mut rows, mut children, mut exports) = (Vec::new(), Vec::new(), Vec::new());
    for (count, text, module, ty) in listed {
        rows.push([count.to_string(), link(ty), text].map(Cell::Plain).to_vec());
        children.push(Child::of(module, ChildAccess::Private));
        exports.push(Use::one(module, ty).into());
    }
    let docs = docs.then(Paragraph::Table(vec![first, second, ""], rows));
    let content = Content::Module { children, exports, aliases: Vec::new() };
    File { docs, ..File::of(path.to_owned(), header(package), content) }
}

fn topic<'d>(topics: Topics<'d>, index: MessageIndex, options: &Options) -> Result<File<'d>, Internal> {
    let message = topics.message(index)?;
    let (Named { model, names }, item) = (message, topics.topic(message)?);
    let mut named = Mentioned { functions: vec!["get", "put"], ..Mentioned::default() };
    named.topic(&item);
    let uses = named.imports(&options.runtime);
    let (path, header) = (format!("messages/{}.rs", names.module), header(&format!("{}.msg", model.name)));
    Ok(File { uses, ..File::of(path, header, Content::Topic(Box::new(item))) })
}

/// What the code of a topic names.
#[derive(Default)]
struct Mentioned<'d> {
    enums: Vec<&'d str>,
    topics: Vec<&'d str>,
    /// Functions of the runtime.
    functions: Vec<&'static str>,
}

impl<'d> Mentioned<'d> {
    fn topic(&mut self, topic: &Topic<'d>) {
        for field in &topic.fields {
            match field.slot.ty {
                TopicType::Enum(one) => self.enums.push(one.ident),
                TopicType::Message(ident) => self.topics.push(ident),
                TopicType::Plain(_) => {}
            }
        }
        topic.definitions.iter().for_each(|definition| self.fields(&definition.cdr));
    }

    /// What loading a message names, and the literals of what it nests, however deep.
    fn fields(&mut self, part: &Part<'d>) {
        for field in &part.fields {
            match &field.held {
                Held::Scalars(scalars) => self.scalars(field.slot, *scalars),
                Held::Message(nested) => self.nested(nested),
                Held::Each(row) => self.nested(&row.part),
                Held::Rows(rows, _) => rows.iter().for_each(|row| self.nested(&row.part)),
            }
        }
    }

    fn nested(&mut self, part: &Part<'d>) {
        self.topics.push(part.ident);
        self.fields(part);
    }

    /// The enum of a field is named where it is not loaded as it is.
    fn scalars(&mut self, slot: TopicSlot<'d>, Scalars { stored, len, widens, few }: Scalars) {
        if stored == Plain::Bool {
            self.functions.push(if len.is_some() { "booleans" } else { "boolean" });
        }
        if let (TopicType::Enum(one), true) = (slot.ty, widens || few) {
            self.enums.push(one.ident);
        }
    }

    /// The `use` lines of what is named, with each name once.
    fn imports(mut self, runtime: &str) -> Vec<Use> {
        order::sort_and_dedup(&mut self.functions);
        [&mut self.enums, &mut self.topics].into_iter().for_each(order::sort_and_dedup);
        let parts = [("super::super::enums", &self.enums), ("super::super::messages", &self.topics)];
        let parts = parts.into_iter().filter(|(_, names)| !names.is_empty());
        let uses = parts.map(|(module, names)| {
            Use::Names(module.to_owned(), names.iter().map(|name| (*name).to_owned()).collect_vec())
        });
        let of_runtime =
            [Use::Runtime(runtime.to_owned()), Use::Generated(self.functions.clone()), Use::one("wire", "uorb")];
        uses.chain(of_runtime).collect_vec()
    }
}
