//! A view of each slot of arrays that lie side by side: the slot's type, an iterator, and setters for simulators.

use super::super::items::Items;
use super::super::named::{NamedMessage, NamedSlots, NamedView};
use super::source::{element, place};
use super::{Given, summary};
use crate::collect::CollectVec as _;
use crate::docs::line;
use crate::internal::Internal;
use crate::ir::{self, SwitchOn, ViewSentinel};
use crate::order;
use crate::rust::{
    Count, Docs, Error, Key, Kind, Method, Paragraph, RecordField, RecordType, Sig, Slot, SlotElement, Stored, Ty,
};

impl<'d> Items<'d> {
    pub(super) fn slots(
        self,
        message: NamedMessage<'d>,
        view: NamedView<'d>,
        slots: NamedSlots<'d>,
    ) -> Result<Given<'d>, Internal> {
        let slot = self.slot(message, view, slots)?;
        let mut methods = reading(view, slots, &slot);
        methods.extend(writing(slots, slot));
        Ok(Given { record: Some(self.declared_slot(message, view, slots)?), methods })
    }

    /// `pub struct Esc { … }`
    fn declared_slot(
        self,
        message: NamedMessage<'d>,
        view: NamedView<'d>,
        slots: NamedSlots<'d>,
    ) -> Result<RecordType<'d>, Internal> {
        let fields = slots.keys().map(|(key, ident)| self.key_field(message, key, ident));
        let mut fields = fields.try_collect_vec()?;
        let optional = view.model.condition.is_some() || !view.model.invalid.is_empty();
        fields.push(RecordField {
            ident: "status",
            ty: Ty::Named(view.ty()).optional(optional),
            docs: Docs::line(match optional {
                true => "What the bits say; `None` where they say nothing.",
                false => "What the bits say.",
            }),
        });
        let docs = Docs::line(format!("One slot of [`{}::{}`].", message.ty(), slots.items));
        Ok(RecordType { ident: slots.item, docs, fields })
    }

    fn slot(self, message: NamedMessage<'d>, view: NamedView<'d>, slots: NamedSlots<'d>) -> Result<Slot<'d>, Internal> {
        let count = slots.model.count.map(|count| {
            let field = message.field(count)?;
            Ok(Count { field: field.ident, as_int: self.element(field)?.as_int() })
        });
        let keys = slots.keys().map(|(key, ident)| self.key(message, key, ident));
        Ok(Slot {
            ident: slots.item,
            source: self.source(message, view)?,
            count: count.transpose()?,
            elements: elements(message, view, slots)?,
            keys: keys.try_collect_vec()?,
            sentinel: self.sentinel(message, view)?,
        })
    }

    /// The public field for a key or a value.
    pub(super) fn key_field(
        self,
        message: NamedMessage<'d>,
        key: &'d ir::Key,
        ident: &'d str,
    ) -> Result<RecordField<'d>, Internal> {
        let ty = self.element(message.field(key.place.field)?)?.ty();
        Ok(RecordField { ident, ty: ty.optional(key.invalid.is_some()), docs: key_docs(key, ident) })
    }

    /// Where a key or a value stands.
    pub(super) fn key(self, message: NamedMessage<'d>, key: &'d ir::Key, ident: &'d str) -> Result<Key<'d>, Internal> {
        let field = message.field(key.place.field)?;
        let invalid = key.invalid.map(|invalid| self.literal(field, invalid)).transpose()?;
        Ok(Key { ident, place: place(message, key.place)?, invalid })
    }

    /// How a message says that the bits of a slot mean nothing: by words if it can, else by a field.
    fn sentinel(self, message: NamedMessage<'d>, view: NamedView<'d>) -> Result<Stored<'d>, Internal> {
        let words = view.model.invalid.iter().find_map(|sentinel| match sentinel {
            ViewSentinel::Words(value) => Some(*value),
            ViewSentinel::Field(..) => None,
        });
        match (words, view.model.invalid.first()) {
            (None, Some(ViewSentinel::Field(at, value))) => {
                let literal = self.literal(message.field(at.field)?, *value)?;
                Ok(Stored::Field(place(message, *at)?, literal))
            }
            (words, _) => Ok(Stored::Words(words.unwrap_or_default())),
        }
    }
}

