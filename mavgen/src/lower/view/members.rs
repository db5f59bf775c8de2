//! Named bits: getters and setters of what they hold, and of the values that raw numbers stand for.

use super::super::items::{Items, NamedView};
use super::super::{docs, spelling};
use super::units;
use crate::docs::line;
use crate::internal::Internal;
use crate::ir::{Meaning, Member, Presence, Scaled, SwitchOn};
use crate::rust::{
    BitField, Docs, Error, Holds, Int, Kind, Method, Paragraph, Present, Receiver, Scale, Selector, Sig, Ty,
};

/// What a setter says that may fail.
const DOES_NOT_FIT: &str = " An error if the value does not fit.";

/// Numbers below this are exact in `f32`.
const EXACT_IN_F32: i128 = 1 << 24;

impl<'d> Items<'d> {
    /// Everything that one member contributes to its view.
    pub(super) fn member_methods(
        self,
        view: NamedView<'d>,
        (member, name): (&'d Member, &str),
    ) -> Result<Vec<Method<'d>>, Internal> {
        let holds = match &member.meaning {
            Meaning::Flag => Holds::Flag,
            Meaning::Values(id) => Holds::Enum(self.enum_type(*id)?),
            Meaning::Number { .. } | Meaning::Scaled(_) => Holds::Number,
        };
        let bits = bits(view, member, holds)?;
        let get_docs = docs::of_part(&member.description, name, units(member), None);
        let mut methods = match &member.meaning {
            Meaning::Scaled(scaled) => scaled_accessors(name, bits, scaled, [get_docs, setter_docs(name, true)]),
            _ => {
                let set_docs = setter_docs(name, !bits.always_sets());
                accessors(name, bits, [get_docs, set_docs])
            }
        };
        let set = methods.get(1).ok_or_else(|| Internal::new(format!("{name} has no setter")))?;
        let fails = if matches!(set.sig.result, Ty::Fallible(_)) { DOES_NOT_FIT } else { "" };
        methods.insert(2, set.with(name, Docs::line(format!("With this [`Self::{name}`].{fails}"))));
        Ok(methods)
    }
}

fn bits<'d>(view: NamedView<'d>, member: &'d Member, holds: Holds<'d>) -> Result<BitField<'d>, Internal> {
    Ok(BitField {
        storage: Int::of_bits(view.model.width, false),
        at: member.at,
        width: member.width,
        repeat: member.repeat,
        raw: Int::of_bits(member.width, member.signed),
        holds,
        present: present(view, member)?,
    })
}

fn present<'d>(view: NamedView<'d>, member: &'d Member) -> Result<Option<Present<'d>>, Internal> {
    let Presence::When(ranges) = &member.presence else { return Ok(None) };
    let switch = view.model.switch.as_ref().ok_or_else(|| Internal::new("nothing selects a layout"))?;
    let selector = match switch.on {
        SwitchOn::Field(..) => Selector::Field(view.switch_getter()?),
        SwitchOn::Bits { at, width } => Selector::Bits { at, width },
    };
    Ok(Some(Present { selector, ranges }))
}

/// A getter and a setter of what the bits hold, without scaling.
fn accessors<'d>(name: &str, bits: BitField<'d>, [get_docs, set_docs]: [Docs<'d>; 2]) -> Vec<Method<'d>> {
    let several = bits.repeat.is_some();
    let get_docs = match several {
        true => get_docs.then(Paragraph::line("`None` where there is no such one.")),
        false => get_docs,
    };
    let getter = Sig::const_getter(bits.ty().optional(bits.is_optional())).indexed(several);
    let setter = Sig { is_const: true, ..Sig::setter("value", bits.ty()) }.indexed(several);
    let setter = if bits.always_sets() { setter } else { setter.fallible(Error::View) };
    vec![
        Method::new(name, getter, get_docs, Kind::MemberGet(bits.clone())),
        Method::new(format!("set_{name}"), setter, set_docs, Kind::MemberSet(bits)),
    ]
}

/// Of a scaled number: as a float, exactly in a smaller unit, and raw.
fn scaled_accessors<'d>(
    name: &str,
    bits: BitField<'d>,
    scaled: &'d Scaled,
    [get_docs, set_docs]: [Docs<'d>; 2],
) -> Vec<Method<'d>> {
    let (several, optional, scale) = (bits.repeat.is_some(), bits.is_optional(), scale(name, &bits, scaled));
    let getter = Sig { receiver: Receiver::Value, ..Sig::getter(Ty::F32.optional(optional)) }.indexed(several);
    let setter = Sig::setter("value", Ty::F32).fallible(Error::View).indexed(several);
    let mut methods = vec![
        Method::new(name, getter, get_docs, Kind::ScaledGet(scale.clone())),
        Method::new(format!("set_{name}"), setter, set_docs, Kind::ScaledSet(scale.clone())),
    ];
    methods.extend(scale.exact.map(|(exact, int)| {
        let docs = Docs::line(format!("[`Self::{name}`] exactly, in {}.", line(&exact.units)));
        let getter = Sig::const_getter(Ty::Int(int).optional(optional)).indexed(several);
        Method::new(spelling::beside(name, &exact.suffix()), getter, docs, Kind::ExactGet(scale.clone()))
    }));
    let raw = |text: &str| Docs::line(format!("{text} raw number behind [`Self::{name}`]."));
    methods.extend(accessors(&scale.get_raw, bits, [raw("The"), raw("Sets the")]));
    methods
}

fn scale<'d>(name: &str, bits: &BitField<'d>, scaled: &'d Scaled) -> Scale<'d> {
    let largest = |factor: i64, bias: i64| {
        let product = i128::from(factor).abs().saturating_mul(1 << bits.width.min(64));
        product.saturating_add(i128::from(bias).abs())
    };
    let Scaled { factor, bias, divisor, .. } = *scaled;
    let exact = scaled.exact.as_ref().map(|exact| {
        let fits = largest(exact.factor, exact.bias) <= i128::from(i32::MAX);
        (exact, Int::of_bits(if fits { 32 } else { 64 }, true))
    });
    Scale {
        bits: bits.clone(),
        get_raw: spelling::beside(name, "raw"),
        set_raw: spelling::beside(&format!("set_{name}"), "raw"),
        factor,
        bias,
        divisor,
        in_f32: largest(factor, bias) < EXACT_IN_F32 && i128::from(divisor) < EXACT_IN_F32,
        exact,
    }
}

fn setter_docs<'d>(name: &str, fallible: bool) -> Docs<'d> {
    Docs::line(format!("Sets [`Self::{name}`].{}", if fallible { DOES_NOT_FIT } else { "" }))
}
