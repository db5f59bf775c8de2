//! How an element of XML becomes a type: each attribute is said once, with the member that it fills.
//! Only a condition, which is one member of two attributes, says them itself.

use super::Text;
use crate::source::Span;

/// An attribute of an element, as a grammar has it.
pub(crate) struct Attribute {
    pub(crate) name: &'static str,
    pub(crate) ty: Type,
}

/// What an attribute or the text of an element can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Type {
    /// Any text. What a name, an id or an `invalid` value may be is checked where it is understood.
    Text,
    /// `true`, `false`, `1` or `0`.
    Boolean,
    /// A number from 0 to 255.
    Byte,
    /// A decimal number with or without a fraction and an exponent.
    Float,
    /// A value of an enum. An attribute that is nearly one of these is an error, no warning: without it the wire would be another.
    Number,
    /// A value of an enum, or `NaN`.
    Default,
    /// One of three.
    Multiplier,
    /// Year and month of this century.
    Date,
    /// A type of a field.
    OfField,
    /// A path: pymavlink looks for it with the blanks around it.
    Path,
}

impl Attribute {
    /// An attribute of any text.
    pub(crate) const fn new(name: &'static str) -> Self {
        Self { name, ty: Type::Text }
    }

    pub(crate) const fn typed(self, ty: Type) -> Self {
        Self { ty, ..self }
    }
}

/// A start tag, and those of its attributes that nobody took yet.
pub(crate) struct Tag<'t> {
    pub(crate) name: &'t str,
    pub(crate) span: Span,
    pub(crate) attributes: Vec<Written<'t>>,
    /// The required attributes that it lacks.
    pub(crate) missing: Vec<&'static str>,
}

/// An attribute as it is written in a tag.
pub(crate) struct Written<'t> {
    pub(crate) name: &'t str,
    pub(crate) name_span: Span,
    pub(crate) value: Text,
}

impl Tag<'_> {
    /// The value of an optional attribute.
    pub(crate) fn take(&mut self, name: &'static str) -> Option<Text> {
        let at = self.attributes.iter().position(|attribute| attribute.name == name)?;
        Some(self.attributes.remove(at).value)
    }

    /// The value of a required attribute; without one, nothing, and the tag is not complete.
    pub(crate) fn require(&mut self, name: &'static str) -> Text {
        self.take(name).unwrap_or_else(|| {
            self.missing.push(name);
            Text::new(String::new(), self.span)
        })
    }
}

/// An element that a tag begins.
pub(crate) trait Element {
    /// What the attributes of the tag say; members that they do not fill are empty.
    fn of(tag: &mut Tag<'_>) -> Self;
}

/// A member that an attribute fills.
pub(super) trait Member {
    fn take(tag: &mut Tag<'_>, attribute: &'static str) -> Self;
}

impl Member for Text {
    fn take(tag: &mut Tag<'_>, attribute: &'static str) -> Self {
        tag.require(attribute)
    }
}

impl Member for Option<Text> {
    fn take(tag: &mut Tag<'_>, attribute: &'static str) -> Self {
        tag.take(attribute)
    }
}

/// The type of an element: members that attributes fill, `enum_: Option<Text> = "enum"`, then those that what stands in the
/// element fills, and its place. A member of type `Text` is required. Attributes that the grammar has and nobody reads come
/// last.
macro_rules! element {
    (
        $(#[$about:meta])*
        $name:ident {
            $($(#[$of_member:meta])* $member:ident: $type:ty = $attribute:literal $(as $kind:ident)? $(and $second:literal)?,)*
            $(; $($(#[$of_content:meta])* $content:ident: $content_type:ty,)*)?
            $(; unread $($unread:literal as $unread_kind:ident,)*)?
        }
    ) => {
        $(#[$about])*
        #[derive(Debug)]
        pub struct $name {
            $(
                #[doc = concat!("`", $attribute, "`" $(, " and `", $second, "`")?, ".")]
                $(#[$of_member])*
                pub $member: $type,
            )*
            $($($(#[$of_content])* pub $content: $content_type,)*)?
            /// The start tag.
            pub span: Span,
        }

        impl $name {
            /// The attributes that the grammar has.
            pub(crate) const ATTRIBUTES: &'static [Attribute] = &[
                $(
                    Attribute::new($attribute)$(.typed(Type::$kind))?,
                    $(Attribute::new($second),)?
                )*
                $($(Attribute::new($unread).typed(Type::$unread_kind),)*)?
            ];
        }

        impl Element for $name {
            fn of(tag: &mut Tag<'_>) -> Self {
                Self {
                    $($member: Member::take(tag, $attribute),)*
                    $($($content: Default::default(),)*)?
                    span: tag.span,
                }
            }
        }
    };
}
pub(super) use element;
