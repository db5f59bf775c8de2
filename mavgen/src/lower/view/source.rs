//! Where a message has a view: its words, the value of its switch, and what must hold.

use super::super::types::shape;
use super::super::{Internal, Items};
use crate::ir::{self, Blank, Condition, Field, FieldIndex, Message, SwitchOn, View};
use crate::rust::{Int, Place, Shape, SlotElement, Source, Switch, Test, Word};

/// What templates call their own local variables.
const LOCALS: [&str; 4] = ["index", "bits", "status", "slot"];

impl<'d> Items<'d> {
    pub(super) fn source(self, message: &'d Message, view: &'d View) -> Result<Source<'d>, Internal> {
        Ok(Source {
            view: self.view_type(view),
            storage: Int::of_bits(view.width, false),
            words: self.words(message, view)?,
            switch: self.switch(message, view)?,
            when: self.tests(message, view)?,
        })
    }

    /// The fields that a view is read from.
    pub(super) fn word_fields(self, message: &'d Message, view: &'d View) -> Result<Vec<&'d Field>, Internal> {
        view.words.iter().map(|word| self.field(message, word_field(*word))).collect()
    }

    fn words(self, message: &'d Message, view: &'d View) -> Result<Vec<Word<'d>>, Internal> {
        let mut words = Vec::new();
        let mut at = 0;
        for word in &view.words {
            let field = self.field(message, word_field(*word))?;
            let as_int = self.element(field)?.as_int();
            let places = match *word {
                ir::Word::One(place) => vec![self.place(message, place)?],
                ir::Word::Joined(_) => self.elements_of(field),
            };
            for place in places {
                words.push(Word { place, as_int, at });
                at += as_int.int.bits();
            }
        }
        Ok(words)
    }

    fn elements_of(self, field: &'d Field) -> Vec<Place<'d>> {
        let count = field.ty.array.map_or(1, std::num::NonZeroU8::get);
        (0..count).map(|index| Place::At(self.field_name(field), index)).collect()
    }

    fn switch(self, message: &'d Message, view: &'d View) -> Result<Option<Switch<'d>>, Internal> {
        let Some(switch) = &view.switch else { return Ok(None) };
        let SwitchOn::Field(place, _) = switch.on else { return Ok(None) };
        let as_int = self.element(self.field(message, place.field)?)?.as_int();
        Ok(Some(Switch { place: self.place(message, place)?, as_int, get: self.switch_getter(switch) }))
    }

    fn tests(self, message: &'d Message, view: &'d View) -> Result<Vec<Test<'d>>, Internal> {
        let condition = view.condition.iter().map(|condition| self.holds(message, condition));
        let blanks = view.invalid.iter().map(|blank| match *blank {
            Blank::Words(value) => Ok(Test::WordsAreNot(value)),
            Blank::Field(place, value) => {
                let literal = self.literal(self.field(message, place.field)?, value)?;
                Ok(Test::IsNot(self.place(message, place)?, literal))
            }
        });
        condition.chain(blanks).collect()
    }

    /// `self.autopilot == MavAutopilot::AUTOQUAD`
    pub(in crate::lower) fn holds(self, message: &'d Message, condition: &Condition) -> Result<Test<'d>, Internal> {
        let field = self.field(message, condition.field)?;
        Ok(Test::Is(Place::Field(self.field_name(field)), self.literal(field, condition.value.into())?))
    }

    pub(super) fn place(self, message: &'d Message, place: ir::Place) -> Result<Place<'d>, Internal> {
        let field = self.field(message, place.field)?;
        if !place.element {
            return Ok(Place::Field(self.field_name(field)));
        }
        Ok(Place::Element(SlotElement {
            field: self.field_name(field),
            chars: matches!(shape(field), Shape::Chars(_)),
            local: self.local(field),
        }))
    }

    /// The local variable for an element of a field: called like it, unless a template has another of that name.
    fn local(self, field: &'d Field) -> String {
        let name = self.field_name(field);
        // No field is called so: snake case ends with no underscore.
        if LOCALS.contains(&name) { format!("{name}_") } else { name.to_owned() }
    }
}

fn word_field(word: ir::Word) -> FieldIndex {
    match word {
        ir::Word::One(place) => place.field,
        ir::Word::Joined(field) => field,
    }
}
