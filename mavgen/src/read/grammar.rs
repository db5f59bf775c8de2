//! The grammar: which elements and attributes dialect files and overlays have, in one table for all who ask.
//!
//! That of dialect files is `mavschema.xsd` of pymavlink, with its order and its types, though the reader is more lenient: it
//! takes elements in any order. That of overlays is ours.

use super::schema::Type;

/// An element.
pub(crate) struct Element {
    pub(crate) name: &'static str,
    pub(crate) attributes: &'static [Attribute],
    pub(crate) children: &'static [Child],
    pub(crate) text: TextKind,
    /// Whether the wire, or a name, is another without it: then it must not be lost by a slip of spelling.
    pub(crate) essential: bool,
}

/// What an element is filled with.
#[cfg(feature = "vendor")]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Filling {
    /// Elements.
    Elements,
    /// A fact: the path of an include, a number.
    Fact,
    /// Prose.
    Prose,
    /// Nothing, or nothing that the grammar knows.
    Nothing,
}

/// What the text in an element is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TextKind {
    /// There is none.
    None,
    /// A fact: the path of an include, a number.
    Fact(Type),
    /// For people.
    Prose,
}

/// An attribute of an element.
pub(crate) struct Attribute {
    pub(crate) name: &'static str,
    pub(crate) ty: Type,
    /// As of [`Element::essential`].
    pub(crate) essential: bool,
}

/// An element in another.
pub(crate) struct Child {
    pub(crate) element: &'static Element,
    /// Where it stands among its siblings: those of a lower place come first.
    pub(crate) place: u8,
    pub(crate) times: Times,
}

/// How often an element stands in another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Times {
    AtMostOnce,
    Once,
    Any,
}

impl Element {
    /// The element of that name in this one.
    pub(crate) fn child(&self, name: &str) -> Option<&'static Child> {
        self.children.iter().find(|child| child.element.name == name)
    }

    /// The attribute of that name.
    pub(crate) fn attribute(&self, name: &str) -> Option<&'static Attribute> {
        self.attributes.iter().find(|attribute| attribute.name == name)
    }

    /// The element of that name in a dialect file.
    #[cfg(feature = "vendor")]
    pub(crate) fn named(name: &str) -> Option<&'static Self> {
        fn find(within: &'static Element, name: &str) -> Option<&'static Element> {
            let mut children = within.children.iter().map(|child| child.element);
            if within.name == name { Some(within) } else { children.find_map(|child| find(child, name)) }
        }
        find(&MAVLINK, name)
    }
}

/// What fills the element of that name in a dialect file.
#[cfg(feature = "vendor")]
pub(crate) fn filling(name: &str) -> Filling {
    match Element::named(name).map(|element| (element.text, element.children)) {
        None | Some((TextKind::None, [])) => Filling::Nothing,
        Some((TextKind::None, _)) => Filling::Elements,
        Some((TextKind::Fact(_), _)) => Filling::Fact,
        Some((TextKind::Prose, _)) => Filling::Prose,
    }
}

/// An attribute of any text.
const fn text(name: &'static str) -> Attribute {
    typed(name, Type::Text)
}

const fn typed(name: &'static str, ty: Type) -> Attribute {
    Attribute { name, ty, essential: false }
}

const fn optional(place: u8, element: &'static Element) -> Child {
    Child { element, place, times: Times::AtMostOnce }
}

const fn any(place: u8, element: &'static Element) -> Child {
    Child { element, place, times: Times::Any }
}

/// An element that holds others.
const fn container(
    name: &'static str,
    attributes: &'static [Attribute],
    children: &'static [Child],
    essential: bool,
) -> Element {
    Element { name, attributes, children, text: TextKind::None, essential }
}

/// An element that holds prose.
const fn prose(name: &'static str, attributes: &'static [Attribute], children: &'static [Child]) -> Element {
    Element { name, attributes, children, text: TextKind::Prose, essential: false }
}

const fn fact(name: &'static str, ty: Type, essential: bool) -> Element {
    Element { name, attributes: &[], children: &[], text: TextKind::Fact(ty), essential }
}

pub(crate) static MAVLINK: Element = container(
    "mavlink",
    &[text("file")],
    &[
        any(0, &INCLUDE),
        optional(1, &VERSION),
        optional(2, &DIALECT),
        optional(3, &ENUMS),
        Child { element: &MESSAGES, place: 4, times: Times::Once },
    ],
    true,
);
pub(super) static INCLUDE: Element = fact("include", Type::Path, true);
pub(super) static VERSION: Element = fact("version", Type::Byte, true);
pub(super) static DIALECT: Element = fact("dialect", Type::Byte, false);
pub(super) static ENUMS: Element = container("enums", &[], &[any(0, &ENUM)], true);
pub(super) static MESSAGES: Element = container("messages", &[], &[any(0, &MESSAGE)], true);

