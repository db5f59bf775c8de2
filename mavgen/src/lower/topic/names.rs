//! What the topics of a package are called in Rust.

use std::collections::HashSet;

use super::spelling;
use crate::diag::Diagnostics;
use crate::ir::Name;
use crate::lower::collision;
use crate::lower::namespace::{Claim, Namespace, Scope, What};
use crate::source::Span;
use crate::uorb::Scalar;
use crate::uorb::model::Element;
use crate::uorb::union::{Enum, Field, Message, Union};

/// The names of a package, in the order of its model. A keyword is not raw here.
#[derive(Clone, Debug, Default)]
pub(crate) struct UnionNames {
    /// The enum over all messages: `Px4`.
    pub(super) all: String,
    /// Of [`Union::messages`].
    pub(super) messages: Vec<TopicNames>,
    /// Of [`Union::enums`].
    pub(super) enums: Vec<EnumNames>,
    /// Of [`Union::definitions`].
    pub(super) definitions: Vec<DefinitionNames>,
}

/// The names of a message.
#[derive(Clone, Debug)]
pub(super) struct TopicNames {
    /// The type: `EscStatus`.
    pub(super) ty: String,
    /// The module and file: `esc_status`.
    pub(super) module: String,
    pub(super) fields: Vec<String>,
    pub(super) constants: Vec<String>,
    /// The places of the fields that have a getter and a setter beside them.
    pub(super) accessors: Vec<usize>,
}

/// The names of an enum.
#[derive(Clone, Debug)]
pub(super) struct EnumNames {
    /// The type. One that a message has already takes the suffix `Enum`.
    pub(super) ty: String,
    /// The module and file.
    pub(super) module: String,
    pub(super) constants: Vec<String>,
}

/// The names of a definition.
#[derive(Clone, Debug)]
pub(super) struct DefinitionNames {
    /// `V1_14`
    pub(super) constant: String,
    /// `v1_14`
    pub(super) suffix: String,
}

/// Constants that every topic has. One of a message that is called so takes an underscore.
pub(crate) const CONSTANTS: [&str; 8] =
    ["ABSENT", "DEFINITIONS", "FIELDS", "NAME", "QUEUE", "TOPICS", "UNKNOWN", "VERSION"];

/// Methods that every topic has beside those of messages.
const METHODS: [&str; 9] =
    ["from_cdr", "from_cdr_as", "is_blank", "read_cdr", "read_record", "store_cdr", "store_record", "to_cdr", "visit"];

impl UnionNames {
    /// Names a package, and reports what collides.
    pub(crate) fn check(union: &Union, diagnostics: &mut Diagnostics) -> Self {
        let definitions: Vec<_> = union.definitions.iter().map(|one| DefinitionNames::of(&one.name)).collect();
        let reserved: HashSet<&str> =
            CONSTANTS.into_iter().chain(definitions.iter().map(|one| one.constant.as_str())).collect();
        let mut messages: Vec<_> = union.messages.iter().map(|message| TopicNames::of(message, &reserved)).collect();
        let taken: HashSet<String> = messages.iter().map(|message| message.ty.clone()).collect();
        let enums: Vec<_> = union.enums.iter().map(|one| EnumNames::of(one, &taken)).collect();
        let all = types(union, &messages, &enums, diagnostics);
        for (message, names) in union.messages.iter().zip(&mut messages) {
            members(message, names, diagnostics);
            names.accessors = accessors(message, names, diagnostics);
        }
        for (one, names) in union.enums.iter().zip(&enums) {
            let entries = one
                .entries
                .iter()
                .zip(&names.constants)
                .map(|(entry, own)| (own.clone(), claim(What::Entry, &entry.constant.name, entry.constant.span)));
            apart(Scope::Constants, entries, diagnostics);
        }
        Self { all, messages, enums, definitions }
    }
}

impl DefinitionNames {
    fn of(name: &str) -> Self {
        Self { constant: spelling::constant(name), suffix: spelling::field_name(name) }
    }
}

