//! The catalogue of diagnostics: one stable number each.
//!
//! Numbers are never used again for something else. `M0xx` is XML and the file system, `M1xx` a file's grammar, `M2xx` files
//! together, `M3xx` messages, `M4xx` enums, `M5xx` commands, `M6xx` names, `M7xx` overlays, `M8xx` several dialects, `M9xx` PX4's `.msg` files.

use std::fmt;
use std::str::FromStr;

use super::nearest;
use crate::collect::CollectVec as _;

/// How bad a problem is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Nothing is generated.
    Error,
    /// Worth a look; the code is generated.
    Warning,
    /// Worth knowing; there is nothing to mend.
    Note,
}

impl fmt::Display for Severity {
    /// `error`, `warning` or `note`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Error => "error",
            Self::Warning => "warning",
            Self::Note => "note",
        })
    }
}

/// What the catalogue has of a kind of problem.
struct Facts {
    severity: Severity,
    title: &'static str,
    explanation: &'static str,
}

macro_rules! catalogue {
    ($($number:literal $name:ident $severity:ident $title:literal;)*) => {
        /// A kind of problem. Each has a page here, which `mavgen explain M304` prints.
        ///
        /// The examples are parts of a definition: messages stand in `<messages>`, enums in `<enums>`. A comment in the first
        /// line names the file where there are several. The overlays from M700 on are for this definition:
        ///
        /// ```xml
        #[cfg_attr(doc, doc = include_str!("pages/acme.xml"))]
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[expect(clippy::zero_prefixed_literal, reason = "the number as it is shown names the page")]
        pub enum Code {
            $(
                #[doc = concat!("`M", stringify!($number), "`: ", $title)]
                #[doc = ""]
                #[cfg_attr(doc, doc = include_str!(concat!("pages/M", stringify!($number), ".md")))]
                $name = $number,
            )*
        }

        impl Code {
            /// Every kind of problem, by number.
            pub const ALL: &[Self] = &[$(Self::$name,)*];

            fn facts(self) -> &'static Facts {
                match self {
                    $(Self::$name => &Facts {
                        severity: Severity::$severity,
                        title: $title,
                        explanation: include_str!(concat!("pages/M", stringify!($number), ".md")),
                    },)*
                }
            }
        }
    };
}