pub(super) static DESCRIPTION: Element = prose("description", &[], &[]);
/// The schema allows a description inside, and pymavlink drops it.
const NESTED: &[Child] = &[optional(0, &DESCRIPTION)];
pub(super) static WIP: Element = prose("wip", &[typed("since", Type::Date)], NESTED);
pub(super) static SUPERSEDED: Element = prose("superseded", &[typed("since", Type::Date), text("replaced_by")], NESTED);
pub(super) static DEPRECATED: Element =
    prose("deprecated", &[typed("since", Type::Date), text("remove_on_date"), text("replaced_by")], NESTED);

pub(super) static ENUM: Element = container(
    "enum",
    &[text("name"), typed("bitmask", Type::Boolean)],
    &[optional(0, &WIP), optional(0, &SUPERSEDED), optional(0, &DEPRECATED), optional(1, &DESCRIPTION), any(2, &ENTRY)],
    true,
);
pub(super) static ENTRY: Element = container(
    "entry",
    &[
        Attribute { name: "value", ty: Type::Number, essential: true },
        text("name"),
        typed("hasLocation", Type::Boolean),
        typed("hasAltitudeOnly", Type::Boolean),
        typed("isDestination", Type::Boolean),
        typed("missionOnly", Type::Boolean),
        typed("mission", Type::Boolean),
        typed("fence", Type::Boolean),
        typed("rally", Type::Boolean),
        typed("command", Type::Boolean),
    ],
    &[optional(0, &WIP), optional(0, &SUPERSEDED), optional(0, &DEPRECATED), optional(1, &DESCRIPTION), any(2, &PARAM)],
    true,
);
pub(super) static PARAM: Element = prose(
    "param",
    &[
        typed("index", Type::Byte),
        text("label"),
        text("units"),
        typed("multiplier", Type::Multiplier),
        typed("instance", Type::Boolean),
        text("enum"),
        typed("decimalPlaces", Type::Byte),
        typed("increment", Type::Float),
        typed("minValue", Type::Float),
        typed("maxValue", Type::Float),
        typed("reserved", Type::Boolean),
        typed("default", Type::Default),
    ],
    &[],
);

pub(super) static MESSAGE: Element = container(
    "message",
    &[text("id"), text("name")],
    &[
        optional(0, &WIP),
        optional(0, &SUPERSEDED),
        optional(0, &DEPRECATED),
        Child { element: &DESCRIPTION, place: 1, times: Times::Once },
        any(2, &FIELD),
        optional(2, &EXTENSIONS),
    ],
    true,
);
pub(super) static FIELD: Element = Element {
    essential: true,
    ..prose(
        "field",
        &[
            typed("type", Type::OfField),
            text("name"),
            text("print_format"),
            text("enum"),
            text("display"),
            text("units"),
            typed("increment", Type::Float),
            typed("minValue", Type::Float),
            typed("maxValue", Type::Float),
            typed("multiplier", Type::Multiplier),
            typed("default", Type::Default),
            typed("instance", Type::Boolean),
            text("invalid"),
        ],
        NESTED,
    )
};
pub(super) static EXTENSIONS: Element = container("extensions", &[], &[], true);

pub(super) static OVERLAY: Element = container(
    "mavlink-overlay",
    &[text("version"), text("for")],
    &[any(0, &ENUMS), any(0, &REFINE), any(0, &NOTE), any(0, &COMMAND), any(0, &ADDITIONS)],
    false,
);
pub(super) static REFINE: Element =
    container("refine", &[text("enum"), text("bitmask"), text("deprecated")], &[], false);
pub(super) static NOTE: Element = prose("note", &[text("message"), text("field"), text("enum"), text("entry")], &[]);
pub(super) static COMMAND: Element =
    container("command", &[text("name"), text("hasLocation"), text("isDestination")], &[any(0, &NAMED_PARAM)], false);
pub(super) static NAMED_PARAM: Element =
    container("param", &[text("index"), text("label"), text("units"), text("enum")], &[], false);
