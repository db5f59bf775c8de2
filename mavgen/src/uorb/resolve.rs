//! From the syntax of `.msg` files to messages: looks types up, checks names, lays fields out.

use std::collections::HashMap;
use std::io;

use super::folder::Folder;
use super::hash::{message_hash, type_hash};
use super::layout::arrange;
use super::model::{Constant, Docs, Element, Field, Message, MessageIndex, Package};
use super::overlay::Said;
use super::scalar::Scalar;
use super::syntax::{Comment, ConstantSyntax, FieldSyntax, GroupKind, MsgFile};
use super::{names, placed, refine, topic_name};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::source::{Sources, Span, Spanned};
use crate::threads;

pub(super) struct Resolver<'s> {
    folder: Folder,
    /// The bytes of files that nobody asked for yet.
    loaded: HashMap<String, io::Result<Vec<u8>>>,
    said: Said<'s>,
    sources: &'s mut Sources,
    diagnostics: &'s mut Diagnostics,
    /// The messages that are resolved; `None` for one in which something is wrong, which was told.
    known: HashMap<String, Option<MessageIndex>>,
    /// The messages that are begun: each nests the next.
    begun: Vec<String>,
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
            loaded: HashMap::new(),
            said,
            sources,
            diagnostics,
            known: HashMap::new(),
            begun: Vec::new(),
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
        if let Some(known) = self.known.get(name) {
            return *known;
        }
        self.begun.push(name.to_owned());
        let message = self.read(name);
        self.begun.pop();
        let index = message.map(|message| {
            self.depths.push(1 + message.fields.iter().map(|field| self.depth(field)).max().unwrap_or(0));
            self.package.messages.push(message);
            MessageIndex(self.package.messages.len() - 1)
        });
        self.known.insert(name.to_owned(), index);
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
        let fields = file.fields.iter().filter_map(|field| self.field(field)).collect_vec();
        let constants = file.constants.iter().filter_map(|constant| self.constant(constant)).collect_vec();
        self.check_timestamp(&file, &fields);
        if self.diagnostics.broken_files().contains(&Some(id)) {
            return None;
        }
        let mut message = self.lay_out(name, &file, fields, constants)?;
        refine::apply(&mut message, &file, self.said.message(name), &mut self.package, self.diagnostics);
        Some(message)
    }

    /// The message with these fields; what comments and overlays say of them is not in it.
    fn lay_out(
        &mut self,
        name: &str,
        file: &MsgFile,
        mut fields: Vec<Field>,
        mut constants: Vec<Constant>,
    ) -> Option<Message> {
        let nested = &self.package.messages;
        let lengths = arrange(&mut fields, nested).filter(|(length, _)| *length <= LONGEST);
        let Some((struct_len, struct_padding)) = lengths else {
            let message = format!("`{name}` is longer than {LONGEST} bytes");
            let problem = Diagnostic::new(Code::UorbArray, Span::new(file.id, 0..0), message);
            self.diagnostics.push(problem.help("PX4 keeps the length of a message in 16 bits"));
            return None;
        };
        let (in_cdr, cdr_len) = placed::cdr(nested, &fields, 0);
        fields.iter_mut().zip(&in_cdr).for_each(|(field, placed)| field.cdr_offset = placed.at);
        let topics = file.topics.iter().map(|topic| topic.value.clone()).collect_vec();
        let mut take = |wanted: &str| {
            let at = constants.iter().position(|constant| constant.name == wanted)?;
            u32::try_from(constants.remove(at).value).ok()
        };
        Some(Message {
            name: name.to_owned(),
            file: file.id,
            about: file.about.clone(),
            topics: if file.topics.is_empty() { vec![topic_name(name)] } else { topics },
            version: take("MESSAGE_VERSION"),
            queue: take("ORB_QUEUE_LENGTH"),
            hash: message_hash(&fields, nested),
            type_hash: type_hash(name, &fields, nested),
            fields,
            constants,
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
        let problem = |message: String| Diagnostic::new(Code::UorbNested, element.span, message);
        let too_deep = || {
            let problem = problem(format!("`{name}` is message {} within another", DEEPEST + 1));
            problem.help(format!("at most {DEEPEST} messages can be within each other"))
        };
        let problem = if !self.folder.has(name) {
            unknown_type(element, &self.folder)
        } else if self.begun.iter().any(|begun| begun == name) {
            problem(format!("`{name}` is nested in itself"))
        } else if self.begun.len() >= DEEPEST {
            too_deep()
        } else {
            match self.message(name) {
                Some(index) if self.depths.get(index.0).is_some_and(|depth| *depth < DEEPEST) => {
                    return Some(Element::Message(index));
                }
                Some(_) => too_deep(),
                // What is wrong there was told there; here it must not look right.
                None => problem(format!("`{name}` has mistakes, so this cannot be laid out")),
            }
        };
        self.diagnostics.push(problem);
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

fn unknown_type(element: &Spanned<String>, folder: &Folder) -> Diagnostic {
    let name = element.value.as_str();
    let problem = Diagnostic::new(Code::UorbType, element.span, format!("there is no type `{name}`"));
    let scalars = Scalar::ALL.iter().map(|scalar| scalar.name());
    match name {
        "string" => problem.help("write the number of characters: `char[20]`"),
        "byte" => problem.help("write `uint8`"),
        _ => problem
            .help("a type is a scalar, or the name of a `.msg` file in the same folder")
            .meant(nearest(name, scalars.chain(folder.names()))),
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