catalogue! {
    001 Unreadable Error "A file cannot be read.";
    002 NotUtf8 Error "A file is not UTF-8 text.";
    003 NotWellFormed Error "The text is not well-formed XML.";
    004 Unclosed Error "An element, a tag or a comment is not closed before the file or its parent ends.";
    005 UnknownEntity Error "An entity reference is not one of XML's own five.";
    006 DocumentType Error "A document type declaration is refused: nothing is expanded or fetched.";
    007 TooLarge Error "A file is larger or deeper than any dialect.";
    008 DeclaredEncoding Warning "The XML declaration names an encoding that the file is not in.";
    009 NotListed Note "There are more problems than are listed.";

    100 WrongRoot Error "The root element is not the one of such a file.";
    101 UnknownElement Warning "An element is not part of the grammar.";
    102 UnknownAttribute Warning "An attribute is not part of the grammar.";
    103 MissingAttribute Error "A required attribute is missing.";
    104 DuplicateAttribute Error "An attribute stands twice in one tag.";
    105 DuplicateElement Error "`<version>` stands twice in a file.";
    106 BadNumber Error "A number is not written as one, or is out of range.";
    107 BadBoolean Error "A truth value is not `true`, `false`, `1` or `0`.";
    108 StrayText Warning "Text stands where the grammar has none.";
    109 TruthSpelling Warning "A truth value is spelled so that pymavlink takes it otherwise.";
    110 Misspelt Error "An element or attribute is nearly one without which the wire, or a name, is another.";
    111 PymavlinkRefuses Warning "pymavlink's validation refuses what mavgen takes.";
    112 DocumentedNumber Warning "A number that only documentation shows is not written as one.";
    113 RepeatedElement Warning "An element that no byte depends on stands twice.";

    200 MissingInclude Error "An included file cannot be read.";
    201 IncludeCycle Error "Files include each other in a circle.";
    202 IncludeDepth Error "Includes are nested more deeply than pymavlink follows.";
    203 SameFile Warning "A file is included by two different paths.";

    300 DuplicateMessageId Error "Two messages have one id.";
    301 DuplicateMessageName Error "Two messages have one name.";
    302 DuplicateField Error "Two fields of a message have one name.";
    303 MessageId Error "A message id is not a number from 0 to 16777215.";
    304 UnknownType Error "A field type does not exist.";
    305 ArrayLength Error "An array length is not a number from 1 to 255.";
    306 PayloadTooLong Error "A payload is longer than 255 bytes.";
    307 TooManyFields Error "A message has more than 64 fields.";
    308 NoFields Error "A message has no fields.";
    309 Extensions Error "`<extensions/>` stands twice, or before the first field.";
    310 UnknownEnum Error "A field names an enum that does not exist.";
    311 EnumOnField Warning "An enum is named by a field that cannot carry it.";
    312 ValueBeyondField Warning "An enum has values that do not fit a field that uses it.";
    313 EnumWidths Warning "An enum is used by fields of different types.";
    314 Invalid Warning "An `invalid` value is not understood, or does not fit its field.";
    315 TargetType Warning "A target field is not a `uint8_t`.";
    316 VersionField Error "`uint8_t_mavlink_version` is an array.";
    317 EmptyExtensions Warning "No field follows `<extensions/>`.";
    318 Range Warning "A range is empty: its minimum is above its maximum.";
    319 Display Warning "`display` is not understood, or does not suit its field.";
    320 Instance Warning "A message has more than one instance field.";
    321 Units Warning "A unit is not one of MAVLink's.";
    322 TypeSpelling Warning "A field type is spelled as it was long ago.";
    323 LateVersion Warning "`<version>` stands after a message that has the version as a field.";
    324 SecondVersionField Warning "A message has the version as a field twice.";

    400 BadValue Error "An enum value is not a number from 0 to 2^64 - 1.";
    401 DuplicateValue Error "Two entries of an enum have one value.";
    402 DuplicateEntry Error "Two entries of an enum have one name.";
    403 EmptyEnum Error "An enum has no entries.";
    404 AutomaticValue Note "An entry without a value was given one.";
    405 BitmaskValue Warning "A value of a bitmask is not a single bit.";
    406 BitmaskDiffers Warning "Files disagree on whether an enum is a bitmask.";
    407 WidenedEnum Warning "An entry of another file does not fit the enum, which becomes wider.";
    408 LikelyBitmask Warning "An enum looks like a bitmask, and is not declared one.";
    409 SameEntryName Warning "Entries of two enums have one name.";
    410 EnumTwice Warning "An enum is defined twice in one file.";

    500 ParamIndex Warning "A param index is not a number from 1 to 7, or stands twice.";
    501 ParamEnum Warning "A param names an enum that does not exist.";
    502 ParamDefault Warning "A param that can be an integer on the wire has the default NaN.";

    600 BadName Error "A name is not letters, digits and underscores after a first letter.";
    601 NameCollision Error "Two names become one in Rust.";
    602 Lifecycle Warning "A lifecycle element does not say since when, as `YYYY-MM`, or what replaces it.";
    603 AccessorLost Warning "A field has no getter and setter, because another field's have their names.";
    604 ReservedName Warning "A name means something in C or Python, so that pymavlink does not take it.";
    605 CommandLost Warning "A command has no type of its own, because another has its name.";
    606 ParamLabel Warning "A param of a command is named after its number, because its label makes no name of its own.";

    700 OverlayVersion Error "An overlay is of a version that is not known.";
    701 OverlayBase Error "An overlay belongs to a file that is not part of the dialect.";
    702 OverlayMessage Error "An overlay names a message that does not exist.";
    703 OverlayField Error "An overlay names a field that does not exist.";
    704 OverlayEnum Error "An overlay names an enum that does not exist.";
    705 OverlayEntry Error "An overlay names an enum entry that does not exist.";
    706 RedefinedEnum Error "An overlay defines an enum that exists.";
    707 Refinement Error "A refinement says nothing, says it twice, or asks for what cannot be.";
    708 NeedlessRefinement Warning "A refinement says what the definitions say.";
    709 Note Error "A note has no text, or does not say what it is about.";
    710 Condition Error "A condition asks a field for a value that it cannot have.";
    711 Bind Error "An enum is bound to a field that cannot carry it.";
    712 OverlayCommand Error "An overlay names a command that does not exist.";
    713 OverlayParam Error "A param in an overlay has no number from 1 to 7, is named twice, or is reserved.";
    714 OverlayLabel Error "A label in an overlay makes no name of its own.";

    720 Words Error "The words of a view are none, or stand there twice.";
    721 Index Error "An array stands without an index, or a scalar with one.";
    722 WordType Error "A word of a view is not an unsigned integer.";
    723 WordLengths Error "Arrays that a view reads side by side have different lengths.";
    724 WordsTooWide Error "The words of a view are wider than 128 bits.";
    725 WordsMixed Error "A view is read from elements of arrays and from whole fields.";
    726 Slots Error "An attribute or element of a view belongs to slots, and there are none, or is missing where there are.";
    727 Count Error "A count is not a scalar unsigned integer.";
    728 UnsuitableField Error "A field is not of a type that it is used for.";
    729 Sentinel Error "A value that means nothing is not understood, does not fit, or excludes nothing more.";
    730 ViewKind Error "A view of bits has values, or a view of values has what belongs to bits.";
    731 ValueTwice Error "Two values of a view are one field, or a value is what the condition asks.";

    740 BitsPlace Error "Bits have no width, or lie outside of the words.";
    741 BitsOverlap Error "Bits are in two members of one layout.";
    742 BitsUncovered Error "Bits of a layout are in no member and not reserved.";
    743 EmptyView Error "A view has no members.";
    744 BitsKind Error "Attributes of bits contradict each other.";
    745 EnumTooNarrow Error "An enum is narrower than the bits that carry it.";
    746 ValueBeyondBits Warning "An enum has values that do not fit the bits that carry it.";
    747 Repeat Error "A repetition is none, or overlaps itself.";
    748 Scale Error "A scale or bias is not a fraction, is zero, or is beyond 64 bits.";
    749 NotExact Error "An exact getter would not be whole for every value.";
    750 ExactUnits Error "The unit of an exact getter is no decimal fraction of the unit of the value.";

    760 NestedSwitch Error "A switch stands inside another switch.";
    761 SecondSwitch Error "A view has two switches.";
    762 SwitchOn Error "A switch does not say what it looks at, or cannot look at it.";
    763 CaseValue Error "The values of a case are not understood.";
    764 CaseOverlap Error "Two cases have a value in common.";
    765 UnreachableCase Error "A case is never reached.";
    766 MissingCase Error "A switch has neither a case for every value nor a default.";
    767 SecondDefault Error "A switch has two defaults.";
    768 LayoutDiffers Error "A name stands for different bits in two cases.";

    800 SecondValue Warning "An entry has different values in two dialects, so that its enum is a type in each.";
    801 HomelessOverlay Error "An overlay belongs to a file that is part of none of the dialects.";
    802 RootModule Error "Two dialects of one tree would be one module.";
    900 UorbLine Error "A line of a `.msg` file is neither a field nor a constant.";
    901 UorbName Error "A name in a `.msg` file is not one.";
    902 UorbType Error "A `.msg` file names a type that does not exist.";
    903 UorbArray Error "An array of a `.msg` file has no length that can be.";
    904 UorbConstant Error "The value of a constant is not a whole number that fits.";
    905 UorbNested Error "A message cannot be nested.";
    906 UorbDuplicate Error "Two things of a `.msg` file have one name.";
    907 UorbTimestamp Error "A `.msg` file has no `uint64 timestamp`.";
    908 UorbEncoding Error "A `.msg` file begins with a byte order mark.";
    909 UorbEnum Warning "An `[@enum]` has no constants, or its field cannot carry them.";
    910 UorbGroup Warning "A bracket group in a comment says nothing that is known.";
    911 UorbOverlayFolder Error "An overlay belongs to a folder of which nothing is read.";
    912 UorbRefinement Error "A field of an overlay says nothing, or half of something.";
    913 UorbCarrier Error "A field cannot carry the enum or flags that an overlay gives it.";
    914 UorbConstants Error "An overlay takes constants that do not exist, or leaves them out.";
    915 UorbEnumTwice Error "Two different enums of `.msg` files have one name.";
    916 UorbFormerName Error "The former name of a field is that of another.";
    917 UorbUnion Error "A field cannot be one with what it is in another definition.";
    918 UorbConstantChanged Warning "A constant has another value in an older definition.";
}

