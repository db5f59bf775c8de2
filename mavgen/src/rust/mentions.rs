//! Which enums an item names: what its file imports, and whether it names a deprecated one.

use super::{
    AsInt, Command, EnumType, Holds, Kind, Literal, Method, ParamTy, Place, Sentinel, Sig, Slot, Source, Stored,
    Struct, Test, Through, Ty, Unknown, View,
};

/// The enums that are named, each once.
#[derive(Clone, Debug, Default)]
pub(crate) struct Mentions<'d>(pub(crate) Vec<EnumType<'d>>);

impl<'d> Mentions<'d> {
    /// Those of a view's file.
    pub(crate) fn of_view(view: &View<'d>) -> Self {
        let mut mentions = Self::default();
        let own = view.packed.iter().flat_map(|packed| &packed.methods);
        own.chain(&view.message_methods).for_each(|method| mentions.method(method));
        view.record.iter().flat_map(|record| &record.fields).for_each(|field| mentions.ty(&field.ty));
        mentions
    }

    /// Those of a message's file.
    pub(crate) fn of_message(message: &Struct<'d>) -> Self {
        let mut mentions = Self::default();
        message.methods.iter().for_each(|method| mentions.method(method));
        message.fields.iter().filter_map(|field| field.carries).for_each(|carried| mentions.named(carried));
        mentions
    }

    /// Those of a command's file.
    pub(crate) fn of_command(command: &Command<'d>) -> Self {
        let mut mentions = Self::default();
        for field in &command.fields {
            if let ParamTy::Enum(one) = field.ty {
                mentions.named(one);
            }
        }
        mentions
    }

    /// Whether naming one of them makes the compiler warn.
    pub(crate) fn is_any_deprecated(&self) -> bool {
        self.0.iter().any(|one| one.deprecated)
    }

    fn named(&mut self, one: EnumType<'d>) {
        if self.0.iter().all(|known| known.id != one.id) {
            self.0.push(one);
        }
    }

    fn method(&mut self, method: &Method<'d>) {
        let Sig { params, result, .. } = &method.sig;
        params.iter().for_each(|param| self.ty(&param.ty));
        self.ty(result);
        self.kind(&method.kind);
    }

    fn ty(&mut self, ty: &Ty<'d>) {
        match ty {
            Ty::Enum(one) => self.named(*one),
            Ty::Array(inner, _) | Ty::Option(inner) | Ty::Iterator(inner) => self.ty(inner),
            Ty::Int(_)
            | Ty::F32
            | Ty::F64
            | Ty::Bool
            | Ty::Usize
            | Ty::Unit
            | Ty::Own
            | Ty::Named(_)
            | Ty::Fallible(_)
            | Ty::Params
            | Ty::Made(_) => {}
        }
    }

    fn kind(&mut self, kind: &Kind<'d>) {
        match kind {
            Kind::MemberGet(bits) | Kind::MemberSet(bits) => {
                if let Holds::Enum(one) = bits.holds {
                    self.named(one);
                }
            }
            Kind::ViewGet(source) => source.when.iter().for_each(|test| self.test(test)),
            Kind::ViewSet(source) => self.made(source),
            Kind::SlotGet(slot) => {
                slot.source.when.iter().for_each(|test| self.test(test));
                slot.keys.iter().filter_map(|key| key.invalid).for_each(|literal| self.literal(literal));
            }
            Kind::RecordGet(record) | Kind::RecordSet(record) => {
                record.when.iter().for_each(|test| self.test(test));
                record.values.iter().filter_map(|value| value.invalid).for_each(|literal| self.literal(literal));
            }
            Kind::SlotStore(slot) => self.stored(slot),
            Kind::SlotPush { count, .. } => self.made_of(count.as_int),
            Kind::BindGet(bind) => {
                self.named(bind.bound);
                bind.when.iter().for_each(|test| self.test(test));
            }
            Kind::BindSet(bind) => self.named(bind.bound),
            Kind::SentinelGet(Sentinel { unknown, .. })
            | Kind::SentinelSet(Sentinel { unknown, .. })
            | Kind::SentinelIter(Sentinel { unknown, .. }) => self.unknown(*unknown),
            Kind::EnumGet(convert) => {
                self.named(convert.to);
                convert.unknown.into_iter().for_each(|unknown| self.unknown(unknown));
            }
            Kind::EnumSet(convert) => self.named(convert.to),
            Kind::FromBits { .. }
            | Kind::Params
            | Kind::Bits
            | Kind::SwitchGet(_)
            | Kind::Slots { .. }
            | Kind::SlotSet { .. } => {}
            Kind::With { .. } | Kind::ScaledGet(_) | Kind::ScaledSet(_) | Kind::ExactGet(_) => {}
        }
    }

    fn test(&mut self, test: &Test<'d>) {
        match test {
            Test::Is(_, literal) | Test::IsNot(_, literal) => self.literal(*literal),
            Test::WordsAreNot(_) => {}
        }
    }

    fn literal(&mut self, literal: Literal<'d>) {
        match literal {
            Literal::Constant(one, _) => self.named(one),
            Literal::Number(as_int, _) => self.made_of(as_int),
            Literal::Float(_) => {}
        }
    }

    fn unknown(&mut self, unknown: Unknown<'d>) {
        if let Unknown::Is(literal) = unknown {
            self.literal(literal);
        }
    }

    /// What a value is made of its integer through.
    fn made_of(&mut self, as_int: AsInt<'d>) {
        match as_int.through {
            Through::Open(one) | Through::Flags(one) => self.named(one),
            Through::Plain | Through::Float | Through::Double => {}
        }
    }

    /// What the setter of a view makes.
    fn made(&mut self, source: &Source<'d>) {
        source.words.iter().for_each(|word| self.made_of(word.as_int));
        source.switch.iter().for_each(|switch| self.made_of(switch.as_int));
    }

    fn stored(&mut self, slot: &Slot<'d>) {
        self.made(&slot.source);
        let elements = slot.keys.iter().filter(|key| matches!(key.place, Place::Element(_)));
        elements.filter_map(|key| key.invalid).for_each(|literal| self.literal(literal));
        if let Stored::Field(_, literal) = slot.sentinel {
            self.literal(literal);
        }
    }
}
