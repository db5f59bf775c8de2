//! The generated Rust as its users see it: public types and their public members, as they are decided before they are printed.

use std::collections::BTreeMap;

use crate::internal::Internal;
use crate::ir::Valid;
use crate::lower::names::Names;
use crate::lower::{Commands, Options, tree};
use crate::rust::{
    Command, Content, Default, Element, Enum, Error, Field, Method, Packed, Param, Receiver, RecordType,
    Shape as FieldShape, Sig, Struct, Ty,
};

/// Public types by name.
pub(super) type Surface = BTreeMap<String, Shape>;

/// What users see of a type.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Shape {
    /// What kind of type: `an enum of u8`, `a struct`.
    pub(super) signature: String,
    pub(super) deprecated: bool,
    /// Whether it is built of its public fields, all of them.
    pub(super) exhaustive: bool,
    pub(super) members: BTreeMap<Name, Member>,
}

/// What a member is called.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Name {
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

/// What users see of a field, constant, method or implementation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Member {
    /// The type, or the parameters and what they give.
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
    match content {
        Content::Enum(one) => {
            surface.insert(one.ident.to_owned(), of_enum(one));
        }
        Content::Message(one) => {
            surface.insert(one.ident.to_owned(), of_message(one));
        }
        Content::View(view) => {
            surface.extend(view.packed.as_ref().map(|packed| (packed.ident.to_owned(), of_packed(packed))));
            surface.extend(view.record.as_ref().map(|record| (record.ident.to_owned(), of_record(record))));
            if let Some(message) = surface.get_mut(view.message) {
                message.members.extend(methods(&view.message_methods));
            }
        }
        Content::Command(command) => {
            surface.insert(format!("commands::{}", command.ident), of_command(command));
        }
        // What these export are the types of the others.
        Content::Module { .. } | Content::Commands(..) | Content::Dialect(_) => {}
        #[cfg(feature = "uorb")]
        Content::Topic(_) => {}
    }
}

fn of_enum(one: &Enum<'_>) -> Shape {
    let kind = if one.flags { "flags" } else { "an enum" };
    let constants = one.constants.iter().map(|constant| {
        let deprecated = constant.deprecated.is_some();
        let member = Member { signature: "Self".to_owned(), deprecated, default: None };
        (Name::Constant(constant.ident.to_owned()), member)
    });
    Shape {
        signature: format!("{kind} of {}", one.int.name()),
        deprecated: one.deprecated.is_some(),
        exhaustive: false,
        members: constants.chain(methods(&one.methods)).collect(),
    }
}

fn of_message(message: &Struct<'_>) -> Shape {
    let fields = message.fields.iter().map(|field| {
        let default = default(field).map(|number| number.to_string());
        (Name::Field(field.ident.to_owned()), Member { signature: field_type(field), deprecated: false, default })
    });
    let targeted = message.frame.target_system.and(message.frame.target_component).map(|_| "wire::Targeted");
    // Others have a derived one.
    let secretive = message.fields.iter().any(|field| field.secret).then_some(DEBUG);
    let traits = ["wire::Message"].into_iter().chain(targeted).chain(secretive).map(implementation);
    Shape {
        signature: "a struct".to_owned(),
        deprecated: message.deprecated.is_some(),
        exhaustive: true,
        members: fields.chain(methods(&message.methods)).chain(traits).collect(),
    }
}

fn of_command(command: &Command<'_>) -> Shape {
    let fields = command.fields.iter().map(|field| {
        let signature = ty(&field.ty.ty());
        (
            Name::Field(field.ident.to_owned()),
            Member { signature, deprecated: false, default: Some(field.default.to_string()) },
        )
    });
    Shape {
        signature: "a struct".to_owned(),
        deprecated: command.deprecated.is_some(),
        exhaustive: true,
        members: fields.collect(),
    }
}

