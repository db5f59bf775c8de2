//! Where the definitions have the fields of a topic, and how they are read from there.

use super::definitions::{InDefinition, plain};
use super::{Named, Topics};
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::rust::{Held, Move, Part, Plain, Row, Scalars, TopicSlot};
use crate::uorb::Scalar;
use crate::uorb::model::MessageIndex;
use crate::uorb::placed::{self, Placed, Run};

impl<'d> Topics<'d> {
    /// How the newest definition is written as a record.
    pub(super) fn record(self, message: Named<'d>) -> Result<Part<'d>, Internal> {
        let newest = message.model.known.first().ok_or_else(|| Internal::new("a topic without a definition"))?;
        let own = self.in_definition(newest.definition, newest.message)?;
        self.part(message, own, &placed::in_record(own.package, own.message), 0)
    }

    /// The fields of a topic that a definition has, and where; what holds them begins at `base`.
    pub(super) fn part(
        self,
        message: Named<'d>,
        own: InDefinition<'d>,
        placed: &[Placed],
        base: u32,
    ) -> Result<Part<'d>, Internal> {
        let known = message.model.known.iter().find(|known| known.definition == own.definition);
        let known = known.ok_or_else(|| Internal::new(format!("a definition lacks {}", message.model.name)))?;
        let fields = placed.iter().map(|Placed { field, at, held }| {
            let union = known.fields.get(*field).ok_or_else(|| Internal::new("a field is none of the union's"))?;
            let slot = self.slot(message, *union)?;
            let held = match held {
                placed::Held::Scalars(scalar, len) => Held::Scalars(scalars(slot, *scalar, *len)),
                placed::Held::Messages(nested, runs) => {
                    self.messages(slot, self.in_definition(own.definition, *nested)?, runs, base)?
                }
            };
            Ok(Move { slot, at: base + at, later: is_later(&held), held })
        });
        let fields = fields.try_collect_vec()?;
        let lacks = fields.len() < message.model.fields.len() || fields.iter().any(|field| field.later);
        Ok(Part { ident: &message.names.ty, fields, lacks })
    }

    fn messages(
        self,
        slot: TopicSlot<'d>,
        nested: InDefinition<'d>,
        runs: &[Run],
        base: u32,
    ) -> Result<Held<'d>, Internal> {
        let at = self.union.messages.iter().position(|message| message.name == nested.message.name);
        let at = at.ok_or_else(|| Internal::new(format!("there is no {}", nested.message.name)))?;
        let message = self.message(MessageIndex(at))?;
        let Some(len) = slot.len else {
            let run = runs.first().ok_or_else(|| Internal::new(format!("`{}` lies nowhere", slot.name)))?;
            return Ok(Held::Message(self.part(message, nested, &run.fields, base + run.at)?));
        };
        let rows = runs.iter().map(|run| {
            let Run { first: skip, at, stride, len: bytes, .. } = *run;
            let take = (skip + run.count < len).then_some(run.count);
            let part = self.part(message, nested, &run.fields, 0)?;
            Ok(Row { skip, take, at: base + at, stride, len: bytes, part })
        });
        let mut rows = rows.try_collect_vec()?;
        let room = runs.iter().map(|run| run.count).sum();
        Ok(match rows.as_slice() {
            [row] if room == len && is_total(&row.part) => Held::Each(rows.remove(0)),
            _ => Held::Rows(rows, (room < len).then_some(room)),
        })
    }
}

fn scalars(slot: TopicSlot<'_>, scalar: Scalar, len: Option<u16>) -> Scalars {
    let stored = plain(scalar);
    Scalars { stored, len, widens: slot.ty.plain() != Some(stored), few: slot.len.unwrap_or(1) > len.unwrap_or(1) }
}

/// Whether a field is not one value: only some of its elements are there, or a loop reads them.
fn is_later(held: &Held<'_>) -> bool {
    match held {
        Held::Scalars(scalars) => scalars.few,
        Held::Message(part) => part.fields.iter().any(|field| field.later),
        Held::Each(_) => false,
        Held::Rows(..) => true,
    }
}

/// Whether a message is one literal, and nothing in it is refused.
fn is_total(part: &Part<'_>) -> bool {
    part.fields.iter().all(|field| match &field.held {
        Held::Scalars(scalars) => scalars.stored != Plain::Bool && !scalars.few,
        Held::Message(nested) => is_total(nested),
        Held::Each(_) => true,
        Held::Rows(..) => false,
    })
}
