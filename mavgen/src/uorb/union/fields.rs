//! The fields of a message in all of its definitions, joined.

use std::collections::BTreeMap;

use super::{Definition, Enums, Field, Joined};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::uorb::Scalar;
use crate::uorb::model::{self, Element, MessageIndex};

/// What fields are looked up in.
pub(super) struct Context<'d> {
    pub(super) definitions: &'d [Definition],
    /// The place of each message in the union.
    pub(super) places: &'d BTreeMap<&'d str, usize>,
    pub(super) enums: &'d Enums,
}

impl Context<'_> {
    /// The type of a field's elements, in the union.
    fn element(&self, definition: usize, element: Element) -> Element {
        let Element::Message(index) = element else { return element };
        let message = self.definitions.get(definition).and_then(|one| one.package.messages.get(index.0));
        let place = message.and_then(|message| self.places.get(&*message.name));
        Element::Message(MessageIndex(place.copied().unwrap_or(usize::MAX)))
    }
}

/// A field of one of the definitions.
#[derive(Clone, Copy)]
struct Seen<'d> {
    field: &'d model::Field,
    element: Element,
}

/// The fields of the union, and for each definition which of them its own are.
pub(super) fn join(
    known: &Joined<'_>,
    context: &Context<'_>,
    diagnostics: &mut Diagnostics,
) -> (Vec<Field>, Vec<Vec<usize>>) {
    let (mut fields, mut places): (Vec<Field>, Vec<Vec<usize>>) = (Vec::new(), Vec::new());
    let mut seen: Vec<Vec<Seen<'_>>> = Vec::new();
    for (age, (definition, _, message)) in known.iter().enumerate() {
        let mut own = Vec::new();
        for field in &message.fields {
            let element = context.element(*definition, field.element);
            let place = place(&fields, field, message).unwrap_or(fields.len());
            if place == fields.len() {
                let enum_ = field.enum_.and_then(|index| context.enums.get(*definition, index));
                let until = (age > 0).then_some(*definition);
                fields.push(Field {
                    name: field.name.clone(),
                    span: field.span,
                    was: field.was.clone(),
                    element,
                    array: field.array,
                    docs: field.docs.clone(),
                    enum_,
                    invalid: field.invalid,
                    until,
                });
                seen.push(Vec::new());
            }
            seen.get_mut(place).into_iter().for_each(|seen| seen.push(Seen { field, element }));
            own.push(place);
        }
        places.push(own);
    }
    for (field, seen) in fields.iter_mut().zip(&seen) {
        widen(field, seen, diagnostics);
    }
    (fields, places)
}

/// The field of newer definitions that this one is.
fn place(fields: &[Field], field: &model::Field, message: &model::Message) -> Option<usize> {
    let by_name = fields.iter().position(|newer| newer.name == field.name);
    by_name.or_else(|| {
        let renamed = |newer: &Field| {
            newer.was.as_ref() == Some(&field.name) && message.fields.iter().all(|other| other.name != newer.name)
        };
        fields.iter().position(renamed)
    })
}

/// Gives the field the type that has the values of all definitions.
fn widen(field: &mut Field, seen: &[Seen<'_>], diagnostics: &mut Diagnostics) {
    let Some((newest, older)) = seen.split_first() else { return };
    let widest = seen.iter().map(|one| one.element).find(|wide| seen.iter().all(|one| fits(one.element, *wide)));
    let odd = match widest {
        Some(widest) => {
            field.element = widest;
            older.iter().find(|one| one.field.array.is_some() != newest.field.array.is_some())
        }
        None => {
            let is_odd = |one: &&Seen<'_>| !fits(one.element, newest.element) && !fits(newest.element, one.element);
            older.iter().find(is_odd).or(older.last())
        }
    };
    field.array = seen.iter().filter_map(|one| one.field.array).max();
    if let Some(odd) = odd {
        let message = format!("`{}` cannot be one field with what it is in a newer definition", odd.field.name);
        let problem = Diagnostic::new(Code::UorbUnion, odd.field.span, message)
            .related(newest.field.span, "the newer definition has it here")
            .help("no type holds the values of both: leave one of the definitions out, or rename the field in one of them");
        diagnostics.push(problem);
    }
}

/// Whether every value of one type is one of the other.
fn fits(element: Element, wide: Element) -> bool {
    match (element, wide) {
        (Element::Scalar(scalar), Element::Scalar(wide)) => scalar.widens_to(wide),
        (Element::Message(a), Element::Message(b)) => a == b,
        _ => false,
    }
}

impl Scalar {
    /// Whether every value of this type is one of the other, so that nothing is lost.
    pub fn widens_to(self, wide: Self) -> bool {
        match (self.range(), wide.range()) {
            _ if self == wide => true,
            (Some(range), Some(wide)) => wide.contains(range.start()) && wide.contains(range.end()),
            (None, Some(_)) => self == Self::Bool,
            (Some(_), None) => match wide {
                Self::F32 => self.size() <= 2,
                Self::F64 => self.size() <= 4,
                _ => false,
            },
            (None, None) => (self, wide) == (Self::F32, Self::F64),
        }
    }
}
