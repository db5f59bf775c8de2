//! The fields of a message in all of its definitions, joined.

use std::collections::HashMap;

use super::{Definition, Enum, Field, Joined};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::uorb::Scalar;
use crate::uorb::model::{self, Element, EnumIndex, MessageIndex};

/// What fields are looked up in.
pub(super) struct Context<'d> {
    pub(super) definitions: &'d [Definition],
    /// The place of each message in the union.
    pub(super) places: &'d HashMap<&'d str, usize>,
    pub(super) enums: &'d [Enum],
}

/// A field of one of the definitions.
#[derive(Clone, Copy)]
struct Seen<'d> {
    definition: usize,
    field: &'d model::Field,
    /// The type of its elements, in the union.
    element: Element,
}

impl<'d> Context<'d> {
    fn seen(&self, definition: usize, field: &'d model::Field) -> Seen<'d> {
        let place = |index| self.places.get(&*self.definitions.get(definition)?.package.message(index)?.name).copied();
        let element = match field.element {
            Element::Scalar(_) => field.element,
            Element::Message(index) => Element::Message(MessageIndex(place(index).unwrap_or(usize::MAX))),
        };
        Seen { definition, field, element }
    }

    /// The enum that a field carries, in the union.
    fn carried(&self, seen: &Seen<'_>) -> Option<EnumIndex> {
        let own = self.definitions.get(seen.definition)?.package.enum_(seen.field.enum_?)?;
        self.enums.iter().position(|one| one.name.text == own.name.text).map(EnumIndex)
    }
}

/// The fields of the union, and for each definition which of them its own are.
pub(super) fn join(
    known: &Joined<'_>,
    context: &Context<'_>,
    diagnostics: &mut Diagnostics,
) -> (Vec<Field>, Vec<Vec<usize>>) {
    let (mut all, mut places): (Vec<Vec<Seen<'_>>>, Vec<Vec<usize>>) = (Vec::new(), Vec::new());
    for (definition, _, message) in known {
        let mut own = Vec::new();
        for field in &message.fields {
            let (place, seen) = (place(&all, field, message), context.seen(*definition, field));
            match place.and_then(|place| all.get_mut(place)) {
                Some(newer) => newer.push(seen),
                None => all.push(vec![seen]),
            }
            own.push(place.unwrap_or(all.len() - 1));
        }
        places.push(own);
    }
    let newest = known.first().map(|(definition, ..)| *definition);
    let fields = all.iter().filter_map(|seen| {
        let field = union(seen, context, diagnostics)?;
        Some(Field { until: field.until.filter(|until| Some(*until) != newest), ..field })
    });
    (fields.collect_vec(), places)
}

/// The field of newer definitions that this one is.
fn place(all: &[Vec<Seen<'_>>], field: &model::Field, message: &model::Message) -> Option<usize> {
    let mut newer = all.iter().map(|seen| seen.first().map(|newest| newest.field));
    let by_name = newer.clone().position(|newer| newer.is_some_and(|newer| newer.name == field.name));
    by_name.or_else(|| {
        let is_gone = |newer: &model::Field| message.fields.iter().all(|other| other.name != newer.name);
        newer.position(|newer| newer.is_some_and(|newer| newer.was.as_ref() == Some(&field.name) && is_gone(newer)))
    })
}

/// What a field is in all definitions: as the newest has it, but of the type that has the values of all.
fn union(seen: &[Seen<'_>], context: &Context<'_>, diagnostics: &mut Diagnostics) -> Option<Field> {
    let (newest, older) = seen.split_first()?;
    let widest = seen.iter().map(|one| one.element).find(|wide| seen.iter().all(|one| fits(one.element, *wide)));
    let odd = match widest {
        Some(_) => older.iter().find(|one| one.field.array.is_some() != newest.field.array.is_some()),
        None => {
            let is_odd = |one: &&Seen<'_>| !fits(one.element, newest.element) && !fits(newest.element, one.element);
            older.iter().find(is_odd).or(older.last())
        }
    };
    if let Some(odd) = odd {
        let message = format!("`{}` cannot be one field with what it is in a newer definition", odd.field.name);
        let problem = Diagnostic::new(Code::UorbUnion, odd.field.span, message)
            .related(newest.field.span, "the newer definition has it here")
            .help("no type holds the values of both: leave one of the definitions out, or rename the field in one of them");
        diagnostics.push(problem);
    }
    let field = newest.field;
    Some(Field {
        name: field.name.clone(),
        span: field.span,
        was: field.was.clone(),
        element: widest.unwrap_or(newest.element),
        array: seen.iter().filter_map(|one| one.field.array).max(),
        docs: field.docs.clone(),
        enum_: context.carried(newest),
        invalid: field.invalid,
        until: Some(newest.definition),
    })
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
