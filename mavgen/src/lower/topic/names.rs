//! What the topics of a package are called in Rust.

use std::collections::HashSet;

use crate::collect::CollectVec as _;
use crate::diag::Diagnostics;
use crate::lower::names::{EnumNames, dialect_type, methods};
use crate::lower::namespace::{Claim, Namespace, Scope, What};
use crate::lower::{collision, spelling};
use crate::rust::Extent;
use crate::source::Span;
use crate::uorb::Scalar;
use crate::uorb::model::{Constant, Element};
use crate::uorb::union::{Field, Message, Union};

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
const METHODS: &str = "from_cdr from_cdr_as is_blank read_cdr read_record store_cdr store_record to_cdr visit";

impl UnionNames {
    /// Names a package, and reports what collides.
    pub(crate) fn check(union: &Union, diagnostics: &mut Diagnostics) -> Self {
        let definitions = union.definitions.iter().map(|one| DefinitionNames::of(&one.name)).collect_vec();
        let reserved: HashSet<&str> =
            CONSTANTS.into_iter().chain(definitions.iter().map(|one| one.constant.as_str())).collect();
        let mut messages = union.messages.iter().map(|message| TopicNames::of(message, &reserved)).collect_vec();
        let taken: HashSet<String> = messages.iter().map(|message| message.ty.clone()).collect();
        let enums = union.enums.iter().map(|one| {
            let constants = one.entries.iter().map(|entry| spelling::constant(&entry.label)).collect_vec();
            EnumNames::new(&one.name.text, &taken, constants)
        });
        let enums = enums.collect_vec();
        let all = types(union, &messages, &enums, diagnostics);
        for (message, names) in union.messages.iter().zip(&mut messages) {
            let fields = message.fields.iter().map(|field| Claim::at(What::Field, &field.name, field.span));
            collision::apart(Scope::Fields, fields, &names.fields, diagnostics);
            collision::apart(
                Scope::Constants,
                message.constants.iter().map(of_constant),
                &names.constants,
                diagnostics,
            );
            names.accessors = accessors(message, names, diagnostics);
        }
        for (one, names) in union.enums.iter().zip(&enums) {
            let entries = one.entries.iter().map(|entry| of_constant(&entry.constant));
            collision::apart(Scope::Constants, entries, &names.constants, diagnostics);
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
            fields: message.fields.iter().map(|field| spelling::field_name(&field.name)).collect_vec(),
            constants: constants.collect_vec(),
            accessors: Vec::new(),
        }
    }
}

/// Checks the types, and names that over all messages: after the package, with the suffix `Topics` if something else has that.
fn types(union: &Union, messages: &[TopicNames], enums: &[EnumNames], diagnostics: &mut Diagnostics) -> String {
    let messages = union.messages.iter().zip(messages).map(|(message, names)| {
        (names.ty.clone(), Claim::at(What::Message, &message.name, Span::new(message.file, 0..0)))
    });
    let enums = union.enums.iter().zip(enums);
    let enums = enums.map(|(one, names)| (names.ty.clone(), Claim::of(What::Enum, &one.name)));
    let mut types = Namespace::of(Scope::Types);
    collision::report(types.claim_by_age(messages.chain(enums).collect_vec()), diagnostics);
    dialect_type(&union.name, "Topics", &types, diagnostics)
}

/// Decides which fields have a getter and a setter: those that may be unknown, if the names are free.
fn accessors(message: &Message, names: &TopicNames, diagnostics: &mut Diagnostics) -> Vec<usize> {
    let mut taken = Namespace::of(Scope::Methods);
    taken.reserve("a method of every topic", METHODS);
    let mut with_accessors = Vec::new();
    for (at, (field, name)) in message.fields.iter().zip(&names.fields).enumerate() {
        if has_accessors(field) {
            let extent = field.invalid.map(|invalid| Extent::of(invalid.scope, field.array));
            let own = methods::accessors(name, extent.is_some_and(Extent::is_indexed));
            let found = taken.claim_all(&own, Claim::at(What::Accessors, &field.name, field.span));
            with_accessors.extend(collision::is_free(found, diagnostics).then_some(at));
        }
    }
    with_accessors
}

/// Whether a field may be unknown, and can say so.
pub(super) fn has_accessors(field: &Field) -> bool {
    let is_number = match field.element {
        Element::Scalar(scalar) => !matches!(scalar, Scalar::Char | Scalar::Bool),
        Element::Message(_) => false,
    };
    is_number && field.invalid.is_some()
}

fn of_constant(constant: &Constant) -> Claim<'_> {
    Claim::at(What::Entry, &constant.name, constant.span)
}
