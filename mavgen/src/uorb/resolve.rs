//! From the syntax of `.msg` files to messages: looks types up, checks names, lays fields out.

use std::collections::BTreeMap;
use std::io;

use super::folder::Folder;
use super::hash::{message_hash, type_hash};
use super::layout::{Nested, arrange, arrange_cdr};
use super::model::{Constant, Docs, Element, Field, Message, MessageIndex, Package};
use super::overlay::Said;
use super::scalar::Scalar;
use super::syntax::{Comment, ConstantSyntax, FieldSyntax, GroupKind, MsgFile};
use super::{names, refine, topic_name};
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::source::{FileId, Sources, Span, Spanned};
use crate::threads;

/// What is known of a message by its name.
enum Known {
    /// It is being resolved: who nests it now nests itself.
    Begun,
    /// It is in the package.
    Done(MessageIndex),
    /// Something in it is wrong, and was told.
    Poisoned,
}

pub(super) struct Resolver<'s> {
    folder: Folder,
    /// The bytes of files that nobody asked for yet.
    loaded: BTreeMap<String, io::Result<Vec<u8>>>,
    said: Said<'s>,
    sources: &'s mut Sources,
    diagnostics: &'s mut Diagnostics,
    known: BTreeMap<String, Known>,
    /// How many messages are begun: each nests the next.
    begun: usize,
    /// How deep each message of the package nests: one that nests nothing is 1 deep.
    depths: Vec<usize>,
    package: Package,
}

impl<'s> Resolver<'s> {
    pub(super) fn new(
        folder: Folder,
        said: Said<'s>,
        sources: &'s mut Sources,
        diagnostics: &'s mut Diagnostics,
    ) -> Self {
        Self {
            folder,
            loaded: BTreeMap::new(),
            said,
            sources,
            diagnostics,
            known: BTreeMap::new(),
            begun: 0,
            depths: Vec::new(),
            package: Package::default(),
        }
    }

    /// Loads the files of these messages, which take most of their time in the system, before they are asked for.
    pub(super) fn load(&mut self, names: &[String]) {
        let loaded = threads::in_order(names, |name| self.folder.load(name));
        self.loaded = names.iter().cloned().zip(loaded).filter_map(|(name, bytes)| Some((name, bytes?))).collect();
    }

    pub(super) fn finish(self) -> Package {
        self.package
    }

    /// The message of this name; `None` if something in it is wrong. What it nests comes into the package before it.
    pub(super) fn message(&mut self, name: &str) -> Option<MessageIndex> {
        if let Some(Known::Done(index)) = self.known.get(name) {
            return Some(*index);
        }
        if self.known.contains_key(name) {
            return None;
        }
        self.known.insert(name.to_owned(), Known::Begun);
        self.begun += 1;
        let message = self.read(name);
        self.begun -= 1;
        let index = message.map(|message| {
            self.depths.push(1 + message.fields.iter().map(|field| self.depth(field)).max().unwrap_or(0));
            self.package.messages.push(message);
            MessageIndex(self.package.messages.len() - 1)
        });
        self.known.insert(name.to_owned(), index.map_or(Known::Poisoned, Known::Done));
        index
    }

    /// How deep the message in a field nests; 0 of a scalar.
    fn depth(&self, field: &Field) -> usize {
        match field.element {
            Element::Message(nested) => self.depths.get(nested.0).copied().unwrap_or(0),
            Element::Scalar(_) => 0,
        }
    }

    fn read(&mut self, name: &str) -> Option<Message> {
        let bytes = self.loaded.remove(name).or_else(|| self.folder.load(name))?;
        let id = self.folder.open(name, bytes, self.sources, self.diagnostics)?;
        if !names::is_message(name) {
            let message = format!("`{name}` is not a name of a message");
            let problem = Diagnostic::new(Code::UorbName, Span::new(id, 0..0), message);
            self.diagnostics.push(
                problem.help("a file is called as its message, in words that begin with capitals: `EscStatus.msg`"),
            );
        }
        let file = super::read(id, self.sources, self.diagnostics);
        names::check(&file, self.diagnostics);
        let fields: Vec<Field> = file.fields.iter().filter_map(|field| self.field(field)).collect();
        let constants: Vec<Constant> = file.constants.iter().filter_map(|constant| self.constant(constant)).collect();
        self.check_timestamp(&file, &fields);
        if self.diagnostics.broken_files().contains(&Some(id)) {
            return None;
        }
        let mut message = self.lay_out(name, file.id, fields, constants)?;
        message.topics = match file.topics.as_slice() {
            [] => vec![topic_name(name)],
            named => named.iter().map(|topic| topic.value.clone()).collect(),
        };
        message.about.clone_from(&file.about);
        refine::apply(&mut message, &file, self.said.message(name), &mut self.package, self.diagnostics);
        Some(message)
    }