impl Code {
    /// Whether this kind is an error.
    pub fn severity(self) -> Severity {
        self.facts().severity
    }

    /// What this kind of problem is, in one sentence.
    pub fn title(self) -> &'static str {
        self.facts().title
    }

    /// What it means, a wrong example and a right one, and why it matters on the wire: a page of markdown, the same as in the
    /// documentation of this type.
    pub fn explanation(self) -> &'static str {
        self.facts().explanation
    }

    /// Whether only `mavgen lint` tells of it: who uses a dialect has no use for it, who maintains it for other tools has.
    /// [`super::Diagnostics::for_lint`] lists it.
    pub fn is_for_lint(self) -> bool {
        self == Self::PymavlinkRefuses
    }

    /// The stable number.
    pub fn number(self) -> u16 {
        self as u16
    }

    /// The definition that the overlays of [`Code::explanation`] are for, as XML; `None` if there is no overlay in it.
    pub fn example_definition(self) -> Option<&'static str> {
        (700..800).contains(&self.number()).then_some(include_str!("pages/acme.xml"))
    }
}

impl fmt::Display for Code {
    /// `M304`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "M{:03}", self.number())
    }
}

/// A text that is no [`Code`]. `Display` says which one may have been meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownCode(String);

impl FromStr for Code {
    type Err = UnknownCode;