impl TopicNames {
    fn of(message: &Message, reserved: &HashSet<&str>) -> Self {
        let constants = message.constants.iter().map(|constant| {
            let name = spelling::constant(&constant.name);
            if reserved.contains(&*name) { name + "_" } else { name }
        });
        Self {
            ty: spelling::type_name(&message.name),
            module: spelling::item_module_name(&message.name),
            fields: message.fields.iter().map(|field| spelling::field_name(&field.name)).collect(),
            constants: constants.collect(),
            accessors: Vec::new(),
        }
    }
}

impl EnumNames {
    fn of(one: &Enum, messages: &HashSet<String>) -> Self {
        let ty = spelling::type_name(&one.name.text);
        Self {
            ty: if messages.contains(&ty) { spelling::suffixed(&ty, "Enum") } else { ty },
            module: spelling::item_module_name(&one.name.text),
            constants: one.entries.iter().map(|entry| spelling::constant(&entry.label)).collect(),
        }
    }
}

/// Checks the types, and names that over all messages: after the package, with the suffix `Topics` if something else has that.
fn types(union: &Union, messages: &[TopicNames], enums: &[EnumNames], diagnostics: &mut Diagnostics) -> String {
    let messages =
        union.messages.iter().zip(messages).map(|(message, names)| {
            (names.ty.clone(), claim(What::Message, &message.name, Span::new(message.file, 0..0)))
        });
    let enums = union.enums.iter().zip(enums);
    let enums = enums.map(|(one, names)| (names.ty.clone(), claim(What::Enum, &one.name.text, one.name.span)));
    let mut types = Namespace::of(Scope::Types);
    let collisions = types.claim_by_age(messages.chain(enums).collect());
    diagnostics.extend(collisions.iter().filter_map(collision::diagnostic));
    let own = spelling::dialect_type_name(&union.name);
    let own = if types.get(&own).is_some() { spelling::suffixed(&own, "Topics") } else { own };
    match types.get(&own) {
        Some(first) => diagnostics.push(collision::of_dialect(&union.name, &own, first)),
        None if Name::fault(&own).is_some() => diagnostics.push(collision::no_name(&union.name)),
        None => {}
    }
    own
}

/// Fields have different names, and so have constants.
fn members(message: &Message, names: &TopicNames, diagnostics: &mut Diagnostics) {
    let fields = message.fields.iter().zip(&names.fields);
    apart(
        Scope::Fields,
        fields.map(|(field, own)| (own.clone(), claim(What::Field, &field.name, field.span))),
        diagnostics,
    );
    let constants = message.constants.iter().zip(&names.constants);
    apart(
        Scope::Constants,
        constants.map(|(constant, own)| (own.clone(), claim(What::Entry, &constant.name, constant.span))),
        diagnostics,
    );
}

/// Decides which fields have a getter and a setter: those that may be unknown, if the names are free.
fn accessors(message: &Message, names: &TopicNames, diagnostics: &mut Diagnostics) -> Vec<usize> {
    let mut methods = Namespace::of(Scope::Methods);
    methods.reserve("a method of every topic", &METHODS);
    let mut accessors = Vec::new();
    for (at, (field, name)) in message.fields.iter().zip(&names.fields).enumerate() {
        if !has_accessors(field) {
            continue;
        }
        let iterator = field.array.map(|_| format!("iter_{name}"));
        let own: Vec<String> = [name.clone(), format!("set_{name}")].into_iter().chain(iterator).collect();
        match methods.claim_all(&own, claim(What::Accessors, &field.name, field.span)) {
            None => accessors.push(at),
            Some(collision) => diagnostics.extend(collision::diagnostic(&collision)),
        }
    }
    accessors
}

/// Whether a field may be unknown, and can say so.
pub(super) fn has_accessors(field: &Field) -> bool {
    let is_number = match field.element {
        Element::Scalar(scalar) => !matches!(scalar, Scalar::Char | Scalar::Bool),
        Element::Message(_) => false,
    };
    is_number && field.invalid.is_some()
}

fn claim(what: What, text: &str, span: Span) -> Claim<'_> {
    Claim { what, text, span: Some(span), age: 0 }
}

fn apart<'a>(scope: Scope, claims: impl Iterator<Item = (String, Claim<'a>)>, diagnostics: &mut Diagnostics) {
    let collisions = Namespace::of(scope).claim_by_age(claims.collect());
    diagnostics.extend(collisions.iter().filter_map(collision::diagnostic));
}
