//! The generated Rust as its users see it: public types and their public members, as they are decided before they are printed.

use std::collections::BTreeMap;

use crate::format::line;
use crate::internal::Internal;
use crate::ir::Valid;
use crate::lower::names::Names;
use crate::lower::{Commands, Options, tree};
use crate::rust::{
    Command, Content, Element, Enum, Field, Method, Packed, Receiver, RecordType, Shape as FieldShape, Sig, Struct, Ty,
};
use crate::tokens::{ToTokens, quote};

/// Public types by name.
pub(super) type Surface = BTreeMap<String, Shape>;

/// What users see of a type.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Shape {
    /// Whether it is built of its public fields, all of them.
    pub(super) exhaustive: bool,
    pub(super) members: BTreeMap<Name, Member>,
}

/// What a type and its members are called.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Name {
    /// The type itself.
    Type,
    /// A field.
    Field(String),
    /// A constant.
    Constant(String),
    /// A method or function.
    Method(String),
    /// An implementation of a trait.
    Trait(String),
}

/// What methods beside a getter are called.
pub(super) const BESIDE: [&str; 3] = ["set_", "with_", "iter_"];

/// A method that stands beside a getter: its prefix, and the getter.
pub(super) fn beside(method: &str) -> Option<(&'static str, &str)> {
    BESIDE.into_iter().find_map(|prefix| Some((prefix, method.strip_prefix(prefix)?)))
}

/// What users see of a type, field, constant, method or implementation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Member {
    /// The type, or the parameters and what they give; of a type what kind it is: `an enum of u8`, `a struct`.
    pub(super) signature: String,
    pub(super) deprecated: bool,
    /// Of a field: its number in `DEFAULT`.
    pub(super) default: Option<String>,
}

/// The public types of a state: of its enums, of its messages with their views, and of its commands.
pub(super) fn surface(dialect: Valid<'_>, names: &Names) -> Result<Surface, Internal> {
    let options = Options { deprecated: true, commands: Commands::Always, ..Options::default() };
    let mut surface = Surface::new();
    tree(dialect, names, &options)?.iter().for_each(|file| add(&mut surface, &file.content));
    Ok(surface)
}

fn add(surface: &mut Surface, content: &Content<'_>) {
    let (name, shape) = match content {
        Content::Enum(one) => (one.ident.to_owned(), of_enum(one)),
        Content::Message(one) => (one.ident.to_owned(), of_message(one)),
        Content::Command(command) => (format!("commands::{}", command.ident), of_command(command)),
        Content::View(view) => {
            surface.extend(view.packed.as_ref().map(|packed| (packed.ident.to_owned(), of_packed(packed))));
            surface.extend(view.record.as_ref().map(|record| (record.ident.to_owned(), of_record(record))));
            if let Some(message) = surface.get_mut(view.message) {
                message.members.extend(methods(&view.message_methods));
            }
            return;
        }
        // What these export are the types of the others.
        Content::Module { .. } | Content::Commands(..) | Content::Dialect(_) => return,
        #[cfg(feature = "uorb")]
        Content::Topic(_) => return,
    };
    surface.insert(name, shape);
}

fn of_enum(one: &Enum<'_>) -> Shape {
    let kind = if one.flags { "flags" } else { "an enum" };
    let constants = one.constants.iter().map(|constant| {
        let member = Member { deprecated: constant.deprecated.is_some(), ..Member::of(&Ty::Own) };
        (Name::Constant(constant.ident.to_owned()), member)
    });
    let members = constants.chain(methods(&one.methods));
    Shape::new(&format!("{kind} of {}", one.int.name()), one.deprecated.is_some(), false, members)
}

fn of_message(message: &Struct<'_>) -> Shape {
    let fields = message.fields.iter().map(|field| {
        let default = default(field).map(|number| number.to_string());
        let element = field.element.ty();
        let ty = match field.shape {
            FieldShape::One => quote!(#element),
            FieldShape::Array(n) => quote!([#element; #n]),
            FieldShape::Chars(n) => quote!(wire::Chars<#n>),
        };
        (Name::Field(field.ident.to_owned()), Member { default, ..Member::of(&ty) })
    });
    let targeted = message.frame.target_system.and(message.frame.target_component).map(|_| "wire::Targeted");
    // Others have a derived one.
    let secretive = message.fields.iter().any(|field| field.secret).then_some(DEBUG);
    let traits = ["wire::Message"].into_iter().chain(targeted).chain(secretive).map(implementation);
    let members = fields.chain(methods(&message.methods)).chain(traits);
    Shape::new("a struct", message.deprecated.is_some(), true, members)
}

fn of_command(command: &Command<'_>) -> Shape {
    let fields = command.fields.iter().map(|field| {
        let member = Member { default: Some(field.default.to_string()), ..Member::of(&field.ty.ty()) };
        (Name::Field(field.ident.to_owned()), member)
    });
    Shape::new("a struct", command.deprecated.is_some(), true, fields)
}

fn of_packed(packed: &Packed<'_>) -> Shape {
    Shape::new("a type", false, false, methods(&packed.methods).chain([implementation(DEBUG)]))
}

fn of_record(record: &RecordType<'_>) -> Shape {
    let fields = record.fields.iter().map(|field| (Name::Field(field.ident.to_owned()), Member::of(&field.ty)));
    Shape::new("a struct", false, true, fields)
}

impl Shape {
    fn new(kind: &str, deprecated: bool, exhaustive: bool, members: impl Iterator<Item = (Name, Member)>) -> Self {
        let own = Member { signature: kind.to_owned(), deprecated, default: None };
        Self { exhaustive, members: members.chain([(Name::Type, own)]).collect() }
    }
}

impl Member {
    /// One of this type, or with these parameters and what they give.
    fn of(signature: &impl ToTokens) -> Self {
        Self { signature: line(&quote!(#signature)), ..Self::default() }
    }
}

const DEBUG: &str = "core::fmt::Debug";

fn implementation(of: &str) -> (Name, Member) {
    (Name::Trait(of.to_owned()), Member::default())
}

/// The public ones: `fn(&mut self, value: u16)`; `const` is a promise like others.
fn methods(methods: &[Method<'_>]) -> impl Iterator<Item = (Name, Member)> {
    methods.iter().filter(|method| method.sig.public).map(|Method { ident, sig, .. }| {
        // That a value may be changed inside is nobody's business.
        let receiver = if sig.receiver == Receiver::MutValue { Receiver::Value } else { sig.receiver };
        let sig = Sig { receiver, ..sig.clone() };
        (Name::Method(ident.clone()), Member::of(&quote!(#(if sig.is_const => const) fn #sig)))
    })
}

/// The number that a field has in `DEFAULT`; all other values hang on its type alone.
fn default(field: &Field<'_>) -> Option<u8> {
    match (field.version, field.shape, field.element) {
        (Some(version), FieldShape::One, _) => Some(version),
        (None, FieldShape::One, Element::Int(_)) => Some(0),
        _ => None,
    }
}
