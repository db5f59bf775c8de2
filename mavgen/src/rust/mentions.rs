//! Which enums an item names: what its file imports, and whether it names a deprecated one.

use super::{Command, EnumType, Kind, Method, Slot, Source, Struct, Test, Ty, View};

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
        message.fields.iter().for_each(|field| mentions.named(field.carries));
        mentions
    }

    /// Those of a command's file.
    pub(crate) fn of_command(command: &Command<'d>) -> Self {
        let mut mentions = Self::default();
        command.fields.iter().for_each(|field| mentions.ty(&field.ty.ty()));
        mentions
    }

    /// Whether naming one of them makes the compiler warn.
    pub(crate) fn is_any_deprecated(&self) -> bool {
        self.0.iter().any(|one| one.deprecated)
    }

    fn named(&mut self, one: Option<EnumType<'d>>) {
        self.0.extend(one.filter(|one| self.0.iter().all(|known| known.id != one.id)));
    }

    fn ty(&mut self, ty: &Ty<'d>) {
        match ty {
            Ty::Enum(one) => self.named(Some(*one)),
            Ty::Array(inner, _) | Ty::Option(inner) | Ty::Iterator(inner) => self.ty(inner),
            _ => {}
        }
    }

    /// What the signature names, and what only the body does: a sentinel is a value of the type that the getter gives.
    fn method(&mut self, Method { sig, kind, .. }: &Method<'d>) {
        sig.params.iter().for_each(|param| self.ty(&param.ty));
        self.ty(&sig.result);
        match kind {
            Kind::ViewGet(source) | Kind::SlotGet(Slot { source, .. }) => self.tests(&source.when),
            Kind::ViewSet(source) | Kind::SlotStore(Slot { source, .. }) => self.made(source),
            Kind::SlotPush { count, .. } => self.named(count.element.enum_()),
            Kind::RecordGet(record) | Kind::RecordSet(record) => self.tests(record.when.as_slice()),
            Kind::BindGet(bind) => self.tests(bind.when.as_slice()),
            _ => {}
        }
    }

    fn tests(&mut self, tests: &[Test<'d>]) {
        for test in tests {
            match test {
                Test::Is(_, literal) | Test::IsNot(_, literal) => self.named(literal.enum_()),
                Test::WordsAreNot(_) => {}
            }
        }
    }

    /// What the setter of a view makes.
    fn made(&mut self, source: &Source<'d>) {
        source.words.iter().for_each(|word| self.named(word.element.enum_()));
        self.named(source.switch.as_ref().and_then(|switch| switch.element.enum_()));
    }
}
