//! Where a message has a view: its words, the value of its switch, and what must hold.

use super::super::items::{Items, NamedField, NamedMessage, NamedView};
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::{self, Condition, FieldIndex, SwitchOn, ViewSentinel};
use crate::rust::{Int, Place, Shape, SlotElement, Source, Switch, Test, Word};

/// What templates call their own local variables.
const LOCALS: [&str; 4] = ["index", "bits", "status", "slot"];

impl<'d> Items<'d> {
    pub(super) fn source(self, view: NamedView<'d>) -> Result<Source<'d>, Internal> {
        Ok(Source {
            view: view.ty(),
            storage: Int::of_bits(view.model.width, false),
            words: self.words(view)?,
            switch: self.switch(view)?,
            when: self.tests(view)?,
        })
    }

    fn words(self, view: NamedView<'d>) -> Result<Vec<Word<'d>>, Internal> {
        let mut words = Vec::new();
        let mut at = 0;
        for word in &view.model.words {
            let field = view.message.field(word_field(*word))?;
            let element = self.element(field)?;
            let places = match *word {
                ir::Word::One(at) => vec![place(view, at)?],
                ir::Word::Joined(_) => elements_of(field),
            };
            for place in places {
                words.push(Word { place, element, at });
                at += element.int().bits();
            }
        }
        Ok(words)
    }

    fn switch(self, view: NamedView<'d>) -> Result<Option<Switch<'d>>, Internal> {
        let Some(SwitchOn::Field(at, _)) = view.model.switch.as_ref().map(|switch| switch.on) else { return Ok(None) };
        let element = self.element(view.message.field(at.field)?)?;
        Ok(Some(Switch { place: place(view, at)?, element, get: view.switch_getter()? }))
    }

    fn tests(self, view: NamedView<'d>) -> Result<Vec<Test<'d>>, Internal> {
        let condition = view.model.condition.iter().map(|condition| self.holds(view.message, condition));
        let sentinels = view.model.invalid.iter().map(|sentinel| match *sentinel {
            ViewSentinel::Words(value) => Ok(Test::WordsAreNot(value)),
            ViewSentinel::Field(at, value) => {
                let literal = self.literal(view.message.field(at.field)?, value)?;
                Ok(Test::IsNot(place(view, at)?, literal))
            }
        });
        condition.chain(sentinels).try_collect_vec()
    }

    /// `self.autopilot == MavAutopilot::AUTOQUAD`
    pub(in crate::lower) fn holds(
        self,
        message: NamedMessage<'d>,
        condition: &Condition,
    ) -> Result<Test<'d>, Internal> {
        let field = message.field(condition.field)?;
        Ok(Test::Is(Place::Field(field.ident), self.literal(field, condition.value.into())?))
    }
}

/// The field that a word is.
pub(super) fn word_field(word: ir::Word) -> FieldIndex {
    match word {
        ir::Word::One(place) => place.field,
        ir::Word::Joined(field) => field,
    }
}

fn elements_of(field: NamedField<'_>) -> Vec<Place<'_>> {
    let count = field.model.ty.array.map_or(1, std::num::NonZeroU8::get);
    (0..count).map(|index| Place::At(field.ident, index)).collect_vec()
}

pub(super) fn place(view: NamedView<'_>, at: ir::Place) -> Result<Place<'_>, Internal> {
    let field = view.message.field(at.field)?;
    Ok(if at.element { Place::Element(element(field)) } else { Place::Field(field.ident) })
}

/// The slot's element of an array, in a local variable that is called like the field, unless a template has another of that name.
pub(super) fn element(field: NamedField<'_>) -> SlotElement<'_> {
    let name = field.ident;
    SlotElement {
        field: name,
        chars: matches!(field.shape(), Shape::Chars(_)),
        // No field is called so: snake case ends with no underscore.
        local: if LOCALS.contains(&name) { format!("{name}_") } else { name.to_owned() },
    }
}
