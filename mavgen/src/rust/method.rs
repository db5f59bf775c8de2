//! Methods: a signature, and a kind with all that the body needs.

use super::{Bind, BitField, Convert, Count, Docs, Error, Record, Scale, Sentinel, Slot, Source, Ty};

/// A method or an associated function.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Method<'d> {
    /// Its name; a keyword is written raw.
    pub(crate) ident: String,
    pub(crate) sig: Sig<'d>,
    pub(crate) docs: Docs<'d>,
    pub(crate) kind: Kind<'d>,
}

impl<'d> Method<'d> {
    pub(crate) fn new(ident: impl Into<String>, sig: Sig<'d>, docs: Docs<'d>, kind: Kind<'d>) -> Self {
        Self { ident: ident.into(), sig, docs, kind }
    }

    /// `x()`, an `Option` where there may be none, and `set_x(value)`.
    pub(crate) fn pair(name: &str, ty: Ty<'d>, optional: bool, docs: [Docs<'d>; 2], kinds: [Kind<'d>; 2]) -> [Self; 2] {
        let ([get_docs, set_docs], [get, set]) = (docs, kinds);
        [
            Self::new(name, Sig::getter(ty.clone().optional(optional)), get_docs, get),
            Self::new(format!("set_{name}"), Sig::setter("value", ty), set_docs, set),
        ]
    }

    /// The builder's way to call this setter of `name`: `with_x(value)`.
    pub(crate) fn with(&self, name: &str, docs: Docs<'d>) -> Self {
        let (indexed, fallible) = (self.sig.params.len() > 1, matches!(self.sig.result, Ty::Fallible(_)));
        let kind = Kind::With { set: self.ident.clone(), indexed, fallible };
        Self::new(format!("with_{name}"), self.sig.with(), docs, kind)
    }

    /// Whether it is `#[inline]`: not what is large, and not what the compiler inlines anyway.
    pub(crate) fn is_inline(&self) -> bool {
        use Kind::{Bits, FromBits, Params, SlotStore, SwitchGet};
        !matches!(self.kind, FromBits { .. } | Bits | SwitchGet(_) | Params | SlotStore(_))
    }
}

/// What callers see of a method.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sig<'d> {
    pub(crate) public: bool,
    pub(crate) is_const: bool,
    pub(crate) receiver: Receiver,
    pub(crate) params: Vec<Param<'d>>,
    pub(crate) result: Ty<'d>,
}

/// What a method is called on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Receiver {
    None,
    /// `self`
    Value,
    /// `&self`
    Ref,
    /// `&mut self`
    Mut,
    /// `mut self`
    MutValue,
}

/// `index: usize`
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Param<'d> {
    pub(crate) ident: &'d str,
    pub(crate) ty: Ty<'d>,
}

/// What a method does.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Kind<'d> {
    /// Of a view: makes one of its bits, and of the switch value that it carries along.
    FromBits {
        switch: Option<&'d str>,
    },
    /// Of a view: its bits.
    Bits,
    /// Of a view: the switch value that it carries along.
    SwitchGet(&'d str),
    /// Of a view: what some of its bits hold; `…Set` sets what `…Get` gives, here and below.
    MemberGet(BitField<'d>),
    MemberSet(BitField<'d>),
    /// Of a view or a message: itself, after this setter.
    With {
        set: String,
        indexed: bool,
        fallible: bool,
    },
    /// Of a view: the value that a raw number stands for.
    ScaledGet(Scale<'d>),
    ScaledSet(Scale<'d>),
    /// Of a view: the value as a whole number of a smaller unit.
    ExactGet(Scale<'d>),
    /// Of a message: a view.
    ViewGet(Source<'d>),
    ViewSet(Source<'d>),
    /// Of a message: iterates over the slots, of which `get` gives one.
    Slots {
        get: &'d str,
        length: u8,
    },
    /// Of a message: a slot.
    SlotGet(Slot<'d>),
    /// Of a message: sets a slot that is in use, as `get` says, by `store`.
    SlotSet {
        get: &'d str,
        store: String,
    },
    /// Of a message: adds a slot by `store`.
    SlotPush {
        count: Count<'d>,
        length: u8,
        store: String,
    },
    /// Of a message: a record of values.
    RecordGet(Record<'d>),
    /// Of a message: sets the values of a record, and what says that they are there.
    RecordSet(Record<'d>),
    /// Of a message, and private: puts a slot into the arrays.
    SlotStore(Slot<'d>),
    /// Of an enum of commands: what is known of the parameters.
    Params,
    /// Of a message: a field that may be unknown.
    SentinelGet(Sentinel<'d>),
    SentinelSet(Sentinel<'d>),
    /// Of a message: the elements of a field, each of which may be unknown.
    SentinelIter(Sentinel<'d>),
    /// Of a message: a field as an enum of another width or sign.
    EnumGet(Convert<'d>),
    EnumSet(Convert<'d>),
    /// Of a message: a field as the enum that an overlay binds to it.
    BindGet(Bind<'d>),
    BindSet(Bind<'d>),
}

impl<'d> Sig<'d> {
    /// `pub fn …(&self) -> T`
    pub(crate) fn getter(result: Ty<'d>) -> Self {
        Self { public: true, is_const: false, receiver: Receiver::Ref, params: Vec::new(), result }
    }

    /// `pub fn …(&mut self, value: T)`
    pub(crate) fn setter(ident: &'d str, ty: Ty<'d>) -> Self {
        let params = vec![Param { ident, ty }];
        Self { public: true, is_const: false, receiver: Receiver::Mut, params, result: Ty::Unit }
    }

    /// Of a type that is copied: `pub const fn …(self) -> T`
    pub(crate) fn const_getter(result: Ty<'d>) -> Self {
        Self { is_const: true, receiver: Receiver::Value, ..Self::getter(result) }
    }

    /// Of a setter of a type that is copied: `pub const fn …(mut self, value: T) -> Self`
    fn with(&self) -> Self {
        let result = match self.result {
            Ty::Fallible(error) => Ty::Made(error),
            _ => Ty::Own,
        };
        Self { receiver: Receiver::MutValue, result, ..self.clone() }
    }

    /// With `index: usize` as the first parameter, if there are several.
    pub(crate) fn indexed(mut self, indexed: bool) -> Self {
        if indexed {
            self.params.insert(0, Param { ident: "index", ty: Ty::Usize });
        }
        self
    }

    /// With `Result<(), …>`.
    pub(crate) fn fallible(self, error: Error) -> Self {
        Self { result: Ty::Fallible(error), ..self }
    }
}
