//! Formatting: from tokens to the text of a file.
//!
//! A build script writes plain lines, which take no time and no dependency. A tree that is committed and reviewed is formatted.

mod blank_lines;
mod lines;

use crate::internal::Internal;
use crate::tokens::TokenStream;

/// How the text of a file is laid out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Layout {
    /// A line for each item, statement, field and match arm.
    #[default]
    Lines,
    /// As a formatter does it.
    #[cfg(feature = "format")]
    Formatted,
}

impl Layout {
    /// The text of a file made of these items.
    ///
    /// # Errors
    /// If they are no items, which is a mistake of the emitters; plain lines do not tell.
    pub(crate) fn text(self, items: &TokenStream) -> Result<String, Internal> {
        let text = lines::lines(items);
        let text = match self {
            Self::Lines => text,
            #[cfg(feature = "format")]
            Self::Formatted => formatted(&text)?,
        };
        Ok(blank_lines::blank_lines(&text))
    }
}

/// The layout of a formatter: lines are broken at a width.
///
/// rustfmt would break some lines elsewhere (it fills 100 columns, prettyplease 89), and orders modules otherwise. A program
/// cannot count on it: it may not be installed, it takes ten times as long, and its layout changes with the toolchain, where
/// the same definitions have to give the same bytes.
#[cfg(feature = "format")]
fn formatted(lines: &str) -> Result<String, Internal> {
    let file = syn::parse_file(lines).map_err(|error| Internal::new(format!("generated code is no Rust: {error}")))?;
    Ok(prettyplease::unparse(&file))
}

/// Tokens as one line.
#[cfg(feature = "compare")]
pub(crate) fn line(tokens: &TokenStream) -> String {
    lines::lines(tokens).trim_end().to_owned()
}

#[cfg(all(test, feature = "format"))]
mod tests {
    use crate::tokens::quote;

    use super::*;

    #[test]
    fn items_are_separated() {
        let text = Layout::Formatted.text(&quote! {
            use super::A;
            use super::B;
            #[doc = " A type."]
            pub struct C(pub u8);
            impl C {
                #[doc = " One."]
                pub const ONE: Self = Self(1);
                #[doc = " Two;"]
                #[doc = " or so."]
                pub const TWO: Self = Self(2);
                #[doc = " Long."]
                pub const LONG: Self = Self::of_a_name_that_takes_a_line(111_111_111).and(222_222_222).and(333_333_333);
                #[doc = " Get."]
                pub fn get(self) -> u8 { self.0 }
            }
            mod x;
            mod y;
        });
        let constants = "    /// One.\n    pub const ONE: Self = Self(1);\n    /// Two;\n    /// or so.\n    pub const TWO: Self = Self(2);\n";
        let long = "    /// Long.\n    pub const LONG: Self = Self::of_a_name_that_takes_a_line(111_111_111)\n        .and(222_222_222)\n        \
                    .and(333_333_333);\n";
        let get = "    /// Get.\n    pub fn get(self) -> u8 {\n        self.0\n    }\n";
        let expected = format!(
            "use super::A;\nuse super::B;\n\n/// A type.\npub struct C(pub u8);\n\nimpl C {{\n{constants}\n{long}\n{get}}}\n\nmod x;\nmod y;\n"
        );
        assert_eq!(text.unwrap(), expected);
    }
}
