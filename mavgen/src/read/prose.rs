//! What may be said of anything: its description and its stage of life.

use super::elements::{Broken, Elements, Grammar};
use super::tag::Tag;
use crate::source::Span;
use crate::syntax::{Lifecycle, Stage, Text};

const PLAIN: Grammar = Grammar::prose(&[]);
/// The grammar allows a description inside, and pymavlink drops it.
const NESTED: Grammar = Grammar::prose(&["description"]);

/// `<description>` and one of `<wip>`, `<superseded>` and `<deprecated>`.
#[derive(Default)]
pub(super) struct Prose {
    pub(super) description: Option<Text>,
    pub(super) lifecycle: Option<Lifecycle>,
    description_tag: Option<Span>,
}

impl Prose {
    /// Reads one of the four elements.
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
        self.description = elements.text(&PLAIN)?;
        Ok(())
    }
}

fn read_lifecycle<'t>(elements: &mut Elements<'t, '_>, mut tag: Tag<'t>, stage: Stage) -> Result<Lifecycle, Broken> {
    let span = tag.span;
    let since = tag.take("since");
    let replaced_by = if stage == Stage::Wip { None } else { tag.take("replaced_by") };
    if stage == Stage::Deprecated {
        tag.ignore(&["remove_on_date"]);
    }
    elements.close_tag(tag);
    Ok(Lifecycle { stage, since, replaced_by, description: read_text(elements)?, span })
}

/// The text of an element that may have a description inside.
pub(super) fn read_text(elements: &mut Elements<'_, '_>) -> Result<Option<Text>, Broken> {
    elements.text(&NESTED)
}
