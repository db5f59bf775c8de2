//! A view of each slot of arrays that lie side by side: the slot's type, an iterator, and setters for simulators.

use super::super::docs;
use super::super::items::{Items, NamedSlots, NamedView};
use super::super::spelling::SLOT_VIEW;
use super::source::{element, place};
use super::summary;
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::rust::{
    Count, Docs, Error, Key, Kind, Method, Paragraph, Place, RecordField, RecordType, Sig, Slot, SlotElement, Source,
    Test, Ty,
};

impl<'d> Items<'d> {
    /// `escs()` and `esc(index)`; `set_esc`, `push_esc`, and what they share.
    pub(super) fn slots(self, slots: NamedSlots<'d>) -> Result<Vec<Method<'d>>, Internal> {
        let (view, slot) = (slots.view, self.slot(slots)?);
        let (get, length) = (view.names.getter.as_str(), slots.model.length.get());
        let [set, push, store] = ["set", "push", "store"].map(|verb| format!("{verb}_{get}"));
        let ty = Ty::Named(slot.ident);
        let items = Sig::getter(Ty::Iterator(Box::new(ty.clone())));
        let getter = Sig::getter(ty.clone().optional(true)).indexed(true);
        let setter = Sig::setter("slot", ty);
        let indexed_setter = setter.clone().indexed(true);
        let storing = Sig { public: false, result: Ty::Unit.optional(true), ..indexed_setter.clone() };
        let in_use = Paragraph::line(match slot.source.when.as_slice() {
            [] => "Every slot that is in use.",
            _ => "Every slot that is in use, also those whose bits say nothing.",
        });
        let get_docs = Docs::line("The slot with this index; `None` where it is not in use.");
        let set_docs =
            Docs::line("Sets a slot that is in use. What is `None` in it is written as the value that says so.");
        let set_kind = Kind::SlotSet { get, store: store.clone() };
        let mut methods = vec![
            Method::new(view.getter(), items, Docs(vec![summary(view), in_use]), Kind::Slots { get, length }),
            Method::new(get, getter, get_docs, Kind::SlotGet(slot.clone())),
            Method::new(set, indexed_setter.fallible(Error::View), set_docs, set_kind),
        ];
        methods.extend(slot.count.map(|count| {
            let docs = Docs::line("Adds a slot behind those in use. An error if all are.");
            let kind = Kind::SlotPush { count, length, store: store.clone() };
            Method::new(push, setter.fallible(Error::View), docs, kind)
        }));
        methods.push(Method::new(store, storing, Docs::default(), Kind::SlotStore(slot)));
        Ok(methods)
    }

    /// `pub struct Esc { … }`
    pub(super) fn declared_slot(self, slots: NamedSlots<'d>) -> Result<RecordType<'d>, Internal> {
        let view = slots.view;
        let mut fields = self.key_fields(view)?;
        let optional = view.model.condition.is_some() || !view.model.invalid.is_empty();
        fields.push(RecordField {
            ident: SLOT_VIEW,
            ty: Ty::Named(view.ty()).optional(optional),
            docs: Docs::line(match optional {
                true => "What the bits say; `None` where they say nothing.",
                false => "What the bits say.",
            }),
        });
        let docs = Docs::line(format!("One slot of [`{}::{}`].", view.message.ty(), slots.names.items));
        Ok(RecordType { ident: &slots.names.ty, docs, fields })
    }

    fn slot(self, slots: NamedSlots<'d>) -> Result<Slot<'d>, Internal> {
        let view = slots.view;
        let count = slots.model.count.map(|count| {
            let field = view.message.field(count)?;
            Ok(Count { field: field.ident, element: self.element(field)? })
        });
        let (source, keys) = (self.source(view)?, self.keys(view)?);
        let elements = elements(view, &source, &keys);
        Ok(Slot { ident: &slots.names.ty, source, count: count.transpose()?, elements, keys })
    }

    /// The public fields for keys or values.
    pub(super) fn key_fields(self, view: NamedView<'d>) -> Result<Vec<RecordField<'d>>, Internal> {
        let fields = view.keys().map(|(key, ident)| {
            let ty = self.element(view.message.field(key.place.field)?)?.ty();
            let unknown = key.invalid.map(|_| "`None` where it is not known.");
            let docs = docs::of_part(&key.description, ident, key.units.as_deref(), unknown);
            Ok(RecordField { ident, ty: ty.optional(key.invalid.is_some()), docs })
        });
        fields.try_collect_vec()
    }

    /// Where keys or values stand.
    pub(super) fn keys(self, view: NamedView<'d>) -> Result<Vec<Key<'d>>, Internal> {
        let keys = view.keys().map(|(key, ident)| {
            let field = view.message.field(key.place.field)?;
            let invalid = key.invalid.map(|invalid| self.literal(field, invalid)).transpose()?;
            Ok(Key { ident, place: place(view, key.place)?, invalid })
        });
        keys.try_collect_vec()
    }
}

/// Every array that a slot has elements of, once, in the order of the fields.
fn elements<'d>(view: NamedView<'d>, source: &Source<'d>, keys: &[Key<'d>]) -> Vec<SlotElement<'d>> {
    let tests = source.when.iter().filter_map(|test| match test {
        Test::Is(place, _) | Test::IsNot(place, _) => Some(place),
        Test::WordsAreNot(_) => None,
    });
    let read = keys.iter().map(|key| &key.place).chain(source.words.iter().map(|word| &word.place));
    let places = read.chain(source.switch.iter().map(|switch| &switch.place)).chain(tests).collect_vec();
    let is_read = |element: &SlotElement<'_>| places.iter().any(|place| **place == Place::Element(element.clone()));
    view.message.fields().map(element).filter(is_read).collect_vec()
}