    /// `M304`, in any case, or `304`.
    fn from_str(text: &str) -> Result<Self, UnknownCode> {
        let number = text.trim().trim_start_matches(['M', 'm']).parse().ok();
        let code = Self::ALL.iter().copied().find(|code| Some(code.number()) == number);
        code.ok_or_else(|| UnknownCode(text.to_owned()))
    }
}

impl fmt::Display for UnknownCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let codes = Code::ALL.iter().map(Code::to_string).collect_vec();
        write!(f, "there is no diagnostic `{}`; ", self.0)?;
        match nearest(&self.0, codes.iter().map(String::as_str)) {
            Some(meant) => write!(f, "did you mean `{meant}`?"),
            None => f.write_str("`mavgen explain` lists all"),
        }
    }
}

impl std::error::Error for UnknownCode {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_rise() {
        assert!(Code::ALL.is_sorted_by(|a, b| a.number() < b.number()));
        assert_eq!(Code::UnknownType.to_string(), "M304");
    }

    #[test]
    fn any_spelling_of_a_code() {
        for text in ["M304", "m304", "304", " M304 "] {
            assert_eq!(text.parse(), Ok(Code::UnknownType), "{text}");
        }
        assert_eq!("M007".parse::<Code>(), "7".parse());
        for (text, help) in [("M3O4", "did you mean `M304`?"), ("M9999", "lists all"), ("", "lists all")] {
            let message = text.parse::<Code>().unwrap_err().to_string();
            assert!(message.contains(help), "{message}");
        }
    }
}
