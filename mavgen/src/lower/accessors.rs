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
                    accessors.extend(self.optional(field, invalid)?);
                    accessors.extend(self.known(field, invalid)?);
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

    /// A field that may be unknown: as an `Option`.
    fn optional(self, field: NamedField<'d>, invalid: &Invalid) -> Result<[Method<'d>; 2], Internal> {
        let extent = match (invalid.scope, field.model.ty.array) {
            (_, None) => Extent::Scalar,
            (Scope::Each, Some(_)) => Extent::Each,
            (Scope::First, Some(_)) => Extent::First,
            (Scope::Whole, Some(n)) => Extent::Whole(n.get()),
        };
        let sentinel = Sentinel { field: field.ident, unknown: self.unknown(field, invalid)?, extent };
        let element = self.element(field)?.ty();
        let ty = match extent {
            Extent::Whole(n) => Ty::Array(Box::new(element), n),
            Extent::Scalar | Extent::Each | Extent::First => element,
        };
        let value = ty.optional(true);
        let indexed = matches!(extent, Extent::Each | Extent::First);
        let setter = Sig::setter("value", value.clone()).indexed(indexed);
        let setter = if indexed { setter.fallible(Error::OutOfRange) } else { setter };
        let docs = match indexed {
            false => ["#, or `None` where the sender does not know it.", "Sets #; `None` says that it is not known."],
            true => [
                "Element `index` of #, or `None` where the sender does not know it, or there is no such element.",
                "Sets element `index` of #; `None` says that it is not known. An error if there is no such element.",
            ],
        };
        let kinds = [Kind::SentinelGet(sentinel.clone()), Kind::SentinelSet(sentinel)];
        Ok(pair(field.ident, [Sig::getter(value).indexed(indexed), setter], docs, kinds))
    }

    /// The elements of an array, each of which may be unknown.
    fn known(self, field: NamedField<'d>, invalid: &Invalid) -> Result<Option<Method<'d>>, Internal> {
        let extent = match (invalid.scope, field.model.ty.array) {
            (Scope::Each, Some(_)) => Extent::Each,
            (Scope::First, Some(_)) => Extent::First,
            _ => return Ok(None),
        };
        let name = field.ident;
        let sentinel = Sentinel { field: name, unknown: self.unknown(field, invalid)?, extent };
        let element = self.element(field)?.ty().optional(true);
        let docs = format!("The elements of `{}`, each `None` where the sender does not know it.", spelled(name));
        Ok(Some(Method {
            ident: iterator(name),
            sig: Sig::getter(Ty::Iterator(Box::new(element))),
            docs: Docs::line(docs),
            inline: true,
            kind: Kind::SentinelIter(sentinel),
        }))
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
