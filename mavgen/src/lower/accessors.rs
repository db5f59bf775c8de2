//! Getters and setters beside the plain fields: for sentinels ("not known"), and for enums in fields of another width.

use super::items::Items;
use super::named::{NamedField, NamedMessage, spelled};
use super::names::iterator;
use crate::internal::Internal;
use crate::ir::{self, EnumId, Invalid, Scalar, Scope, Values};
use crate::rust::{Convert, Docs, Error, Extent, Kind, Literal, Method, Sentinel, Sig, Ty, Unknown};

impl<'d> Items<'d> {
    /// The accessors of a message, of those fields that have some.
    pub(super) fn accessors(self, message: NamedMessage<'d>) -> Result<Vec<Method<'d>>, Internal> {
        let mut accessors = Vec::new();
        for &index in &message.names.accessors {
            let field = message.field(index)?;
            accessors.extend(match (field.model.values, &field.model.invalid) {
                (Some(Values::Converted(id)), _) => self.converted(field, id)?,
                (_, Some(invalid)) => {
                    let own = self.may_be_unknown(field, invalid)?;
                    accessors.extend(optional(&own));
                    accessors.extend(known(&own));
                    continue;
                }
                (_, None) => return Err(Internal::new(format!("no accessor suits {}", field.ident))),
            });
        }
        Ok(accessors)
    }

    fn unknown(self, field: NamedField<'d>, invalid: &Invalid) -> Result<Unknown<'d>, Internal> {
        Ok(match (invalid.sentinel, field.model.ty.scalar) {
            (ir::Sentinel::NotANumber, Scalar::F64) => Unknown::NanF64,
            (ir::Sentinel::NotANumber, _) => Unknown::NanF32,
            (ir::Sentinel::Float(value), _) => Unknown::Is(Literal::Float(value)),
            (ir::Sentinel::Integer(value), _) => Unknown::Is(self.literal(field, value)?),
        })
    }

    /// A field that may be unknown.
    fn may_be_unknown(self, field: NamedField<'d>, invalid: &Invalid) -> Result<Optional<'d>, Internal> {
        let extent = match (invalid.scope, field.model.ty.array) {
            (_, None) => Extent::Scalar,
            (Scope::Each, Some(_)) => Extent::Each,
            (Scope::First, Some(_)) => Extent::First,
            (Scope::Whole, Some(n)) => Extent::Whole(n.get().into()),
        };
        let (unknown, element) = (self.unknown(field, invalid)?, self.element(field)?.ty());
        Ok(Optional { ident: field.ident, element, unknown, extent })
    }

    /// An enum in a field of another width or sign: scalars without, arrays with an index.
    fn converted(self, field: NamedField<'d>, id: EnumId) -> Result<[Method<'d>; 2], Internal> {
        let invalid = field.model.invalid.as_ref();
        let convert = Convert {
            field: field.ident,
            int: self.element(field)?.as_int().int,
            to: self.enum_type(id)?,
            unknown: invalid.map(|invalid| self.unknown(field, invalid)).transpose()?,
            element: field.model.ty.array.is_some(),
        };
        let (element, sets) = (convert.element, convert.always_sets());
        let getter = Sig::getter(Ty::Enum(convert.to).optional(convert.is_optional())).indexed(element);
        let setter = Sig::setter("value", Ty::Enum(convert.to)).indexed(element);
        let setter = if element || !sets { setter.fallible(Error::OutOfRange) } else { setter };
        let docs = [converted_getter(&convert), converted_setter(&convert)];
        Ok(pair(convert.field, [getter, setter], docs, [Kind::EnumGet(convert.clone()), Kind::EnumSet(convert)]))
    }
}

/// A field that may be unknown.
pub(super) struct Optional<'d> {
    pub(super) ident: &'d str,
    /// The type of one element.
    pub(super) element: Ty<'d>,
    pub(super) unknown: Unknown<'d>,
    pub(super) extent: Extent,
}

impl<'d> Optional<'d> {
    fn sentinel(&self) -> Sentinel<'d> {
        Sentinel { field: self.ident, unknown: self.unknown, extent: self.extent }
    }
}

/// The field as an `Option`.
pub(super) fn optional<'d>(field: &Optional<'d>) -> [Method<'d>; 2] {
    let ty = match field.extent {
        Extent::Whole(n) => Ty::Array(Box::new(field.element.clone()), n),
        Extent::Scalar | Extent::Each | Extent::First => field.element.clone(),
    };
    let value = ty.optional(true);
    let indexed = matches!(field.extent, Extent::Each | Extent::First);
    let setter = Sig::setter("value", value.clone()).indexed(indexed);
    let setter = if indexed { setter.fallible(Error::OutOfRange) } else { setter };
    let docs = match indexed {
        false => ["#, or `None` where the sender does not know it.", "Sets #; `None` says that it is not known."],
        true => [
            "Element `index` of #, or `None` where the sender does not know it, or there is no such element.",
            "Sets element `index` of #; `None` says that it is not known. An error if there is no such element.",
        ],
    };
    let kinds = [Kind::SentinelGet(field.sentinel()), Kind::SentinelSet(field.sentinel())];
    pair(field.ident, [Sig::getter(value).indexed(indexed), setter], docs, kinds)
}

/// The elements of an array, if each may be unknown.
pub(super) fn known<'d>(field: &Optional<'d>) -> Option<Method<'d>> {
    if !matches!(field.extent, Extent::Each | Extent::First) {
        return None;
    }
    let element = field.element.clone().optional(true);
    let docs = format!("The elements of `{}`, each `None` where the sender does not know it.", spelled(field.ident));
    Some(Method {
        ident: iterator(field.ident),
        sig: Sig::getter(Ty::Iterator(Box::new(element))),
        docs: Docs::line(docs),
        inline: true,
        kind: Kind::SentinelIter(field.sentinel()),
    })
}

fn converted_getter(convert: &Convert<'_>) -> &'static str {
    match (convert.element, convert.is_optional()) {
        (true, _) => {
            "Element `index` of # as its enum; `None` where the number cannot be one, is not known, or is not there."
        }
        (false, true) => "# as its enum; `None` where the number cannot be one, or is not known.",
        (false, false) => "# as its enum.",
    }
}

fn converted_setter(convert: &Convert<'_>) -> &'static str {
    match (convert.element, convert.always_sets()) {
        (true, _) => {
            "Sets element `index` of # from its enum. An error if the value does not fit, or there is no such element."
        }
        (false, false) => "Sets # from its enum. An error if the value does not fit the field.",
        (false, true) => "Sets # from its enum.",
    }
}

/// A getter and a setter, each with a line of documentation that has the field's name for `#`.
fn pair<'d>(field: &str, sigs: [Sig<'d>; 2], docs: [&str; 2], kinds: [Kind<'d>; 2]) -> [Method<'d>; 2] {
    let [get, set] = docs.map(|text| Docs::line(text.replace('#', &format!("`{}`", spelled(field)))));
    let ([get_sig, set_sig], [get_kind, set_kind]) = (sigs, kinds);
    [
        Method { ident: field.to_owned(), sig: get_sig, docs: get, inline: true, kind: get_kind },
        Method { ident: format!("set_{field}"), sig: set_sig, docs: set, inline: true, kind: set_kind },
    ]
}