fn of_packed(packed: &Packed<'_>) -> Shape {
    Shape {
        signature: "a type".to_owned(),
        deprecated: false,
        exhaustive: false,
        members: methods(&packed.methods).chain([implementation(DEBUG)]).collect(),
    }
}

fn of_record(record: &RecordType<'_>) -> Shape {
    let fields = record.fields.iter().map(|field| {
        let member = Member { signature: ty(&field.ty), ..Member::default() };
        (Name::Field(field.ident.to_owned()), member)
    });
    Shape { signature: "a struct".to_owned(), deprecated: false, exhaustive: true, members: fields.collect() }
}

const DEBUG: &str = "core::fmt::Debug";

fn implementation(of: &str) -> (Name, Member) {
    (Name::Trait(of.to_owned()), Member::default())
}

fn methods(methods: &[Method<'_>]) -> impl Iterator<Item = (Name, Member)> {
    let public = methods.iter().filter(|method| method.sig.public);
    public.map(|method| {
        let member = Member { signature: signature(&method.sig), ..Member::default() };
        (Name::Method(method.ident.clone()), member)
    })
}

/// `fn(&mut self, value: u16)`; `const` is a promise like others.
fn signature(sig: &Sig<'_>) -> String {
    let Sig { public: _, is_const, receiver, params, result } = sig;
    let receiver = match receiver {
        Receiver::None => None,
        // That a value may be changed inside is nobody's business.
        Receiver::Value | Receiver::MutValue => Some("self".to_owned()),
        Receiver::Ref => Some("&self".to_owned()),
        Receiver::Mut => Some("&mut self".to_owned()),
    };
    let params = params.iter().map(|Param { ident, ty: of }| format!("{ident}: {}", ty(of)));
    let params: Vec<String> = receiver.into_iter().chain(params).collect();
    let (is_const, result) = (
        if *is_const { "const " } else { "" },
        match result {
            Ty::Unit => String::new(),
            result => format!(" -> {}", ty(result)),
        },
    );
    format!("{is_const}fn({}){result}", params.join(", "))
}

fn field_type(field: &Field<'_>) -> String {
    let element = ty(&field.element.ty());
    match field.shape {
        FieldShape::One => element,
        FieldShape::Array(n) => format!("[{element}; {n}]"),
        FieldShape::Chars(n) => format!("wire::Chars<{n}>"),
    }
}

/// The number that a field has in `DEFAULT`; all other values hang on its type alone.
fn default(field: &Field<'_>) -> Option<u8> {
    match (field.default, field.shape, field.element) {
        (Default::Version(version), FieldShape::One, _) => Some(version),
        (Default::Zero, FieldShape::One, Element::Int(_)) => Some(0),
        _ => None,
    }
}

fn ty(of: &Ty<'_>) -> String {
    match of {
        Ty::Int(int) => int.name().to_owned(),
        Ty::F32 => "f32".to_owned(),
        Ty::F64 => "f64".to_owned(),
        Ty::Bool => "bool".to_owned(),
        Ty::Usize => "usize".to_owned(),
        Ty::Unit => "()".to_owned(),
        Ty::Own => "Self".to_owned(),
        Ty::Enum(one) => one.ident.to_owned(),
        Ty::Named(name) => (*name).to_owned(),
        Ty::Array(inner, length) => format!("[{}; {length}]", ty(inner)),
        Ty::Option(inner) => format!("Option<{}>", ty(inner)),
        Ty::Fallible(error) => format!("Result<(), {}>", error_type(*error)),
        Ty::Made(error) => format!("Result<Self, {}>", error_type(*error)),
        Ty::Params => "&'static [wire::ParamInfo]".to_owned(),
        Ty::Iterator(item) => format!("impl Iterator<Item = {}> + '_", ty(item)),
    }
}

fn error_type(error: Error) -> &'static str {
    match error {
        Error::OutOfRange => "wire::OutOfRange",
        Error::View => "wire::ViewError",
    }
}