/// Every array that slots have elements of, once, in the order of the fields.
fn elements<'d>(
    message: NamedMessage<'d>,
    view: NamedView<'d>,
    slots: NamedSlots<'d>,
) -> Result<Vec<SlotElement<'d>>, Internal> {
    let words = view.model.words.iter().filter_map(|word| match word {
        ir::Word::One(place) => Some(*place),
        ir::Word::Joined(_) => None,
    });
    let sentinels = view.model.invalid.iter().filter_map(|sentinel| match sentinel {
        ViewSentinel::Field(place, _) => Some(*place),
        ViewSentinel::Words(_) => None,
    });
    let switch = view.model.switch.iter().filter_map(|switch| match switch.on {
        SwitchOn::Field(place, _) => Some(place),
        SwitchOn::Bits { .. } => None,
    });
    let places = slots.model.keys.iter().map(|key| key.place).chain(words).chain(sentinels).chain(switch);
    let mut fields = places.filter(|place| place.element).map(|place| place.field).collect_vec();
    order::sort_by_key(&mut fields, |field| field.0);
    fields.dedup();
    fields.into_iter().map(|field| message.field(field).map(element)).try_collect_vec()
}

/// The description, the unit, and what `None` means.
fn key_docs<'d>(key: &'d ir::Key, ident: &str) -> Docs<'d> {
    let mut sentences: Vec<String> = Vec::new();
    if key.description.trim().is_empty() {
        sentences.push(format!("`{ident}`."));
    }
    sentences.extend(key.units.iter().map(|units| format!("In {}.", line(units))));
    sentences.extend(key.invalid.map(|_| "`None` where it is not known.".to_owned()));
    Docs(vec![Paragraph::said(key.description.as_str(), sentences)])
}

/// `escs()` and `esc(index)`
fn reading<'d>(view: NamedView<'d>, slots: NamedSlots<'d>, slot: &Slot<'d>) -> Vec<Method<'d>> {
    let ty = Ty::Named(slot.ident);
    let in_use = Paragraph::line(match slot.source.when.as_slice() {
        [] => "Every slot that is in use.",
        _ => "Every slot that is in use, also those whose bits say nothing.",
    });
    let items = Method {
        ident: slots.items.to_owned(),
        sig: Sig::getter(Ty::Iterator(Box::new(ty.clone()))),
        docs: Docs(vec![summary(view), in_use]),
        inline: true,
        kind: Kind::Slots { get: slots.getter, length: slots.model.length.get() },
    };
    let get = Method {
        ident: slots.getter.to_owned(),
        sig: Sig::getter(ty.optional(true)).indexed(true),
        docs: Docs::line("The slot with this index; `None` where it is not in use."),
        inline: true,
        kind: Kind::SlotGet(slot.clone()),
    };
    vec![items, get]
}

/// `set_esc`, `push_esc`, and what they share.
fn writing<'d>(slots: NamedSlots<'d>, slot: Slot<'d>) -> Vec<Method<'d>> {
    let get = slots.getter;
    let [set, push, store] = ["set", "push", "store"].map(|verb| format!("{verb}_{get}"));
    let setter = Sig::setter("slot", Ty::Named(slot.ident));
    let mut methods = vec![Method {
        ident: set,
        sig: setter.clone().indexed(true).fallible(Error::View),
        docs: Docs::line("Sets a slot that is in use. What is `None` in it is written as the value that says so."),
        inline: true,
        kind: Kind::SlotSet { get, store: store.clone() },
    }];
    methods.extend(slot.count.map(|count| Method {
        ident: push,
        sig: setter.clone().fallible(Error::View),
        docs: Docs::line("Adds a slot behind those in use. An error if all are."),
        inline: true,
        kind: Kind::SlotPush { count, length: slots.model.length.get(), store: store.clone() },
    }));
    methods.push(Method {
        ident: store,
        sig: Sig { public: false, result: Ty::Unit.optional(true), ..setter.indexed(true) },
        docs: Docs::default(),
        inline: false,
        kind: Kind::SlotStore(slot),
    });
    methods
}