    /// The message with these fields; what comments say of it is not in it.
    fn lay_out(
        &mut self,
        name: &str,
        file: FileId,
        mut fields: Vec<Field>,
        constants: Vec<Constant>,
    ) -> Option<Message> {
        let nested = &self.package.messages;
        let in_struct = arrange(&mut fields, &Nested(nested)).filter(|(length, _)| *length <= LONGEST);
        // Work on nested arrays is bounded by the length of the struct, so that comes first.
        let layouts = in_struct.and_then(|lengths| Some((lengths, arrange_cdr(&mut fields, &Nested(nested))?)));
        let Some(((struct_len, struct_padding), cdr_len)) = layouts else {
            let message = format!("`{name}` is longer than {LONGEST} bytes");
            let problem = Diagnostic::new(Code::UorbArray, Span::new(file, 0..0), message);
            self.diagnostics.push(problem.help("PX4 keeps the length of a message in 16 bits"));
            return None;
        };
        let number = |wanted: &str| {
            let constant = constants.iter().find(|constant| constant.name == wanted)?;
            u32::try_from(constant.value).ok()
        };
        Some(Message {
            name: name.to_owned(),
            file,
            about: Vec::new(),
            topics: Vec::new(),
            version: number(VERSION),
            queue: number(QUEUE),
            hash: message_hash(&fields, nested),
            type_hash: type_hash(name, &fields, nested),
            constants: constants.into_iter().filter(|constant| ![VERSION, QUEUE].contains(&&*constant.name)).collect(),
            fields,
            cdr_len,
            struct_len,
            struct_padding,
        })
    }

    fn field(&mut self, field: &FieldSyntax) -> Option<Field> {
        Some(Field {
            name: field.name.value.clone(),
            span: field.name.span,
            element: self.element(&field.element)?,
            array: field.array.as_ref().map(|array| array.value),
            struct_offset: 0,
            cdr_offset: 0,
            enum_: None,
            invalid: None,
            was: None,
            docs: docs(&field.comment),
        })
    }

    /// The type of this name: a scalar, or the message of another file.
    fn element(&mut self, element: &Spanned<String>) -> Option<Element> {
        let name = element.value.as_str();
        if let Some(scalar) = Scalar::of(name) {
            return Some(Element::Scalar(scalar));
        }
        if matches!(self.known.get(name), Some(Known::Begun)) {
            let message = format!("`{name}` is nested in itself");
            self.diagnostics.push(Diagnostic::new(Code::UorbNested, element.span, message));
            return None;
        }
        if self.folder.has(name) {
            if self.begun >= DEEPEST {
                self.diagnostics.push(too_deep(element));
                return None;
            }
            let message = self.message(name);
            if message.is_some_and(|index| self.depths.get(index.0).is_some_and(|depth| *depth >= DEEPEST)) {
                self.diagnostics.push(too_deep(element));
                return None;
            }
            if message.is_none() {
                // What is wrong there was told there; here it must not look right.
                self.diagnostics.push(Diagnostic::new(
                    Code::UorbNested,
                    element.span,
                    format!("`{name}` has mistakes, so this cannot be laid out"),
                ));
            }
            return message.map(Element::Message);
        }
        self.diagnostics.push(unknown_type(element, &self.folder));
        None
    }

    fn constant(&mut self, constant: &ConstantSyntax) -> Option<Constant> {
        let Some(scalar) = Scalar::of(&constant.element.value) else {
            self.diagnostics.push(unknown_type(&constant.element, &self.folder));
            return None;
        };
        let (name, span) = (constant.name.value.clone(), constant.name.span);
        Some(Constant { name, span, scalar, value: constant.value.value, docs: docs(&constant.comment) })
    }

    /// PX4 refuses a message that does not say when it was made.
    fn check_timestamp(&mut self, file: &MsgFile, fields: &[Field]) {
        let is_time = |field: &Field| field.element == Element::Scalar(Scalar::U64) && field.array.is_none();
        let problem = match file.fields.iter().find(|field| field.name.value == "timestamp") {
            Some(_) if fields.iter().any(|field| field.name == "timestamp" && is_time(field)) => return,
            Some(field) => Diagnostic::new(Code::UorbTimestamp, field.element.span, "`timestamp` is not a `uint64`"),
            None => Diagnostic::new(Code::UorbTimestamp, Span::new(file.id, 0..0), "there is no `timestamp`"),
        };
        self.diagnostics.push(problem.help("every uORB message has `uint64 timestamp`, in microseconds"));
    }
}

/// Bytes of the longest message.
const LONGEST: u32 = 0xffff;

/// Messages within each other. PX4 has three; the compiler of Rust gives up beyond eighty.
const DEEPEST: usize = 32;

const VERSION: &str = "MESSAGE_VERSION";
const QUEUE: &str = "ORB_QUEUE_LENGTH";

fn too_deep(element: &Spanned<String>) -> Diagnostic {
    let message = format!("`{}` is message {} within another", element.value, DEEPEST + 1);
    let problem = Diagnostic::new(Code::UorbNested, element.span, message);
    problem.help(format!("at most {DEEPEST} messages can be within each other"))
}

fn unknown_type(element: &Spanned<String>, folder: &Folder) -> Diagnostic {
    let name = element.value.as_str();
    let problem = Diagnostic::new(Code::UorbType, element.span, format!("there is no type `{name}`"));
    let scalars = Scalar::ALL.iter().map(|scalar| scalar.name());
    match name {
        "string" => problem.help("write the number of characters: `char[20]`"),
        "byte" => problem.help("write `uint8`"),
        _ => match nearest(name, scalars.chain(folder.names())) {
            Some(meant) => problem.help(format!("did you mean `{meant}`?")),
            None => problem.help("a type is a scalar, or the name of a `.msg` file in the same folder"),
        },
    }
}

fn docs(comment: &Comment) -> Docs {
    let mut docs = Docs { lines: comment.lines.clone(), ..Docs::default() };
    for group in &comment.groups {
        match group.kind.clone() {
            GroupKind::Units(units) => docs.units = Some(units),
            GroupKind::Enum(mut prefixes) => docs.constants.append(&mut prefixes),
            GroupKind::Range(low, high) => docs.range = Some((low, high)),
            GroupKind::Invalid(value) => docs.invalid = Some(value),
            GroupKind::Frame(frame) => docs.frame = Some(frame),
        }
    }
    docs
}
