//! The grammar: which elements dialect files and overlays have, in one table for all who ask. Which attributes they have is said
//! where their types are, in [`crate::syntax`].
//!
//! That of dialect files is `mavschema.xsd` of pymavlink, with its order and its types, though the reader is more lenient: it
//! takes elements in any order. That of overlays is ours.

use crate::syntax::overlay::{
    Additions, Bind, Bits, Command, Invalid, Key, NamedParam, Note, Refinement, Reserved, Switch, View,
};
#[cfg(feature = "uorb")]
use crate::syntax::uorb_overlay;
use crate::syntax::{Attribute, Entry, Enum, Field, Message, Param, Type};

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
    /// Blanks at both ends do not count, as in the path of an include or a number.
    Trimmed(Type),
    /// Prose, as it is written.
    Prose,
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
        Some((TextKind::Trimmed(_), _)) => Filling::Fact,
        Some((TextKind::Prose, _)) => Filling::Prose,
    }
}

const fn optional(place: u8, element: &'static Element) -> Child {
    Child { element, place, times: Times::AtMostOnce }
}

const fn any(place: u8, element: &'static Element) -> Child {
    Child { element, place, times: Times::Any }
}

/// An element with these attributes, that holds these others; it has no text and is not essential.
const fn element(name: &'static str, attributes: &'static [Attribute], children: &'static [Child]) -> Element {
    Element { name, attributes, children, text: TextKind::None, essential: false }
}

impl Element {
    const fn essential(self) -> Self {
        Self { essential: true, ..self }
    }

    const fn text(self, text: TextKind) -> Self {
        Self { text, ..self }
    }
}

/// A text without blanks at both ends.
const TRIMMED: TextKind = TextKind::Trimmed(Type::Text);

pub(crate) static MAVLINK: Element = element(
    "mavlink",
    &[Attribute::new("file")],
    &[
        any(0, &INCLUDE),
        optional(1, &VERSION),
        optional(2, &DIALECT),
        optional(3, &ENUMS),
        Child { element: &MESSAGES, place: 4, times: Times::Once },
    ],
)
.essential();
static INCLUDE: Element = element("include", &[], &[]).text(TextKind::Trimmed(Type::Path)).essential();
static VERSION: Element = element("version", &[], &[]).text(TextKind::Trimmed(Type::Byte)).essential();
static DIALECT: Element = element("dialect", &[], &[]).text(TextKind::Trimmed(Type::Byte));
static ENUMS: Element = element("enums", &[], &[any(0, &ENUM)]).essential();
static MESSAGES: Element = element("messages", &[], &[any(0, &MESSAGE)]).essential();

static DESCRIPTION: Element = element("description", &[], &[]).text(TextKind::Prose);
/// The schema allows a description inside, and pymavlink drops it.
const NESTED: &[Child] = &[optional(0, &DESCRIPTION)];
const SINCE: Attribute = Attribute::new("since").typed(Type::Date);
const REPLACED_BY: Attribute = Attribute::new("replaced_by");
static WIP: Element = element("wip", &[SINCE], NESTED).text(TextKind::Prose);
static SUPERSEDED: Element = element("superseded", &[SINCE, REPLACED_BY], NESTED).text(TextKind::Prose);
static DEPRECATED: Element =
    element("deprecated", &[SINCE, Attribute::new("remove_on_date"), REPLACED_BY], NESTED).text(TextKind::Prose);

static ENUM: Element = element(
    "enum",
    Enum::ATTRIBUTES,
    &[optional(0, &WIP), optional(0, &SUPERSEDED), optional(0, &DEPRECATED), optional(1, &DESCRIPTION), any(2, &ENTRY)],
)
.essential();
static ENTRY: Element = element(
    "entry",
    Entry::ATTRIBUTES,
    &[optional(0, &WIP), optional(0, &SUPERSEDED), optional(0, &DEPRECATED), optional(1, &DESCRIPTION), any(2, &PARAM)],
)
.essential();
static PARAM: Element = element("param", Param::ATTRIBUTES, &[]).text(TextKind::Prose);
static MESSAGE: Element = element(
    "message",
    Message::ATTRIBUTES,
    &[
        optional(0, &WIP),
        optional(0, &SUPERSEDED),
        optional(0, &DEPRECATED),
        Child { element: &DESCRIPTION, place: 1, times: Times::Once },
        any(2, &FIELD),
        optional(2, &EXTENSIONS),
    ],
)
.essential();
static FIELD: Element = element("field", Field::ATTRIBUTES, NESTED).text(TextKind::Prose).essential();
static EXTENSIONS: Element = element("extensions", &[], &[]).essential();

/// What the root of an overlay of any kind has.
const ROOT: &[Attribute] = &[Attribute::new("version"), Attribute::new("for")];
pub(super) static OVERLAY: Element = element(
    "mavlink-overlay",
    ROOT,
    &[any(0, &ENUMS), any(0, &REFINE), any(0, &NOTE), any(0, &COMMAND), any(0, &ADDITIONS)],
);
static REFINE: Element = element("refine", Refinement::ATTRIBUTES, &[]);
static NOTE: Element = element("note", Note::ATTRIBUTES, &[]).text(TRIMMED);
static COMMAND: Element = element("command", Command::ATTRIBUTES, &[any(0, &NAMED_PARAM)]);
static NAMED_PARAM: Element = element("param", NamedParam::ATTRIBUTES, &[]);
static ADDITIONS: Element = element("message", Additions::ATTRIBUTES, &[any(0, &BIND), any(0, &VIEW)]);
static BIND: Element = element("bind", Bind::ATTRIBUTES, &[]).text(TRIMMED);
static VIEW: Element = element(
    "view",
    View::ATTRIBUTES,
    &[
        optional(0, &VIEW_DESCRIPTION),
        any(0, &KEY),
        any(0, &INVALID),
        any(0, &BITS),
        any(0, &RESERVED),
        any(0, &SWITCH),
        any(0, &VALUE),
    ],
)
.text(TRIMMED);
static VIEW_DESCRIPTION: Element = element("description", &[], &[]).text(TRIMMED);
static KEY: Element = element("key", Key::ATTRIBUTES, &[]).text(TRIMMED);
static VALUE: Element = element("value", Key::ATTRIBUTES, &[]).text(TRIMMED);
static INVALID: Element = element("invalid", Invalid::ATTRIBUTES, &[]);
static BITS: Element = element("bits", Bits::ATTRIBUTES, &[]).text(TRIMMED);
static RESERVED: Element = element("reserved", Reserved::ATTRIBUTES, &[]).text(TRIMMED);
static SWITCH: Element = element("switch", Switch::ATTRIBUTES, &[any(0, &CASE), any(0, &DEFAULT)]);
/// A switch is known in a case only to be refused with a better text than that of an unknown element.
const CASES: &[Child] = &[any(0, &BITS), any(0, &RESERVED), any(0, &NESTED_SWITCH)];
static CASE: Element = element("case", &[Attribute::new("value")], CASES);
static DEFAULT: Element = element("default", &[], CASES);
static NESTED_SWITCH: Element = element("switch", Switch::ATTRIBUTES, &[]);

#[cfg(feature = "uorb")]
pub(super) static UORB_OVERLAY: Element = element("uorb-overlay", ROOT, &[any(0, &UORB_MESSAGE)]);
#[cfg(feature = "uorb")]
static UORB_MESSAGE: Element = element("message", uorb_overlay::Message::ATTRIBUTES, &[any(0, &UORB_FIELD)]);
#[cfg(feature = "uorb")]
static UORB_FIELD: Element = element("field", uorb_overlay::Field::ATTRIBUTES, &[]);
