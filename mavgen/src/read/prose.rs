//! What may be said of anything: its description and its stage of life.

use super::elements::{Broken, Elements};
use super::grammar;
use super::tag::Tag;
use crate::source::Span;
use crate::syntax::{Lifecycle, Stage, Text};

/// `<description>` and one of `<wip>`, `<superseded>` and `<deprecated>`.
#[derive(Default)]
pub(super) struct Prose {
    pub(super) description: Option<Text>,
    pub(super) lifecycle: Option<Lifecycle>,
    description_tag: Option<Span>,
}

impl Prose {
    /// Reads one of the four elements. Of two stages the last counts, and descriptions are joined, as pymavlink does it.
    pub(super) fn read<'t>(&mut self, elements: &mut Elements<'t, '_>, tag: Tag<'t>) -> Result<(), Broken> {
        let stage = match tag.name {
            "wip" => Stage::Wip,
            "superseded" => Stage::Superseded,
            "deprecated" => Stage::Deprecated,
            _ => return self.read_description(elements, tag),
        };
        if let Some(first) = &self.lifecycle {
            elements.repeated(&tag, first.span);
        }
        self.lifecycle = Some(read_lifecycle(elements, tag, stage)?);
        Ok(())
    }

    fn read_description<'t>(&mut self, elements: &mut Elements<'t, '_>, tag: Tag<'t>) -> Result<(), Broken> {
        match self.description_tag {
            Some(first) => elements.repeated(&tag, first),
            None => self.description_tag = Some(tag.span),
        }
        elements.close_tag(tag);
        let more = elements.text(&grammar::DESCRIPTION)?;
        match (&mut self.description, more) {
            (Some(description), Some(more)) => description.value.push_str(&more.value),
            (description, more) => *description = description.take().or(more),
        }
        Ok(())
    }
}

fn read_lifecycle<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>, stage: Stage) -> Result<Lifecycle, Broken> {
    let span = tag.span;
    let since = tag.take("since");
    let (replaced_by, element) = match stage {
        Stage::Wip => (None, &grammar::WIP),
        Stage::Superseded => (tag.take("replaced_by"), &grammar::SUPERSEDED),
        Stage::Deprecated => (tag.take("replaced_by"), &grammar::DEPRECATED),
    };
    elements.close_tag(tag);
    Ok(Lifecycle { stage, since, replaced_by, description: elements.text(element)?, span })
}
