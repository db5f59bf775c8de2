//! A view of each slot of arrays that lie side by side: the slot's type, an iterator, and setters for simulators.

use super::super::{Internal, Items};
use super::Given;
use crate::ir::{self, Blank, Message, Slots, View};
use crate::rust::{
    Count, Docs, Error, Key, Kind, Method, Paragraph, Place, Sig, Slot, SlotElement, SlotField, SlotType, Stored, Ty,
};

impl<'d> Items<'d> {
    pub(super) fn slots(self, message: &'d Message, view: &'d View, slots: &'d Slots) -> Result<Given<'d>, Internal> {
        let slot = self.slot(message, view, slots)?;
        let mut methods = self.reading(view, slots, &slot);
        methods.extend(self.writing(slots, slot));
        Ok(Given { slot: Some(self.declared_slot(message, view, slots)?), methods })
    }

    /// `pub struct Esc { … }`
    fn declared_slot(self, message: &'d Message, view: &'d View, slots: &'d Slots) -> Result<SlotType<'d>, Internal> {
        let field = |key: &'d ir::Key| {
            let ty = self.element(self.field(message, key.place.field)?)?.ty();
            let ty = ty.optional(key.invalid.is_some());
            Ok(SlotField { ident: self.slot_field(key), ty, docs: self.key_docs(key) })
        };
        let mut fields = slots.keys.iter().map(field).collect::<Result<Vec<_>, Internal>>()?;
        fields.push(SlotField {
            ident: "status".to_owned(),
            ty: Ty::Named(self.view_type(view)).optional(true),
            docs: Docs::line("What the bits say; `None` where they say nothing."),
        });
        let docs =
            Docs::line(format!("One slot of [`{}::{}`].", self.message_type(message), self.slot_iterator(slots)));
        Ok(SlotType { ident: self.slot_type(slots), docs, fields })
    }

    /// The description, the unit, and what `None` means.
    fn key_docs(self, key: &'d ir::Key) -> Docs<'d> {
        let mut sentences: Vec<String> = Vec::new();
        if key.description.trim().is_empty() {
            sentences.push(format!("`{}`.", self.slot_field(key)));
        }
        sentences.extend(key.units.iter().map(|units| format!("In {units}.")));
        sentences.extend(key.invalid.map(|_| "`None` where it is not known.".to_owned()));
        Docs(vec![Paragraph::Prose(&key.description, sentences)])
    }

    fn slot(self, message: &'d Message, view: &'d View, slots: &'d Slots) -> Result<Slot<'d>, Internal> {
        let count = slots.count.map(|count| {
            let field = self.field(message, count)?;
            Ok(Count { field: self.field_name(field), as_int: self.element(field)?.as_int() })
        });
        let keys = slots.keys.iter().map(|key| {
            let field = self.field(message, key.place.field)?;
            let invalid = key.invalid.map(|invalid| self.literal(field, invalid)).transpose()?;
            Ok(Key { ident: self.slot_field(key), place: self.place(message, key.place)?, invalid })
        });
        Ok(Slot {
            ident: self.slot_type(slots),
            source: self.source(message, view)?,
            count: count.transpose()?,
            elements: self.elements(message, view, slots)?,
            keys: keys.collect::<Result<_, Internal>>()?,
            blank: self.blank(message, view)?,
        })
    }

    /// Every array that slots have elements of, once, in the order of the fields.
    fn elements(
        self,
        message: &'d Message,
        view: &'d View,
        slots: &'d Slots,
    ) -> Result<Vec<SlotElement<'d>>, Internal> {
        let words = view.words.iter().filter_map(|word| match word {
            ir::Word::One(place) => Some(*place),
            ir::Word::Joined(_) => None,
        });
        let blanks = view.invalid.iter().filter_map(|blank| match blank {
            Blank::Field(place, _) => Some(*place),
            Blank::Words(_) => None,
        });
        let switch = view.switch.iter().filter_map(|switch| match switch.on {
            ir::SwitchOn::Field(place, _) => Some(place),
            ir::SwitchOn::Bits { .. } => None,
        });
        let places = slots.keys.iter().map(|key| key.place).chain(words).chain(blanks).chain(switch);
        let mut places: Vec<ir::Place> = places.filter(|place| place.element).collect();
        places.sort_by_key(|place| place.field.0);
        places.dedup();
        let places = places.into_iter().map(|place| self.place(message, place));
        let places = places.collect::<Result<Vec<_>, _>>()?;
        Ok(places.into_iter().filter_map(Place::element).collect())
    }

    /// How a message says that the bits of a slot mean nothing: by words if it can, else by a field.
    fn blank(self, message: &'d Message, view: &'d View) -> Result<Stored<'d>, Internal> {
        let words = view.invalid.iter().find_map(|blank| match blank {
            Blank::Words(value) => Some(*value),
            Blank::Field(..) => None,
        });
        match (words, view.invalid.first()) {
            (None, Some(Blank::Field(place, value))) => {
                let literal = self.literal(self.field(message, place.field)?, *value)?;
                Ok(Stored::Field(self.place(message, *place)?, literal))
            }
            (words, _) => Ok(Stored::Words(words.unwrap_or_default())),
        }
    }

    /// `escs()` and `esc(index)`
    fn reading(self, view: &'d View, slots: &'d Slots, slot: &Slot<'d>) -> Vec<Method<'d>> {
        let (ty, get) = (Ty::Named(slot.ident), self.slot_getter(slots));
        let in_use = Paragraph::line("Every slot that is in use, also those whose bits say nothing.");
        let items = Method {
            ident: self.slot_iterator(slots),
            sig: Sig::getter(Ty::Iterator(Box::new(ty.clone()))),
            docs: Docs(vec![self.summary(view), in_use]),
            inline: true,
            kind: Kind::Slots { get: get.clone(), length: slots.length.get() },
        };
        let get = Method {
            ident: get,
            sig: Sig::getter(ty.optional(true)).indexed(true),
            docs: Docs::line("The slot with this index; `None` where it is not in use."),
            inline: true,
            kind: Kind::SlotGet(slot.clone()),
        };
        vec![items, get]
    }

    /// `set_esc`, `push_esc`, and what they share.
    fn writing(self, slots: &'d Slots, slot: Slot<'d>) -> Vec<Method<'d>> {
        let get = self.slot_getter(slots);
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
            kind: Kind::SlotPush { count, length: slots.length.get(), store: store.clone() },
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
}
