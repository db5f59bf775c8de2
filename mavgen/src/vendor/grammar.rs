//! What of a dialect file is a fact: the elements and attributes of `mavlink.xsd`, which say nothing in sentences.
//!
//! Whatever is not listed here might be prose, and is left behind with it.

/// What may stand in an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    /// These elements.
    Elements(&'static [&'static str]),
    /// A fact: the path of an include, a number.
    Fact,
    /// A description.
    Prose,
    /// Nothing.
    Nothing,
}

/// What may stand in an element of this name; an element that the grammar does not have has nothing.
pub(super) fn content(element: &str) -> Content {
    match element {
        "mavlink" => Content::Elements(&["include", "version", "dialect", "enums", "messages"]),
        "enums" => Content::Elements(&["enum"]),
        "messages" => Content::Elements(&["message"]),
        "enum" => Content::Elements(&["wip", "superseded", "deprecated", "description", "entry"]),
        "entry" => Content::Elements(&["wip", "superseded", "deprecated", "description", "param"]),
        "message" => Content::Elements(&["wip", "superseded", "deprecated", "description", "field", "extensions"]),
        "include" | "version" | "dialect" => Content::Fact,
        "wip" | "superseded" | "deprecated" | "description" | "field" | "param" => Content::Prose,
        _ => Content::Nothing,
    }
}

/// The attributes that an element of this name may have, those that mavgen has no use for included.
pub(super) fn attributes(element: &str) -> &'static [&'static str] {
    match element {
        "mavlink" => &["file"],
        "enum" => &["name", "bitmask"],
        "entry" => &[
            "value",
            "name",
            "hasLocation",
            "hasAltitudeOnly",
            "isDestination",
            "missionOnly",
            "mission",
            "fence",
            "rally",
            "command",
        ],
        "param" => &[
            "index",
            "label",
            "units",
            "multiplier",
            "instance",
            "enum",
            "decimalPlaces",
            "increment",
            "minValue",
            "maxValue",
            "reserved",
            "default",
        ],
        "message" => &["id", "name"],
        "field" => &[
            "type",
            "name",
            "print_format",
            "enum",
            "display",
            "units",
            "increment",
            "minValue",
            "maxValue",
            "multiplier",
            "default",
            "instance",
            "invalid",
        ],
        "wip" => &["since"],
        "superseded" => &["since", "replaced_by"],
        "deprecated" => &["since", "remove_on_date", "replaced_by"],
        _ => &[],
    }
}

/// Where an element stands among its brothers: `mavlink.xsd` wants the stage of life first, and then the description.
pub(super) fn rank(element: &str) -> u8 {
    match element {
        "wip" | "superseded" | "deprecated" => 0,
        "description" => 1,
        _ => 2,
    }
}

/// Whether `mavlink.xsd` demands a description, be it empty.
pub(super) fn requires_description(element: &str) -> bool {
    element == "message"
}

/// Whether an element is one that people look up, and so should have a description.
pub(super) fn wants_description(element: &str) -> bool {
    matches!(element, "enum" | "entry" | "param" | "message" | "field")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Code, Diagnostics};
    use crate::read::read;
    use crate::source::Sources;

    /// An element with every attribute and, in it, every element that the table lists.
    fn complete(element: &str) -> String {
        let attributes: String = attributes(element).iter().map(|name| format!(" {name}='1'")).collect();
        let content = match content(element) {
            Content::Elements(children) => children.iter().map(|child| complete(child)).collect(),
            Content::Fact | Content::Prose => "1".to_owned(),
            Content::Nothing => String::new(),
        };
        format!("<{element}{attributes}>{content}</{element}>")
    }

    #[test]
    fn the_reader_knows_all_of_it() {
        let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
        let id = sources.add("all.xml", complete("mavlink"));
        read(id, &sources, &mut diagnostics);
        let unknown = diagnostics.iter().filter(|problem| problem.code != Code::DuplicateElement);
        assert_eq!(unknown.map(|problem| problem.message.as_str()).collect::<Vec<_>>(), Vec::<&str>::new());
    }
}
