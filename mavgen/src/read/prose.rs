//! What may be said of anything: its description and its stage of life.

use super::elements::{Broken, Elements};
use crate::syntax::{Lifecycle, Stage, Tag, Text};

/// Reads `<description>`, `<wip>`, `<superseded>` or `<deprecated>`. Of two stages the last counts, and descriptions are
/// joined, as pymavlink does it.
pub(super) fn read<'t>(
    elements: &mut Elements<'t, '_>,
    mut tag: Tag<'t>,
    description: &mut Option<Text>,
    lifecycle: &mut Option<Lifecycle>,
) -> Result<(), Broken> {
    let stage = match tag.name {
        "wip" => Stage::Wip,
        "superseded" => Stage::Superseded,
        "deprecated" => Stage::Deprecated,
        _ => {
            elements.check_repeated(&tag, &["description"]);
            elements.close_tag(tag);
            match (description, elements.text()?) {
                (Some(description), Some(more)) => description.value.push_str(&more.value),
                (description, more) => *description = description.take().or(more),
            }
            return Ok(());
        }
    };
    elements.check_repeated(&tag, &["wip", "superseded", "deprecated"]);
    let (span, since) = (tag.span, tag.take("since"));
    let replaced_by = tag.take("replaced_by").filter(|_| stage != Stage::Wip);
    elements.close_tag(tag);
    *lifecycle = Some(Lifecycle { stage, since, replaced_by, description: elements.text()?, span });
    Ok(())
}
