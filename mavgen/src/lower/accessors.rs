//! Getters and setters beside the plain fields: for sentinels ("not known"), for enums in fields of another width, and for
//! enums that overlays bind to fields.

use super::docs;
use super::items::{Items, NamedField, NamedMessage, spelled};
use super::names::methods::iterator;
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::{self, Binding, EnumId, Invalid, Scalar, Values};
use crate::rust::{
    Bind, Convert, Docs, Element, Error, Extent, Kind, Literal, Method, Paragraph, Sentinel, Sig, Ty, Unknown,
};

impl<'d> Items<'d> {
    /// The accessors of a message, of those fields that have some, and of what overlays bind to fields.
    pub(super) fn accessors(self, message: NamedMessage<'d>) -> Result<Vec<Method<'d>>, Internal> {
        let mut accessors = Vec::new();
        for &index in &message.names.accessors {
            let field = message.field(index)?;
            match (field.model.values, &field.model.invalid) {
                (Some(Values::Converted(id)), _) => accessors.extend(self.converted(field, id)?),
                (_, Some(invalid)) => {
                    let extent = Extent::of(invalid.scope, field.model.ty.array.map(|n| n.get().into()));
                    let sentinel = Sentinel { field: field.ident, unknown: self.unknown(field, invalid)?, extent };
                    accessors.extend(optional(self.element(field)?, sentinel));
                }
                (_, None) => return Err(Internal::new(format!("no accessor suits {}", field.ident))),
            }
        }
        for binding in message.bindings() {
            accessors.extend(self.binding(message, binding)?);
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

    /// An enum in a field of another width or sign: scalars without, arrays with an index.
    fn converted(self, field: NamedField<'d>, id: EnumId) -> Result<[Method<'d>; 2], Internal> {
        let invalid = field.model.invalid.as_ref();
        let convert = Convert {
            field: field.ident,
            int: self.element(field)?.int(),
            to: self.enum_type(id)?,
            unknown: invalid.map(|invalid| self.unknown(field, invalid)).transpose()?,
            element: field.model.ty.array.is_some(),
        };
        let (element, sets) = (convert.element, convert.always_sets());
        let getter = Sig::getter(Ty::Enum(convert.to).optional(convert.is_optional())).indexed(element);
        let setter = Sig::setter("value", Ty::Enum(convert.to)).indexed(element);
        let setter = if element || !sets { setter.fallible(Error::OutOfRange) } else { setter };
        let docs = [converted_getter(&convert), converted_setter(&convert)];
        Ok(pair(convert.field, [getter, setter], docs, [Kind::EnumGet(convert), Kind::EnumSet(convert)]))
    }

    /// The getter and setter of what an overlay binds to a field.
    fn binding(
        self,
        message: NamedMessage<'d>,
        (binding, getter): (&'d Binding, &str),
    ) -> Result<[Method<'d>; 2], Internal> {
        let (field, bound) = (message.field(binding.field)?.ident, self.enum_type(binding.enum_)?);
        let when = binding.condition.as_ref().map(|condition| self.holds(message, condition)).transpose()?;
        let link = format!("[`Self::{field}`](field@Self::{field})");
        let shown = docs::link(bound.ident);
        let said = Paragraph::prose(binding.description.as_str());
        let get_docs = Docs(vec![said, Paragraph::line(format!("{link} as {shown}."))]);
        let docs = [get_docs, Docs::line(format!("Sets {link} from {shown}."))];
        let kinds = [
            Kind::BindGet(Bind { field, bound, when: when.clone() }),
            Kind::BindSet(Bind { field, bound, when: None }),
        ];
        Ok(Method::pair(getter, Ty::Enum(bound), when.is_some(), docs, kinds))
    }
}

/// A field as an `Option`; and the elements of an array, if each may be unknown.
pub(super) fn optional<'d>(element: Element<'d>, sentinel: Sentinel<'d>) -> Vec<Method<'d>> {
    let Sentinel { field, extent, .. } = sentinel;
    let indexed = extent.is_indexed();
    let value = match extent {
        Extent::Whole(n) => Ty::Array(Box::new(element.ty()), n),
        Extent::Scalar | Extent::Each | Extent::First => element.ty(),
    };
    let value = value.optional(true);
    let setter = Sig::setter("value", value.clone()).indexed(indexed);
    let setter = if indexed { setter.fallible(Error::OutOfRange) } else { setter };
    let docs = match indexed {
        false => ["#, or `None` where the sender does not know it.", "Sets #; `None` says that it is not known."],
        true => [
            "Element `index` of #, or `None` where the sender does not know it, or there is no such element.",
            "Sets element `index` of #; `None` says that it is not known. An error if there is no such element.",
        ],
    };
    let kinds = [Kind::SentinelGet(sentinel), Kind::SentinelSet(sentinel)];
    let mut methods =
        pair(field, [Sig::getter(value.clone()).indexed(indexed), setter], docs, kinds).into_iter().collect_vec();
    if indexed {
        let docs = format!("The elements of `{}`, each `None` where the sender does not know it.", spelled(field));
        let (sig, kind) = (Sig::getter(Ty::Iterator(Box::new(value))), Kind::SentinelIter(sentinel));
        methods.push(Method::new(iterator(field), sig, Docs::line(docs), kind));
    }
    methods
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
    let [get_docs, set_docs] = docs.map(|text| Docs::line(text.replace('#', &format!("`{}`", spelled(field)))));
    let ([get_sig, set_sig], [get_kind, set_kind]) = (sigs, kinds);
    [Method::new(field, get_sig, get_docs, get_kind), Method::new(format!("set_{field}"), set_sig, set_docs, set_kind)]
}