pub(super) static ADDITIONS: Element = container("message", &[text("name")], &[any(0, &BIND), any(0, &VIEW)], false);
pub(super) static BIND: Element =
    prose("bind", &[text("name"), text("field"), text("enum"), text("if"), text("is")], &[]);
pub(super) static VIEW: Element = prose(
    "view",
    &[text("name"), text("words"), text("item"), text("items"), text("count"), text("partial"), text("if"), text("is")],
    &[
        optional(0, &DESCRIPTION),
        any(0, &KEY),
        any(0, &INVALID),
        any(0, &BITS),
        any(0, &RESERVED),
        any(0, &SWITCH),
        any(0, &VALUE),
    ],
);
pub(super) static KEY: Element = prose("key", &[text("name"), text("field"), text("units"), text("invalid")], &[]);
pub(super) static VALUE: Element = prose("value", KEY.attributes, &[]);
pub(super) static INVALID: Element = container("invalid", &[text("field"), text("value")], &[], false);
pub(super) static BITS: Element = prose(
    "bits",
    &[
        text("name"),
        text("at"),
        text("width"),
        text("enum"),
        text("signed"),
        text("scale"),
        text("bias"),
        text("units"),
        text("exact"),
        text("repeat"),
        text("stride"),
    ],
    &[],
);
pub(super) static RESERVED: Element = prose("reserved", &[text("at"), text("width")], &[]);
pub(super) static SWITCH: Element =
    container("switch", &[text("field"), text("bits")], &[any(0, &CASE), any(0, &DEFAULT)], false);
/// A switch is known in a case only to be refused with a better text than that of an unknown element.
const CASES: &[Child] = &[any(0, &BITS), any(0, &RESERVED), any(0, &NESTED_SWITCH)];
pub(super) static CASE: Element = container("case", &[text("value")], CASES, false);
pub(super) static DEFAULT: Element = container("default", &[], CASES, false);
static NESTED_SWITCH: Element = container("switch", &[text("field"), text("bits")], &[], false);

#[cfg(feature = "uorb")]
pub(super) static UORB_OVERLAY: Element =
    container("uorb-overlay", &[text("version"), text("for")], &[any(0, &UORB_MESSAGE)], false);
#[cfg(feature = "uorb")]
pub(super) static UORB_MESSAGE: Element = container("message", &[text("name")], &[any(0, &UORB_FIELD)], false);
#[cfg(feature = "uorb")]
pub(super) static UORB_FIELD: Element = container(
    "field",
    &[
        text("name"),
        text("enum"),
        text("flags"),
        text("constants"),
        text("bits"),
        text("except"),
        text("units"),
        text("invalid"),
        text("was"),
    ],
    &[],
    false,
);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Code, Diagnostics};
    use crate::read::{read, read_overlay};
    use crate::source::Sources;

    /// An element with every attribute and, in it, every element that the table lists.
    fn complete(element: &Element) -> String {
        let attributes: String = element.attributes.iter().map(|one| format!(" {}='1'", one.name)).collect();
        let children: String = element.children.iter().map(|child| complete(child.element)).collect();
        let text = if element.text == TextKind::None { "" } else { "1" };
        format!("<{0}{attributes}>{text}{children}</{0}>", element.name)
    }

    fn problems(text: String, read: impl FnOnce(crate::source::FileId, &Sources, &mut Diagnostics)) -> Vec<String> {
        let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
        let id = sources.add("all.xml", text);
        read(id, &sources, &mut diagnostics);
        let grammar = [Code::UnknownElement, Code::UnknownAttribute, Code::Misspelt, Code::StrayText];
        let found = diagnostics.iter().filter(|problem| grammar.contains(&problem.code));
        found.map(|problem| problem.message.clone()).collect()
    }

    #[test]
    fn the_reader_knows_all_of_it() {
        let dialect = problems(complete(&MAVLINK), |id, sources, diagnostics| drop(read(id, sources, diagnostics)));
        let overlay =
            problems(complete(&OVERLAY), |id, sources, diagnostics| drop(read_overlay(id, sources, diagnostics)));
        assert_eq!((dialect, overlay), (Vec::new(), Vec::new()));
    }

    #[cfg(feature = "uorb")]
    #[test]
    fn the_reader_of_uorb_overlays_knows_all_of_it() {
        let read = |id, sources: &Sources, diagnostics: &mut Diagnostics| {
            drop(crate::read::read_uorb_overlay(id, sources, diagnostics));
        };
        assert_eq!(problems(complete(&UORB_OVERLAY), read), Vec::<String>::new());
    }
}
